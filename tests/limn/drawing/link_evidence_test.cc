#include "limn/drawing/link_evidence.h"

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

// Two drawn links and what is known of them.
struct Scene {
  std::vector<View> views = testing::DomeViews(16, 5);
  testing::SceneCurve edge = testing::Segment({-0.2, 0, 0}, {0.2, 0, 0});
  std::vector<ImageCurves> curves = testing::ProjectCurves(views, {edge});
  SampleSet samples;
  std::vector<int> agreeing_views;
  Draft draft;

  // A link along x, made by these primary views, with which so many agree.
  void AddLink(const Eigen::Vector3d& offset, const std::vector<ViewId>& primaries, int agreeing) {
    std::vector<int> merged;
    for (const ViewId view : primaries) {
      samples.origins.push_back({0, 0, view, false});
      samples.curve_of.push_back(samples.NumCurves() - 1);
      samples.position.push_back(offset);
      agreeing_views.push_back(agreeing);
      merged.push_back(samples.NumSamples() - 1);
    }
    DraftLink link;
    for (int k = 0; k <= 20; ++k) {
      link.position.push_back(offset + Eigen::Vector3d(-0.15 + 0.015 * k, 0, 0));
      link.information.push_back(Eigen::Matrix3d::Identity());
      link.footprint.push_back(5.0 / 600);
      link.samples.push_back(merged);
    }
    draft.links.push_back(link);
  }

  std::vector<uint8_t> Believed() const {
    const DrawingOptions options;
    const auto evidence = BuildEvidence(curves, {});
    return BelievedLinks({samples, agreeing_views, views, curves, evidence}, options, draft, {});
  }
};

using Believed = std::vector<uint8_t>;

TEST(BelievedLinksTest, AgreementOfEnoughPrimaryViewsIsEnough) {
  Scene scene;
  scene.AddLink({0, 0, 0.4}, {0, 1}, 4);  // no edgels there
  scene.AddLink({0, 0, 0.4}, {0, 1}, 1);
  EXPECT_EQ(scene.Believed(), (Believed{1, 0}));
}

TEST(BelievedLinksTest, EdgelsOfItsOwnMakeUpForAgreement) {
  Scene scene;
  scene.AddLink({0, 0, 0}, {0, 1}, 1);
  EXPECT_EQ(scene.Believed(), (Believed{1}));
}

TEST(BelievedLinksTest, EdgelsOfACertainLinkDoNotCount) {
  Scene scene;
  scene.AddLink({0, 0, 0}, {0, 1}, 1);
  scene.AddLink({0, 0, 0}, {2, 3}, 4);
  EXPECT_EQ(scene.Believed(), (Believed{0, 1}));
}

TEST(BelievedLinksTest, EdgelsThatAreEverywhereDoNotCount) {
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

TEST(BelievedLinksTest, OnePrimaryViewIsNeverEnough) {
  Scene scene;
  scene.AddLink({0, 0, 0}, {0}, 4);
  EXPECT_EQ(scene.Believed(), (Believed{0}));
}

}  // namespace
}  // namespace limn
