// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/ply_sketch_writer.h"

#include <algorithm>

#include "limn/formats/colors.h"
#include "limn/formats/ply_output.h"

namespace limn {
namespace {

size_t NumEdges(const Curve3D& curve) {
  if (curve.size() < 2) return 0;
  return curve.closed ? curve.size() : curve.size() - 1;
}

void PutSamples(const Curve3D& curve, const Color& color, std::ostream& out) {
  for (size_t i = 0; i < curve.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) PutLittleEndian(out, curve.points_in_world[i][axis]);
    PutColor(out, color);
    PutLittleEndian(out, curve.depth_sigma[i]);
    const size_t support = curve.support.Of(i).size();
    PutLittleEndian(out, static_cast<uint8_t>(std::min<size_t>(support, 255)));
  }
}

}  // namespace

void WriteSketchPly(const CurveSketch& sketch, std::ostream& out) {
  size_t num_vertices = 0;
  size_t num_edges = 0;
  for (const Curve3D& curve : sketch.curves) {
    num_vertices += curve.size();
    num_edges += NumEdges(curve);
  }
  out << "ply\nformat binary_little_endian 1.0\ncomment curve sketch by limn\n"
      << "element vertex " << num_vertices << '\n'
      << "property double x\nproperty double y\nproperty double z\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\n"
         "property double sigma\nproperty uchar support\n"
      << "element edge " << num_edges << '\n'
      << "property int vertex1\nproperty int vertex2\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int link\n"
         "end_header\n";
  for (size_t id = 0; id < sketch.curves.size(); ++id) {
    PutSamples(sketch.curves[id], ColorOfCurve(static_cast<int>(id)), out);
  }
  int32_t first = 0;
  for (size_t id = 0; id < sketch.curves.size(); ++id) {
    const Curve3D& curve = sketch.curves[id];
    const int32_t count = static_cast<int32_t>(curve.size());
    for (int32_t i = 0; i < static_cast<int32_t>(NumEdges(curve)); ++i) {
      PutLittleEndian(out, first + i);
      PutLittleEndian(out, first + (i + 1) % count);
      PutColor(out, ColorOfCurve(static_cast<int>(id)));
      PutLittleEndian(out, static_cast<int32_t>(id));
    }
    first += count;
  }
}

}  // namespace limn
