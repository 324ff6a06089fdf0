// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"
#include "limn/util/length_unit.h"

namespace limn {

struct ObjOptions {
  // Elements of two vertices each, for programs that show no polylines (MeshLab).
  bool segments = false;
  // Written with y up: (x, y, z) as (x, z, -y).
  bool y_up = false;
};

// A line with a vertex ("v") or a normal ("vn").
void PutObjVector(const char* keyword, const Eigen::Vector3d& vector, const ObjOptions& options,
                  std::ostream& out);

// Writes a drawing as Wavefront OBJ: a comment "# unit: m" if the unit of its coordinates is known,
// the nodes' vertices first, then per link an object "link_<id>" in the group of its kind of edge,
// where kinds are known, with its inner vertices and one polyline element (or one per segment);
// then per face an object "face_<id>" in the group of its surface
// ("plane", "ruled", "patch"), with its vertices, their normals and its triangles.
void WriteDrawingObj(const DrawingGraph& graph, const ObjOptions& options, LengthUnit unit,
                     std::ostream& out);

}  // namespace limn
