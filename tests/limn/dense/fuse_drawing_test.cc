#include "limn/dense/fuse_drawing.h"

#include <algorithm>

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
  static const FusionResult result =
      FuseDrawing({testing::PlateViews(), graph, testing::PlateDepths(), std::nullopt}, {}, {});
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
  const FusionResult result =
      FuseDrawing({testing::PlateViews(), graph, testing::PlateDepths(), std::nullopt}, {}, {});
  EXPECT_FALSE(result.classes.links[kBelow].behind_surface);
}

// Three views find the surface far behind everything.
TEST(FuseDrawing, ALinkThatEnoughViewsSeeIsNotBehind) {
  const DrawingGraph graph = PlateDrawing();
  const DepthSource plate = testing::PlateDepths();
  const DepthSource some = [&](ViewId view) {
    auto image = plate(view);
    if (view < 3) std::fill(image->depth.begin(), image->depth.end(), 1e3f);
    return image;
  };
  const auto behind = [&](double enough) {
    DenseOptions options;
    options.enough_visible_views = enough;
    return FuseDrawing({testing::PlateViews(), graph, some, std::nullopt}, options, {})
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
      FuseDrawing({testing::PlateViews(), graph, testing::PlateDepths(), none}, {}, {});
  EXPECT_EQ(result.classes.links[kPaint].dense_class, DenseClass::kSurface);
  EXPECT_EQ(result.classes.links[kPaint].added_share, 1);
  EXPECT_NEAR(LengthAdded(result.samples, result.classes), 0.6 + 1.2 + 0.2, 0.1);
}

TEST(FuseDrawing, EmptyDrawingAndNoDepths) {
  const DrawingGraph empty;
  EXPECT_TRUE(
      FuseDrawing({testing::PlateViews(), empty, testing::PlateDepths(), std::nullopt}, {}, {})
          .points.empty());
  const DepthSource nothing = [](ViewId) { return std::nullopt; };
  const DrawingGraph graph = PlateDrawing();
  const FusionResult result =
      FuseDrawing({testing::PlateViews(), graph, nothing, std::nullopt}, {}, {});
  for (const LinkDense& link : result.classes.links) {
    EXPECT_FALSE(link.behind_surface);
    EXPECT_EQ(link.dense_class, DenseClass::kFree);
  }
}

}  // namespace
}  // namespace limn
