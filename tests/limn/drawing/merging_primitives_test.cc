#include "limn/drawing/merging_primitives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

#include <gtest/gtest.h>

#include "limn/topology/graph_fixture.h"
#include "limn/topology/sample_curves.h"

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
      const auto made_from = SamplesOf(graph_.links.at(primitives_->LinkOf(s)));
      EXPECT_EQ(std::count(made_from.begin(), made_from.end(), primitives_->HomeOf(s)), 1)
          << "sample " << s;
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

  const DrawingOptions options_;
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
  primitives_->Attach(50, 49);
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
  primitives_->Attach(50, 45);
  ExpectConsistent();
  ASSERT_EQ(Compact().links.size(), 1u);
  EXPECT_EQ(Compact().links[0].size(), 46 + 40);
  // The stub's vertices live on where the run begins.
  EXPECT_EQ(primitives_->HomeOf(48), 50);
  EXPECT_EQ(primitives_->LinkOf(48), primitives_->LinkOf(60));
}

TEST_P(MergingPrimitivesTest, RunThatLeavesTheInsideBranches) {
  Start({Row({0, 0, 0}, kX, 61), Row({30, 1, 0}, kY, 40)});
  AddTarget(Range(0, 61));
  AddRun(Range(61, 40));
  primitives_->Attach(61, 30);
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
  primitives_->Attach(80, 39);
  // The run's other end is now an end of the longer link.
  primitives_->Attach(99, 40);
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
  primitives_->Attach(61, 30);
  AddRun(Range(101, 40));
  primitives_->Attach(101, 29);
  ExpectConsistent();
  EXPECT_EQ(Degrees(), std::vector<int>({4}));
  EXPECT_EQ(counts().multi_attached, 1);
}

TEST_P(MergingPrimitivesTest, OnlyEndsAreAttached) {
  Start({Row({0, 0, 0}, kX, 61), Row({30, 1, 0}, kY, 40)});
  AddTarget(Range(0, 61));
  AddRun(Range(61, 40));
  primitives_->Attach(80, 30);
  ExpectConsistent();
  EXPECT_TRUE(Degrees().empty());
  EXPECT_EQ(Compact().links.size(), 2u);
}

TEST_P(MergingPrimitivesTest, LoopCloses) {
  Start({CircleOf(120, 20)});
  AddTarget(Range(0, 120));
  const int first = RunBackwards() ? 119 : 0;
  primitives_->Attach(119 - first, first);
  ExpectConsistent();
  ASSERT_EQ(Compact().links.size(), 1u);
  EXPECT_TRUE(Compact().links[0].closed);
  EXPECT_TRUE(Degrees().empty());
}

TEST_P(MergingPrimitivesTest, BranchFromALoopMakesItBeginAtTheJunction) {
  Start({CircleOf(120, 20), Row({21, 0, 0}, kX, 30)});
  std::vector<int> loop = Range(0, 120);
  std::rotate(loop.begin(), loop.begin() + 60, loop.end());  // sample 0 is inside
  AddTarget(loop, true);
  AddRun(Range(120, 30));
  primitives_->Attach(120, 0);
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
  primitives_->Attach(50, 45);
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
    if (merged.front() == 50) {
      EXPECT_EQ(merged.size(), 6u);  // those of the stub, too
      EXPECT_EQ(std::count(merged.begin(), merged.end(), 92), 1);
    }
  }
  std::sort(all.begin(), all.end());
  EXPECT_EQ(all, Range(0, 93));
}

INSTANTIATE_TEST_SUITE_P(Directions, MergingPrimitivesTest,
                         ::testing::Combine(::testing::Bool(), ::testing::Bool()));

}  // namespace
}  // namespace limn
