// SPDX-License-Identifier: BSD-3-Clause
#include "limn/dense/fuse_drawing.h"

#include <algorithm>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/dense/plate_scene.h"

namespace limn {
namespace {

using testing::kPlateHalf;

enum Curve { kPaint, kRim, kAir, kBelow, kNumCurves };

DrawingGraph PlateDrawing() {
  constexpr double h = kPlateHalf;
  return testing::GraphOf({{{-0.3, 0.1, 0}, {0.3, 0.1, 0}},
                           {{-h, h, 0}, {h, h, 0}},
                           {{-0.1, 0, 0.15}, {0.1, 0, 0.15}},
                           {{-0.1, 0, -0.15}, {0.1, 0, -0.15}}});
}

const FusionResult& Fused() {
  static const DrawingGraph graph = PlateDrawing();
  static const FusionResult result = FuseDrawing(
      {testing::PlateViews(), graph, testing::PlateDepths(), true, std::nullopt}, {}, {});
  return result;
}

TEST(FuseDrawing, LinksGetTheirClasses) {
  const std::vector<LinkDense>& links = Fused().classes.links;
  ASSERT_EQ(links.size(), size_t{kNumCurves});
  EXPECT_EQ(links[kPaint].dense_class, DenseClass::kSurface);
  EXPECT_LT(links[kPaint].fold_deg, 1);
  EXPECT_EQ(links[kRim].dense_class, DenseClass::kBoundary);
  EXPECT_EQ(links[kAir].dense_class, DenseClass::kFree);
  EXPECT_DOUBLE_EQ(links[kAir].added_share, 1);
  for (const Curve curve : {kPaint, kRim, kAir}) EXPECT_FALSE(links[curve].behind_surface);
  EXPECT_TRUE(links[kBelow].behind_surface);
  EXPECT_DOUBLE_EQ(links[kBelow].occluded_share, 1);
  for (size_t l = 0; l < links.size(); ++l) {
    EXPECT_EQ(Fused().graph.links[l].dense->dense_class, links[l].dense_class);
  }
}

TEST(FuseDrawing, LengthsAddUp) {
  const auto length = [](DenseClass of) { return LengthOf(of, Fused().samples, Fused().classes); };
  EXPECT_NEAR(length(DenseClass::kSurface), 0.6, 0.03);
  EXPECT_NEAR(length(DenseClass::kBoundary), 1.2, 0.06);
  EXPECT_NEAR(length(DenseClass::kFree), 0.2, 1e-9);
  EXPECT_NEAR(LengthAdded(Fused().samples, Fused().classes), 0.2, 1e-9);
  EXPECT_NEAR(LengthBehind(Fused().samples, Fused().classes), 0.2, 1e-9);
}

TEST(FuseDrawing, PointsKnowTheirFaces) {
  size_t num_paint = 0;
  for (const CurvePoint& point : Fused().points) {
    EXPECT_NE(point.link, LinkId{kBelow});
    if (point.link == LinkId{kAir}) {
      EXPECT_FALSE(point.HasNormal());
      EXPECT_NEAR(point.Outward(testing::PlateViews()).dot(point.tangent), 0, 1e-9);
    }
    if (point.link != LinkId{kPaint}) continue;
    ++num_paint;
    // One face on both sides.
    EXPECT_GT(point.normals[0].z(), 0.999);
    EXPECT_EQ(point.normals[1].norm(), 0);
    EXPECT_EQ(point.views.size(), testing::PlateViews().size());
  }
  EXPECT_NEAR(static_cast<double>(num_paint), 0.6 / testing::kPlatePx, 8);
}

TEST(FuseDrawing, WithoutOccludedKeepsTheRest) {
  const DrawingGraph kept = WithoutOccluded(Fused().graph);
  EXPECT_EQ(kept.links.size(), size_t{kNumCurves} - 1);
  EXPECT_TRUE(Validate(kept).empty());
}

TEST(FuseDrawing, AViewThatIsNotASupporterHasNoSay) {
  DrawingGraph graph = PlateDrawing();
  graph.links[kBelow].supporting_views.clear();
  const FusionResult result = FuseDrawing(
      {testing::PlateViews(), graph, testing::PlateDepths(), true, std::nullopt}, {}, {});
  EXPECT_FALSE(result.classes.links[kBelow].behind_surface);
}

// Makes the depths around a line far.
void PutFar(ViewId view, const Polyline3d& line, DepthImage* image) {
  for (int k = 0; k <= 100; ++k) {
    const Eigen::Vector3d at = line.front() + 0.01 * k * (line.back() - line.front());
    const Eigen::Vector2i cell = image->CellAt(*testing::PlateViews()[view].Project(at));
    for (int dy = -8; dy <= 8; ++dy) {
      for (int dx = -8; dx <= 8; ++dx) {
        image->depth[image->Index(cell.x() + dx, cell.y() + dy)] = 1e3f;
      }
    }
  }
}

// Three views find the surface far behind everything near that link.
TEST(FuseDrawing, ALinkThatEnoughViewsSeeIsNotBehind) {
  const DrawingGraph graph = PlateDrawing();
  const DepthSource plate = testing::PlateDepths();
  const DepthSource some = [&](ViewId view) {
    auto image = plate(view);
    if (view < 3) PutFar(view, graph.links[kBelow].points_in_world, &*image);
    return image;
  };
  const auto behind = [&](double enough) {
    DenseOptions options;
    options.enough_visible_views = enough;
    return FuseDrawing({testing::PlateViews(), graph, some, true, std::nullopt}, options, {})
        .classes.links[kBelow]
        .behind_surface;
  };
  ASSERT_GT(testing::PlateViews().size(), 6u);  // most still hide it
  EXPECT_FALSE(behind(2.9));
  EXPECT_TRUE(behind(3.1));
}

TEST(FuseDrawing, CloudDecidesWhatIsAdded) {
  const DensePointStream none = [](const DensePointVisitor&) {};
  const DrawingGraph graph = PlateDrawing();
  const FusionResult result =
      FuseDrawing({testing::PlateViews(), graph, testing::PlateDepths(), true, none}, {}, {});
  EXPECT_EQ(result.classes.links[kPaint].dense_class, DenseClass::kSurface);
  EXPECT_EQ(result.classes.links[kPaint].added_share, 1);
  EXPECT_NEAR(LengthAdded(result.samples, result.classes), 0.6 + 1.2 + 0.2, 0.1);
}

TEST(FuseDrawing, EmptyDrawingAndNoDepths) {
  const DrawingGraph empty;
  EXPECT_TRUE(
      FuseDrawing({testing::PlateViews(), empty, testing::PlateDepths(), true, std::nullopt}, {},
                  {})
          .points.empty());
  const DepthSource nothing = [](ViewId) { return std::nullopt; };
  const DrawingGraph graph = PlateDrawing();
  const FusionResult result =
      FuseDrawing({testing::PlateViews(), graph, nothing, true, std::nullopt}, {}, {});
  for (const LinkDense& link : result.classes.links) {
    EXPECT_FALSE(link.behind_surface);
    EXPECT_EQ(link.dense_class, DenseClass::kUnknown);
  }
  EXPECT_EQ(result.trust.num_views, 0u);
  EXPECT_FALSE(result.trust.is_believed);
  EXPECT_TRUE(result.trust.has_few_depths);
}

// Depths of the plate and the drawing of it, seen by all views, that were changed by this.
template <typename Change>
FusionResult FuseWith(const Change& change) {
  static const DrawingGraph graph = PlateDrawing();
  const DepthSource plate = testing::PlateDepths();
  const DepthSource changed = [&](ViewId view) {
    auto image = plate(view);
    change(view, &*image);
    return image;
  };
  return FuseDrawing({testing::PlateViews(), graph, changed, true, std::nullopt}, {}, {});
}

void ExpectNothingIsJudged(const FusionResult& result) {
  EXPECT_FALSE(result.trust.is_believed);
  for (const LinkDense& link : result.classes.links) {
    EXPECT_EQ(link.dense_class, DenseClass::kUnknown);
    EXPECT_FALSE(link.behind_surface);
  }
  EXPECT_FALSE(result.points.empty());
}

TEST(FuseDrawing, DepthsOfAnotherScaleJudgeNothing) {
  for (const float factor : {0.5F, 1.2F, 100.0F}) {
    const FusionResult result = FuseWith([=](ViewId, DepthImage* image) {
      for (float& depth : image->depth) depth *= factor;
    });
    ExpectNothingIsJudged(result);
    EXPECT_EQ(result.trust.cause.kind, DepthCause::Kind::kFactor);
    EXPECT_NEAR(result.trust.cause.factor / factor, 1, 0.02);
  }
}

TEST(FuseDrawing, OtherDepthsJudgeNothingEither) {
  const FusionResult inverse = FuseWith([](ViewId, DepthImage* image) {
    for (float& depth : image->depth) depth = depth > 0 ? 1 / depth : 0;
  });
  ExpectNothingIsJudged(inverse);
  EXPECT_EQ(inverse.trust.cause.kind, DepthCause::Kind::kInverse);
  const FusionResult shifted = FuseWith([](ViewId, DepthImage* image) {
    const int by = image->width / 4;
    std::rotate(image->depth.begin(), image->depth.end() - by, image->depth.end());
  });
  ExpectNothingIsJudged(shifted);
  EXPECT_EQ(shifted.trust.cause.kind, DepthCause::Kind::kShifted);
  std::mt19937 random(1);
  const FusionResult noise = FuseWith([&](ViewId, DepthImage* image) {
    std::shuffle(image->depth.begin(), image->depth.end(), random);
  });
  ExpectNothingIsJudged(noise);
  EXPECT_EQ(noise.trust.cause.kind, DepthCause::Kind::kUnknown);
}

TEST(FuseDrawing, HardlyAnyDepthsJudgeNothing) {
  const FusionResult result = FuseWith([](ViewId, DepthImage* image) {
    for (size_t i = 0; i < image->depth.size(); ++i) {
      if (i % 31 != 0) image->depth[i] = 0;
    }
  });
  ExpectNothingIsJudged(result);
  EXPECT_TRUE(result.trust.has_few_depths);
}

TEST(FuseDrawing, DepthsOfOtherViewsAreNotUsed) {
  const auto num_views = static_cast<ViewId>(testing::PlateViews().size());
  const DepthSource plate = testing::PlateDepths();
  const FusionResult all =
      FuseWith([&](ViewId view, DepthImage* image) { *image = *plate((view + 1) % num_views); });
  ExpectNothingIsJudged(all);
  EXPECT_EQ(all.trust.cause.kind, DepthCause::Kind::kOtherViews);
  const ViewId depths_of = all.trust.cause.depths_of, fit_view = all.trust.cause.fit_view;
  EXPECT_EQ((depths_of + 1) % num_views, fit_view);
  const FusionResult some = FuseWith([](ViewId view, DepthImage* image) {
    for (float& depth : image->depth) depth *= view < 3 ? 1.3F : 1.0F;
  });
  EXPECT_TRUE(some.trust.is_believed);
  EXPECT_EQ(some.trust.cause.kind, DepthCause::Kind::kFactor);
  EXPECT_THAT(some.trust.unfit, ::testing::ElementsAre(0, 1, 2));
  EXPECT_EQ(some.classes.links[kPaint].dense_class, DenseClass::kSurface);
  EXPECT_EQ(some.classes.links[kRim].dense_class, DenseClass::kBoundary);
}

}  // namespace
}  // namespace limn
