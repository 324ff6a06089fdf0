// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/verify_links.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "limn/support/view_edgels.h"
#include "limn/topology/graph_editor.h"
#include "limn/topology/graph_fixture.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

// Two drawn links and what is known of them.
struct Scene {
  std::vector<View> views = testing::DomeViews(16, 5);
  testing::SceneCurve edge = testing::Segment({-0.2, 0, 0}, {0.2, 0, 0});
  std::vector<ImageCurves> curves = testing::ProjectCurves(views, {edge});
  CurveSketch sketch;
  DrawingGraph graph;

  // A link along x, made by these primary views, with which this many agree.
  void AddLink(const Eigen::Vector3d& offset, const std::vector<ViewId>& primaries, int agreeing) {
    AddLink(offset, primaries, agreeing, agreeing);
  }
  // So many on its first half, and on its second.
  void AddLink(const Eigen::Vector3d& offset, const std::vector<ViewId>& primaries, int agreeing,
               int agreeing_behind) {
    std::vector<SketchSample> samples;
    for (const ViewId view : primaries) {
      sketch.curves.emplace_back();
      sketch.curves.back().anchor.view = view;
      samples.push_back({static_cast<int>(sketch.curves.size()) - 1, 0});
    }
    DrawingLink link;
    for (int k = 0; k <= 20; ++k) {
      link.points_in_world.push_back(offset + Eigen::Vector3d(-0.15 + 0.015 * k, 0, 0));
      link.sigma.push_back(1);
      link.vertices.push_back({Eigen::Matrix3d::Identity(),
                               5.0 / 600,
                               k < 10 ? agreeing : agreeing_behind,
                               {},
                               samples});
    }
    GraphEditor(&graph).Add(std::move(link));
  }

  std::vector<uint8_t> Believed() const {
    testing::ExpectValid(graph);
    const auto support = BuildViewEdgels(curves, {});
    const TopologyInput input = {views, curves, support, {1.0, 1.0, M_PI / 12}};
    return VerifyLinks(input, sketch, options, graph, {});
  }

  TopologyOptions options;
};

using Believed = std::vector<uint8_t>;

TEST(VerifyLinksTest, AgreementOfEnoughPrimaryViewsIsEnough) {
  Scene scene;
  scene.AddLink({0, 0, 0.4}, {0, 1}, 4);  // no edgels there
  scene.AddLink({0, 0, 0.4}, {0, 1}, 1);
  EXPECT_EQ(scene.Believed(), (Believed{1, 0}));
}

TEST(VerifyLinksTest, EdgelsOfItsOwnMakeUpForAgreement) {
  Scene scene;
  scene.AddLink({0, 0, 0}, {0, 1}, 1);
  EXPECT_EQ(scene.Believed(), (Believed{1}));
}

TEST(VerifyLinksTest, EdgelsOfACertainLinkDoNotCount) {
  Scene scene;
  scene.AddLink({0, 0, 0}, {0, 1}, 1);
  scene.AddLink({0, 0, 0}, {2, 3}, 4);
  EXPECT_EQ(scene.Believed(), (Believed{0, 1}));
}

TEST(VerifyLinksTest, EdgelsThatAreEverywhereDoNotCount) {
  Scene scene;
  std::vector<testing::SceneCurve> edges = {scene.edge};
  for (const double px : {-10, -6, 6, 10}) {
    const double shift = px * 5 / 600;
    edges.push_back(testing::Segment({-0.2, shift, 0}, {0.2, shift, 0}));
    edges.push_back(testing::Segment({-0.2, 0, shift}, {0.2, 0, shift}));
  }
  scene.curves = testing::ProjectCurves(scene.views, edges);
  scene.AddLink({0, 0, 0}, {0, 1}, 1);
  EXPECT_EQ(scene.Believed(), (Believed{0}));
}

