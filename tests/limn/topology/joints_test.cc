// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/joints.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "limn/topology/frontal_scene.h"

namespace limn {
namespace {

using testing::FrontalPoint;
using testing::FrontalScene;
using testing::kFrontalPx;
using testing::PxSegment;

TEST(CollectJointsTest, EndsAtANodeAreOneJoint) {
  FrontalScene scene;
  scene.Draw(PxSegment(0, 0, 60, 0));
  scene.Draw(PxSegment(0, 40, 0, 0));
  const Joint corner = scene.JointAt(FrontalPoint(0, 0));
  EXPECT_EQ(scene.graph.nodes.at(corner.node).incident, (std::vector<LinkEnd>{{0, 0}, {1, 1}}));
  EXPECT_EQ(corner.position, FrontalPoint(0, 0));
  EXPECT_NEAR(corner.footprint, kFrontalPx, 1e-12);
  ASSERT_EQ(corner.leaving.size(), 2u);
  EXPECT_LT((corner.leaving[0] - Eigen::Vector3d::UnitX()).norm(), 1e-6);
  EXPECT_LT((corner.leaving[1] - Eigen::Vector3d::UnitY()).norm(), 1e-6);
  // Free ends have joints of their own.
  for (const auto& [x, y] : {std::pair(60, 0), std::pair(0, 40)}) {
    EXPECT_EQ(scene.graph.nodes.at(scene.JointAt(FrontalPoint(x, y)).node).Degree(), 1);
  }
}

TEST(CollectJointsTest, LoopsHaveNone) {
  FrontalScene scene;
  scene.Draw(testing::RingThroughOrigin(40));
  scene.Build();
  EXPECT_TRUE(CollectJoints(scene.graph, scene.views().size()).empty());
}

TEST(CollectJointsTest, LinksLeaveAsTheirLastPixelsRun) {
  FrontalScene scene;
  scene.Draw({{0, 0}, {20, 0}, {20, 60}});
  EXPECT_LT((scene.JointAt(FrontalPoint(0, 0)).leaving[0] - Eigen::Vector3d::UnitX()).norm(), 1e-6);
  EXPECT_LT((scene.JointAt(FrontalPoint(20, 60)).leaving[0] + Eigen::Vector3d::UnitY()).norm(),
            1e-6);
}

TEST(CollectJointsTest, ViewsThatSupportALinkNearTheJointSeeIt) {
  FrontalScene scene;
  scene.Draw(PxSegment(0, 0, 60, 0));
  scene.Show(PxSegment(0, 0, 20, 0), {0, 5});
  scene.Show(PxSegment(40, 0, 60, 0), {5, 7});
  scene.Show(PxSegment(20, 0, 40, 0), {9});  // nowhere near an end
  std::vector<uint8_t> first(16, 0);
  first[0] = first[5] = 1;
  EXPECT_EQ(scene.JointAt(FrontalPoint(0, 0)).visible, first);
  std::vector<uint8_t> last(16, 0);
  last[5] = last[7] = 1;
  EXPECT_EQ(scene.JointAt(FrontalPoint(60, 0)).visible, last);
}

TEST(CollectJointsTest, AllLinksOfAJointMakeItVisible) {
  FrontalScene scene;
  scene.ShowAndDraw(PxSegment(0, 0, 60, 0), {1});
  scene.ShowAndDraw(PxSegment(0, 0, 0, 60), {3});
  std::vector<uint8_t> both(16, 0);
  both[1] = both[3] = 1;
  EXPECT_EQ(scene.JointAt(FrontalPoint(0, 0)).visible, both);
}

TEST(IsTakenTest, DirectionsNearALinksAre) {
  FrontalScene scene;
  scene.Draw(PxSegment(0, 0, 60, 0));
  scene.Draw(PxSegment(0, 0, 0, 60));
  const Joint joint = scene.JointAt(FrontalPoint(0, 0));
  const auto taken = [&](double angle) {
    return IsTaken(joint, {std::cos(angle), std::sin(angle), 0});
  };
  EXPECT_TRUE(taken(0.34));
  EXPECT_TRUE(taken(-0.34));
  EXPECT_FALSE(taken(0.36));
  EXPECT_TRUE(taken(M_PI / 2 + 0.34));
  EXPECT_FALSE(taken(M_PI));
  EXPECT_FALSE(IsTaken(Joint(), {1, 0, 0}));
}

TEST(SupportAtTest, EdgelsOfTheViewsAskedAreFound) {
  const auto views = testing::FrontalViews(3, 1, 0.75);
  const auto curves =
      testing::ProjectCurves(views, {testing::Segment(FrontalPoint(0, 0), FrontalPoint(20, 0))});
  const auto support = BuildViewEdgels(curves, {});
  const TopologyInput input = {views, curves, support, {}};
  const auto views_at = [&](const Eigen::Vector3d& point, const Eigen::Vector3d& direction) {
    std::vector<ViewId> found;
    for (const EdgelRef& ref : SupportAt(input, point, direction, {0, 2}, {1.5, 1.5, 0.4})) {
      found.push_back(ref.view);
    }
    return found;
  };
  EXPECT_EQ(views_at(FrontalPoint(10, 1.4), {1, 0, 0}), (std::vector<ViewId>{0, 2}));
  EXPECT_TRUE(views_at(FrontalPoint(10, 1.6), {1, 0, 0}).empty());
  EXPECT_TRUE(views_at(FrontalPoint(10, 0), {0, 1, 0}).empty());
}

// A link that ends at the origin, an edge that leaves it along y, and another link.
class AddStraightLinkTest : public ::testing::Test {
 protected:
  AddStraightLinkTest() {
    scene_.ShowAndDraw(PxSegment(-60, 0, 0, 0));
    scene_.Show(PxSegment(0, 0, 0, 20), {0, 1, 2, 3});
    scene_.Draw(PxSegment(-60, 40, 0, 40));
    scene_.Build();
    joints_ = CollectJoints(scene_.graph, scene_.views().size());
    if (joints_[0].position != FrontalPoint(0, 0)) std::swap(joints_[0], joints_[1]);
  }

