// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "limn/formats/obj_drawing_writer.h"
#include "limn/model/wireframe.h"
#include "limn/util/length_unit.h"

namespace limn {

// Files of wireframes:
//   .obj    v x y z, and l a b per edge, counted from 1
//   .json   {"wf_vertices": [[x, y, z], ...], "wf_edges": [[a, b], ...]}, counted from 0, or a list
//           of one such object: as the data and the submissions of the S23DR challenge have them
// Other members and statements are passed over.

// What such a file tells besides, if it is known.
struct WireframeStamp {
  LengthUnit unit = LengthUnit::kNone;
  double tolerance = 0;  // of ReduceToWireframe
};

// With comments "# unit: m" and "# tolerance: 0.1". `options`: y_up.
void WriteWireframeObj(const Wireframe& wireframe, const ObjOptions& options,
                       const WireframeStamp& stamp, std::ostream& out);

// With "format", "unit" and "tolerance" before the two lists.
void WriteWireframeJson(const Wireframe& wireframe, const WireframeStamp& stamp, std::ostream& out);

// Reads a wireframe as it is, with its unit if the file tells it as above, with corners of no edge,
// copies, and edges of no length. Nothing if the file, of any format of curves, is none: an OBJ
// file without lines, or with one of more than two vertices, points or faces; a JSON file without
// "wf_vertices", another extension. Any file may be packed (.gz). Throws IoError.
std::optional<Wireframe> ReadWireframe(const std::string& path);

// The same of a JSON file, whatever its extension.
std::optional<Wireframe> ReadJsonWireframe(const std::string& path);

}  // namespace limn
