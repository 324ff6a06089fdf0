#include "limn/regularity/regularize.h"

#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/primitives/fit_primitives.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using Eigen::Vector3d;

// Ten views around the origin; a pixel is about 8 mm large there.
constexpr double kPx = 0.008;
constexpr double kNoisePx = 0.15;

const std::vector<View>& ViewsAround() {
  static const std::vector<View> views = testing::DomeViews(10, 5);
  return views;
}

// A graph of noisy curves; the noise changes every 10 px.
class NoisyDrawing {
 public:
  NodeId AddNode(const Vector3d& position) {
    graph_.nodes.emplace_back();
    graph_.nodes.back().position_in_world = position + Noise();
    return static_cast<NodeId>(graph_.nodes.size()) - 1;
  }

  template <class Curve>
  void AddLink(NodeId node0, NodeId node1, double length, const Curve& curve) {
    const int count = std::max(3, static_cast<int>(length / kPx));
    DrawingLink link;
    Vector3d noise = Noise(), next = Noise();
    for (int k = 0; k <= count; ++k) {
      if (k % 10 == 0) noise = std::exchange(next, Noise());
      const double part = (k % 10) / 10.0;
      link.points_in_world.push_back(curve(static_cast<double>(k) / count) + (1 - part) * noise +
                                     part * next);
    }
    link.node0 = node0;
    link.node1 = node1;
    link.points_in_world.front() = graph_.nodes[node0].position_in_world;
    link.points_in_world.back() = graph_.nodes[node1].position_in_world;
    link.sigma.assign(link.points_in_world.size(), kNoisePx * kPx);
    link.closed = node0 == node1;
    for (size_t v = 0; v < ViewsAround().size(); ++v) {
      link.supporting_views.push_back(static_cast<ViewId>(v));
    }
    graph_.links.push_back(std::move(link));
  }

  void AddLine(NodeId node0, NodeId node1, const Vector3d& from, const Vector3d& to) {
    AddLink(node0, node1, (to - from).norm(),
            [&](double t) { return Vector3d((1 - t) * from + t * to); });
  }
  void AddFreeLine(const Vector3d& from, const Vector3d& to) {
    AddLine(AddNode(from), AddNode(to), from, to);
  }

  void AddCircle(const Vector3d& center, const Vector3d& x, const Vector3d& y) {
    const NodeId node = AddNode(center + x);
    AddLink(node, node, 2 * M_PI * x.norm(), [&](double t) {
      return Vector3d(center + std::cos(2 * M_PI * t) * x + std::sin(2 * M_PI * t) * y);
    });
  }

  DrawingGraph Fitted() {
    RebuildIncidence(&graph_);
    return FitPrimitives(graph_, ViewsAround(), {}, {}).graph;
  }

 private:
  Vector3d Noise() {
    std::normal_distribution<double> normal(0, kNoisePx * kPx);
    return {normal(random_), normal(random_), normal(random_)};
  }

  DrawingGraph graph_;
  std::mt19937 random_{5};
};

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
  for (int i = 0; i < 8; ++i) corners.push_back(drawing->AddNode(BoxCorner(i)));
  for (int i = 0; i < 8; ++i) {
    for (const int bit : {1, 2, 4}) {
      if (i & bit) continue;
      drawing->AddLine(corners[i], corners[i | bit], BoxCorner(i), BoxCorner(i | bit));
    }
  }
}

RegularityResult Regularized(const DrawingGraph& graph, const RegularityOptions& options = {}) {
  const RegularityResult result = Regularize(graph, ViewsAround(), options, {});
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
  const DrawingGraph before = drawing.Fitted();
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
}

TEST(Regularize, WhatIsNearlyRegularStays) {
  // Five lines that differ by 2 degrees each.
  NoisyDrawing drawing;
  for (int i = 0; i < 5; ++i) {
    const double angle = i * 2 * M_PI / 180;
    const Vector3d middle(0, 0.15 * i - 0.3, 0.05 * i);
    const Vector3d half(0.4 * std::cos(angle), 0, 0.4 * std::sin(angle));
    drawing.AddFreeLine(middle - half, middle + half);
  }
  const DrawingGraph before = drawing.Fitted();
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
    drawing.AddCircle(height * axis, 0.35 * x, 0.35 * y);
  }
  drawing.AddCircle(0.1 * axis + 0.05 * x, 0.2 * x, 0.2 * y);  // of neither
  const RegularityResult result = Regularized(drawing.Fitted());
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
  const DrawingGraph before = drawing.Fitted();
  RegularityOptions options;
  options.max_growth_px = 0.01;
  const RegularityResult result = Regularized(before, options);
  for (size_t l = 0; l < before.links.size(); ++l) {
    EXPECT_LE(result.graph.links[l].primitive->rms_px,
              before.links[l].primitive->rms_px + options.max_growth_px + 1e-9);
  }
}

TEST(Regularize, OptionsAreChecked) {
  RegularityOptions options;
  options.max_growth_px = -1;
  EXPECT_THROW(Regularize({}, ViewsAround(), options, {}), OptionError);
}

TEST(Regularize, AnEmptyDrawingStaysEmpty) {
  const RegularityResult result = Regularized({});
  EXPECT_TRUE(result.graph.links.empty());
  EXPECT_TRUE(result.graph.regularities.IsEmpty());
}

}  // namespace
}  // namespace limn
