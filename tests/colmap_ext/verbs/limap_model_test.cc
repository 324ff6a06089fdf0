// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/limap_model.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/verbs/small_model.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

LimapModel Made(bool chains) {
  const SparseModel model = MakeScene();
  return ToLimap(MakeDrawing(), model, ViewsOf(model), chains);
}

TEST(LimapModel, AStraightLinkIsALineWithSegments) {
  const LimapModel made = Made(false);
  ASSERT_EQ(made.structures.lines.size(), 1u);
  const LimapLine& line = made.structures.lines[0];
  EXPECT_EQ(line.start, Eigen::Vector3d(-1, 0, 0));
  EXPECT_EQ(line.uncertainty, 0.25);
  ASSERT_EQ(line.track.size(), 2u);
  EXPECT_EQ(line.track[0].image_id, 10u);
  EXPECT_EQ(line.track[1].image_id, 30u);
  // Sorted by id, also those without segments.
  ASSERT_EQ(made.structures.images.size(), 3u);
  const LimapImage& image = made.structures.images[0];
  EXPECT_EQ(image.id, 10u);
  ASSERT_EQ(image.segments.size(), 1u);
  EXPECT_EQ(image.segments[0].line, 0u);
  // In the pixels of the model's camera.
  EXPECT_LT((image.segments[0].start - Eigen::Vector2d(87.5, 50)).norm(), 1e-9);
  EXPECT_LT((image.segments[0].end - Eigen::Vector2d(125, 56.25)).norm(), 1e-9);
  EXPECT_THAT(made.structures.images[1].segments, IsEmpty());
  EXPECT_EQ(made.structures.images[1].num_points, 2u);
  // Nothing meets, so that the points are those of the model.
  EXPECT_THAT(made.structures.wireframe, IsEmpty());
  EXPECT_EQ(made.model.points.size(), 1u);
}

TEST(LimapModel, ChainsMeetInPointsOfTheModel) {
  const LimapModel made = Made(true);
  ASSERT_EQ(made.structures.lines.size(), 4u);
  ASSERT_EQ(made.model.points.size(), 4u);
  const ModelPoint& point = made.model.points[1];
  EXPECT_EQ(point.id, 42u);
  EXPECT_EQ(point.position, Eigen::Vector3d(0.5, 0.25, 0));
  ASSERT_EQ(point.track.size(), 2u);
  // Places in the file, not ids: the image 10 is the second.
  EXPECT_EQ(point.track[0].image_id, 10u);
  EXPECT_EQ(point.track[0].observation, 1u);
  EXPECT_TRUE(made.model.images[1].Shows(42, 1));
  EXPECT_LT((made.model.images[1].observations[1].position - Eigen::Vector2d(125, 56.25)).norm(),
            1e-9);
  ASSERT_EQ(made.structures.wireframe.size(), 6u);
  EXPECT_EQ(made.structures.wireframe[0].point, 42u);
  EXPECT_EQ(made.structures.wireframe[0].line, 0u);
  EXPECT_EQ(made.structures.wireframe[0].weight, 2);  // images
  EXPECT_EQ(made.structures.wireframe[1].line, 1u);
  EXPECT_EQ(made.structures.images[0].num_points, 4u);
  ASSERT_EQ(made.structures.images[0].wireframe.size(), 6u);
  EXPECT_EQ(made.structures.images[0].wireframe[1].point, 1u);
  EXPECT_EQ(made.structures.images[0].wireframe[1].line, 1u);
}

// The bent link of the drawing, on a quarter of a circle or as so many points of one.
DrawingFile WithArc(int num_points) {
  DrawingFile drawing = MakeDrawing();
  DrawingLink& link = drawing.graph.links[1];
  const CircularArc arc = {{0.5, -0.5, 0}, {0, 1, 0}, {1, 0, 0}, 0.75, M_PI / 2};
  link.points_in_world.clear();
  for (int i = 0; i < num_points; ++i) {
    link.points_in_world.push_back(PointAt(arc, i * M_PI / 2 / (num_points - 1)));
  }
  link.sigma.assign(link.points_in_world.size(), 0.25);
  drawing.graph.nodes[1].position_in_world = link.points_in_world.front();
  drawing.graph.nodes[2].position_in_world = link.points_in_world.back();
  drawing.graph.links[0].points_in_world[1] = link.points_in_world.front();
  link.primitive = LinkPrimitive{arc};
  return drawing;
}

size_t NumChainLines(const CurveShape& shape, double footprint) {
  return SampleShape(shape, 0.5 * footprint).size() - 1;
}

