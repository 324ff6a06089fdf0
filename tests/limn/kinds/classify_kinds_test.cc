// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/classify_kinds.h"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "limn/kinds/step_image.h"
#include "support/synthetic_image.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::FrontalPoint;
using testing::FrontalViews;
using testing::GaussianStep;
using testing::kFrontalPx;
using testing::Mix;
using testing::StepColor;

// Linear intensities, as sRGB.
StepColor Encoded(double red, double green, double blue) {
  StepColor color = {red, green, blue};
  for (double& value : color) value = 255 * (1.055 * std::pow(value, 1 / 2.4) - 0.055);
  return color;
}

// What a view shows along x in the band around one line of a plane.
struct Band {
  std::string name;
  double blur_px = 0.6;
  // Linear colors of both sides in a view whose light has this intensity.
  std::function<std::array<StepColor, 2>(int view, double light)> sides;
};

constexpr double kBandPx = 40;
constexpr double kLinePx = 80;

// Lines of a plane, one in the middle of every band, and the photographs of them.
class Plane {
 public:
  Plane(std::vector<Band> bands, std::vector<double> light_of_view)
      : bands_(std::move(bands)), light_(std::move(light_of_view)) {
    views_ = FrontalViews(static_cast<int>(light_.size()), 1, 0.05);
  }

  DrawingGraph Lines() const {
    DrawingGraph graph;
    for (size_t b = 0; b < bands_.size(); ++b) {
      DrawingLink link;
      const double x = MiddlePx(b);
      link.points_in_world = {FrontalPoint(x, -kLinePx / 2), FrontalPoint(x, kLinePx / 2)};
      link.sigma = {0, 0};
      for (NodeId* node : {&link.node0, &link.node1}) {
        *node = static_cast<NodeId>(graph.nodes.size());
        graph.nodes.emplace_back();
        graph.nodes.back().position_in_world = link.points_in_world[node == &link.node1];
      }
      for (size_t v = 0; v < views_.size(); ++v) {
        link.supporting_views.push_back(static_cast<ViewId>(v));
      }
      graph.links.push_back(link);
    }
    RebuildIncidence(&graph);
    EXPECT_TRUE(Validate(graph).empty());
    return graph;
  }

  Image Photograph(ViewId v) const {
    const double x0 = views_[v].Project(FrontalPoint(0, 0))->x();
    Image image = testing::ImageOf(640, 480, [&](double x, double) {
      const double along = x - x0 + kBandPx * static_cast<double>(bands_.size()) / 2;
      const auto b = static_cast<size_t>(
          std::clamp(along / kBandPx, 0.0, static_cast<double>(bands_.size()) - 1));
      const auto [left, right] = bands_[b].sides(v, light_[v]);
      const double beside = x - x0 - MiddlePx(b);
      const StepColor color = Mix(left, right, GaussianStep(beside / bands_[b].blur_px));
      return Encoded(color[0], color[1], color[2]);
    });
    testing::AddNoise(1, static_cast<unsigned>(v) + 1, &image);
    testing::Quantize(&image);
    return image;
  }

  DrawingGraph Classified(const DrawingGraph& graph, int num_threads = 1) const {
    RunContext context;
    context.num_threads = num_threads;
    const std::function<Image(ViewId)> read = [&](ViewId v) { return Photograph(v); };
    KindsResult result = ClassifyKinds({views_, read, graph}, context);
    EXPECT_TRUE(Validate(result.graph).empty());
    return result.graph;
  }

 private:
  double MiddlePx(size_t b) const {
    return kBandPx * (static_cast<double>(b) + 0.5 - static_cast<double>(bands_.size()) / 2);
  }

  std::vector<Band> bands_;
  std::vector<double> light_;
  std::vector<View> views_;
};

StepColor Times(double factor, const StepColor& color) {
  return {factor * color[0], factor * color[1], factor * color[2]};
}

