// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/shard.h"

#include <numeric>

#include <gtest/gtest.h>

#include "limn/util/errors.h"

namespace limn {
namespace {

TEST(Shard, IsReadFromText) {
  const Shard shard = ParseShard("2/8");
  EXPECT_EQ(shard.index, 2);
  EXPECT_EQ(shard.count, 8);
  for (const char* bad : {"", "/", "1", "1/", "/2", "0/2", "3/2", "-1/2", "1/2/3", "1 /2", "1/2x",
                          "a/b", "1/99999999999"}) {
    EXPECT_THROW(ParseShard(bad), OptionError) << bad;
  }
}

TEST(Shard, EveryViewIsInOne) {
  for (size_t num_views : {0, 1, 2, 7, 24, 1000}) {
    for (int count : {1, 2, 3, 7, 40}) {
      std::vector<ViewId> views;
      for (int index = 1; index <= count; ++index) {
        const auto part = ItemsOf({index, count}, num_views);
        EXPECT_LE(part.size(), (num_views + count - 1) / count);
        EXPECT_GE(part.size(), num_views / count);
        views.insert(views.end(), part.begin(), part.end());
      }
      std::vector<ViewId> all(num_views);
      std::iota(all.begin(), all.end(), 0);
      EXPECT_EQ(views, all) << count;
    }
  }
}

}  // namespace
}  // namespace limn