TEST(VerifyLinksTest, OnePrimaryViewIsNeverEnough) {
  Scene scene;
  scene.AddLink({0, 0, 0}, {0}, 4);
  EXPECT_EQ(scene.Believed(), (Believed{0}));
}

TEST(VerifyLinksTest, ViewsOfOneSampleEachAreTwoPrimaryViews) {
  // The same number of samples, of one view and of two.
  Scene scene;
  scene.AddLink({0, 0, 0.4}, {3, 3}, 4);
  scene.AddLink({0, 0, 0.4}, {3, 5}, 4);
  EXPECT_EQ(scene.Believed(), (Believed{0, 1}));
}

// Links where no image has an edgel, with which 1, 2, ... primary views agree, and 16 views contain
// them: the first that is believed, 0 if none.
int LeastAgreement(const TopologyOptions& options) {
  Scene scene;
  scene.options = options;
  for (int agreeing = 1; agreeing <= 16; ++agreeing) scene.AddLink({0, 0, 0.4}, {0, 1}, agreeing);
  const Believed believed = scene.Believed();
  const auto first = std::find(believed.begin(), believed.end(), 1);
  EXPECT_TRUE(std::all_of(first, believed.end(), [](uint8_t one) { return one == 1; }));
  return first == believed.end() ? 0 : static_cast<int>(first - believed.begin()) + 1;
}

TEST(VerifyLinksTest, PrimaryViewsNeededAreAShareWithinBounds) {
  TopologyOptions options;
  options.primary_views_share = 0.3;  // of 16: 4.8
  options.min_primary_views = 1;
  options.max_primary_views = 16;
  EXPECT_EQ(LeastAgreement(options), 5);
  options.primary_views_share = 0.55;  // 8.8
  EXPECT_EQ(LeastAgreement(options), 9);
  options.max_primary_views = 7;
  EXPECT_EQ(LeastAgreement(options), 7);
  options.primary_views_share = 0.05;  // 0.8
  EXPECT_EQ(LeastAgreement(options), 1);
  options.min_primary_views = 3;
  EXPECT_EQ(LeastAgreement(options), 3);
}

TEST(VerifyLinksTest, AgreementIsTheMeanOverTheLength) {
  Scene scene;
  scene.options.min_primary_views = 3;
  scene.AddLink({0, 0, 0.4}, {0, 1}, 1, 4);
  scene.AddLink({0, 0, 0.4}, {0, 1}, 2, 5);
  EXPECT_EQ(scene.Believed(), (Believed{0, 1}));
}

TEST(VerifyLinksTest, PointsThatWereAddedHaveNoSay) {
  // No sample agrees on the first half: it was bridged.
  Scene scene;
  scene.options.min_primary_views = 3;
  scene.AddLink({0, 0, 0.4}, {0, 1}, 0, 3);
  EXPECT_EQ(scene.Believed(), (Believed{1}));
}

// Views in two rows to either side of the link, so that no copy of it, wherever it is moved to,
// looks like the link itself: without other edges there is no background at all. So many views show
// the link.
Scene SceneInRows(ViewId num_shown) {
  Scene scene;
  scene.views.clear();
  for (const double side : {-1.5, 1.5}) {
    for (const View& view : testing::FrontalViews(8, 1, 0.3)) {
      scene.views.push_back(view);
      const Eigen::Vector3d aside(0, side, 0);
      View& moved = scene.views.back();
      moved.cam_from_world.translation -= moved.cam_from_world.rotation * aside;
    }
  }
  scene.curves.clear();
  for (size_t v = 0; v < scene.views.size(); ++v) {
    std::vector<testing::SceneCurve> shown;
    if (static_cast<ViewId>(v) % 8 * 2 + static_cast<ViewId>(v) / 8 < num_shown) {
      shown.push_back(scene.edge);
    }
    scene.curves.push_back(testing::ProjectCurves(scene.views[v], shown));
  }
  return scene;
}