TEST(LimapModel, ChainsAreInPixelsOfTheViewsOfTheDrawing) {
  SparseModel model = MakeScene();
  model.images[0].cam_from_world.translation.z() = 0.5;  // c.png, b.png and d.png
  model.images[2].cam_from_world.translation.z() = 16;
  std::vector<View> views = ViewsOf(model);
  DrawingFile drawing = WithArc(3);
  const CurveShape shape = drawing.graph.links[1].primitive->shape;
  const size_t num_lines = NumChainLines(shape, 16.0 / 50);
  ASSERT_LT(num_lines, NumChainLines(shape, 4.0 / 50));
  // Made of two of the three images.
  drawing.metadata.view_names = {"b.png", "d.png"};
  for (DrawingLink& link : drawing.graph.links) link.supporting_views = {1};
  EXPECT_EQ(ToLimap(drawing, model, views, true).structures.lines.size(), 1 + num_lines);
  // Made with an image that has become a duplicate of another one.
  drawing.metadata.view_names = {"b.png", "c.png", "d.png"};
  for (DrawingLink& link : drawing.graph.links) link.supporting_views = {0, 2};
  views.erase(views.begin() + 1);
  const LimapModel made = ToLimap(drawing, model, views, true);
  EXPECT_EQ(made.structures.lines.size(), 1 + num_lines);
  ASSERT_EQ(made.structures.lines[0].track.size(), 1u);
  EXPECT_EQ(made.structures.lines[0].track[0].image_id, 30u);
}

TEST(LimapModel, ChainsOfPointsAreWithinHalfAPixel) {
  const SparseModel model = MakeScene();
  DrawingFile drawing = WithArc(400);
  drawing.graph.links[1].primitive.reset();
  const LimapModel made = ToLimap(drawing, model, ViewsOf(model), true);
  EXPECT_LT(made.structures.lines.size(), 8u);
  Polyline3d chain = {made.structures.lines[1].start};
  for (size_t i = 1; i < made.structures.lines.size(); ++i) {
    EXPECT_EQ(made.structures.lines[i].start, chain.back());
    chain.push_back(made.structures.lines[i].end);
  }
  for (const Eigen::Vector3d& point : drawing.graph.links[1].points_in_world) {
    EXPECT_LE(std::sqrt(ClosestPoint(chain, point).squared_distance), 0.5 * 4 / 50);
  }
}

TEST(LimapModel, LinksThatHardlyBendAreLines) {
  const SparseModel model = MakeScene();
  DrawingFile drawing = MakeDrawing();
  DrawingLink& link = drawing.graph.links[0];
  const Eigen::Vector3d middle = (link.points_in_world[0] + link.points_in_world[1]) / 2;
  link.points_in_world.insert(link.points_in_world.begin() + 1,
                              middle + Eigen::Vector3d(0, 0.01, 0));
  link.sigma.push_back(0.25);
  EXPECT_EQ(ToLimap(drawing, model, ViewsOf(model), false).structures.lines.size(), 1u);
  link.points_in_world[1].y() += 0.02;
  EXPECT_EQ(ToLimap(drawing, model, ViewsOf(model), false).structures.lines.size(), 0u);
}

TEST(LimapModel, JointsThatOneImageShowsAreNoPoints) {
  const SparseModel model = MakeScene();
  std::vector<View> views = ViewsOf(model);
  // d.png ends before all places where lines meet.
  views[2].region.max_px.x() = 45;
  const LimapModel made = ToLimap(MakeDrawing(), model, views, true);
  EXPECT_EQ(made.structures.lines.size(), 4u);
  size_t num_observations = 0;
  for (const ModelImage& image : model.images) num_observations += image.observations.size();
  for (const ModelImage& image : made.model.images) num_observations -= image.observations.size();
  EXPECT_EQ(num_observations, 0u);
  EXPECT_EQ(made.model.points.size(), 1u);
  EXPECT_THAT(made.structures.wireframe, IsEmpty());
}

