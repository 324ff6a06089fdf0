#include "limn/drawing/forks.h"

#include <cmath>

#include <gtest/gtest.h>

namespace limn {
namespace {

// A straight link of points 1 px apart that leaves node 0 at this angle in the xy plane.
DraftLink Ray(double angle_deg, int length_px) {
  DraftLink link;
  const double angle = angle_deg * M_PI / 180;
  for (int k = 0; k <= length_px; ++k) {
    link.position.push_back(k * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0));
    link.information.push_back(Eigen::Matrix3d::Identity());
    link.footprint.push_back(1);
    link.samples.emplace_back();
  }
  link.node[0] = 0;
  return link;
}

Draft Star(const std::vector<DraftLink>& links) {
  Draft draft;
  draft.links = links;
  draft.num_nodes = 1;
  return draft;
}

TEST(CutForksTest, StrandThatPartsSlowlyIsFreed) {
  // The short one goes on into the trunk, the long one turns more.
  Draft draft = Star({Ray(180, 40), Ray(15, 60), Ray(0, 30)});
  EXPECT_EQ(CutForks(DrawingOptions(), &draft), 1);
  EXPECT_EQ(draft.links[0].node[0], 0);
  EXPECT_EQ(draft.links[1].node[0], -1);
  EXPECT_EQ(draft.links[2].node[0], 0);
}

TEST(CutForksTest, TheLongerStaysIfBothTurnAlike) {
  Draft draft = Star({Ray(180, 40), Ray(10, 30), Ray(-10, 60)});
  EXPECT_EQ(CutForks(DrawingOptions(), &draft), 1);
  EXPECT_EQ(draft.links[1].node[0], -1);
  EXPECT_EQ(draft.links[2].node[0], 0);
}

TEST(CutForksTest, JunctionsAndPlainCornersStay) {
  Draft junction = Star({Ray(180, 40), Ray(30, 40), Ray(-30, 40)});
  EXPECT_EQ(CutForks(DrawingOptions(), &junction), 0);
  Draft hairpin = Star({Ray(10, 40), Ray(-10, 40)});
  EXPECT_EQ(CutForks(DrawingOptions(), &hairpin), 0);
}

TEST(CutForksTest, CornerWithADoubledEdgeKeepsItsThree) {
  Draft draft = Star({Ray(0, 40), Ray(90, 40), Ray(182, 40), Ray(5, 20)});
  EXPECT_EQ(CutForks(DrawingOptions(), &draft), 1);
  EXPECT_EQ(draft.links[3].node[0], -1);
}

}  // namespace
}  // namespace limn
