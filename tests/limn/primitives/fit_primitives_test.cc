// SPDX-License-Identifier: BSD-3-Clause
#include "limn/primitives/fit_primitives.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/util/errors.h"
#include "support/noisy_drawing.h"
#include "support/random_numbers.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::LineCurve;
using Scene = testing::NoisyDrawing;
using Curve = Scene::Curve;

constexpr double kPx = testing::kNoisyDrawingPx;
constexpr double kNoisePx = testing::kDrawnNoisePx;

const std::vector<View>& Views() { return testing::ViewsOfNoisyDrawing(); }

// In a tilted plane around the origin.
Curve Arc(double radius, double sweep_rad) {
  const Eigen::Vector3d x(1, 0, 0);
  const Eigen::Vector3d y(0, 0.8, 0.6);
  return [=](double t) -> Eigen::Vector3d {
    return radius * (std::cos(t * sweep_rad) * x + std::sin(t * sweep_rad) * y);
  };
}

Curve Wave(double begin, double end) {
  return [=](double t) -> Eigen::Vector3d {
    const double x = begin + t * (end - begin);
    return {x, 0.15 * std::sin(5 * x), 0.1 * std::cos(3 * x)};
  };
}

PrimitiveResult Fit(const DrawingGraph& graph) {
  const PrimitiveResult result = FitPrimitives(graph, Views(), {}, {});
  EXPECT_THAT(Validate(result.graph), ::testing::IsEmpty());
  for (const DrawingLink& link : result.graph.links) {
    EXPECT_TRUE(!link.primitive || ValidateShape(link.primitive->shape).empty());
  }
  return result;
}

const CurveShape& ShapeOf(const PrimitiveResult& result, size_t link) {
  return result.graph.links[link].primitive.value().shape;
}

TEST(FitPrimitives, LinesAreLines) {
  Scene scene;
  const Eigen::Vector3d along = Eigen::Vector3d(3, 1, -1).normalized();
  for (const double length : {0.08, 0.3, 1.2}) {
    scene.AddCurve(LineCurve(Eigen::Vector3d::Zero(), length * along), length);
  }
  const PrimitiveResult result = Fit(scene.graph());
  for (size_t l = 0; l < 3; ++l) {
    ASSERT_STREQ(ShapeName(ShapeOf(result, l)), "line");
    EXPECT_LT(result.graph.links[l].primitive->max_px, 5 * kNoisePx);
  }
  const auto& longest = std::get<LineSegment>(ShapeOf(result, 2));
  // Two ends with an error of the noise, over 150 px.
  EXPECT_GT((longest.end - longest.start).normalized().dot(along), std::cos(3 * kNoisePx / 150));
}

TEST(FitPrimitives, CirclesAndArcsAreFound) {
  Scene scene;
  scene.AddCurve(Arc(0.5, 2 * M_PI), M_PI);
  scene.AddCurve(Arc(0.4, 2), 0.8);
  scene.AddCurve(Arc(0.3, 4.5), 1.35);  // more than a half
  const PrimitiveResult result = Fit(scene.graph());
  const double radii[] = {0.5, 0.4, 0.3};
  const char* names[] = {"circle", "arc", "arc"};
  const Eigen::Vector3d normal(0, -0.6, 0.8);
  for (size_t l = 0; l < 3; ++l) {
    ASSERT_STREQ(ShapeName(ShapeOf(result, l)), names[l]);
    const auto& arc = std::get<CircularArc>(ShapeOf(result, l));
    EXPECT_NEAR(arc.radius, radii[l], 4 * kNoisePx * kPx);
    EXPECT_LT(arc.center.norm(), 4 * kNoisePx * kPx);
    EXPECT_GT(arc.Normal().dot(normal), std::cos(0.01));
  }
  EXPECT_NEAR(std::get<CircularArc>(ShapeOf(result, 2)).sweep_rad, 4.5, 0.05);
}

TEST(FitPrimitives, CirclesOnWhichOthersEndAreCircles) {
  Scene scene;
  // The node is two thirds of a pixel off.
  const Eigen::Vector3d start = Arc(0.4, 2 * M_PI)(0);
  const NodeId node = scene.AddNode(start + Eigen::Vector3d(0.7 * kPx, 0, 0));
  scene.AddLink(node, node, Arc(0.4, 2 * M_PI), 0.8 * M_PI);
  const Eigen::Vector3d end(0.9, 0.3, 0);
  scene.AddLink(node, scene.AddNode(end), LineCurve(start, end), 0.6);
  const PrimitiveResult result = Fit(scene.graph());
  EXPECT_FALSE(result.graph.links[0].closed);
  ASSERT_STREQ(ShapeName(ShapeOf(result, 0)), "circle");
  const CurveShape& circle = ShapeOf(result, 0);
  EXPECT_NEAR(std::get<CircularArc>(circle).radius, 0.4, 4 * kNoisePx * kPx);
  EXPECT_GT(std::get<CircularArc>(circle).Normal().dot(Eigen::Vector3d(0, -0.6, 0.8)), 0.99);
  for (const double t : {0, 1}) {
    EXPECT_LT((PointAt(circle, t) - result.graph.nodes[node].position_in_world).norm(), 1e-9);
  }
}