  void Add(double x_px, double y_px, const std::vector<ViewId>& in_views, Joint* target) {
    GraphEditor editor(&scene_.graph);
    AddStraightLink(scene_.Input(), FrontalPoint(x_px, y_px), in_views, &joints_[0], target,
                    &editor);
    testing::ExpectValid(scene_.graph);
  }

  FrontalScene scene_;
  std::vector<Joint> joints_;
};

TEST_F(AddStraightLinkTest, PointsKnowTheEdgelsOfTheViewsGiven) {
  Add(0, 20, {1, 2, 3, 7}, nullptr);
  const DrawingLink& link = scene_.graph.links.back();
  EXPECT_EQ(link.points_in_world.front(), FrontalPoint(0, 0));
  EXPECT_EQ(link.points_in_world.back(), FrontalPoint(0, 20));
  EXPECT_NEAR(LengthPx(link), 20, 1e-9);
  EXPECT_EQ(NumSketchSamples(link), 0);
  for (int k = 0; k < link.size(); ++k) {
    const LinkVertex& vertex = link.vertices[k];
    std::vector<ViewId> views;
    for (const EdgelRef& ref : vertex.support) views.push_back(ref.view);
    EXPECT_EQ(views, (std::vector<ViewId>{1, 2, 3})) << k;
    EXPECT_NEAR(vertex.footprint, kFrontalPx, 1e-12);
    // Known across the link, not along it, and the sigma is of that.
    EXPECT_LT((vertex.information * Eigen::Vector3d::UnitY()).norm(),
              1e-9 * vertex.information.norm());
    EXPECT_GT(vertex.information(0, 0), 0);
    EXPECT_EQ(link.sigma[k], SigmaAcross(vertex.information, vertex.footprint));
  }
}

TEST_F(AddStraightLinkTest, JointsKnowTheNewLink) {
  Add(0, 20, {0, 1, 2, 3}, nullptr);
  EXPECT_EQ(joints_[0].leaving.back(), Eigen::Vector3d::UnitY());
  EXPECT_EQ(scene_.Degree(0, 0), 2);
  EXPECT_EQ(scene_.Degree(0, 20), 1);
}

TEST_F(AddStraightLinkTest, TargetIsItsEnd) {
  Joint* target = &joints_[2];
  ASSERT_EQ(target->position, FrontalPoint(-60, 40));
  Add(-60, 40, {}, target);
  EXPECT_EQ(scene_.graph.links.back().node1, target->node);
  EXPECT_EQ(target->leaving.back(), -joints_[0].leaving.back());
  EXPECT_EQ(scene_.Degree(-60, 40), 2);
}

TEST_F(AddStraightLinkTest, LinesAlongLinksAreTaken) {
  EXPECT_FALSE(IsTaken(joints_[0], FrontalPoint(0, 20), nullptr));
  EXPECT_TRUE(IsTaken(joints_[0], FrontalPoint(-50, 5), nullptr));
  // At the target alone.
  EXPECT_FALSE(IsTaken(joints_[0], joints_[2].position, &joints_[2]));
  joints_[2].leaving.push_back((joints_[0].position - joints_[2].position).normalized());
  EXPECT_TRUE(IsTaken(joints_[0], joints_[2].position, &joints_[2]));
}

}  // namespace
}  // namespace limn
