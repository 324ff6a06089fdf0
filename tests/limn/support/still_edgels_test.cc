#include "limn/support/still_edgels.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::FrontalPoint;
using testing::FrontalViews;
using testing::ProjectCurves;
using testing::Segment;

constexpr int kStillCount = 30;

// Adds a horizontal fragment of edgels 1 px apart.
void AddRow(double x_px, double y_px, ImageCurves* curves) {
  CurveFragment fragment;
  for (int k = 0; k < kStillCount; ++k) {
    Edgel edgel;
    edgel.position_px = {x_px + k, y_px};
    edgel.stored_px = edgel.position_px.cast<float>();
    edgel.strength = 1;
    fragment.edgel_ids.push_back(static_cast<EdgelId>(curves->edge_map.edgels.size()));
    curves->edge_map.edgels.push_back(edgel);
  }
  curves->fragments.push_back(fragment);
}

struct StillScene {
  std::vector<View> views;
  std::vector<ImageCurves> curves;  // first the edge of the scene, then a row at one place

  explicit StillScene(std::vector<View> of_scene, size_t num_with_row = 1000)
      : views(std::move(of_scene)) {
    for (size_t v = 0; v < views.size(); ++v) {
      curves.push_back(
          ProjectCurves(views[v], {Segment(FrontalPoint(-50, 3), FrontalPoint(50, 40))}, 0, 0));
      if (v < num_with_row) AddRow(100, 400, &curves.back());
    }
  }

  // Of the first view, whether the edgels of each fragment are all still; fails if only some are.
  std::vector<bool> StillFragments() const {
    const std::vector<bool> still = StillEdgels(views, curves, {}).In(0, curves[0]);
    std::vector<bool> fragments;
    for (const CurveFragment& fragment : curves[0].fragments) {
      const auto count = std::ranges::count_if(fragment.edgel_ids,
                                               [&](EdgelId id) { return bool{still[id]}; });
      EXPECT_TRUE(count == 0 || count == static_cast<int64_t>(fragment.edgel_ids.size()));
      fragments.push_back(count > 0);
    }
    return fragments;
  }
};

TEST(StillEdgelsTest, WhatStaysAtItsPixelsWhileTheCameraMoves) {
  EXPECT_EQ(StillScene(FrontalViews(3, 2, 0.3)).StillFragments(), (std::vector<bool>{false, true}));
  EXPECT_EQ(StillScene(FrontalViews(6, 6, 0.1)).StillFragments(), (std::vector<bool>{false, true}));
}

TEST(StillEdgelsTest, MostViewsMustHaveIt) {
  EXPECT_EQ(StillScene(FrontalViews(4, 4, 0.3), 8).StillFragments(), (std::vector<bool>{false, false}));
  EXPECT_EQ(StillScene(FrontalViews(4, 4, 0.3), 9).StillFragments(), (std::vector<bool>{false, true}));
}

TEST(StillEdgelsTest, FewViewsTellNothing) {
  EXPECT_EQ(StillScene(FrontalViews(5, 1, 0.3)).StillFragments(), (std::vector<bool>{false, false}));
  EXPECT_TRUE(StillEdgels::ViewsToCompare(FrontalViews(5, 1, 0.3)).empty());
}

TEST(StillEdgelsTest, OnePoseInManyLightsIsNoMotion) {
  std::vector<View> views = FrontalViews(3, 1, 0.3);
  for (int light = 0; light < 3; ++light) {
    for (int pose = 0; pose < 3; ++pose) views.push_back(views[pose]);
  }
  EXPECT_EQ(StillScene(views).StillFragments(), (std::vector<bool>{false, false}));
}

TEST(StillEdgelsTest, PhotographsOfOtherSizesAreNotCompared) {
  std::vector<View> views = FrontalViews(4, 2, 0.3);
  for (size_t v = 4; v < views.size(); ++v) views[v].camera.width += 2;
  EXPECT_EQ(StillScene(views).StillFragments(), (std::vector<bool>{false, false}));
}

TEST(StillEdgelsTest, AtMost24ViewsAreCompared) {
  EXPECT_EQ(StillEdgels::ViewsToCompare(FrontalViews(10, 10, 0.1)).size(), 24u);
}

}  // namespace
}  // namespace limn
