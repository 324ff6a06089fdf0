// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/run_needs.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace limn::colmap_ext {
namespace {

std::vector<View> Views(int count, int width, int height) {
  View view;
  view.camera.width = width;
  view.camera.height = height;
  return std::vector<View>(count, view);
}

void ExpectSame(double a, double b) { EXPECT_NEAR(a, b, 1); }

TEST(RunNeeds, GrowWithNumberAndSizeOfTheViews) {
  const RunNeeds one = EstimateNeeds(Views(1, 1600, 1200), {}, 1);
  const RunNeeds two = EstimateNeeds(Views(2, 1600, 1200), {}, 1);
  EXPECT_GT(two.memory_bytes, one.memory_bytes);
  ExpectSame(two.cache_bytes, 2 * one.cache_bytes);
  // Twice the side: twice the length of its edges.
  const RunNeeds large = EstimateNeeds(Views(1, 3200, 2400), {}, 1);
  EXPECT_GT(large.memory_bytes, one.memory_bytes);
  ExpectSame(large.cache_bytes, two.cache_bytes);
}

TEST(RunNeeds, EveryThreadHasItsImage) {
  const std::vector<View> views = Views(2, 1600, 1200);
  const double four = EstimateNeeds(views, {}, 4).memory_bytes;
  const double eight = EstimateNeeds(views, {}, 8).memory_bytes;
  ExpectSame(eight - four, 4 * 40.0 * 1600 * 1200);
}

TEST(RunNeeds, TilesBoundMemoryButNotTheCache) {
  TileOptions tiles;
  tiles.max_views = 20;
  const RunNeeds of_tile = EstimateNeeds(Views(20, 800, 600), tiles, 2);
  const RunNeeds of_many = EstimateNeeds(Views(400, 800, 600), tiles, 2);
  ExpectSame(of_many.memory_bytes, of_tile.memory_bytes);
  ExpectSame(of_many.cache_bytes, 20 * of_tile.cache_bytes);
  tiles.max_views = 0;  // never
  EXPECT_GT(EstimateNeeds(Views(400, 800, 600), tiles, 2).memory_bytes, of_tile.memory_bytes);
}

TEST(RunNeeds, NothingNeedsLittle) {
  const RunNeeds none = EstimateNeeds({}, {}, 4);
  EXPECT_EQ(none.cache_bytes, 0);
  EXPECT_LT(none.memory_bytes, 2e8);
}

TEST(RunNeeds, WarnsIfThereIsLess) {
  const RunNeeds needs = {1.26e9, 84e6};
  EXPECT_EQ(LinesOf(needs, 2e9).size(), 1u);
  EXPECT_EQ(LinesOf(needs, {}).size(), 1u);
  const std::vector<std::string> lines = LinesOf(needs, 0.9e9);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NE(lines[0].find("1.3 GB of memory"), std::string::npos);
  EXPECT_NE(lines[0].find("84 MB on disk"), std::string::npos);
  EXPECT_TRUE(lines[1].starts_with("WARNING: 900 MB of memory is available"));
  for (const char* remedy : {"--max_image_size", "--Tiles.max_views", "--num_threads"}) {
    EXPECT_NE(lines[1].find(remedy), std::string::npos) << remedy;
  }
}

TEST(RunNeeds, TheSystemTellsWhatIsAvailable) {
  const auto available = AvailableMemory();
  if (!available) GTEST_SKIP() << "this system does not tell";
  EXPECT_GT(*available, 1e6);
}

}  // namespace
}  // namespace limn::colmap_ext
