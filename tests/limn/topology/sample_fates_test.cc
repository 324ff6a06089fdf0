#include "limn/topology/sample_fates.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

using enum EdgelFate;

CurveSketch SketchOfSizes(const std::vector<size_t>& sizes) {
  CurveSketch sketch;
  for (const size_t size : sizes) {
    sketch.curves.emplace_back();
    sketch.curves.back().points_in_world.resize(size);
  }
  return sketch;
}

// One link per list, of these samples (curve, sample), a point per list within.
DrawingGraph GraphOf(const std::vector<std::vector<std::vector<SketchSample>>>& links) {
  DrawingGraph graph;
  for (const auto& points : links) {
    graph.links.emplace_back();
    for (const auto& samples : points) {
      graph.links.back().vertices.emplace_back();
      graph.links.back().vertices.back().samples = samples;
    }
  }
  return graph;
}

TEST(SampleLedgerTest, SamplesThatAreInNoLinkLostTheirSupport) {
  const SampleLedger ledger(SketchOfSizes({4, 3, 1}),
                            GraphOf({{{{0, 0}}, {{0, 1}}}, {{{1, 2}}, {{0, 2}}}}));
  EXPECT_EQ(ledger.fates(), (SampleFates{{kDrawn, kDrawn, kDrawn, kLostSupport},
                                         {kLostSupport, kLostSupport, kDrawn},
                                         {kLostSupport}}));
}

TEST(SampleLedgerTest, EachSampleMeetsItsFirstFate) {
  SampleLedger ledger(SketchOfSizes({5}), GraphOf({{{{0, 0}}, {{0, 1}}}, {{{0, 2}}, {{0, 3}}}}));
  ledger.Update(GraphOf({{{{0, 0}}, {{0, 1}}}, {{{0, 2}}}}), kPrunedLink);
  ledger.Update(GraphOf({{{{0, 0}}}}), kDoubtfulLink);
  EXPECT_EQ(ledger.fates(),
            (SampleFates{{kDrawn, kDoubtfulLink, kDoubtfulLink, kPrunedLink, kLostSupport}}));
  ledger.Update(DrawingGraph(), kPrunedLink);
  EXPECT_EQ(ledger.fates(),
            (SampleFates{{kPrunedLink, kDoubtfulLink, kDoubtfulLink, kPrunedLink, kLostSupport}}));
}

TEST(SampleLedgerTest, AllSamplesMergedIntoAPointAreInTheLink) {
  SampleLedger ledger(SketchOfSizes({2, 2}), GraphOf({{{{0, 0}, {1, 0}}, {}, {{1, 1}, {0, 1}}}}));
  EXPECT_EQ(ledger.fates(), (SampleFates{{kDrawn, kDrawn}, {kDrawn, kDrawn}}));
  ledger.Update(GraphOf({{{{1, 1}, {0, 0}}}}), kPrunedLink);
  EXPECT_EQ(ledger.fates(), (SampleFates{{kDrawn, kPrunedLink}, {kPrunedLink, kDrawn}}));
}

TEST(SampleLedgerTest, GrownLinksHaveNoSamples) {
  SampleLedger ledger(SketchOfSizes({1}), GraphOf({{{{0, 0}}}}));
  ledger.Update(GraphOf({{{{0, 0}}}, {{}, {}}}), kPrunedLink);
  EXPECT_EQ(ledger.fates(), (SampleFates{{kDrawn}}));
}

}  // namespace
}  // namespace limn
