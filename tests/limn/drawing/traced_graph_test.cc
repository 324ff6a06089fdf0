// SPDX-License-Identifier: BSD-3-Clause
#include "limn/drawing/traced_graph.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "limn/drawing/noisy_samples.h"
#include "limn/topology/graph_fixture.h"

namespace limn {
namespace {

using Eigen::Vector3d;
using testing::CircleAround;
using testing::LineBetween;
using testing::PxCurve;

// Traced curves whose vertices, a px apart, stand for one sample each.
class TracedScene {
 public:
  // Returns the curve.
  int Add(const PxCurve& curve, bool closed = false) {
    const int first = static_cast<int>(traced_.vertices.size());
    const int id = static_cast<int>(traced_.curves.size());
    maker_.Add(curve, 0);
    const SampleSet& samples = maker_.samples();
    traced_.curves.emplace_back();
    traced_.curves.back().closed = closed;
    for (int s = first; s < samples.NumSamples(); ++s) {
      traced_.curves.back().vertices.push_back(s);
      traced_.vertices.push_back({samples.position[s], samples.tangent[s], 1, id, {s}});
    }
    return id;
  }
  // An end of a curve comes upon a vertex of another one; counted from the last vertex if negative.
  void Meet(int curve, int end, int other, int index) {
    const std::vector<int>& vertices = traced_.curves[other].vertices;
    traced_.curves[curve].meets[end] = index >= 0 ? vertices[index] : vertices.end()[index];
  }
  TracedVertex& Vertex(int curve, int index) {
    return traced_.vertices[traced_.curves[curve].vertices[index]];
  }
  const SampleSet& samples() const { return maker_.samples(); }

  DrawingGraph Make(const std::vector<int>& num_views = {}) {
    const SampleSet& samples = maker_.samples();
    Consensus consensus = {samples.position, samples.tangent, num_views};
    consensus.num_views.resize(samples.NumSamples(), 3);
    DrawingGraph graph = MakeTracedGraph(samples, consensus, traced_);
    testing::ExpectValid(graph);
    for (const DrawingLink& link : graph.links) {
      EXPECT_EQ(link.vertices.size(), link.points_in_world.size());
      for (const double sigma : link.sigma) EXPECT_EQ(sigma, 0);
    }
    return graph;
  }