constexpr StepColor kWall = {0.5, 0.45, 0.4};
constexpr StepColor kRed = {0.5, 0.08, 0.06};

// The background beside an object, which views see differently.
StepColor Background(int view) {
  return view % 3 == 0   ? StepColor{0.1, 0.12, 0.2}
         : view % 3 == 1 ? StepColor{0.25, 0.3, 0.1}
                         : StepColor{0.15, 0.05, 0.02};
}

Band Boundary() {
  return {"boundary", 0.6, [](int view, double light) -> std::array<StepColor, 2> {
            return {Times(light, kWall), Times(light, Background(view))};
          }};
}

Band PaintBand() {
  return {"paint", 0.6, [](int, double light) -> std::array<StepColor, 2> {
            return {Times(light, kWall), Times(light, kRed)};
          }};
}

Band Shadow(double blur_px) {
  return {"shadow", blur_px, [](int, double light) -> std::array<StepColor, 2> {
            return {Times(light, kWall), Times(0.5 * light, kWall)};
          }};
}

// Seen in one light only: elsewhere the wall is as bright on both sides.
Band ShadowOfOneLight() {
  return {"shadow of one light", 0.6, [](int, double light) -> std::array<StepColor, 2> {
            return {Times(light, kWall), Times(light == 1 ? 0.5 : light, kWall)};
          }};
}

const std::vector<double> kSteadyLight(8, 1.0);
const std::vector<double> kChangingLight = {1, 0.4, 1, 0.25, 1, 0.4, 1, 0.25};

TEST(ClassifyKindsTest, EdgesPaintAndSoftShadowsAreToldApart) {
  const Plane plane({Boundary(), PaintBand(), Shadow(2), Boundary(), PaintBand()}, kSteadyLight);
  const DrawingGraph graph = plane.Classified(plane.Lines());
  const LinkKind expected[] = {LinkKind::kEdge, LinkKind::kPaint, LinkKind::kShadow,
                               LinkKind::kEdge, LinkKind::kPaint};
  for (size_t l = 0; l < graph.links.size(); ++l) {
    EXPECT_EQ(graph.links[l].kind, expected[l]) << l;
    EXPECT_GT(graph.links[l].kind_confidence, 0.5) << l;
  }
}

TEST(ClassifyKindsTest, SharpShadowsAreToldByLightThatChanges) {
  const Plane plane({Boundary(), ShadowOfOneLight(), PaintBand(), Boundary(), PaintBand()},
                    kChangingLight);
  DrawingGraph graph = plane.Lines();
  // Its support: the views of the light that casts it.
  graph.links[1].supporting_views = {0, 2, 4, 6};
  graph = plane.Classified(graph);
  EXPECT_EQ(graph.links[1].kind, LinkKind::kShadow);
  EXPECT_EQ(graph.links[0].kind, LinkKind::kEdge);
  EXPECT_EQ(graph.links[2].kind, LinkKind::kPaint);
}

TEST(ClassifyKindsTest, BlurOfTheWholePhotographMakesNoShadows) {
  const auto blurred = [](Band band) {
    band.blur_px = 2;
    return band;
  };
  const Plane plane({blurred(Boundary()), blurred(PaintBand()), blurred(Boundary()),
                     blurred(Boundary()), blurred(PaintBand())},
                    kSteadyLight);
  for (const DrawingLink& link : plane.Classified(plane.Lines()).links) {
    EXPECT_NE(link.kind, LinkKind::kShadow);
  }
}

