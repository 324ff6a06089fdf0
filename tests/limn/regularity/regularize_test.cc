// SPDX-License-Identifier: BSD-3-Clause
#include "limn/regularity/regularize.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/primitives/fit_primitives.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "support/noisy_drawing.h"

namespace limn {
namespace {

using Eigen::Vector3d;

using testing::LineCurve;
using testing::NoisyDrawing;

constexpr double kPx = testing::kNoisyDrawingPx;

NodeId AddNoisyNode(const Vector3d& position, NoisyDrawing* drawing) {
  return drawing->AddNode(position + drawing->Noise());
}

void AddFreeLine(const Vector3d& from, const Vector3d& to, NoisyDrawing* drawing) {
  const NodeId node0 = AddNoisyNode(from, drawing);
  const NodeId node1 = AddNoisyNode(to, drawing);
  drawing->AddLink(node0, node1, LineCurve(from, to), (to - from).norm());
}

void AddCircle(const Vector3d& center, const Vector3d& x, const Vector3d& y,
               NoisyDrawing* drawing) {
  const NodeId node = AddNoisyNode(center + x, drawing);
  const auto circle = [=](double t) {
    return Vector3d(center + std::cos(2 * M_PI * t) * x + std::sin(2 * M_PI * t) * y);
  };
  drawing->AddLink(node, node, circle, 2 * M_PI * x.norm());
}

DrawingGraph Fitted(NoisyDrawing* drawing) {
  return FitPrimitives(drawing->graph(), testing::ViewsOfNoisyDrawing(), {}, {}).graph;
}

// A tilted box of 0.8 x 0.6 x 0.5 around the origin.
const Eigen::Matrix3d& Tilt() {
  static const Eigen::Matrix3d tilt =
      Eigen::AngleAxisd(0.4, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  return tilt;
}

Vector3d BoxCorner(int index) {
  const Vector3d half(0.4, 0.3, 0.25);
  return Tilt() * Vector3d((index & 1 ? 1 : -1) * half.x(), (index & 2 ? 1 : -1) * half.y(),
                           (index & 4 ? 1 : -1) * half.z());
}

void AddBox(NoisyDrawing* drawing) {
  std::vector<NodeId> corners;
  for (int i = 0; i < 8; ++i) corners.push_back(AddNoisyNode(BoxCorner(i), drawing));
  for (int i = 0; i < 8; ++i) {
    for (const int bit : {1, 2, 4}) {
      if (i & bit) continue;
      const Vector3d from = BoxCorner(i), to = BoxCorner(i | bit);
      drawing->AddLink(corners[i], corners[i | bit], LineCurve(from, to), (to - from).norm());
    }
  }
}

RegularityResult Regularized(const DrawingGraph& graph, const RegularityOptions& options = {}) {
  const RegularityResult result =
      Regularize(graph, testing::ViewsOfNoisyDrawing(), options, {}, {});
  EXPECT_THAT(Validate(result.graph), ::testing::IsEmpty());
  return result;
}

template <class Follows>
std::vector<LinkId> LinksThat(const DrawingGraph& graph, const Follows& follow) {
  std::vector<LinkId> links;
  for (size_t l = 0; l < graph.links.size(); ++l) {
    if (graph.links[l].regularity && follow(*graph.links[l].regularity)) {
      links.push_back(static_cast<LinkId>(l));
    }
  }
  return links;
}
std::vector<LinkId> LinksOfDirection(const DrawingGraph& graph, int index) {
  return LinksThat(graph, [&](const LinkRegularity& of) { return of.direction == index; });
}
std::vector<LinkId> LinksOfPlane(const DrawingGraph& graph, int index) {
  return LinksThat(graph, [&](const LinkRegularity& of) {
    return std::count(of.planes.begin(), of.planes.end(), index) == 1;
  });
}

Vector3d DirectionOf(const DrawingGraph& graph, LinkId link) {
  const auto& line = std::get<LineSegment>(graph.links[link].primitive.value().shape);
  return (line.end - line.start).normalized();
}

TEST(Regularize, ABoxGetsRightAngles) {
  NoisyDrawing drawing;
  AddBox(&drawing);
  const DrawingGraph before = Fitted(&drawing);
  const RegularityResult result = Regularized(before);
  const Regularities& found = result.graph.regularities;
  ASSERT_EQ(found.directions.size(), 3u);
  for (int d = 0; d < 3; ++d) {
    const CommonDirection& of = found.directions[d];
    const std::vector<LinkId> links = LinksOfDirection(result.graph, d);
    EXPECT_EQ(links.size(), 4u);
    EXPECT_EQ(of.orthogonal_to.size(), 2u);
    for (const LinkId l : links) {
      EXPECT_LT(of.direction.cross(DirectionOf(result.graph, l)).norm(), 1e-6);
    }
    for (const int other : of.orthogonal_to) {
      EXPECT_NEAR(of.direction.dot(found.directions[other].direction), 0, 1e-6);
    }
  }
  ASSERT_EQ(found.planes.size(), 6u);
  for (int p = 0; p < 6; ++p) {
    const CommonPlane& of = found.planes[p];
    const std::vector<LinkId> links = LinksOfPlane(result.graph, p);
    EXPECT_EQ(links.size(), 4u);
    EXPECT_GE(of.normal_direction, 0);
    for (const LinkId l : links) {
      for (const Vector3d& end : {result.graph.links[l].points_in_world.front(),
                                  result.graph.links[l].points_in_world.back()}) {
        EXPECT_NEAR(of.normal.dot(end), of.offset, 1e-3 * kPx);
      }
    }
  }
  // Nearer to the truth than before.
  double error_before = 0, error_after = 0;
  for (int i = 0; i < 8; ++i) {
    error_before += (before.nodes[i].position_in_world - BoxCorner(i)).squaredNorm();
    error_after += (result.graph.nodes[i].position_in_world - BoxCorner(i)).squaredNorm();
  }
  EXPECT_LT(error_after, 0.8 * error_before);
  EXPECT_LT(result.moves.max_px, 1);
  EXPECT_GT(result.moves.num_ends, 12);
  // The summary reports the same ends.
  int64_t num_moved = 0;
  for (const auto& [what, count] : result.summary.kept) {
    if (what.starts_with("ends: moved")) num_moved += count;
  }
  EXPECT_EQ(num_moved, result.moves.num_ends);
  EXPECT_EQ(result.summary.dropped.back().second + num_moved, 2 * 12);
}

TEST(Regularize, WhatIsNearlyRegularStays) {
  // Five lines that differ by 2 degrees each.
  NoisyDrawing drawing;
  for (int i = 0; i < 5; ++i) {
    const double angle = i * 2 * kDeg;
    const Vector3d middle(0, 0.15 * i - 0.3, 0.05 * i);
    const Vector3d half(0.4 * std::cos(angle), 0, 0.4 * std::sin(angle));
    AddFreeLine(middle - half, middle + half, &drawing);
  }
  const DrawingGraph before = Fitted(&drawing);
  const RegularityResult result = Regularized(before);
  EXPECT_TRUE(result.graph.regularities.IsEmpty());
  EXPECT_EQ(result.moves.num_ends, 0);
  for (size_t n = 0; n < before.nodes.size(); ++n) {
    EXPECT_EQ(result.graph.nodes[n].position_in_world, before.nodes[n].position_in_world);
  }
}

TEST(Regularize, CirclesGetOneAxisAndOneRadius) {
  NoisyDrawing drawing;
  const Vector3d x = Tilt().col(0), y = Tilt().col(1), axis = Tilt().col(2);
  for (const double height : {-0.3, 0.0, 0.3}) {
    AddCircle(height * axis, 0.35 * x, 0.35 * y, &drawing);
  }
  AddCircle(0.1 * axis + 0.05 * x, 0.2 * x, 0.2 * y, &drawing);  // of neither
  const RegularityResult result = Regularized(Fitted(&drawing));
  const Regularities& found = result.graph.regularities;
  ASSERT_EQ(found.radii.size(), 1u);
  EXPECT_NEAR(found.radii[0], 0.35, 0.1 * kPx);
  ASSERT_EQ(found.axes.size(), 1u);
  EXPECT_LT(found.axes[0].direction.cross(axis).norm(), 0.003);
  const auto on_axis = [](const LinkRegularity& of) { return of.axis == 0 && of.radius == 0; };
  EXPECT_THAT(LinksThat(result.graph, on_axis), ::testing::ElementsAre(0, 1, 2));
  for (const LinkId l : {0, 1, 2}) {
    const auto& circle = std::get<CircularArc>(result.graph.links[l].primitive.value().shape);
    EXPECT_NEAR(circle.radius, found.radii[0], 1e-9);
    EXPECT_LT((circle.center - found.axes[0].point).cross(found.axes[0].direction).norm(),
              1e-3 * kPx);
    EXPECT_LT(circle.Normal().cross(found.axes[0].direction).norm(), 1e-6);
  }
  EXPECT_TRUE(!result.graph.links[3].regularity || result.graph.links[3].regularity->radius < 0);
}

TEST(Regularize, NoResidualGrows) {
  NoisyDrawing drawing;
  AddBox(&drawing);
  const DrawingGraph before = Fitted(&drawing);
  RegularityOptions options;
  options.max_growth_px = 0.01;
  const RegularityResult result = Regularized(before, options);
  for (size_t l = 0; l < before.links.size(); ++l) {
    EXPECT_LE(result.graph.links[l].primitive->rms_px,
              before.links[l].primitive->rms_px + options.max_growth_px + 1e-9);
  }
}

// A face whose border is a link and a bridge between its ends.
DrawingFace FaceOf(const DrawingGraph& graph, LinkId id) {
  const DrawingLink& link = graph.links[id];
  const FaceEdge whole = {id, 0, static_cast<double>(link.size() - 1), {}};
  const FaceEdge back = {-1, 0, 0, {link.points_in_world.back(), link.points_in_world.front()}};
  DrawingFace face;
  face.loops = {{whole, back}};
  return face;
}

TEST(Regularize, FacesStayWithLinksThatStay) {
  NoisyDrawing drawing;
  AddBox(&drawing);
  const Vector3d alone = Vector3d(1, 2, 3).normalized();
  AddFreeLine(Vector3d(0.6, 0.6, 0), Vector3d(0.6, 0.6, 0) + 0.3 * alone, &drawing);
  DrawingGraph before = Fitted(&drawing);
  for (const LinkId id : {0, 12, 5}) before.faces.push_back(FaceOf(before, id));
  const RegularityResult result = Regularized(before);
  ASSERT_NE(result.graph.links[0].points_in_world, before.links[0].points_in_world);
  ASSERT_NE(result.graph.links[5].points_in_world, before.links[5].points_in_world);
  ASSERT_EQ(result.graph.links[12].points_in_world, before.links[12].points_in_world);
  ASSERT_EQ(result.graph.faces.size(), 1u);
  EXPECT_EQ(result.graph.faces[0].loops[0][0].link, 12);
}

TEST(Regularize, OptionsAreChecked) {
  RegularityOptions options;
  options.max_growth_px = -1;
  EXPECT_THROW(Regularize({}, testing::ViewsOfNoisyDrawing(), options, {}, {}), OptionError);
  PrimitiveOptions primitives;
  primitives.max_residual_px = 0;
  EXPECT_THROW(Regularize({}, testing::ViewsOfNoisyDrawing(), {}, primitives, {}), OptionError);
}

TEST(Regularize, AnEmptyDrawingStaysEmpty) {
  const RegularityResult result = Regularized({});
  EXPECT_TRUE(result.graph.links.empty());
  EXPECT_TRUE(result.graph.regularities.IsEmpty());
}

}  // namespace
}  // namespace limn
