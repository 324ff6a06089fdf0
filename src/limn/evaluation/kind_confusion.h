// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <iosfwd>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "limn/model/curve_set.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// True curves by their kind, indexed by LinkKind.
using CurvesByKind = std::array<CurveSet, kNumLinkKinds>;

struct KindConfusionOptions {
  // A drawn place is of the kind of a true curve within this distance: in world units, or in pixel
  // footprints if there are views.
  double tau = 2;
  // Only what is inside counts.
  std::optional<Eigen::AlignedBox3d> region;
};

// Drawn length, world units, by kind of the true curve there (kUnknown: none is near) and by kind
// of the link.
struct KindConfusion {
  double tau = 0;
  std::array<std::array<double, kNumLinkKinds>, kNumLinkKinds> length = {};
};

// The kind of the drawn length against that of the nearest true curve. Edges, paint and rods come
// before shadows and contours that are nearer: these often run beside what causes them. Throws
// OptionError.
KindConfusion CompareKinds(const DrawingGraph& drawing, const CurvesByKind& truth,
                           const std::vector<View>& views, const KindConfusionOptions& options);

// The table as text.
void PrintKindConfusion(const KindConfusion& confusion, std::ostream& out);

}  // namespace limn