TEST(LimapModel, RoundTripThroughAFolder) {
  const TempDir dir;
  const LimapModel made = Made(true);
  WriteModelBinary(made.model, dir.path());
  std::filesystem::create_directory(dir / "structures");
  WriteLimapStructures(made.structures, dir / "structures");
  for (const std::string& path : {dir.path().string(), (dir / "structures").string()}) {
    EXPECT_TRUE(HoldsLimapDrawing(path));
    const DrawingFile read = ReadLimapDrawing(path);
    EXPECT_THAT(Validate(read.graph), IsEmpty());
    EXPECT_EQ(read.metadata.view_names, MakeDrawing().metadata.view_names);
    ASSERT_EQ(read.graph.links.size(), 4u);
    EXPECT_EQ(read.graph.nodes.size(), 5u);
    EXPECT_EQ(read.graph.links[0].node1, read.graph.links[1].node0);
    EXPECT_EQ(read.graph.links[0].points_in_world, MakeDrawing().graph.links[0].points_in_world);
    EXPECT_THAT(read.graph.links[0].sigma, ElementsAre(0.25, 0.25));
    EXPECT_THAT(read.graph.links[0].supporting_views, ElementsAre(0, 2));
    ASSERT_TRUE(read.graph.links[3].primitive);
    EXPECT_STREQ(ShapeName(read.graph.links[3].primitive->shape), "line");
  }
  std::filesystem::rename(dir / "structures", dir / "lines");
  EXPECT_FALSE(HoldsLimapDrawing(dir / "lines"));
  std::filesystem::rename(dir / "lines", dir / "structures");
  std::filesystem::remove(dir / "structures/lines3D.bin");
  EXPECT_FALSE(HoldsLimapDrawing(dir.path()));
  EXPECT_THAT([&] { ReadLimapDrawing(dir.path()); },
              ThrowsMessage<IoError>(HasSubstr("is not a drawing")));
}

TEST(LimapModel, EndsWithinTheirUncertaintyOfAPointMeetThere) {
  LimapModel limap = {MakeScene(), {}};
  limap.structures.lines = {{0, {0.1, 0, 0}, {1, 0, 0}, {}, 0.125},
                            {1, {0, 0.2, 0}, {0, 1, 0}, {}, 0.125},
                            {2, {0, 0, 0.05}, {0, 0, -0.1}, {}, 0.25}};
  limap.structures.wireframe = {{41, 0, 1}, {41, 1, 1}, {41, 2, 1}};
  const DrawingGraph graph = FromLimap(limap).graph;
  ASSERT_THAT(Validate(graph), IsEmpty());
  EXPECT_EQ(graph.links[0].points_in_world[0], Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(graph.links[1].points_in_world[0], Eigen::Vector3d(0, 0.2, 0));  // too far
  // Only the nearer end of a line as short as it is uncertain.
  EXPECT_EQ(graph.links[2].node0, graph.links[0].node0);
  EXPECT_EQ(graph.links[2].points_in_world[1], Eigen::Vector3d(0, 0, -0.1));
  EXPECT_EQ(graph.nodes.size(), 5u);
}

TEST(LimapModel, ImagesThatAreLeftOutSupportNothing) {
  const DrawingFile drawing = FromLimap(Made(true), {"c.png", "d.png"});
  EXPECT_THAT(drawing.metadata.view_names, ElementsAre("c.png", "d.png"));
  ASSERT_EQ(drawing.graph.links.size(), 4u);
  EXPECT_THAT(drawing.graph.links[0].supporting_views, ElementsAre(1));
  EXPECT_THAT([] { FromLimap(Made(true), {"e.png"}); },
              ThrowsMessage<IoError>(HasSubstr("the model has no image e.png")));
}

TEST(LimapModel, WhatTheModelHasNotIsRefused) {
  LimapModel limap = {MakeScene(), {}};
  limap.structures.lines = {{0, {0, 0, 0}, {1, 0, 0}, {{11, 0}}, -1}};
  EXPECT_THAT([&] { FromLimap(limap); },
              ThrowsMessage<IoError>(HasSubstr("line 0 has a track in an image 11")));
  limap.structures.lines[0].track.clear();
  limap.structures.wireframe = {{40, 0, 1}};
  EXPECT_THAT([&] { FromLimap(limap); },
              ThrowsMessage<IoError>(HasSubstr("the wireframe has a 3D point 40")));

  SparseModel model = MakeScene();
  DrawingFile drawing = MakeDrawing();
  drawing.metadata.view_names[1] = "z.png";
  EXPECT_THAT([&] { ToLimap(drawing, model, ViewsOf(model), false); },
              ThrowsMessage<IoError>(HasSubstr("the model has no image z.png")));
  model.cameras[0].model = CameraModelId::kSimpleRadial;
  EXPECT_THAT([&] { ToLimap(MakeDrawing(), model, ViewsOf(model), false); },
              ThrowsMessage<InputError>(HasSubstr("camera 1 has a lens (SIMPLE_RADIAL)")));
  model.cameras[0].model = CameraModelId::kEquirectangular;
  EXPECT_THAT([&] { ToLimap(MakeDrawing(), model, ViewsOf(model), false); },
              ThrowsMessage<InputError>(HasSubstr("camera 1 is EQUIRECTANGULAR")));
}

}  // namespace
}  // namespace limn::colmap_ext
