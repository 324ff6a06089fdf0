// SPDX-License-Identifier: BSD-3-Clause
#include "limn/drawing/samples.h"

#include <gtest/gtest.h>

#include "limn/drawing/sample_curves.h"

namespace limn {
namespace {

TEST(SamplesTest, CurvesLieBackToBack) {
  const SampleSet samples = testing::MakeSamples(
      {testing::Row({0, 0, 0}, {1, 0, 0}, 4), testing::Row({0, 9, 0}, {1, 0, 0}, 7)});
  EXPECT_EQ(samples.NumCurves(), 2);
  EXPECT_EQ(samples.NumSamples(), 11);
  EXPECT_EQ(samples.Size(0), 4);
  EXPECT_EQ(samples.Size(1), 7);
  EXPECT_EQ(SampleSet().NumCurves(), 0);
  EXPECT_EQ(SampleSet().NumSamples(), 0);
}

TEST(ArcPxTest, CountsFootprintsFromTheFirstSampleOfTheCurve) {
  SampleSet samples = testing::MakeSamples(
      {testing::Row({7, 0, 0}, {0, 5, 0}, 3), {{0, 0, 0}, {3, 4, 0}, {3, 4, 6}, {3, 4, 6}}});
  // Between two samples the unit is the mean of their footprints.
  samples.footprint = {1, 1, 1, 0.5, 1.5, 0.5, 4};
  EXPECT_EQ(ArcPx(samples, 1), (std::vector<double>{0, 5, 11, 11}));
  EXPECT_EQ(ArcPx(samples, 0), (std::vector<double>{0, 5, 10}));
}

TEST(ReserveTest, NothingGrowsUpToWhatWasReserved) {
  SampleSet samples;
  Reserve(100, 300, &samples);
  EXPECT_EQ(samples.NumSamples(), 0);
  const auto* position = samples.position.data();
  const auto* information = samples.information.data();
  const auto* edgels = samples.support.edgels.data();
  const auto* offsets = samples.support.offsets.data();
  for (int s = 0; s < 100; ++s) {
    samples.position.emplace_back(s, 0, 0);
    samples.information.push_back(Eigen::Matrix3d::Identity());
    samples.support.Append(std::vector<EdgelRef>{{0, s}, {1, s}, {2, s}});
  }
  EXPECT_EQ(samples.position.data(), position);
  EXPECT_EQ(samples.information.data(), information);
  EXPECT_EQ(samples.support.edgels.data(), edgels);
  EXPECT_EQ(samples.support.offsets.data(), offsets);
  EXPECT_GE(samples.curve_of.capacity(), 100u);
  EXPECT_GE(samples.tangent.capacity(), 100u);
  EXPECT_GE(samples.footprint.capacity(), 100u);
}

}  // namespace
}  // namespace limn