TEST(ClassifyKindsTest, ContoursStayAndTheUnseenIsUnknown) {
  const Plane plane({Boundary(), PaintBand(), Boundary()}, kSteadyLight);
  DrawingGraph graph = plane.Lines();
  graph.links[0].kind = LinkKind::kContour;
  graph.links[0].kind_confidence = 0.75;
  graph.links[1].supporting_views = {};
  graph.links[1].kind = LinkKind::kShadow;
  graph.links[1].kind_confidence = 0.9;
  graph = plane.Classified(graph);
  EXPECT_EQ(graph.links[0].kind, LinkKind::kContour);
  EXPECT_EQ(graph.links[0].kind_confidence, 0.75);
  EXPECT_EQ(graph.links[1].kind, LinkKind::kUnknown);
  EXPECT_EQ(graph.links[1].kind_confidence, 0);
  EXPECT_EQ(graph.links[2].kind, LinkKind::kEdge);
}

TEST(ClassifyKindsTest, ThreadsDoNotMatter) {
  const Plane plane({Boundary(), PaintBand(), Shadow(2)}, kSteadyLight);
  const DrawingGraph one = plane.Classified(plane.Lines(), 1);
  const DrawingGraph two = plane.Classified(plane.Lines(), 2);
  for (size_t l = 0; l < one.links.size(); ++l) {
    EXPECT_EQ(one.links[l].kind, two.links[l].kind);
    EXPECT_EQ(one.links[l].kind_confidence, two.links[l].kind_confidence);
  }
}

TEST(ClassifyKindsTest, SummaryCountsEveryLinkOnce) {
  const Plane plane({Boundary(), PaintBand(), Shadow(2)}, kSteadyLight);
  const std::vector<View> views = FrontalViews(8, 1, 0.05);
  const DrawingGraph graph = plane.Lines();
  const std::function<Image(ViewId)> read = [&](ViewId v) { return plane.Photograph(v); };
  const StageSummary summary = ClassifyKinds({views, read, graph}, {}).summary;
  int64_t sum = 0;
  for (const auto& [name, count] : summary.kept) sum += count;
  EXPECT_EQ(sum, 3);
}

// Variation between views, and what of it exposure does not explain.
constexpr SceneLight kSteady = {0.04, 0.04};
constexpr SceneLight kChanging = {0.4, 0.2};

KindEvidence Sharp(double chroma_change, double change_spread) {
  KindEvidence evidence;
  evidence.num_profiles = 50;
  evidence.num_views = 8;
  evidence.blur_ratio = 1.05;
  evidence.unevenness = 0.03;
  evidence.chroma_change = chroma_change;
  evidence.change_spread = evidence.darker_spread = evidence.brighter_spread = change_spread;
  return evidence;
}

TEST(ClassifyTest, EvidenceDecides) {
  EXPECT_EQ(Classify(Sharp(0.8, 0.04), kSteady).kind, LinkKind::kPaint);
  EXPECT_EQ(Classify(Sharp(0.1, 0.04), kSteady).kind, LinkKind::kEdge);
  // A background that changes shows that the surface ends.
  EXPECT_EQ(Classify(Sharp(0.5, 0.6), kSteady).kind, LinkKind::kEdge);
  KindEvidence soft = Sharp(0.1, 0.04);
  soft.blur_ratio = 2;
  EXPECT_EQ(Classify(soft, kSteady).kind, LinkKind::kShadow);
  EXPECT_GT(Classify(soft, kSteady).confidence, 0.9);
  // Paint that is out of focus is no shadow.
  soft.chroma_change = 0.8;
  EXPECT_NE(Classify(soft, kSteady).kind, LinkKind::kShadow);
  // Two profiles tell nothing.
  KindEvidence few = Sharp(0.8, 0.04);
  few.num_profiles = 2;
  EXPECT_EQ(Classify(few, kSteady).kind, LinkKind::kUnknown);
  EXPECT_EQ(Classify(few, kSteady).confidence, 0);
}

KindEvidence Soft(double change_spread, double side_spread) {
  KindEvidence evidence = Sharp(0.1, side_spread);
  evidence.blur_ratio = 2;
  evidence.change_spread = change_spread;
  return evidence;
}

