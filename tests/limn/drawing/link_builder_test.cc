#include "limn/drawing/link_builder.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "limn/drawing/sample_curves.h"

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

std::vector<LinkBuilder::Link> Alive(const LinkBuilder& builder) {
  std::vector<LinkBuilder::Link> alive;
  for (const auto& link : builder.links()) {
    if (link.alive) alive.push_back(link);
  }
  return alive;
}

// What does not depend on the direction in which links are stored: per link its number of vertices,
// whether it is closed and how many of its ends are at nodes; sorted.
std::vector<std::array<int, 3>> Shape(const LinkBuilder& builder) {
  std::vector<std::array<int, 3>> shape;
  for (const auto& link : Alive(builder)) {
    shape.push_back({static_cast<int>(link.vertices.size()), link.closed,
                     (link.node[0] >= 0) + (link.node[1] >= 0)});
  }
  std::sort(shape.begin(), shape.end());
  return shape;
}

// Degree of every node, sorted.
std::vector<int> Degrees(const LinkBuilder& builder) {
  std::vector<int> degrees(builder.num_nodes(), 0);
  for (const auto& link : Alive(builder)) {
    for (const int node : link.node) {
      if (node >= 0) ++degrees[node];
    }
  }
  std::sort(degrees.begin(), degrees.end());
  return degrees;
}

// Every vertex stands in the link that it is said to be in.
void ExpectConsistent(const LinkBuilder& builder) {
  for (int v = 0; v < builder.num_vertices(); ++v) {
    const auto& link = builder.links().at(builder.LinkOf(v));
    EXPECT_TRUE(link.alive) << "vertex " << v;
    EXPECT_EQ(std::count(link.vertices.begin(), link.vertices.end(), builder.Resolve(v)), 1)
        << "vertex " << v;
  }
}

std::vector<int> SamplesOf(const LinkBuilder& builder, const LinkBuilder::Link& link) {
  std::vector<int> samples;
  for (const int vertex : link.vertices) samples.push_back(builder.SampleOf(vertex));
  return samples;
}

// The parameter says whether the target and the run are stored backwards.
class LinkBuilderTest : public ::testing::TestWithParam<std::tuple<bool, bool>> {
 protected:
  // Adds a link of these samples, in the direction the parameter asks for.
  int Add(LinkBuilder* builder, std::vector<int> samples, bool backwards) const {
    if (backwards) std::reverse(samples.begin(), samples.end());
    return builder->AddLink(samples, false);
  }
  bool TargetBackwards() const { return std::get<0>(GetParam()); }
  bool RunBackwards() const { return std::get<1>(GetParam()); }
  // The end of a link that holds the first of its samples.
  int FirstEnd(bool backwards) const { return backwards ? 1 : 0; }
  int VertexOf(const LinkBuilder& builder, int sample) const {
    for (int v = 0; v < builder.num_vertices(); ++v) {
      if (builder.SampleOf(v) == sample) return v;
    }
    return -1;
  }

  const DrawingOptions options_;
};

TEST_P(LinkBuilderTest, RunBeyondAFreeEndElongates) {
  const SampleSet samples = MakeSamples({Row({0, 0, 0}, kX, 50), Row({50, 0, 0}, kX, 40)});
  LinkBuilder builder(samples, options_);
  Add(&builder, Range(0, 50), TargetBackwards());
  const int run = Add(&builder, Range(50, 40), RunBackwards());
  builder.Attach(run, FirstEnd(RunBackwards()), VertexOf(builder, 49));
  ExpectConsistent(builder);
  ASSERT_EQ(Alive(builder).size(), 1u);
  std::vector<int> order = SamplesOf(builder, Alive(builder)[0]);
  if (order.front() > order.back()) std::reverse(order.begin(), order.end());
  EXPECT_EQ(order, Range(0, 90));
  EXPECT_EQ(builder.num_nodes(), 0);
  EXPECT_EQ(builder.counts().elongated, 1);
}

TEST_P(LinkBuilderTest, ElongationReplacesAShortStub) {
  // Leaves the target 4 px before its end.
  const SampleSet samples = MakeSamples({Row({0, 0, 0}, kX, 50), Row({46, 0.5, 0}, kX, 40)});
  LinkBuilder builder(samples, options_);
  Add(&builder, Range(0, 50), TargetBackwards());
  const int run = Add(&builder, Range(50, 40), RunBackwards());
  const int end = builder.Attach(run, FirstEnd(RunBackwards()), VertexOf(builder, 45));
  ExpectConsistent(builder);
  ASSERT_EQ(Alive(builder).size(), 1u);
  EXPECT_EQ(Alive(builder)[0].vertices.size(), 46u + 40u);
  // The stub's vertices live on where the run begins.
  EXPECT_EQ(builder.SampleOf(builder.Resolve(VertexOf(builder, 48))), 50);
  EXPECT_EQ(builder.LinkOf(VertexOf(builder, 60)), end);
}

