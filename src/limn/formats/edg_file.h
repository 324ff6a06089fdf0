#pragma once

#include <iosfwd>
#include <string>

#include "limn/model/edge_map.h"

namespace limn {

// Edge maps of the VXL tools, text (`.edg`, also gzipped): a version line, the keys WIDTH, HEIGHT
// and EDGE_COUNT, then one edgel per line:
//   [ix, iy]  idir iconf  [x, y]  dir conf uncertainty        (the last number is absent before v3)
// Edgel ids are the order of the lines. Pixels have the center of the top-left one at (0, 0), as
// here. Which of the two directions along the edge `dir` means is taken as it is. Reading fills
// position_px and stored_px alike; throws IoError.
EdgeMap ReadEdg(const std::string& path);

// Version 3: positions and directions in the virtual pinhole image, strength as conf, sigma as
// uncertainty; all come back exactly but for directions below 0, which gain 2 pi.
void WriteEdg(const EdgeMap& edge_map, std::ostream& out);

}  // namespace limn
