// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>

#include "limn/model/edge_map.h"

namespace limn {

// Edge maps of the VXL tools, text (`.edg`, also gzipped): a version line, the keys WIDTH, HEIGHT
// and EDGE_COUNT, then one edgel per line:
//   [ix, iy]  idir iconf  [x, y]  dir conf uncertainty        (the last number is absent before v3)
// Edgel ids are the order of the lines. The center of the top-left pixel is (0, 0), as here. The
// sense of `dir` along the edge is kept. Reading sets position_px and stored_px to the same values;
// throws IoError, also for edgels more than a pixel outside the image, numbers that are not finite,
// strengths and uncertainties below 0, and uncertainties above 10 px.
EdgeMap ReadEdg(const std::string& path);

// Version 3: positions and directions in the virtual pinhole image (in the stored one before
// ApplyLens), strength as conf, sigma as uncertainty; all are read back exactly. Directions are
// from -pi to pi, while other programs write 0 to 2 pi.
void WriteEdg(const EdgeMap& edge_map, std::ostream& out);

}  // namespace limn
