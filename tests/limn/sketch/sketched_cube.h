// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "limn/evaluation/evaluate_curves.h"
#include "support/synthetic_scene.h"

namespace limn::testing {

// The edges of a cube, seen without noise: what every sketch should find.
constexpr double kCubeHalfSide = 0.8;

inline const std::vector<View>& CubeViews() {
  static const std::vector<View> views = DomeViews(16, 5);
  return views;
}

inline const std::vector<ImageCurves>& CubeCurves() {
  static const std::vector<ImageCurves> curves =
      ProjectCurves(CubeViews(), CubeEdges(kCubeHalfSide));
  return curves;
}

inline TauResult EvaluateCube(const CurveSketch& sketch, double tau) {
  CurveSet truth;
  truth.polylines = Polylines(CubeEdges(kCubeHalfSide));
  EvaluationOptions options;
  options.taus = {tau};
  options.find_duplicates = false;
  const TauResult row =
      EvaluateCurvesInFootprints(ToCurveSet(sketch), truth, CubeViews(), options).rows.at(0);
  ::testing::Test::RecordProperty("recall", std::to_string(row.recall.value()));
  ::testing::Test::RecordProperty("precision", std::to_string(row.precision.value()));
  return row;
}

// Arrays of equal length, unit tangents along the curve, support sorted by view and with the
// anchor's own edgel.
inline void ExpectSoundCube(const CurveSketch& sketch) {
  ASSERT_FALSE(sketch.curves.empty());
  for (const Curve3D& curve : sketch.curves) {
    ASSERT_GE(curve.size(), 2u);
    ASSERT_EQ(curve.tangents_in_world.size(), curve.size());
    ASSERT_EQ(curve.depth_sigma.size(), curve.size());
    ASSERT_EQ(curve.certain.size(), curve.size());
    ASSERT_EQ(curve.support.NumSamples(), curve.size());
    const auto& ids =
        CubeCurves().at(curve.anchor.view).fragments.at(curve.anchor.fragment).edgel_ids;
    for (size_t s = 0; s < curve.size(); ++s) {
      EXPECT_NEAR(curve.tangents_in_world[s].norm(), 1, 1e-9);
      const EdgelRef own{curve.anchor.view, ids[curve.anchor.VertexOf(s, ids.size())]};
      const auto support = curve.support.Of(s);
      EXPECT_TRUE(std::binary_search(support.begin(), support.end(), own));
      for (size_t k = 1; k < support.size(); ++k) EXPECT_LT(support[k - 1].view, support[k].view);
    }
  }
}

}  // namespace limn::testing
