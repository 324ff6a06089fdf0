// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/ply_curves_writer.h"

#include "limn/formats/colors.h"
#include "limn/formats/ply_output.h"

namespace limn {
namespace {

void PutVertex(std::ostream& out, const Eigen::Vector3d& point, const Color& color) {
  for (int axis = 0; axis < 3; ++axis) PutLittleEndian(out, point[axis]);
  PutColor(out, color);
}

void PutVertices(const CurveSet& set, std::ostream& out) {
  constexpr Color kWhite = {255, 255, 255};
  for (size_t id = 0; id < set.polylines.size(); ++id) {
    const Color color = ColorOfCurve(static_cast<int>(id));
    for (const Eigen::Vector3d& point : set.polylines[id]) PutVertex(out, point, color);
  }
  for (const Eigen::Vector3d& point : set.points) PutVertex(out, point, kWhite);
}

void PutEdges(const CurveSet& set, std::ostream& out) {
  int32_t vertex = 0;
  for (size_t id = 0; id < set.polylines.size(); ++id) {
    for (size_t i = 0; i + 1 < set.polylines[id].size(); ++i, ++vertex) {
      PutLittleEndian(out, vertex);
      PutLittleEndian(out, vertex + 1);
      PutColor(out, ColorOfCurve(static_cast<int>(id)));
      PutLittleEndian(out, static_cast<int32_t>(id));
    }
    ++vertex;
  }
}

}  // namespace

void WriteCurvesPly(const CurveSet& set, std::ostream& out) {
  size_t num_vertices = set.points.size();
  size_t num_edges = 0;
  for (const Polyline3d& polyline : set.polylines) {
    num_vertices += polyline.size();
    num_edges += polyline.size() - 1;
  }
  out << "ply\nformat binary_little_endian 1.0\ncomment curves by limn\n"
      << "element vertex " << num_vertices << '\n'
      << "property double x\nproperty double y\nproperty double z\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      << "element edge " << num_edges << '\n'
      << "property int vertex1\nproperty int vertex2\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int link\n"
         "end_header\n";
  PutVertices(set, out);
  PutEdges(set, out);
}

}  // namespace limn
