// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pictures/overlays.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "limn/formats/colors.h"
#include "limn/formats/small_drawing.h"
#include "limn/formats/temporary_folder.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

Image GrayPhoto(int width, int height) {
  Image photo;
  photo.width = width;
  photo.height = height;
  photo.channels = 1;
  photo.data.assign(static_cast<size_t>(width) * height, 100.f);
  return photo;
}

View SmallView() {
  View view = testing::ForwardView();
  view.name = "a.png";
  return view;
}

DrawingGraph HorizontalLink() {
  DrawingGraph graph;
  graph.nodes.resize(2);
  graph.nodes[0].position_in_world = {-0.3, 0.1, 1};
  graph.nodes[1].position_in_world = {0.3, 0.1, 1};
  DrawingLink link;
  link.points_in_world = {{-0.3, 0.1, 1}, {0.3, 0.1, 1}};
  link.sigma = {0, 0};
  link.node0 = 0;
  link.node1 = 1;
  link.supporting_views = {0};
  graph.links = {link};
  RebuildIncidence(&graph);
  return graph;
}

bool IsColor(const uint8_t* pixel, const Color& color) {
  return pixel[0] == color.red && pixel[1] == color.green && pixel[2] == color.blue;
}

TEST(DrawOverlay, LinksThatContinueEachOtherHaveOneColor) {
  DrawingGraph graph = HorizontalLink();
  const Eigen::Vector3d right(0.45, 0.1, 1);
  DrawingLink next = graph.links[0];
  next.points_in_world = {graph.nodes[1].position_in_world, right};
  next.node0 = 1;
  next.node1 = 2;
  graph.nodes.emplace_back().position_in_world = right;
  graph.links.push_back(next);
  RebuildIncidence(&graph);
  PictureOptions options;
  options.scale = 1;
  options.line_width_px = 3;
  options.node_radius_px = 0;
  const auto is_drawn_as = [&](int curve) {
    const Picture picture = DrawOverlay(GrayPhoto(101, 101), SmallView(), 0, graph, options);
    return IsColor(picture.At(88, 60), ColorOfCurve(curve));
  };
  EXPECT_TRUE(is_drawn_as(1));
  graph.nodes[1].continuations = {{{0, 1}, {1, 0}}};
  EXPECT_TRUE(is_drawn_as(0));
}

TEST(DrawOverlay, LineIsWhereTheLinkProjects) {
  PictureOptions options;
  options.scale = 1;
  options.brightness = 0.5;
  options.line_width_px = 3;
  const Picture picture =
      DrawOverlay(GrayPhoto(101, 101), SmallView(), 0, HorizontalLink(), options);
  ASSERT_EQ(picture.width, 101);
  EXPECT_TRUE(IsColor(picture.At(50, 60), ColorOfCurve(0)));
  EXPECT_TRUE(IsColor(picture.At(50, 55), {50, 50, 50}));
  // The line lies in the middle of its row: both sides look the same.
  for (int offset = 1; offset < 6; ++offset) {
    EXPECT_NEAR(picture.At(50, 60 - offset)[0], picture.At(50, 60 + offset)[0], 8) << offset;
  }
  EXPECT_TRUE(IsColor(picture.At(20, 60), {255, 230, 0}));  // an end's square
}

TEST(DrawOverlay, SmallPhotosAreDoubledAboutPixelCenters) {
  PictureOptions options;
  options.line_width_px = 2;
  const Picture picture =
      DrawOverlay(GrayPhoto(101, 101), SmallView(), 0, HorizontalLink(), options);
  ASSERT_EQ(picture.width, 202);
  // Row 60 of the photo covers rows 120 and 121 of the picture.
  const auto differs = [&](int y) { return !IsColor(picture.At(100, y), {55, 55, 55}); };
  EXPECT_TRUE(differs(120));
  EXPECT_TRUE(differs(121));
  EXPECT_FALSE(differs(117));
  EXPECT_FALSE(differs(124));
}

