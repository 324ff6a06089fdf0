#include "limn/pipeline/content_hash.h"

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

}  // namespace
}  // namespace limn