TEST(ClassifyTest, SoftTextureIsNoShadow) {
  KindEvidence texture = Soft(0.04, 0.04);
  texture.unevenness = 0.3;
  EXPECT_EQ(Classify(texture, kSteady).kind, LinkKind::kUnknown);
  EXPECT_EQ(Classify(texture, kSteady).confidence, 0);
  texture.unevenness = std::numeric_limits<double>::infinity();  // too short to tell
  EXPECT_EQ(Classify(texture, kSteady).kind, LinkKind::kUnknown);
}

TEST(ClassifyTest, WhatSeveralLightsShowIsNoShadow) {
  // Light scales both sides of paint alike.
  EXPECT_EQ(Classify(Soft(0.05, 0.4), kChanging).kind, LinkKind::kPaint);
  EXPECT_GT(Classify(Soft(0.05, 0.4), kChanging).confidence, 0.8);
  // That of a rounded crease changes with the light.
  EXPECT_EQ(Classify(Soft(0.4, 0.4), kChanging).kind, LinkKind::kUnknown);
  EXPECT_EQ(Classify(Soft(0.03, 0.05), kChanging).kind, LinkKind::kShadow);
  // Steady only for want of views.
  KindEvidence few = Soft(0.03, 0.05);
  few.num_views = 2;
  EXPECT_EQ(Classify(few, kChanging).kind, LinkKind::kUnknown);
}

TEST(ClassifyTest, OnlyLightThatChangesTellsSharpShadows) {
  EXPECT_EQ(Classify(Sharp(0.1, 0.03), kChanging).kind, LinkKind::kShadow);
  EXPECT_EQ(Classify(Sharp(0.1, 0.03), kSteady).kind, LinkKind::kEdge);
  EXPECT_EQ(Classify(Sharp(0.1, 0.3), kChanging).kind, LinkKind::kEdge);
  EXPECT_EQ(Classify(Sharp(0.8, 0.03), kChanging).kind, LinkKind::kPaint);
}

TEST(ClassifyTest, ExposureIsNoLightThatChanges) {
  const SceneLight exposed = {0.4, 0.04};
  EXPECT_EQ(Classify(Sharp(0.1, 0.03), exposed).kind, LinkKind::kEdge);
  EXPECT_EQ(Classify(Soft(0.05, 0.4), exposed).kind, LinkKind::kShadow);
}

TEST(ClassifyTest, WhatALightOfTheSceneDoesNotSeeIsShadow) {
  KindEvidence cast = Sharp(0.1, 0.04);
  cast.share_behind = 0.8;
  EXPECT_EQ(Classify(cast, kSteady).kind, LinkKind::kShadow);
  EXPECT_EQ(Classify(cast, kSteady).confidence, 0.8);
  cast.share_behind = 0.5;
  EXPECT_EQ(Classify(cast, kSteady).kind, LinkKind::kEdge);
  // Light changes no color.
  cast = Sharp(0.8, 0.04);
  cast.share_behind = 0.8;
  EXPECT_EQ(Classify(cast, kSteady).kind, LinkKind::kPaint);
}

TEST(LightOfTest, IsThatOfTheSteadierSideOfMostLinks) {
  std::vector<KindEvidence> links(5, Sharp(0, 0.5));
  for (KindEvidence& link : links) {
    link.darker_spread = 0.02;  // backgrounds change
    link.steadier_spread_exposed = 0.01;
  }
  EXPECT_NEAR(LightOf(links).variation, 0.02, 1e-12);
  EXPECT_NEAR(LightOf(links).change, 0.01, 1e-12);
  for (KindEvidence& link : links) link.darker_spread = 0.4;
  EXPECT_NEAR(LightOf(links).variation, 0.4, 1e-12);
  for (KindEvidence& link : links) link.num_views = 2;
  EXPECT_EQ(LightOf(links).variation, 0);
  EXPECT_EQ(LightOf(links).change, 0);
}

}  // namespace
}  // namespace limn
