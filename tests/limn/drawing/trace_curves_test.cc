// SPDX-License-Identifier: BSD-3-Clause
#include "limn/drawing/trace_curves.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "limn/drawing/noisy_samples.h"
#include "limn/topology/graph_fixture.h"
#include "limn/topology/link_geometry.h"

namespace limn {
namespace {

using Eigen::Vector3d;
using testing::CircleAround;
using testing::LineBetween;
using testing::PxCurve;
using testing::SampleMaker;
using testing::SampleNoise;

constexpr int kNumTracedViews = 4;
constexpr double kNoise = 0.15;
// Five standard deviations of the mean of the ten samples that are near the end of a line.
const double kLargestError = 5 * kNoise / std::sqrt(10);
// Curves begin and end within a step of their samples, which begin and end within a px of their
// lines.
constexpr double kTracedEndPx = 2;

struct Traced {
  DrawingGraph graph;
  TracingCounts counts;
};

Traced Trace(const SampleMaker& maker, const TracingOptions& options = {}) {
  const SampleSet& samples = maker.samples();
  Traced traced;
  traced.graph = TraceCurves(samples, options, {}, &traced.counts);
  testing::ExpectValid(traced.graph);
  // Samples are listed once, or else counted as not traced.
  std::set<SketchSample> listed;
  int64_t num_listed = 0;
  for (const DrawingLink& link : traced.graph.links) {
    for (const double sigma : link.sigma) EXPECT_EQ(sigma, 0);
    for (const LinkVertex& vertex : link.vertices) {
      listed.insert(vertex.samples.begin(), vertex.samples.end());
      num_listed += std::ssize(vertex.samples);
      EXPECT_EQ(vertex.samples.size(), vertex.support.size());
    }
  }
  EXPECT_EQ(std::ssize(listed), num_listed);
  EXPECT_EQ(num_listed + traced.counts.unclaimed, samples.NumSamples());
  return traced;
}

// The links whose points are all near a curve, which they cover except for its ends.
int NumLinksAlong(const DrawingGraph& graph, const PxCurve& curve, double within_px) {
  return static_cast<int>(std::ranges::count_if(graph.links, [&](const DrawingLink& link) {
    const auto distance = [&](const Vector3d& point) {
      double nearest = (curve.at(0) - point).norm();
      for (double arc = 0; arc <= curve.length_px; arc += 0.05) {
        nearest = std::min(nearest, (curve.at(arc) - point).norm());
      }
      return nearest;
    };
    return std::ranges::all_of(
               link.points_in_world,
               [&](const Vector3d& point) { return distance(point) < within_px; }) &&
           std::abs(LengthPx(link) - curve.length_px) < 2 * kTracedEndPx;
  }));
}

TEST(TraceCurvesTest, NothingGivesNothing) {
  const Traced traced = Trace(SampleMaker());
  EXPECT_TRUE(traced.graph.links.empty());
  EXPECT_EQ(traced.counts.curves, 0);
  EXPECT_EQ(traced.counts.unclaimed, 0);
}

TEST(TraceCurvesTest, LineIsOneLink) {
  SampleMaker maker;
  const PxCurve line = LineBetween({0, 0, 0}, {60, 30, 60});
  maker.AddInViews(line, 0, kNumTracedViews, SampleNoise::Even(kNoise));
  const Traced traced = Trace(maker);
  ASSERT_EQ(traced.graph.links.size(), 1u);
  EXPECT_EQ(NumLinksAlong(traced.graph, line, 1), 1);
  for (const Vector3d& point : traced.graph.links[0].points_in_world) {
    const Vector3d along = Vector3d(2, 1, 2) / 3;
    EXPECT_LT((point - point.dot(along) * along).norm(), kLargestError);
  }
  EXPECT_EQ(traced.counts.curves, 1);
  EXPECT_EQ(traced.counts.closed, 0);
  EXPECT_EQ(traced.counts.meetings, 0);
  EXPECT_EQ(traced.counts.unclaimed, 0);
}

TEST(TraceCurvesTest, VerticesKnowTheViewsThatAgree) {
  SampleMaker maker;
  maker.AddInViews(LineBetween({0, 0, 0}, {60, 0, 0}), 0, kNumTracedViews);
  const Traced traced = Trace(maker);
  ASSERT_EQ(traced.graph.links.size(), 1u);
  for (const LinkVertex& vertex : traced.graph.links[0].vertices) {
    EXPECT_EQ(vertex.agreeing_views, kNumTracedViews);
    EXPECT_EQ(vertex.footprint, 1);
  }
}

TEST(TraceCurvesTest, CircleIsOneClosedLink) {
  for (const double radius : {6.0, 20.0}) {
    SampleMaker maker;
    const PxCurve circle = CircleAround({0, 0, 0}, radius);
    maker.AddInViews(circle, 0, kNumTracedViews, SampleNoise::Even(kNoise));
    const Traced traced = Trace(maker);
    ASSERT_EQ(traced.graph.links.size(), 1u);
    EXPECT_TRUE(traced.graph.links[0].closed);
    EXPECT_EQ(NumLinksAlong(traced.graph, circle, 1), 1);
    EXPECT_EQ(traced.counts.closed, 1);
    EXPECT_EQ(traced.counts.meetings, 0);
    // Those between the last vertex and the first.
    EXPECT_LE(traced.counts.unclaimed, kNumTracedViews);
  }
}

TEST(TraceCurvesTest, OpenArcStaysOpen) {
  SampleMaker maker;
  const PxCurve arc = testing::ArcAround({0, 0, 0}, 20, 0, 1.8 * M_PI);
  maker.AddInViews(arc, 0, kNumTracedViews, SampleNoise::Even(kNoise));
  const Traced traced = Trace(maker);
  ASSERT_EQ(traced.graph.links.size(), 1u);
  EXPECT_FALSE(traced.graph.links[0].closed);
  EXPECT_EQ(NumLinksAlong(traced.graph, arc, 1), 1);
}

TEST(TraceCurvesTest, CrossingLinesStayTwo) {
  SampleMaker maker;
  const PxCurve first = LineBetween({-30, 0, 0}, {30, 0, 0});
  const PxCurve second = LineBetween({-15, -26, 0}, {15, 26, 0});
  maker.AddInViews(first, 0, kNumTracedViews, SampleNoise::Even(kNoise));
  maker.AddInViews(second, 0, kNumTracedViews, SampleNoise::Even(kNoise));
  const Traced traced = Trace(maker);
  EXPECT_EQ(traced.graph.links.size(), 2u);
  EXPECT_EQ(traced.counts.meetings, 0);
  EXPECT_EQ(NumLinksAlong(traced.graph, first, 1), 1);
  EXPECT_EQ(NumLinksAlong(traced.graph, second, 1), 1);
}

TEST(TraceCurvesTest, LinesTwoAndAHalfPxApartStayTwo) {
  SampleMaker maker;
  const PxCurve first = LineBetween({0, 0, 0}, {60, 0, 0});
  const PxCurve second = LineBetween({0, 2.5, 0}, {60, 2.5, 0});
  maker.AddInViews(first, 0, kNumTracedViews, SampleNoise::Even(kNoise));
  maker.AddInViews(second, 0, kNumTracedViews, SampleNoise::Even(kNoise));
  const Traced traced = Trace(maker);
  EXPECT_EQ(traced.graph.links.size(), 2u);
  EXPECT_EQ(traced.counts.meetings, 0);
  EXPECT_EQ(NumLinksAlong(traced.graph, first, 1), 1);
  EXPECT_EQ(NumLinksAlong(traced.graph, second, 1), 1);
}

TEST(TraceCurvesTest, StrandsOfOneEdgeAreOneLink) {
  // As blur moves it in some views.
  SampleMaker maker;
  for (ViewId view = 0; view < 6; ++view) {
    const double y = 0.3 * (view % 3 - 1);
    maker.Add(LineBetween({0, y, 0}, {60, y, 0}), view, SampleNoise::Even(kNoise));
  }
  const Traced traced = Trace(maker);
  EXPECT_EQ(traced.graph.links.size(), 1u);
  EXPECT_EQ(NumLinksAlong(traced.graph, LineBetween({0, 0, 0}, {60, 0, 0}), 1), 1);
  EXPECT_EQ(traced.counts.unclaimed, 0);
}

TEST(TraceCurvesTest, CurveThatRunsIntoALineEndsOnIt) {
  // An arc that ends along the line, at the origin.
  SampleMaker maker;
  maker.AddInViews(LineBetween({-50, 0, 0}, {50, 0, 0}), 0, kNumTracedViews,
                   SampleNoise::Even(kNoise));
  maker.AddInViews(testing::ArcAround({0, 30, 0}, 30, -M_PI / 2, -M_PI / 2), 0, kNumTracedViews,
                   SampleNoise::Even(kNoise));
  const Traced traced = Trace(maker);
  EXPECT_EQ(traced.graph.links.size(), 3u);
  EXPECT_EQ(traced.counts.curves, 2);
  EXPECT_EQ(traced.counts.meetings, 1);
  const auto node = std::ranges::find(traced.graph.nodes, NodeKind::kJunction, &DrawingNode::kind);
  ASSERT_NE(node, traced.graph.nodes.end());
  EXPECT_EQ(node->Degree(), 3);
  // The arc is a px from the line at x = -8; a step further the samples ahead are the line's.
  EXPECT_LT(node->position_in_world.x(), 2);
  EXPECT_GT(node->position_in_world.x(), -12);
  EXPECT_LT(std::abs(node->position_in_world.y()), 1);
}

TEST(TraceCurvesTest, CurvesThatPartAreBothTraced) {
  // As above, but traced from where they are one.
  SampleMaker maker;
  maker.AddInViews(testing::ArcAround({0, 30, 0}, 30, -M_PI / 2, -M_PI / 2), 0, kNumTracedViews,
                   SampleNoise::Even(kNoise));
  maker.AddInViews(LineBetween({-50, 0, 0}, {50, 0, 0}), 0, kNumTracedViews,
                   SampleNoise::Even(kNoise));
  const Traced traced = Trace(maker);
  EXPECT_EQ(traced.graph.links.size(), 3u);
  EXPECT_EQ(traced.counts.curves, 2);
  EXPECT_EQ(traced.counts.meetings, 1);
  // Where they part, the first may run between them.
  for (const DrawingLink& link : traced.graph.links) {
    for (const Vector3d& point : link.points_in_world) {
      const double to_line = std::abs(point.y());
      const double to_arc = std::abs((point - Vector3d(0, 30, 0)).norm() - 30);
      EXPECT_LT(std::min(to_line, to_arc), 1);
    }
  }
}

TEST(TraceCurvesTest, CurveMayEndOnItself) {
  // A stem that becomes a ring, which comes back to where it began.
  SampleMaker maker;
  const PxCurve stem = LineBetween({-40, 0, 0}, {0, 0, 0});
  const PxCurve ring = testing::ArcAround({0, 25, 0}, 25, -M_PI / 2, 2 * M_PI);
  const PxCurve six = {[&](double arc) { return arc < 40 ? stem.at(arc) : ring.at(arc - 40); },
                       40 + ring.length_px};
  maker.AddInViews(six, 0, kNumTracedViews, SampleNoise::Even(kNoise));
  const Traced traced = Trace(maker);
  EXPECT_EQ(traced.counts.curves, 1);
  EXPECT_EQ(traced.counts.closed, 0);
  EXPECT_EQ(traced.counts.meetings, 1);
  EXPECT_EQ(traced.graph.links.size(), 2u);
  EXPECT_EQ(traced.graph.nodes.size(), 2u);
}

TEST(TraceCurvesTest, GapsAreBridgedUpToTheLimit) {
  const auto num_links = [](double gap_px, double max_gap_px) {
    SampleMaker maker;
    maker.AddInViews(LineBetween({0, 0, 0}, {30, 0, 0}), 0, kNumTracedViews);
    maker.AddInViews(LineBetween({30 + gap_px, 0, 0}, {60, 0, 0}), 0, kNumTracedViews);
    TracingOptions options;
    options.max_gap_px = max_gap_px;
    const Traced traced = Trace(maker, options);
    for (const DrawingLink& link : traced.graph.links) {
      for (int k = 1; k < link.size(); ++k) EXPECT_LT(ArcPx(link, k - 1, k), 2);
    }
    return traced.graph.links.size();
  };
  EXPECT_EQ(num_links(5, 6), 1u);
  EXPECT_EQ(num_links(8, 6), 2u);
  EXPECT_EQ(num_links(8, 9), 1u);
  EXPECT_EQ(num_links(5, 3), 2u);
}

TEST(TraceCurvesTest, CurvesStartWhereManyViewsAgreeAndGoOnWhereFewerDo) {
  SampleMaker maker;
  maker.Add(LineBetween({-30, 0, 0}, {90, 0, 0}), 0);
  maker.Add(LineBetween({0, 0, 0}, {60, 0, 0}), 1);
  maker.Add(LineBetween({20, 0, 0}, {40, 0, 0}), 2);
  maker.AddInViews(LineBetween({0, 50, 0}, {60, 50, 0}), 0, 2);
  TracingOptions options;
  options.min_seed_views = 3;
  options.min_traced_views = 2;
  const Traced traced = Trace(maker, options);
  ASSERT_EQ(traced.graph.links.size(), 1u);
  // Samples count for those up to 1.5 px before and after them.
  EXPECT_NEAR(LengthPx(traced.graph.links[0]), 60, 2 * (1.5 + 1));
  for (const Vector3d& point : traced.graph.links[0].points_in_world) EXPECT_LT(point.y(), 1);
  options.min_seed_views = 2;
  EXPECT_EQ(Trace(maker, options).graph.links.size(), 2u);
  options.min_seed_views = 4;
  EXPECT_EQ(Trace(maker, options).graph.links.size(), 0u);
  options.min_seed_views = 1;
  options.min_traced_views = 1;
  const DrawingGraph all = Trace(maker, options).graph;
  ASSERT_EQ(all.links.size(), 2u);
  EXPECT_NEAR(LengthPx(all.links[0]), 120, 2 * kTracedEndPx);
}

TEST(TraceCurvesTest, ShortCurvesAreDroppedAndCounted) {
  SampleMaker maker;
  maker.AddInViews(LineBetween({0, 0, 0}, {3, 0, 0}), 0, kNumTracedViews);
  const int num_short = maker.samples().NumSamples();
  maker.AddInViews(LineBetween({0, 30, 0}, {12, 30, 0}), 0, kNumTracedViews);
  const int num_traced = maker.samples().NumSamples() - num_short;
  maker.Add(LineBetween({0, 60, 0}, {30, 60, 0}), 0);  // of one view
  const Traced traced = Trace(maker);
  ASSERT_EQ(traced.graph.links.size(), 1u);
  EXPECT_NEAR(traced.graph.links[0].points_in_world[0].y(), 30, 1e-9);
  EXPECT_EQ(traced.counts.curves, 1);
  EXPECT_EQ(traced.counts.unclaimed, maker.samples().NumSamples() - num_traced);
}

TEST(TraceCurvesTest, ScaledSamplesGiveTheScaledDrawing) {
  const auto trace = [](double footprint) {
    // Spacings of a px would put samples just on the limits of steps.
    SampleMaker maker(footprint, 0.9713);
    maker.AddInViews(LineBetween({0, 0, 0}, {60, 0, 0}), 0, kNumTracedViews,
                     SampleNoise::Even(kNoise));
    maker.AddInViews(CircleAround({0, 30, 0}, 15), 0, kNumTracedViews, SampleNoise::Even(kNoise));
    return Trace(maker).graph;
  };
  const DrawingGraph graph = trace(1);
  for (const double scale : {1e-6, 1e6}) {
    const DrawingGraph scaled = trace(scale);
    ASSERT_EQ(scaled.links.size(), graph.links.size());
    EXPECT_EQ(scaled.nodes.size(), graph.nodes.size());
    for (size_t l = 0; l < graph.links.size(); ++l) {
      ASSERT_EQ(scaled.links[l].size(), graph.links[l].size());
      for (int k = 0; k < graph.links[l].size(); ++k) {
        const Vector3d point = scaled.links[l].points_in_world[k] / scale;
        EXPECT_LT((point - graph.links[l].points_in_world[k]).norm(), 1e-6);
      }
    }
  }
}

}  // namespace
}  // namespace limn
