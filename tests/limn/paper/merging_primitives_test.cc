// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/merging_primitives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

#include <gtest/gtest.h>

#include "limn/drawing/sample_curves.h"
#include "limn/topology/graph_fixture.h"

namespace limn {
namespace {

using Eigen::Vector3d;
using testing::MakeSamples;
using testing::Row;

const Vector3d kX(1, 0, 0);
const Vector3d kY(0, 1, 0);

std::vector<int> Range(int begin, int count) {
  std::vector<int> samples(count);
  std::iota(samples.begin(), samples.end(), begin);
  return samples;
}

std::vector<Vector3d> CircleOf(int count, double radius) {
  std::vector<Vector3d> circle;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * i / count;
    circle.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  return circle;
}

// The parameter says whether the target and the run are stored backwards.
class MergingPrimitivesTest : public ::testing::TestWithParam<std::tuple<bool, bool>> {
 protected:
  void Start(const std::vector<std::vector<Vector3d>>& curves) {
    samples_ = MakeSamples(curves);
    primitives_.emplace(samples_, options_, &graph_);
  }
  void AddTarget(std::vector<int> samples, bool closed = false) {
    if (std::get<0>(GetParam())) std::reverse(samples.begin(), samples.end());
    primitives_->AddRun(samples, closed);
  }
  void AddRun(std::vector<int> samples) {
    if (RunBackwards()) std::reverse(samples.begin(), samples.end());
    primitives_->AddRun(samples, false);
  }
  bool RunBackwards() const { return std::get<1>(GetParam()); }
  const MergingCounts& counts() { return primitives_->counts(); }

  int IdOf(const SketchSample& sample) const {
    return samples_.curve_begin[sample.curve] + sample.sample;
  }
  // The sample a vertex was made from, -1 where a point was added.
  int MadeFrom(const LinkVertex& vertex) const {
    return vertex.samples.empty() ? -1 : IdOf(vertex.samples.front());
  }
  std::vector<int> SamplesOf(const DrawingLink& link) const {
    std::vector<int> samples;
    for (const LinkVertex& vertex : link.vertices) samples.push_back(MadeFrom(vertex));
    return samples;
  }

  // The graph without what was removed.
  DrawingGraph Compact() const {
    DrawingGraph graph = graph_;
    GraphEditor(&graph).Compact();
    testing::ExpectValid(graph);
    return graph;
  }

  // Every sample's vertex is once in the link that it is said to be in.
  void ExpectConsistent() {
    Compact();
    for (int s = 0; s < samples_.NumSamples(); ++s) {
      const SketchSample home = samples_.NameOf(primitives_->HomeOf(s));
      int count = 0;
      for (const LinkVertex& vertex : graph_.links.at(primitives_->LinkOf(s)).vertices) {
        count += static_cast<int>(std::count(vertex.samples.begin(), vertex.samples.end(), home));
      }
      EXPECT_EQ(count, 1) << "sample " << s;
    }
  }

  // What does not depend on the direction in which links are stored: per link its number of points,
  // whether it is closed and how many of its ends are at nodes with others; sorted.
  std::vector<std::array<int, 3>> Shape() const {
    const DrawingGraph graph = Compact();
    std::vector<std::array<int, 3>> shape;
    for (const DrawingLink& link : graph.links) {
      const int num_tied =
          (graph.nodes[link.node0].Degree() > 1) + (graph.nodes[link.node1].Degree() > 1);
      shape.push_back({link.size(), link.closed, link.closed ? 0 : num_tied});
    }
    std::sort(shape.begin(), shape.end());
    return shape;
  }

  // Degree of every node at which links meet, sorted.
  std::vector<int> Degrees() const {
    std::vector<int> degrees;
    for (const DrawingNode& node : Compact().nodes) {
      if (node.Degree() > 1 && node.kind != NodeKind::kLoopAnchor) degrees.push_back(node.Degree());
    }
    std::sort(degrees.begin(), degrees.end());
    return degrees;
  }