TEST(DrawOverlay, UnsupportedLinksAreFadedAndTheirNodesUnmarked) {
  PictureOptions options;
  options.scale = 1;
  const Picture picture =
      DrawOverlay(GrayPhoto(101, 101), SmallView(), 7, HorizontalLink(), options);
  EXPECT_FALSE(IsColor(picture.At(50, 60), ColorOfCurve(0)));
  EXPECT_FALSE(IsColor(picture.At(50, 60), {55, 55, 55}));
  EXPECT_FALSE(IsColor(picture.At(20, 60), {255, 230, 0}));
}

TEST(DrawOverlay, TentativeLinksContoursAndTextureAreFadedAndTheirNodesUnmarked) {
  PictureOptions options;
  options.scale = 1;
  options.detail = Detail::kAll;
  DrawingGraph tentative = HorizontalLink();
  tentative.links[0].tentative = true;
  DrawingGraph contour = HorizontalLink();
  contour.links[0].kind = LinkKind::kContour;
  DrawingGraph texture = HorizontalLink();
  texture.links[0].kind = LinkKind::kTexture;
  for (const DrawingGraph& graph : {tentative, contour, texture}) {
    const Picture picture = DrawOverlay(GrayPhoto(101, 101), SmallView(), 0, graph, options);
    EXPECT_FALSE(IsColor(picture.At(50, 60), ColorOfCurve(0)));
    EXPECT_FALSE(IsColor(picture.At(50, 60), {55, 55, 55}));
    EXPECT_FALSE(IsColor(picture.At(20, 60), {255, 230, 0}));
  }
}

TEST(DrawOverlay, MarksAreNotLargerThanTheirLinks) {
  PictureOptions options;
  options.scale = 1;
  options.node_radius_px = 20;  // the square of an end has .45 of that
  const auto is_marked = [&](double half_length) {
    DrawingGraph graph = HorizontalLink();
    for (Eigen::Vector3d& point : graph.links[0].points_in_world) {
      point.x() = std::copysign(half_length, point.x());
    }
    graph.nodes[0].position_in_world = graph.links[0].points_in_world.front();
    graph.nodes[1].position_in_world = graph.links[0].points_in_world.back();
    const Picture picture = DrawOverlay(GrayPhoto(101, 101), SmallView(), 0, graph, options);
    const Eigen::Vector2d end = *SmallView().Project(graph.nodes[0].position_in_world);
    return IsColor(picture.At(static_cast<int>(end.x()), 60 + 4), {255, 230, 0});
  };
  EXPECT_TRUE(is_marked(0.4));
  EXPECT_FALSE(is_marked(0.1));
}

TEST(DrawOverlay, TextureIsDrawnOnRequest) {
  PictureOptions options;
  options.scale = 1;
  DrawingGraph texture = HorizontalLink();
  texture.links[0].kind = LinkKind::kTexture;
  const auto is_bare = [&] {
    const Picture picture = DrawOverlay(GrayPhoto(101, 101), SmallView(), 0, texture, options);
    return IsColor(picture.At(50, 60), {55, 55, 55});
  };
  EXPECT_TRUE(is_bare());
  options.detail = Detail::kAll;
  EXPECT_FALSE(is_bare());
}

TEST(DrawOverlay, NodesAreThoseOfWhatIsDrawn) {
  DrawingGraph graph = HorizontalLink();
  for (const double y : {-0.1, 0.1}) {
    DrawingLink stick = graph.links[0];
    stick.kind = LinkKind::kTexture;
    stick.node1 = static_cast<NodeId>(graph.nodes.size());
    stick.points_in_world = {graph.nodes[0].position_in_world,
                             graph.nodes[0].position_in_world + Eigen::Vector3d(0, y, 0)};
    graph.nodes.emplace_back();
    graph.nodes.back().position_in_world = stick.points_in_world.back();
    stick.sigma = {0, 0};
    graph.links.push_back(stick);
  }
  RebuildIncidence(&graph);
  ASSERT_EQ(graph.nodes[0].kind, NodeKind::kJunction);
  PictureOptions options;
  options.scale = 1;
  const auto is_end = [&] {
    const Picture picture = DrawOverlay(GrayPhoto(101, 101), SmallView(), 0, graph, options);
    return IsColor(picture.At(20, 60), {255, 230, 0});
  };
  EXPECT_TRUE(is_end());
  options.detail = Detail::kAll;
  EXPECT_FALSE(is_end());
}