TEST(FitPrimitives, OtherCurvesAreSplinesOfFewKnots) {
  Scene scene;
  scene.AddCurve(Wave(-1, 1), 2.4);
  scene.AddCurve(
      [](double t) -> Eigen::Vector3d {
        const double angle = 2 * M_PI * t;
        return {0.6 * std::cos(angle), 0.3 * std::sin(angle), 0.1 * std::sin(2 * angle)};
      },
      3);
  const PrimitiveResult result = Fit(scene.graph());
  for (size_t l = 0; l < 2; ++l) {
    ASSERT_STREQ(ShapeName(ShapeOf(result, l)), "spline");
    EXPECT_LE(result.graph.links[l].primitive->max_px, PrimitiveOptions().max_residual_px);
    EXPECT_LT(std::get<CubicBSpline>(ShapeOf(result, l)).control_points.size(), 20u);
  }
  // The closed one has no kink at its joint.
  const CurveShape& closed = ShapeOf(result, 1);
  EXPECT_LT((PointAt(closed, 0) - PointAt(closed, 1)).norm(), 1e-12);
  EXPECT_GT(DerivativeAt(closed, 0).normalized().dot(DerivativeAt(closed, 1).normalized()),
            1 - 1e-9);
}

TEST(FitPrimitives, EndsAreHeldWhereTheirCurvesMeet) {
  Scene scene;
  // The node is a pixel and a half beside the place where the lines meet.
  const NodeId center = scene.AddNode({1.5 * kPx, 0, 0});
  const Eigen::Vector3d ends[] = {{0.6, 0.1, 0}, {-0.3, 0.5, 0.1}, {-0.2, -0.6, -0.1}};
  for (const Eigen::Vector3d& end : ends) {
    scene.AddLink(center, scene.AddNode(end), LineCurve(Eigen::Vector3d::Zero(), end), 0.6);
  }
  const PrimitiveResult result = Fit(scene.graph());
  const Eigen::Vector3d& meeting = result.graph.nodes[center].position_in_world;
  EXPECT_LT(meeting.norm(), 0.5 * kPx);
  for (size_t l = 0; l < 3; ++l) {
    ASSERT_STREQ(ShapeName(ShapeOf(result, l)), "line");
    EXPECT_EQ(PointAt(ShapeOf(result, l), 0), meeting);
  }
}

TEST(FitPrimitives, EndsOfArcsAreHeldToo) {
  Scene scene;
  const Eigen::Vector3d start = Arc(0.4, 2)(0);
  const NodeId node = scene.AddNode(start + Eigen::Vector3d(0, 0, 1.5 * kPx));
  scene.AddLink(node, scene.AddNode(Arc(0.4, 2)(1)), Arc(0.4, 2), 0.8);
  for (const Eigen::Vector3d& end :
       {Eigen::Vector3d(0.9, 0.3, 0), Eigen::Vector3d(0.6, -0.5, 0.1)}) {
    scene.AddLink(node, scene.AddNode(end), LineCurve(start, end), 0.6);
  }
  const PrimitiveResult result = Fit(scene.graph());
  ASSERT_STREQ(ShapeName(ShapeOf(result, 0)), "arc");
  EXPECT_LT((PointAt(ShapeOf(result, 0), 0) - result.graph.nodes[node].position_in_world).norm(),
            1e-9);
}

TEST(FitPrimitives, ContinuationsShareTheirTangent) {
  Scene scene;
  const NodeId first = scene.AddNode(Wave(-1, 1)(0));
  const NodeId middle = scene.AddNode(Wave(-1, 1)(0.5));
  const NodeId last = scene.AddNode(Wave(-1, 1)(1));
  const NodeId side = scene.AddNode({0, 0.6, 0.1});
  scene.AddLink(first, middle, Wave(-1, 0), 1.2);
  scene.AddLink(middle, last, Wave(0, 1), 1.2);
  scene.AddLink(middle, side, LineCurve(Wave(-1, 1)(0.5), {0, 0.6, 0.1}), 0.6);
  DrawingGraph graph = scene.graph();
  graph.nodes[middle].continuations = {{{0, 1}, {1, 0}}};
  const PrimitiveResult result = Fit(graph);
  for (const size_t l : {0, 1}) ASSERT_STREQ(ShapeName(ShapeOf(result, l)), "spline");
  EXPECT_GT(DerivativeAt(ShapeOf(result, 0), 1)
                .normalized()
                .dot(DerivativeAt(ShapeOf(result, 1), 0).normalized()),
            1 - 1e-9);
  EXPECT_EQ(PointAt(ShapeOf(result, 1), 0), result.graph.nodes[middle].position_in_world);
}

