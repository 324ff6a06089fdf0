// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/sample_fates.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

using enum EdgelFate;

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

// All samples are drawn.
SampleFates DrawnOfSizes(const std::vector<size_t>& sizes) {
  SampleFates fates;
  for (const size_t size : sizes) fates.emplace_back(size, kDrawn);
  return fates;
}

TEST(UpdateFatesTest, SamplesThatAreInNoLinkAreLost) {
  SampleFates fates = DrawnOfSizes({4, 3, 1});
  UpdateFates(GraphOf({{{{0, 0}}, {{0, 1}}}, {{{1, 2}}, {{0, 2}}}}), kLostSupport, &fates);
  EXPECT_EQ(fates, (SampleFates{{kDrawn, kDrawn, kDrawn, kLostSupport},
                                {kLostSupport, kLostSupport, kDrawn},
                                {kLostSupport}}));
}

TEST(UpdateFatesTest, EachSampleMeetsItsFirstFate) {
  SampleFates fates = DrawnOfSizes({5});
  UpdateFates(GraphOf({{{{0, 0}}, {{0, 1}}}, {{{0, 2}}, {{0, 3}}}}), kLostSupport, &fates);
  UpdateFates(GraphOf({{{{0, 0}}, {{0, 1}}}, {{{0, 2}}}}), kPrunedLink, &fates);
  UpdateFates(GraphOf({{{{0, 0}}}}), kDoubtfulLink, &fates);
  EXPECT_EQ(fates,
            (SampleFates{{kDrawn, kDoubtfulLink, kDoubtfulLink, kPrunedLink, kLostSupport}}));
  UpdateFates(DrawingGraph(), kPrunedLink, &fates);
  EXPECT_EQ(fates,
            (SampleFates{{kPrunedLink, kDoubtfulLink, kDoubtfulLink, kPrunedLink, kLostSupport}}));
}

TEST(UpdateFatesTest, AllSamplesMergedIntoAPointAreInTheLink) {
  SampleFates fates = DrawnOfSizes({2, 2});
  UpdateFates(GraphOf({{{{0, 0}, {1, 0}}, {}, {{1, 1}, {0, 1}}}}), kLostSupport, &fates);
  EXPECT_EQ(fates, (SampleFates{{kDrawn, kDrawn}, {kDrawn, kDrawn}}));
  UpdateFates(GraphOf({{{{1, 1}, {0, 0}}}}), kPrunedLink, &fates);
  EXPECT_EQ(fates, (SampleFates{{kDrawn, kPrunedLink}, {kPrunedLink, kDrawn}}));
}

TEST(UpdateFatesTest, GrownLinksHaveNoSamples) {
  SampleFates fates = DrawnOfSizes({1});
  UpdateFates(GraphOf({{{{0, 0}}}, {{}, {}}}), kPrunedLink, &fates);
  EXPECT_EQ(fates, (SampleFates{{kDrawn}}));
}

}  // namespace
}  // namespace limn
