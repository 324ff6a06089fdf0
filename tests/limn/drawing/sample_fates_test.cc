#include "limn/drawing/sample_fates.h"

#include <gtest/gtest.h>

#include "limn/drawing/sample_curves.h"

namespace limn {
namespace {

using enum EdgelFate;
using Fates = std::vector<EdgelFate>;

// Four samples of sketch curve 1 from its sample 2 on, then three of sketch curve 0 from its first.
SampleSet SomeSamples() {
  SampleSet samples = testing::MakeSamples(
      {testing::Row({0, 0, 0}, {1, 0, 0}, 4), testing::Row({0, 9, 0}, {1, 0, 0}, 3)});
  samples.origins[0].sketch_curve = 1;
  samples.origins[0].begin = 2;
  samples.origins[1].sketch_curve = 0;
  return samples;
}

CurveSketch SketchOfSizes(const std::vector<size_t>& sizes) {
  CurveSketch sketch;
  for (const size_t size : sizes) {
    sketch.curves.emplace_back();
    sketch.curves.back().points_in_world.resize(size);
  }
  return sketch;
}

// One link per list, a point per sample.
Draft DraftOf(const std::vector<std::vector<int>>& links, int num_sketch_samples) {
  Draft draft;
  draft.num_sketch_samples = num_sketch_samples;
  for (const std::vector<int>& samples : links) {
    draft.links.emplace_back();
    for (const int s : samples) draft.links.back().samples.push_back({s});
  }
  return draft;
}

TEST(SampleLedgerTest, SamplesThatNeverWereSamplesOfTheDrawingLostTheirSupport) {
  const SampleSet samples = SomeSamples();
  EXPECT_EQ(SampleLedger(samples).ForSketch(samples, SketchOfSizes({4, 8, 1})),
            (SampleFates{{kDrawn, kDrawn, kDrawn, kLostSupport},
                         {kLostSupport, kLostSupport, kDrawn, kDrawn, kDrawn, kDrawn, kLostSupport,
                          kLostSupport},
                         {kLostSupport}}));
}

TEST(SampleLedgerTest, EachSampleMeetsItsFirstFate) {
  const SampleSet samples = SomeSamples();
  SampleLedger ledger(samples);
  ledger.Update(DraftOf({{0, 1}, {2, 4, 5, 6}}, 7), kPrunedLink);
  ledger.Update(DraftOf({{1, 2}, {4}}, 7), kDoubtfulLink);
  // 3 is in a link again, but was lost before.
  ledger.Update(DraftOf({{1, 3}}, 7), kPrunedLink);
  EXPECT_EQ(
      ledger.ForSketch(samples, SketchOfSizes({3, 6})),
      (SampleFates{{kPrunedLink, kDoubtfulLink, kDoubtfulLink},
                   {kLostSupport, kLostSupport, kDoubtfulLink, kDrawn, kPrunedLink, kPrunedLink}}));
}

TEST(SampleLedgerTest, AllSamplesMergedIntoAPointAreInTheLink) {
  const SampleSet samples = SomeSamples();
  SampleLedger ledger(samples);
  Draft draft = DraftOf({{0}}, 7);
  draft.links[0].samples = {{0, 4}, {}, {5, 6, 1}};
  ledger.Update(draft, kPrunedLink);
  EXPECT_EQ(ledger.ForSketch(samples, SketchOfSizes({3, 6})),
            (SampleFates{{kDrawn, kDrawn, kDrawn},
                         {kLostSupport, kLostSupport, kDrawn, kDrawn, kPrunedLink, kPrunedLink}}));
}

TEST(SampleLedgerTest, SamplesOfGrownLinksAreNotOfTheSketch) {
  const SampleSet samples = SomeSamples();
  SampleLedger ledger(samples);
  ledger.Update(DraftOf({{0, 1, 2, 3, 4, 5, 6}, {7, 8}}, 7), kPrunedLink);
  EXPECT_EQ(ledger.ForSketch(samples, SketchOfSizes({3, 6})),
            (SampleFates{Fates(3, kDrawn),
                         {kLostSupport, kLostSupport, kDrawn, kDrawn, kDrawn, kDrawn}}));
}

}  // namespace
}  // namespace limn
