// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cache/content_hash.h"

#include <cstdint>
#include <set>

#include <gtest/gtest.h>

namespace limn {
namespace {

std::string HashOf(std::string_view bytes) {
  ContentHash hash;
  hash.Add(bytes);
  return hash.Hex();
}

// Published test vectors of 64-bit FNV-1a.
TEST(ContentHash, IsFnv1a) {
  EXPECT_EQ(HashOf(""), "cbf29ce484222325");
  EXPECT_EQ(HashOf("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(HashOf("foobar"), "85944171f73967e8");
}

TEST(ContentHash, DoesNotDependOnBlocks) {
  ContentHash hash;
  hash.Add("foo");
  hash.Add("bar");
  EXPECT_EQ(hash.Hex(), HashOf("foobar"));
}

// High bits of one word and low bits of the next must not cancel.
TEST(ContentHash, EveryBitOfAWordCounts) {
  const auto hash_of = [](uint64_t first, uint64_t second) {
    ContentHash hash;
    hash.AddWord(first);
    hash.AddWord(second);
    return hash.Hex();
  };
  std::set<std::string> hashes = {hash_of(0, 0)};
  for (int bit = 0; bit < 64; ++bit) {
    hashes.insert(hash_of(uint64_t{1} << bit, 0));
    hashes.insert(hash_of(0, uint64_t{1} << bit));
    hashes.insert(hash_of(uint64_t{1} << bit, uint64_t{1} << bit));
  }
  EXPECT_EQ(hashes.size(), 1u + 3 * 64);
}

}  // namespace
}  // namespace limn