TEST(DrawOverlay, MarksCanBeLeftOut) {
  PictureOptions options;
  options.scale = 1;
  const auto is_end = [&] {
    const Picture picture =
        DrawOverlay(GrayPhoto(101, 101), SmallView(), 0, HorizontalLink(), options);
    return IsColor(picture.At(20, 60), {255, 230, 0});
  };
  EXPECT_TRUE(is_end());
  options.node_radius_px = 0;
  EXPECT_FALSE(is_end());
}

TEST(DrawOverlay, RodsAreSeenByTheirOutlines) {
  PictureOptions options;
  options.scale = 1;
  options.line_width_px = 3;
  DrawingGraph rod = HorizontalLink();
  rod.links[0].kind = LinkKind::kRod;
  rod.links[0].rod_radius = 0.01;
  DrawingGraph outline = HorizontalLink();
  outline.links[0].tentative = true;
  outline.links[0].doubt = LinkDoubt::kRodOutline;
  const Picture of_rod = DrawOverlay(GrayPhoto(101, 101), SmallView(), 0, rod, options);
  EXPECT_FALSE(IsColor(of_rod.At(50, 60), ColorOfCurve(0)));
  EXPECT_FALSE(IsColor(of_rod.At(50, 60), {55, 55, 55}));
  const Picture of_outline = DrawOverlay(GrayPhoto(101, 101), SmallView(), 0, outline, options);
  EXPECT_TRUE(IsColor(of_outline.At(50, 60), ColorOfCurve(0)));
  EXPECT_TRUE(IsColor(of_outline.At(20, 60), {255, 230, 0}));
}

TEST(DrawOverlay, SketchAndFragments) {
  CurveSketch sketch;
  sketch.curves.resize(1);
  sketch.curves[0].points_in_world = {{-0.3, 0, 1}, {0.3, 0, 1}};
  PictureOptions options;
  options.scale = 1;
  options.line_width_px = 3;
  const Image photo = GrayPhoto(101, 101);
  EXPECT_TRUE(
      IsColor(DrawOverlay(photo, SmallView(), sketch, options).At(50, 50), ColorOfCurve(0)));

  ImageCurves curves;
  curves.edge_map.width = curves.edge_map.height = 101;
  for (int i = 0; i < 20; ++i) {
    Edgel edgel;
    edgel.stored_px = {10.f + i, 30.f};
    curves.edge_map.edgels.push_back(edgel);
    curves.fragments.resize(1);
    curves.fragments[0].edgel_ids.push_back(i);
  }
  EXPECT_TRUE(IsColor(DrawFragments(photo, curves, options).At(20, 30), ColorOfCurve(0)));
}

TEST(DrawOverlay, BadInputIsRefused) {
  EXPECT_THROW(DrawOverlay(GrayPhoto(50, 50), SmallView(), 0, HorizontalLink()), InputError);
  PictureOptions options;
  options.brightness = 2;
  EXPECT_THROW(DrawOverlay(GrayPhoto(101, 101), SmallView(), 0, HorizontalLink(), options),
               OptionError);
}

TEST(WritePng, ComesBackAndKeepsFolders) {
  const TemporaryFolder folder;
  EXPECT_EQ(PicturePath("overlays", "sub/a.jpg").string(), "overlays/sub/a.jpg.png");
  Picture picture{2, 1, {10, 20, 30, 40, 50, 60}};
  const OutputPath path = PicturePath(folder.Path("overlays"), "sub/a.jpg");
  WritePng(path, picture);
  const cv::Mat read = cv::imread(path.string(), cv::IMREAD_COLOR);
  ASSERT_EQ(read.cols, 2);
  EXPECT_EQ(read.at<cv::Vec3b>(0, 1), cv::Vec3b(60, 50, 40));  // OpenCV's order is blue, green, red
}

}  // namespace
}  // namespace limn
