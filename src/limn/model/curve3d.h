// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "limn/model/curve_fragment.h"
#include "limn/model/view.h"

namespace limn {

// An edgel of a view.
struct EdgelRef {
  ViewId view = -1;
  EdgelId edgel = kInvalidEdgel;

  auto operator<=>(const EdgelRef&) const = default;
};

// Per-sample lists of supporting edgels, stored back to back. Sorted by view within a sample; at
// most one edgel per view.
struct SupportLists {
  std::vector<uint32_t> offsets = {0};  // one more than samples
  std::vector<EdgelRef> edgels;

  size_t NumSamples() const { return offsets.size() - 1; }
  std::span<const EdgelRef> Of(size_t sample) const {
    return {edgels.data() + offsets[sample], edgels.data() + offsets[sample + 1]};
  }
  void Append(std::span<const EdgelRef> of_sample) {
    edgels.insert(edgels.end(), of_sample.begin(), of_sample.end());
    offsets.push_back(static_cast<uint32_t>(edgels.size()));
  }
};

// The image curve a 3D curve was made from: samples come from every `step`-th vertex of the
// fragment, from `begin` on.
struct CurveAnchor {
  ViewId view = -1;
  int fragment = -1;
  int begin = 0;
  int step = 1;

  // The vertex of a sample: fragments of `fragment_size` vertices that are closed begin anew.
  size_t VertexOf(size_t sample, size_t fragment_size) const {
    return (begin + step * sample) % fragment_size;
  }
};

// A reconstructed curve, made by every sketch generator and used by the drawing.
struct Curve3D {
  std::vector<Eigen::Vector3d> points_in_world;
  // Unit vectors, in the direction of the points' order.
  std::vector<Eigen::Vector3d> tangents_in_world;
  // Standard deviation along the anchor's viewing ray, world units; infinity if unknown.
  std::vector<double> depth_sigma;
  // False where the depth is interpolated across a portion tangent to epipolar lines: this keeps
  // the topology but does not measure the geometry.
  std::vector<uint8_t> certain;
  CurveAnchor anchor;
  // Supporting edgels of each sample, the anchor's own edgel included.
  SupportLists support;
  bool closed = false;
  // Total support of the curve as a whole (algorithm/paper.md#original-sketch), which only the
  // original sketch uses; else 0.
  double total_support = 0;

  size_t size() const { return points_in_world.size(); }
};

// A curve sketch (original, enhanced or swept): an unorganized set of 3D curves.
struct CurveSketch {
  std::vector<Curve3D> curves;
};

}  // namespace limn