// The least number of views that must show a link that too few primary views agree with.
int LeastOwnViews(const TopologyOptions& options) {
  for (ViewId num_shown = 0; num_shown <= 16; ++num_shown) {
    Scene scene = SceneInRows(num_shown);
    scene.options = options;
    scene.AddLink({0, 0, 0}, {0, 1}, 1);
    if (scene.Believed() == Believed{1}) return num_shown;
  }
  return -1;
}

TEST(VerifyLinksTest, OwnViewsNeededAreAShareWithinBounds) {
  TopologyOptions options;
  options.own_views_share = 0.3;  // of 16: 4.8
  options.min_own_views = 0;
  options.max_own_views = 16;
  EXPECT_EQ(LeastOwnViews(options), 5);
  options.own_views_share = 0.55;  // 8.8
  EXPECT_EQ(LeastOwnViews(options), 9);
  options.max_own_views = 7;
  EXPECT_EQ(LeastOwnViews(options), 7);
  options.own_views_share = 0.05;  // 0.8
  EXPECT_EQ(LeastOwnViews(options), 1);
  options.min_own_views = 3;
  EXPECT_EQ(LeastOwnViews(options), 3);
}

// Edges on all sides of the link, at the distances of pixels.
void ShowBesides(Scene* scene, size_t num_views) {
  for (size_t v = 0; v < num_views; ++v) {
    std::vector<testing::SceneCurve> shown;
    if (!scene->curves[v].fragments.empty()) shown.push_back(scene->edge);
    for (int px = 4; px <= 14; ++px) {
      for (const double sign : {-1.0, 1.0}) {
        const double y = sign * px * 5 / 600;
        shown.push_back(testing::Segment({-0.2, y, 0}, {0.2, y, 0}));
      }
    }
    scene->curves[v] = testing::ProjectCurves(scene->views[v], shown);
  }
}

TEST(VerifyLinksTest, EdgelsBesideItCountAgainstIt) {
  // Shown by six views, where three are enough.
  Scene alone = SceneInRows(6);
  alone.AddLink({0, 0, 0}, {0, 1}, 1);
  EXPECT_EQ(alone.Believed(), (Believed{1}));
  Scene scene = SceneInRows(6);
  ShowBesides(&scene, scene.views.size());
  scene.AddLink({0, 0, 0}, {0, 1}, 1);
  EXPECT_EQ(scene.Believed(), (Believed{0}));
}

TEST(VerifyLinksTest, EdgelsBesideItCountAgainstItEvenIfTheyAreKnown) {
  // All that is beside it belongs to certain links.
  Scene scene = SceneInRows(6);
  ShowBesides(&scene, scene.views.size());
  scene.AddLink({0, 0, 0}, {0, 1}, 1);
  for (int px = 4; px <= 14; ++px) {
    for (const double sign : {-1.0, 1.0}) scene.AddLink({0, sign * px * 5 / 600, 0}, {0, 1}, 4);
  }
  EXPECT_EQ(scene.Believed().front(), 0);
}

TEST(VerifyLinksTest, EdgelsNextToAClaimedOneAreClaimed) {
  // A certain link runs a pixel beside an uncertain one, and both have edgels.
  const auto believed = [](double beside_px) {
    Scene scene = SceneInRows(16);
    const Eigen::Vector3d aside(0, beside_px * 5 / 640, 0);
    for (size_t v = 0; v < scene.views.size(); ++v) {
      scene.curves[v] = testing::ProjectCurves(
          scene.views[v], {scene.edge, testing::Segment(scene.edge.points.front() + aside,
                                                        scene.edge.points.back() + aside)});
    }
    scene.AddLink({0, 0, 0}, {0, 1}, 1);
    scene.AddLink(aside, {2, 3}, 4);
    return scene.Believed();
  };
  EXPECT_EQ(believed(1.2), (Believed{0, 1}));
  EXPECT_EQ(believed(3), (Believed{1, 1}));
}

}  // namespace
}  // namespace limn
