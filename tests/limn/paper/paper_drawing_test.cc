// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/paper_drawing.h"

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "limn/paper/enhanced_sketch.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

RunContext Threads(int num_threads) {
  RunContext context;
  context.num_threads = num_threads;
  return context;
}

const std::vector<View>& Views() {
  static const std::vector<View> views = testing::DomeViews(16, 5);
  return views;
}

const std::vector<ImageCurves>& NoisyCurves() {
  static const std::vector<ImageCurves> curves =
      testing::ProjectCurves(Views(), testing::CubeEdges(0.8), 0.3);
  return curves;
}

const CurveSketch& Sketch() {
  static const CurveSketch sketch =
      BuildEnhancedSketch({{Views(), NoisyCurves()}}, SketchOptions(), Threads(2)).sketch;
  return sketch;
}

DrawingResult Draw(const CurveSketch& sketch, const PaperOptions& options, int num_threads = 2) {
  return BuildPaperDrawing({{Views(), NoisyCurves()}, sketch}, options, TopologyOptions(),
                           Threads(num_threads));
}

int64_t Count(const StageSummary::Counts& counts, const std::string& name) {
  for (const auto& [unit, count] : counts) {
    if (unit == name) return count;
  }
  ADD_FAILURE() << "no count of " << name;
  return -1;
}

// No sample is dropped, nothing is grown or cut.
TEST(PaperDrawingTest, EverySampleOfTheSketchIsInALink) {
  const DrawingResult result = Draw(Sketch(), {});
  EXPECT_EQ(Count(result.summary.kept, "samples"), Count(result.summary.in, "samples"));
  EXPECT_TRUE(result.summary.dropped.empty());
  EXPECT_TRUE(Validate(result.graph).empty());
  int64_t in_links = 0;
  for (const DrawingLink& link : result.graph.links) {
    for (const LinkMember& member : link.members) in_links += member.end - member.begin;
  }
  EXPECT_EQ(in_links, Count(result.summary.in, "samples"));
}

TEST(PaperDrawingTest, EverySampleIsDrawn) {
  const DrawingResult result = Draw(Sketch(), {});
  ASSERT_EQ(result.fates.size(), Sketch().curves.size());
  for (const auto& of_curve : result.fates) {
    for (const EdgelFate fate : of_curve) EXPECT_EQ(fate, EdgelFate::kDrawn);
  }
}

// The movement in the last round, px/1000; the number of rounds must be reported, too.
int64_t LastMovement(const StageSummary::Counts& in, bool converged) {
  EXPECT_GE(Count(in, converged ? "averaging rounds until convergence"
                                : "averaging rounds without convergence"),
            1);
  return Count(in, "largest movement in the last round, px/1000");
}

TEST(PaperDrawingTest, SummaryTellsWhetherAveragingConverged) {
  const auto in_of = [](double tolerance_px, int max_rounds) {
    PaperOptions options;
    options.averaging_tolerance_px = tolerance_px;
    options.max_averaging_rounds = max_rounds;
    return Draw(Sketch(), options).summary.in;
  };
  EXPECT_LE(LastMovement(in_of(0.5, 50), true), 500);
  EXPECT_GT(LastMovement(in_of(1e-9, 1), false), 0);
}

TEST(PaperDrawingTest, ResultDoesNotDependOnThreads) {
  const DrawingGraph one = Draw(Sketch(), {}, 1).graph;
  const DrawingGraph two = Draw(Sketch(), {}, 2).graph;
  ASSERT_EQ(one.links.size(), two.links.size());
  for (size_t l = 0; l < two.links.size(); ++l) {
    EXPECT_EQ(one.links[l].node0, two.links[l].node0);
    EXPECT_EQ(one.links[l].node1, two.links[l].node1);
    EXPECT_EQ(one.links[l].points_in_world, two.links[l].points_in_world);
  }
}

TEST(PaperDrawingTest, EmptySketchGivesEmptyGraph) {
  const DrawingGraph graph = Draw({}, {}).graph;
  EXPECT_TRUE(graph.links.empty());
  EXPECT_TRUE(graph.nodes.empty());
}

TEST(PaperOptionsTest, FewerViewsLinkDenselyThanStrongly) {
  PaperOptions options;
  EXPECT_NO_THROW(options.Check());
  options.dense_link_views = options.strong_link_views + 1;
  EXPECT_THROW(options.Check(), OptionError);
  EXPECT_THROW(Draw({}, options), OptionError);
}

}  // namespace
}  // namespace limn
