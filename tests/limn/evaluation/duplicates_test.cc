// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/duplicates.h"

#include <gtest/gtest.h>

#include "limn/evaluation/plain_curves.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

TEST(RunsAlongsideAnother, TolerancesOfThousandsOfStepsAreRefused) {
  const CurveSet set = testing::Curves({testing::Line(0, 30), testing::Line(0, 30, 1)});
  const CurveSamples samples(set, [](const Polyline3d&) { return 0.005; });
  const CurveTopology topology = FindTopology(set.polylines);
  const std::vector<int> groups =
      GroupNodes(set.polylines, topology, [](const Polyline3d&) { return 0.005; });
  std::vector<SpatialIndex::Neighbor> scratch;
  EXPECT_FALSE(RunsAlongsideAnother({samples, topology, groups}, 0, 0.9, &scratch));
  EXPECT_TRUE(RunsAlongsideAnother({samples, topology, groups}, 0, 1.1, &scratch));
  EXPECT_THROW(RunsAlongsideAnother({samples, topology, groups}, 0, 20, &scratch), InputError);
}

TEST(RunsAlongsideAnother, ManyCopiesAreNot) {
  // 401 steps of each of 50 curves.
  std::vector<Polyline3d> copies;
  for (int i = 0; i < 50; ++i) copies.push_back(testing::Line(0, 5, 1e-3 * i));
  const CurveSet set = testing::Curves(copies);
  const CurveSamples samples(set, [](const Polyline3d&) { return 0.005; });
  const CurveTopology topology = FindTopology(set.polylines);
  const std::vector<int> groups =
      GroupNodes(set.polylines, topology, [](const Polyline3d&) { return 0.005; });
  std::vector<SpatialIndex::Neighbor> scratch;
  EXPECT_TRUE(RunsAlongsideAnother({samples, topology, groups}, 500, 1, &scratch));
}

}  // namespace
}  // namespace limn
