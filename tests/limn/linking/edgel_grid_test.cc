// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/edgel_grid.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace limn {
namespace {

TEST(EdgelGrid, AgreesWithBruteForce) {
  std::mt19937 generator(7);
  testing::UniformDistribution<double> coordinate(-20, 60);
  std::vector<Edgel> edgels(500);
  for (Edgel& edgel : edgels) edgel.position_px = {coordinate(generator), coordinate(generator)};
  const EdgelGrid grid(edgels, 3.5);
  for (int query = 0; query < 200; ++query) {
    // Some queries and all of their discs lie outside the edgels' box.
    const Eigen::Vector2d point(2 * coordinate(generator), coordinate(generator));
    std::vector<EdgelId> expected;
    for (size_t i = 0; i < edgels.size(); ++i) {
      if ((edgels[i].position_px - point).norm() <= 5) expected.push_back(static_cast<EdgelId>(i));
    }
    std::vector<EdgelId> found;
    grid.Near(point, 5, &found);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
  }
}

TEST(EdgelGrid, Empty) {
  const std::vector<Edgel> edgels;
  std::vector<EdgelId> found;
  EdgelGrid(edgels, 2).Near({0, 0}, 10, &found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace limn