 private:
  testing::SampleMaker maker_;
  TracedCurves traced_;
};

// Every sample appears once.
void ExpectSamplesOnce(const DrawingGraph& graph, const SampleSet& samples) {
  std::map<SketchSample, int> times;
  for (const DrawingLink& link : graph.links) {
    for (const LinkVertex& vertex : link.vertices) {
      for (const SketchSample& sample : vertex.samples) ++times[sample];
    }
  }
  EXPECT_EQ(std::ssize(times), samples.NumSamples());
  for (const auto& [sample, count] : times) EXPECT_EQ(count, 1);
}

double LongestStep(const DrawingLink& link) {
  double longest = 0;
  for (int k = 1; k < link.size(); ++k) {
    longest = std::max(longest, (link.points_in_world[k] - link.points_in_world[k - 1]).norm());
  }
  return longest;
}

TEST(TracedGraphTest, NothingGivesNothing) {
  TracedScene scene;
  EXPECT_TRUE(scene.Make().links.empty());
}

TEST(TracedGraphTest, FreeCurveIsALinkWithItsSamples) {
  TracedScene scene;
  scene.Add(LineBetween({0, 0, 0}, {20, 0, 0}));
  scene.Add(LineBetween({0, 9, 0}, {20, 9, 0}));
  const DrawingGraph graph = scene.Make();
  ASSERT_EQ(graph.links.size(), 2u);
  EXPECT_EQ(graph.nodes.size(), 4u);
  const DrawingLink& link = graph.links[1];
  ASSERT_EQ(link.size(), 21);
  for (int k = 0; k < link.size(); ++k) {
    EXPECT_EQ(link.points_in_world[k], scene.Vertex(1, k).position);
    // Names are those of the sketch, whose curve begins three samples earlier.
    EXPECT_EQ(link.vertices[k].samples, (std::vector<SketchSample>{{1, 3 + k}}));
    const auto support = scene.samples().support.Of(21 + k);
    EXPECT_EQ(link.vertices[k].support, std::vector<EdgelRef>(support.begin(), support.end()));
    EXPECT_EQ(link.vertices[k].information, scene.samples().information[21 + k]);
    EXPECT_EQ(link.vertices[k].footprint, 1);
  }
}

TEST(TracedGraphTest, VertexHasTheMeanInformationAndTheMostViewsOfItsSamples) {
  TracedScene scene;
  scene.Add(LineBetween({0, 0, 0}, {20, 0, 0}));
  std::vector<int> num_views(21, 2);
  num_views[8] = 5;
  scene.Vertex(0, 7).samples = {7, 8};
  scene.Vertex(0, 8).samples = {};
  const DrawingGraph graph = scene.Make(num_views);
  ASSERT_EQ(graph.links.size(), 1u);
  const std::vector<LinkVertex>& vertices = graph.links[0].vertices;
  EXPECT_EQ(vertices[7].agreeing_views, 5);
  EXPECT_EQ(vertices[7].samples.size(), 2u);
  EXPECT_EQ(vertices[7].support.size(), 2u);
  EXPECT_TRUE(vertices[7].information.isApprox(scene.samples().information[7]));
  // A vertex without samples is determined like the one before it.
  EXPECT_EQ(vertices[8].agreeing_views, 0);
  EXPECT_TRUE(vertices[8].information.isApprox(scene.samples().information[7]));
}

TEST(TracedGraphTest, ClosedCurveIsAClosedLink) {
  TracedScene scene;
  scene.Add(CircleAround({0, 0, 0}, 12), true);
  const DrawingGraph graph = scene.Make();
  ASSERT_EQ(graph.links.size(), 1u);
  EXPECT_TRUE(graph.links[0].closed);
  ASSERT_EQ(graph.nodes.size(), 1u);
  EXPECT_EQ(graph.nodes[0].kind, NodeKind::kLoopAnchor);
  EXPECT_LT(LongestStep(graph.links[0]), 1.5);
  ExpectSamplesOnce(graph, scene.samples());
}

TEST(TracedGraphTest, ClosedCurveBeginsWhereAnotherMeetsIt) {
  TracedScene scene;
  const int ring = scene.Add(CircleAround({0, 0, 0}, 12), true);
  const int spoke = scene.Add(LineBetween({0, 40, 0}, {0, 13, 0}));
  scene.Meet(spoke, 1, ring, 19);
  const DrawingGraph graph = scene.Make();
  ASSERT_EQ(graph.links.size(), 2u);
  ASSERT_EQ(graph.nodes.size(), 2u);
  EXPECT_EQ(testing::DegreeAt(graph, scene.Vertex(ring, 19).position), 3);
  ExpectSamplesOnce(graph, scene.samples());
}

TEST(TracedGraphTest, ClosedCurveIsCutWhereTwoOthersMeetIt) {
  TracedScene scene;
  const int ring = scene.Add(CircleAround({0, 0, 0}, 12), true);
  const int spoke = scene.Add(LineBetween({0, 40, 0}, {0, 13, 0}));
  scene.Meet(spoke, 1, ring, 19);
  // Near the first vertex, where an open curve would have an end.
  const int other = scene.Add(LineBetween({40, 2, 0}, {13, 2, 0}));
  scene.Meet(other, 1, ring, 2);
  const DrawingGraph graph = scene.Make();
  ASSERT_EQ(graph.links.size(), 4u);
  EXPECT_EQ(testing::DegreeAt(graph, scene.Vertex(ring, 19).position), 3);
  EXPECT_EQ(testing::DegreeAt(graph, scene.Vertex(ring, 2).position), 3);
  ExpectSamplesOnce(graph, scene.samples());
}

TEST(TracedGraphTest, EndOnTheInteriorOfALinkMakesAT) {
  for (const int end : {0, 1}) {
    TracedScene scene;
    const int bar = scene.Add(LineBetween({0, 0, 0}, {40, 0, 0}));
    const int stem = end == 0 ? scene.Add(LineBetween({20, 1, 0}, {20, 30, 0}))
                              : scene.Add(LineBetween({20, 30, 0}, {20, 1, 0}));
    scene.Meet(stem, end, bar, 20);
    const DrawingGraph graph = scene.Make();
    ASSERT_EQ(graph.links.size(), 3u);
    EXPECT_EQ(graph.nodes.size(), 4u);
    EXPECT_EQ(testing::DegreeAt(graph, {20, 0, 0}), 3);
    EXPECT_EQ(testing::DegreeAt(graph, {20, 30, 0}), 1);
    ExpectSamplesOnce(graph, scene.samples());
  }
}

TEST(TracedGraphTest, EndDoesNotRunBackFromAMeeting) {
  TracedScene scene;
  const int bar = scene.Add(LineBetween({0, 0, 0}, {40, 0, 0}));
  const int stem = scene.Add(LineBetween({20, 30, 0}, {20, -2, 0}));
  scene.Meet(stem, 1, bar, 20);
  const DrawingGraph graph = scene.Make();
  ASSERT_EQ(graph.links.size(), 3u);
  const Polyline3d& points = graph.links[2].points_in_world;
  for (size_t k = 1; k < points.size(); ++k) EXPECT_LT(points[k].y(), points[k - 1].y());
  EXPECT_EQ(points.back(), Vector3d(20, 0, 0));
  // The end has the samples beyond it, and their edgels.
  const LinkVertex& last = graph.links[2].vertices.end()[-2];
  EXPECT_EQ(last.samples.size(), 4u);
  EXPECT_EQ(last.support.size(), 4u);
  EXPECT_TRUE(std::ranges::is_sorted(last.support));
  ExpectSamplesOnce(graph, scene.samples());
}

TEST(TracedGraphTest, EndOnItsOwnInteriorMakesASix) {
  TracedScene scene;
  // A stem that turns into a ring and comes back to where the ring began.
  constexpr double kStem = 20;
  const PxCurve stem = LineBetween({-kStem, 0, 0}, {0, 0, 0});
  const PxCurve ring = testing::ArcAround({0, 12, 0}, 12, -M_PI / 2, 2 * M_PI);
  const int six =
      scene.Add({[&](double arc) { return arc < kStem ? stem.at(arc) : ring.at(arc - kStem); },
                 kStem + ring.length_px - 1});
  scene.Meet(six, 1, six, static_cast<int>(kStem));
  const DrawingGraph graph = scene.Make();
  ASSERT_EQ(graph.links.size(), 2u);
  EXPECT_EQ(graph.nodes.size(), 2u);
  EXPECT_EQ(testing::DegreeAt(graph, {0, 0, 0}, 1e-3), 3);
  EXPECT_NEAR(Length(graph.links[0].points_in_world), kStem, 1e-3);
  EXPECT_NEAR(Length(graph.links[1].points_in_world), ring.length_px, 0.5);
  ExpectSamplesOnce(graph, scene.samples());
}

TEST(TracedGraphTest, BothEndsOnOneLinkMakeAP) {
  TracedScene scene;
  const int stem = scene.Add(LineBetween({0, -20, 0}, {0, 20, 0}));
  const int bowl = scene.Add(testing::ArcAround({0, 10, 0}, 10, M_PI / 2, -M_PI));
  scene.Meet(bowl, 0, stem, -3);
  scene.Meet(bowl, 1, stem, 20);
  const DrawingGraph graph = scene.Make();
  ASSERT_EQ(graph.links.size(), 3u);
  EXPECT_EQ(graph.nodes.size(), 3u);
  EXPECT_EQ(testing::DegreeAt(graph, {0, 20, 0}), 2);
  EXPECT_EQ(testing::DegreeAt(graph, {0, 0, 0}), 3);
}

TEST(TracedGraphTest, MeetingNearAnEndIsAtTheEnd) {
  for (const int index : {0, 4, -5, -1}) {
    TracedScene scene;
    const int first = scene.Add(LineBetween({0, 0, 0}, {40, 0, 0}));
    const double x = index >= 0 ? 0 : 40;
    const int second = scene.Add(LineBetween({x, 30, 0}, {x, 1, 0}));
    scene.Meet(second, 1, first, index);
    const DrawingGraph graph = scene.Make();
    EXPECT_EQ(graph.links.size(), 2u);
    EXPECT_EQ(graph.nodes.size(), 3u);
    EXPECT_EQ(testing::DegreeAt(graph, {x, 0, 0}), 2);
  }
}

TEST(TracedGraphTest, EndsThatMeetOneEndShareItsNode) {
  TracedScene scene;
  const int first = scene.Add(LineBetween({0, 0, 0}, {40, 0, 0}));
  for (const double y : {-30.0, 30.0}) {
    const int other = scene.Add(LineBetween({70, y, 0}, {41, 0, 0}));
    scene.Meet(other, 1, first, -1 - (y > 0 ? 2 : 0));
  }
  const DrawingGraph graph = scene.Make();
  EXPECT_EQ(graph.links.size(), 3u);
  EXPECT_EQ(testing::DegreeAt(graph, {40, 0, 0}), 3);
}

TEST(TracedGraphTest, MeetingAtAnEndThatMeetsAnotherCurveIsThere) {
  TracedScene scene;
  const int bar = scene.Add(LineBetween({0, 0, 0}, {40, 0, 0}));
  const int stem = scene.Add(LineBetween({20, 30, 0}, {20, 1, 0}));
  scene.Meet(stem, 1, bar, 20);
  const int third = scene.Add(LineBetween({40, 30, 0}, {21, 2, 0}));
  scene.Meet(third, 1, stem, -2);
  const DrawingGraph graph = scene.Make();
  EXPECT_EQ(graph.links.size(), 4u);
  EXPECT_EQ(graph.nodes.size(), 5u);
  EXPECT_EQ(testing::DegreeAt(graph, {20, 0, 0}), 4);
}

TEST(TracedGraphTest, MeetingAtTheEndOfASixIsWhereItCloses) {
  TracedScene scene;
  const int six = scene.Add(LineBetween({0, 0, 0}, {40, 0, 0}));
  scene.Meet(six, 1, six, 10);
  const int other = scene.Add(LineBetween({70, 0, 0}, {41, 0, 0}));
  scene.Meet(other, 1, six, -1);
  const DrawingGraph graph = scene.Make();
  EXPECT_EQ(graph.links.size(), 3u);
  EXPECT_EQ(testing::DegreeAt(graph, {10, 0, 0}), 4);
}

TEST(TracedGraphTest, LinkIsCutInOrder) {
  TracedScene scene;
  const int bar = scene.Add(LineBetween({0, 0, 0}, {40, 0, 0}));
  for (const int index : {30, 10, 20}) {
    const double x = index;
    const int stem = scene.Add(LineBetween({x, 30, 0}, {x, 1, 0}));
    scene.Meet(stem, 1, bar, index);
  }
  const DrawingGraph graph = scene.Make();
  ASSERT_EQ(graph.links.size(), 7u);
  for (int part = 0; part < 4; ++part) {
    const Polyline3d& points = graph.links[part].points_in_world;
    EXPECT_EQ(points.front(), Vector3d(10 * part, 0, 0));
    EXPECT_EQ(points.back(), Vector3d(10 * part + 10, 0, 0));
    EXPECT_EQ(points.size(), 11u);
  }
  ExpectSamplesOnce(graph, scene.samples());
}

TEST(TracedGraphTest, GapsAreBridgedByBarePoints) {
  TracedScene scene;
  constexpr double kGap = 6;
  scene.Add({[](double arc) -> Vector3d { return {arc > 20.5 ? arc + kGap - 1 : arc, 0, 0}; }, 40});
  const DrawingGraph graph = scene.Make();
  ASSERT_EQ(graph.links.size(), 1u);
  EXPECT_LT(LongestStep(graph.links[0]), 2);
  int num_bare = 0;
  for (const LinkVertex& vertex : graph.links[0].vertices) {
    num_bare += vertex.samples.empty();
    EXPECT_EQ(vertex.samples.empty(), vertex.support.empty());
    EXPECT_FALSE(vertex.information.isZero());
  }
  EXPECT_GE(num_bare, kGap / 2 - 1);
  EXPECT_LE(num_bare, kGap - 1);
  ExpectSamplesOnce(graph, scene.samples());
}

TEST(TracedGraphTest, GapsBeforeMeetingsAreBridged) {
  for (const int end : {0, 1}) {
    TracedScene scene;
    const int bar = scene.Add(LineBetween({0, 0, 0}, {40, 0, 0}));
    const int stem = end == 0 ? scene.Add(LineBetween({20, 6, 0}, {20, 30, 0}))
                              : scene.Add(LineBetween({20, 30, 0}, {20, 6, 0}));
    scene.Meet(stem, end, bar, 20);
    const DrawingGraph graph = scene.Make();
    ASSERT_EQ(graph.links.size(), 3u);
    EXPECT_LT(LongestStep(graph.links[2]), 2);
    ExpectSamplesOnce(graph, scene.samples());
  }
}

TEST(TracedGraphTest, GapWhereACurveClosesIsBridged) {
  TracedScene scene;
  constexpr double kGap = 6;
  PxCurve circle = CircleAround({0, 0, 0}, 12);
  circle.length_px -= kGap;
  scene.Add(circle, true);
  const DrawingGraph graph = scene.Make();
  ASSERT_EQ(graph.links.size(), 1u);
  EXPECT_TRUE(graph.links[0].closed);
  EXPECT_LT(LongestStep(graph.links[0]), 2);
  ExpectSamplesOnce(graph, scene.samples());
}

}  // namespace
}  // namespace limn