  const PaperOptions options_;
  SampleSet samples_;
  DrawingGraph graph_;
  std::optional<MergingPrimitives> primitives_;
};

TEST_P(MergingPrimitivesTest, RunIsALinkOfItsSamples) {
  Start({Row({0, 0, 0}, kX, 10)});
  AddTarget(Range(0, 10));
  ExpectConsistent();
  const DrawingLink& link = graph_.links[primitives_->LinkOf(0)];
  std::vector<int> order = SamplesOf(link);
  if (std::get<0>(GetParam())) std::reverse(order.begin(), order.end());
  EXPECT_EQ(order, Range(0, 10));
  EXPECT_EQ(link.vertices[3].footprint, 1);
  EXPECT_EQ(link.vertices[3].information, samples_.information[3]);
}

TEST_P(MergingPrimitivesTest, RunBeyondAFreeEndElongates) {
  Start({Row({0, 0, 0}, kX, 50), Row({50, 0, 0}, kX, 40)});
  AddTarget(Range(0, 50));
  AddRun(Range(50, 40));
  primitives_->Attach(50, {49}, -1);
  ExpectConsistent();
  const DrawingGraph graph = Compact();
  ASSERT_EQ(graph.links.size(), 1u);
  std::vector<int> order = SamplesOf(graph.links[0]);
  if (order.front() > order.back()) std::reverse(order.begin(), order.end());
  EXPECT_EQ(order, Range(0, 90));
  EXPECT_EQ(graph.nodes.size(), 2u);
  EXPECT_EQ(counts().elongated, 1);
}

TEST_P(MergingPrimitivesTest, ElongationReplacesAShortStub) {
  // Leaves the target 4 px before its end.
  Start({Row({0, 0, 0}, kX, 50), Row({46, 0.5, 0}, kX, 40)});
  AddTarget(Range(0, 50));
  AddRun(Range(50, 40));
  primitives_->Attach(50, {45}, -1);
  ExpectConsistent();
  ASSERT_EQ(Compact().links.size(), 1u);
  EXPECT_EQ(Compact().links[0].size(), 46 + 40);
  // The stub's vertices live on beside where they were.
  EXPECT_EQ(primitives_->HomeOf(48), 52);
  EXPECT_EQ(primitives_->LinkOf(48), primitives_->LinkOf(60));
}

TEST_P(MergingPrimitivesTest, RunThatLeavesTheInsideBranches) {
  Start({Row({0, 0, 0}, kX, 61), Row({30, 1, 0}, kY, 40)});
  AddTarget(Range(0, 61));
  AddRun(Range(61, 40));
  primitives_->Attach(61, {30}, -1);
  ExpectConsistent();
  EXPECT_EQ(counts().branched, 1);
  EXPECT_EQ(Degrees(), std::vector<int>({3}));
  const std::vector<std::array<int, 3>> expected = {{31, 0, 1}, {31, 0, 1}, {41, 0, 1}};
  EXPECT_EQ(Shape(), expected);
  EXPECT_EQ(testing::DegreeAt(graph_, {30, 0, 0}), 3);
}

TEST_P(MergingPrimitivesTest, RunBetweenTwoFreeEndsMakesOneLink) {
  Start({Row({0, 0, 0}, kX, 40), Row({60, 0, 0}, kX, 40), Row({40, 0, 0}, kX, 20)});
  AddTarget(Range(0, 40));
  AddTarget(Range(40, 40));
  AddRun(Range(80, 20));
  primitives_->Attach(80, {39}, -1);
  // The run's other end is now an end of the longer link.
  primitives_->Attach(99, {40}, -1);
  ExpectConsistent();
  const DrawingGraph graph = Compact();
  ASSERT_EQ(graph.links.size(), 1u);
  EXPECT_EQ(graph.nodes.size(), 2u);
  std::vector<int> order = SamplesOf(graph.links[0]);
  if (order.front() != 0) std::reverse(order.begin(), order.end());
  std::vector<int> expected = Range(0, 40);
  for (const int s : Range(80, 20)) expected.push_back(s);
  for (const int s : Range(40, 40)) expected.push_back(s);
  EXPECT_EQ(order, expected);
}

TEST_P(MergingPrimitivesTest, RunToAnExistingNodeEndsThere) {
  Start({Row({0, 0, 0}, kX, 61), Row({30, 1, 0}, kY, 40), Row({30, 0, 1}, {0, 0, 1}, 40)});
  AddTarget(Range(0, 61));
  AddRun(Range(61, 40));
  primitives_->Attach(61, {30}, -1);
  AddRun(Range(101, 40));
  primitives_->Attach(101, {29}, -1);
  ExpectConsistent();
  EXPECT_EQ(Degrees(), std::vector<int>({4}));
  EXPECT_EQ(counts().multi_attached, 1);
}

TEST_P(MergingPrimitivesTest, OnlyEndsAreAttached) {
  Start({Row({0, 0, 0}, kX, 61), Row({30, 1, 0}, kY, 40)});
  AddTarget(Range(0, 61));
  AddRun(Range(61, 40));
  primitives_->Attach(80, {30}, -1);
  ExpectConsistent();
  EXPECT_TRUE(Degrees().empty());
  EXPECT_EQ(Compact().links.size(), 2u);
}

TEST_P(MergingPrimitivesTest, LoopCloses) {
  Start({CircleOf(120, 20)});
  AddTarget(Range(0, 120));
  const int first = RunBackwards() ? 119 : 0;
  primitives_->Attach(119 - first, {first}, -1);
  ExpectConsistent();
  ASSERT_EQ(Compact().links.size(), 1u);
  EXPECT_TRUE(Compact().links[0].closed);
  EXPECT_TRUE(Degrees().empty());
}

TEST_P(MergingPrimitivesTest, LoopClosesWithoutAStub) {
  // It meets itself 5 px from its other end.
  Start({CircleOf(120, 20)});
  AddTarget(Range(0, 120));
  primitives_->Attach(RunBackwards() ? 0 : 119, {RunBackwards() ? 114 : 5}, -1);
  ExpectConsistent();
  const DrawingGraph graph = Compact();
  ASSERT_EQ(graph.links.size(), 1u);
  EXPECT_TRUE(graph.links[0].closed);
  EXPECT_EQ(graph.links[0].size(), 116);  // the first is repeated
  EXPECT_EQ(counts().elongated + counts().branched + counts().multi_attached, 0);
}

TEST_P(MergingPrimitivesTest, RunThatMeetsItsOwnInsideEndsThere) {
  std::vector<Vector3d> p = Row({0, 0, 0}, kX, 61);
  for (const auto& leg :
       {Row({60, 1, 0}, kY, 30), Row({59, 30, 0}, -kX, 34), Row({26, 29, 0}, -kY, 28)}) {
    p.insert(p.end(), leg.begin(), leg.end());
  }
  Start({p});
  AddRun(Range(0, static_cast<int>(p.size())));
  primitives_->Attach(static_cast<int>(p.size()) - 1, {26}, -1);
  ExpectConsistent();
  EXPECT_EQ(Degrees(), std::vector<int>({3}));
  EXPECT_EQ(testing::DegreeAt(graph_, {26, 0, 0}), 3);
  EXPECT_EQ(Compact().links.size(), 2u);
  EXPECT_EQ(counts().branched, 1);
}

TEST_P(MergingPrimitivesTest, RunDoesNotMeetItselfBesideItsEnd) {
  Start({Row({0, 0, 0}, kX, 61)});
  AddRun(Range(0, 61));
  primitives_->Attach(60, {52}, -1);
  ExpectConsistent();
  EXPECT_TRUE(Degrees().empty());
  EXPECT_EQ(Compact().links.size(), 1u);
}

// A run that leaves a row near its beginning, in its direction, and returns to it from below.
std::vector<Vector3d> Detour() {
  std::vector<Vector3d> detour = Row({4, 0.5, 0}, -kX, 30);
  for (const auto& leg :
       {Row({-26, 0, 0}, -kY, 40), Row({-26, -40, 0}, kX, 56), Row({30, -40, 0}, kY, 40)}) {
    detour.insert(detour.end(), leg.begin(), leg.end());
  }
  return detour;
}

TEST_P(MergingPrimitivesTest, RunElongatesAndRejoins) {
  const auto detour = Detour();
  const int size = static_cast<int>(detour.size());
  Start({Row({0, 0, 0}, kX, 61), detour});
  AddTarget(Range(0, 61));
  AddRun(Range(61, size));
  primitives_->Attach(61, {5}, 30);
  primitives_->Attach(61 + size - 1, {30}, 5);
  ExpectConsistent();
  EXPECT_EQ(counts().elongated, 1);
  EXPECT_EQ(counts().branched, 1);
  EXPECT_EQ(Degrees(), std::vector<int>({3}));
  EXPECT_EQ(testing::DegreeAt(graph_, {30, 0, 0}), 3);
  const std::vector<std::array<int, 3>> expected = {{31, 0, 1}, {size + 26 + 1, 0, 2}};
  EXPECT_EQ(Shape(), expected);
}

TEST_P(MergingPrimitivesTest, StubThatTheOtherEndTouchesIsKept) {
  const auto detour = Detour();
  const int size = static_cast<int>(detour.size());
  Start({Row({0, 0, 0}, kX, 61), detour});
  AddTarget(Range(0, 61));
  AddRun(Range(61, size));
  primitives_->Attach(61, {9}, 5);
  primitives_->Attach(61 + size - 1, {5}, 9);
  ExpectConsistent();
  EXPECT_EQ(counts().elongated, 0);
  EXPECT_EQ(counts().branched, 1);
  EXPECT_EQ(counts().multi_attached, 1);  // 4 px beside the new node
  EXPECT_EQ(Degrees(), std::vector<int>({4}));
  EXPECT_EQ(Compact().links.size(), 3u);
}

TEST_P(MergingPrimitivesTest, RunAtTwoLinksMeetsBothInOneNode) {
  Start({Row({0, 0, 0}, kX, 61), Row({0, 1, 0}, kX, 61), Row({30, 2, 0}, kY, 40)});
  AddTarget(Range(0, 61));
  AddTarget(Range(61, 61));
  AddRun(Range(122, 40));
  primitives_->Attach(122, {61 + 30, 30}, -1);
  ExpectConsistent();
  EXPECT_EQ(counts().multi_attached, 1);
  EXPECT_EQ(counts().branched, 0);
  EXPECT_EQ(Degrees(), std::vector<int>({5}));
  EXPECT_EQ(Compact().links.size(), 5u);
}

TEST_P(MergingPrimitivesTest, RunAtTwoNodesMakesThemOne) {
  Start({Row({0, 0, 0}, kX, 61), Row({0, 1, 0}, kX, 61), Row({30, -1, 0}, -kY, 40),
         Row({30, 2, 0}, kY, 40), Row({30, 0.5, 1}, {0, 0, 1}, 40)});
  AddTarget(Range(0, 61));
  AddTarget(Range(61, 61));
  AddRun(Range(122, 40));
  primitives_->Attach(122, {30}, -1);
  AddRun(Range(162, 40));
  primitives_->Attach(162, {61 + 30}, -1);
  AddRun(Range(202, 40));
  primitives_->Attach(202, {29, 61 + 29}, -1);
  ExpectConsistent();
  EXPECT_EQ(counts().branched, 2);
  EXPECT_EQ(counts().multi_attached, 1);
  EXPECT_EQ(Degrees(), std::vector<int>({7}));
  EXPECT_EQ(Compact().links.size(), 7u);
}

TEST_P(MergingPrimitivesTest, LinkThatEndsAtTheNodeIsNotCutBesideIt) {
  Start({Row({0, 0, 0}, kX, 61), Row({0, 0.1, 0}, {std::cos(0.1), std::sin(0.1), 0}, 61),
         Row({4, 0.2, 1}, {0, 0, 1}, 40)});
  AddTarget(Range(0, 61));
  AddTarget(Range(61, 61));
  primitives_->Attach(61, {0}, -1);
  AddRun(Range(122, 40));
  primitives_->Attach(122, {3, 61 + 5}, -1);
  ExpectConsistent();
  EXPECT_EQ(Degrees(), std::vector<int>({3}));
  EXPECT_EQ(Compact().links.size(), 3u);
}

TEST_P(MergingPrimitivesTest, BranchFromALoopMakesItBeginAtTheJunction) {
  Start({CircleOf(120, 20), Row({21, 0, 0}, kX, 30)});
  std::vector<int> loop = Range(0, 120);
  std::rotate(loop.begin(), loop.begin() + 60, loop.end());  // sample 0 is inside
  AddTarget(loop, true);
  AddRun(Range(120, 30));
  primitives_->Attach(120, {0}, -1);
  ExpectConsistent();
  EXPECT_EQ(Degrees(), std::vector<int>({3}));
  const std::vector<std::array<int, 3>> expected = {{31, 0, 1}, {121, 0, 2}};
  EXPECT_EQ(Shape(), expected);
}

TEST_P(MergingPrimitivesTest, SamplesAreMergedIntoTheVerticesOfTheirHomes) {
  // Samples 50 to 52 leave the target before its end; 90 to 92 are merged into it, one of them into
  // the stub that the run replaces.
  Start({Row({0, 0, 0}, kX, 50), Row({46, 0.5, 0}, kX, 40), Row({20, 1, 0}, kX, 3)});
  AddTarget(Range(0, 50));
  AddRun(Range(50, 40));
  primitives_->Attach(50, {45}, -1);
  for (const auto& [sample, home] : {std::pair(90, 20), std::pair(91, 20), std::pair(92, 48)}) {
    primitives_->SetHome(sample, home);
  }
  primitives_->ListSamples();
  testing::ExpectValid(graph_);
  ASSERT_EQ(graph_.links.size(), 1u);
  std::vector<int> all;
  for (const LinkVertex& vertex : graph_.links[0].vertices) {
    std::vector<int> merged;
    for (const SketchSample& sample : vertex.samples) merged.push_back(IdOf(sample));
    all.insert(all.end(), merged.begin(), merged.end());
    if (merged.front() == 20) {
      EXPECT_EQ(merged, (std::vector<int>{20, 90, 91}));
    }
    if (merged.front() == 52) {
      EXPECT_EQ(merged, (std::vector<int>{52, 48, 92}));  // that of the stub, too
    }
  }
  std::sort(all.begin(), all.end());
  EXPECT_EQ(all, Range(0, 93));
}

INSTANTIATE_TEST_SUITE_P(Directions, MergingPrimitivesTest,
                         ::testing::Combine(::testing::Bool(), ::testing::Bool()));

}  // namespace
}  // namespace limn