TEST_P(LinkBuilderTest, RunThatLeavesTheInsideBranches) {
  const SampleSet samples = MakeSamples({Row({0, 0, 0}, kX, 61), Row({30, 1, 0}, kY, 40)});
  LinkBuilder builder(samples, options_);
  Add(&builder, Range(0, 61), TargetBackwards());
  const int run = Add(&builder, Range(61, 40), RunBackwards());
  builder.Attach(run, FirstEnd(RunBackwards()), VertexOf(builder, 30));
  ExpectConsistent(builder);
  EXPECT_EQ(builder.counts().branched, 1);
  EXPECT_EQ(Degrees(builder), std::vector<int>({3}));
  const std::vector<std::array<int, 3>> expected = {{31, 0, 1}, {31, 0, 1}, {41, 0, 1}};
  EXPECT_EQ(Shape(builder), expected);
  // All three links have the sample of the junction at the node's end.
  for (const auto& link : Alive(builder)) {
    const int tip = link.node[0] >= 0 ? link.vertices.front() : link.vertices.back();
    EXPECT_EQ(builder.SampleOf(tip), 30);
  }
}

TEST_P(LinkBuilderTest, RunBetweenTwoFreeEndsFusesTheLinks) {
  const SampleSet samples =
      MakeSamples({Row({0, 0, 0}, kX, 40), Row({60, 0, 0}, kX, 40), Row({40, 0, 0}, kX, 20)});
  LinkBuilder builder(samples, options_);
  Add(&builder, Range(0, 40), TargetBackwards());
  Add(&builder, Range(40, 40), TargetBackwards());
  const int run = Add(&builder, Range(80, 20), RunBackwards());
  const int first_end = FirstEnd(RunBackwards());
  const int fused = builder.Attach(run, first_end, VertexOf(builder, 39));
  // The run's other end is now the end of the fused link that holds sample 99.
  const int tip = builder.links()[fused].vertices.front();
  builder.Attach(fused, builder.SampleOf(tip) == 99 ? 0 : 1, VertexOf(builder, 40));
  ExpectConsistent(builder);
  ASSERT_EQ(Alive(builder).size(), 1u);
  EXPECT_EQ(Alive(builder)[0].vertices.size(), 100u);
  EXPECT_EQ(builder.num_nodes(), 0);
  std::vector<int> order = SamplesOf(builder, Alive(builder)[0]);
  if (order.front() != 0) std::reverse(order.begin(), order.end());
  std::vector<int> expected = Range(0, 40);
  for (const int s : Range(80, 20)) expected.push_back(s);
  for (const int s : Range(40, 40)) expected.push_back(s);
  EXPECT_EQ(order, expected);
}

TEST_P(LinkBuilderTest, RunToAnExistingNodeEndsThere) {
  const SampleSet samples = MakeSamples(
      {Row({0, 0, 0}, kX, 61), Row({30, 1, 0}, kY, 40), Row({30, 0, 1}, {0, 0, 1}, 40)});
  LinkBuilder builder(samples, options_);
  Add(&builder, Range(0, 61), TargetBackwards());
  const int branch = Add(&builder, Range(61, 40), RunBackwards());
  builder.Attach(branch, FirstEnd(RunBackwards()), VertexOf(builder, 30));
  const int run = Add(&builder, Range(101, 40), RunBackwards());
  builder.Attach(run, FirstEnd(RunBackwards()), VertexOf(builder, 29));
  ExpectConsistent(builder);
  EXPECT_EQ(builder.num_nodes(), 1);
  EXPECT_EQ(Degrees(builder), std::vector<int>({4}));
  EXPECT_EQ(builder.counts().multi_attached, 1);
}

TEST_P(LinkBuilderTest, LoopCloses) {
  std::vector<Vector3d> circle;
  for (int i = 0; i < 120; ++i) {
    const double angle = 2 * M_PI * i / 120;
    circle.emplace_back(20 * std::cos(angle), 20 * std::sin(angle), 0);
  }
  const SampleSet samples = MakeSamples({circle});
  LinkBuilder builder(samples, options_);
  const int link = Add(&builder, Range(0, 120), TargetBackwards());
  const int end = RunBackwards() ? 0 : 1;
  const auto& vertices = builder.links()[link].vertices;
  builder.Attach(link, end, end == 1 ? vertices.front() : vertices.back());
  ExpectConsistent(builder);
  ASSERT_EQ(Alive(builder).size(), 1u);
  EXPECT_TRUE(Alive(builder)[0].closed);
  EXPECT_EQ(builder.num_nodes(), 0);
  EXPECT_EQ(builder.counts().rejoined, 1);
}

TEST_P(LinkBuilderTest, BranchFromALoopMakesItBeginAtTheJunction) {
  std::vector<Vector3d> circle;
  for (int i = 0; i < 120; ++i) {
    const double angle = 2 * M_PI * i / 120;
    circle.emplace_back(20 * std::cos(angle), 20 * std::sin(angle), 0);
  }
  const SampleSet samples = MakeSamples({circle, Row({21, 0, 0}, kX, 30)});
  LinkBuilder builder(samples, options_);
  std::vector<int> loop = Range(0, 120);
  std::rotate(loop.begin(), loop.begin() + 60, loop.end());  // sample 0 is inside
  if (TargetBackwards()) std::reverse(loop.begin(), loop.end());
  builder.AddLink(loop, true);
  const int run = Add(&builder, Range(120, 30), RunBackwards());
  builder.Attach(run, FirstEnd(RunBackwards()), VertexOf(builder, 0));
  ExpectConsistent(builder);
  EXPECT_EQ(Degrees(builder), std::vector<int>({3}));
  const std::vector<std::array<int, 3>> expected = {{31, 0, 1}, {121, 0, 2}};
  EXPECT_EQ(Shape(builder), expected);
}

INSTANTIATE_TEST_SUITE_P(Directions, LinkBuilderTest,
                         ::testing::Combine(::testing::Bool(), ::testing::Bool()));

}  // namespace
}  // namespace limn