TEST(FitPrimitives, ShortLinksDoNotCollapse) {
  // A pixel between two corners whose lines meet elsewhere.
  Scene scene;
  const NodeId a = scene.AddNode({0, 0, 0});
  const NodeId b = scene.AddNode({kPx, 0, 0});
  scene.AddLink(a, b, LineCurve({0, 0, 0}, {kPx, 0, 0}), kPx);
  scene.AddLink(a, scene.AddNode({0.02, 0.5, 0}), LineCurve({0.02, 0, 0}, {0.02, 0.5, 0}), 0.5);
  scene.AddLink(b, scene.AddNode({-0.01, -0.5, 0}), LineCurve({-0.01, 0, 0}, {-0.01, -0.5, 0}),
                0.5);
  const PrimitiveResult result = Fit(scene.graph());
  EXPECT_GT(Length(result.graph.links[0].points_in_world), 0.4 * kPx);
  for (const DrawingLink& link : result.graph.links) EXPECT_TRUE(link.primitive);
}

// There and back at once.
Curve Hook(const Eigen::Vector3d& start, const Eigen::Vector3d& there,
           const Eigen::Vector3d& back) {
  const double turn = there.norm() / (there.norm() + back.norm());
  return [=](double t) -> Eigen::Vector3d {
    return start + std::min(t / turn, 1.0) * there + std::max((t - turn) / (1 - turn), 0.0) * back;
  };
}

// The plane of the last camera contains the origin, which is far outside its image: what a point
// there would move by in its pixels says nothing.
std::vector<View> ViewsAndOneAside() {
  std::vector<View> views = Views();
  views.push_back(testing::LookAt({3, 0, -0.004}, {3, 0.3, 10}));
  return views;
}

TEST(FitPrimitives, ShapesThatLeaveTheirLinksAreNone) {
  std::mt19937 random(3);
  testing::NormalDistribution<double> gauss;
  const auto direction = [&] { return testing::RandomVector(gauss, random).normalized(); };
  const std::vector<View> views = ViewsAndOneAside();
  Scene scene;
  constexpr int kNumHooks = 300;
  for (int i = 0; i < kNumHooks; ++i) {
    const Eigen::Vector3d there = 2 * kPx * direction();
    const Eigen::Vector3d back = -1.5 * there + 2 * kPx * direction();
    const NodeId node = scene.AddNode({0, 0, 0});
    scene.AddLink(node, scene.AddNode(there + back), Hook({0, 0, 0}, there, back),
                  there.norm() + back.norm());
    const Eigen::Vector3d end = 0.3 * direction();
    scene.AddLink(node, scene.AddNode(end), LineCurve({0, 0, 0}, end), 0.3);
  }
  DrawingGraph graph = scene.graph();
  for (DrawingLink& link : graph.links) {
    link.supporting_views.push_back(static_cast<ViewId>(views.size()) - 1);
  }
  const PrimitiveResult result = FitPrimitives(graph, views, {}, {});
  // Also looks where the shapes are.
  EXPECT_THAT(Validate(result.graph), ::testing::IsEmpty());
  const int num_without = Describe(result.graph).kinds.back().count;
  EXPECT_GT(num_without, 0);
  EXPECT_LT(num_without, kNumHooks / 10);
}

TEST(FitPrimitives, ViewsThatDoNotShowALinkDoNotCount) {
  Scene scene;
  scene.AddCurve(Wave(-0.3, 0.3), 0.7);
  DrawingGraph graph = scene.graph();
  graph.links[0].supporting_views.clear();
  const PrimitiveResult result = FitPrimitives(graph, ViewsAndOneAside(), {}, {});
  ASSERT_TRUE(result.graph.links[0].primitive);
  EXPECT_LT(result.graph.links[0].primitive->max_px, 5 * kNoisePx);
}

TEST(FitPrimitives, WhatNoViewSeesGetsNone) {
  Scene scene;
  scene.AddCurve(LineCurve({0, 0, 50}, {1, 0, 50}), 1);  // behind all views
  scene.AddCurve(LineCurve({0, 0, 0}, {1, 0, 0}), 1);
  const PrimitiveResult result = Fit(scene.graph());
  EXPECT_FALSE(result.graph.links[0].primitive);
  EXPECT_TRUE(result.graph.links[1].primitive);
  const PrimitiveStatistics statistics = Describe(result.graph);
  EXPECT_EQ(statistics.kinds.front().count, 1);
  EXPECT_EQ(statistics.kinds.back().count, 1);
  EXPECT_EQ(statistics.numbers_after, 6u);
  EXPECT_TRUE(FitPrimitives({}, Views(), {}, {}).graph.links.empty());
}

TEST(FitPrimitives, RegularitiesAndFacesEnd) {
  Scene scene;
  scene.AddCurve(LineCurve({0, 0, 0}, {0.5, 0, 0}), 0.5);
  DrawingGraph graph = scene.graph();
  graph.regularities.directions = {{Eigen::Vector3d::UnitX(), {}}};
  DrawingFace face;
  face.loops = {{{0, 0, 1, {}}}};
  graph.faces = {face};
  const PrimitiveResult result = Fit(graph);
  EXPECT_TRUE(result.graph.regularities.IsEmpty());
  EXPECT_TRUE(result.graph.faces.empty());
}

TEST(FitPrimitives, OptionsAreChecked) {
  PrimitiveOptions options;
  options.max_residual_px = 0;
  EXPECT_THROW(FitPrimitives({}, Views(), options, {}), OptionError);
}

}  // namespace
}  // namespace limn
