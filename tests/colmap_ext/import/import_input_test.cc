// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/import_input.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"

namespace limn::colmap_ext {
namespace {

using ::testing::ElementsAre;

TEST(NaturallyLess, OrdersNumbersByValue) {
  EXPECT_TRUE(NaturallyLess("a2", "a10"));
  EXPECT_FALSE(NaturallyLess("a10", "a2"));
  EXPECT_TRUE(NaturallyLess("a02b", "a2c"));
  EXPECT_TRUE(NaturallyLess("a", "a1"));
  EXPECT_TRUE(NaturallyLess("9", "a"));
  EXPECT_FALSE(NaturallyLess("a1", "a1"));
  EXPECT_NE(NaturallyLess("a01", "a1"), NaturallyLess("a1", "a01"));
}

TEST(ReadImageList, LeavesOffWhatBundlerAdds) {
  const TempDir dir;
  const std::string path =
      dir.WriteFile("list.txt", "./a.jpg\r\n\nb.jpg 0 600.25\nmy holidays 2.jpg\n  d 7.jpg  \n");
  EXPECT_THAT(ReadImageList(path), ElementsAre("./a.jpg", "b.jpg", "my holidays 2.jpg", "d 7.jpg"));
}

TEST(ReadImageList, OnlyTwoNumbersAreLeftOff) {
  const TempDir dir;
  const std::string path = dir.WriteFile(
      "list.txt", "a.jpg 0 1 2.5e+2\n7 1 2\nb.jpg 0.5 600\nc.jpg 600\n1 2\nd.jpg\t0 \t-6E2\n");
  EXPECT_THAT(ReadImageList(path),
              ElementsAre("a.jpg 0", "7", "b.jpg 0.5 600", "c.jpg 600", "1 2", "d.jpg"));
}

// A regular expression overflowed the stack on them.
TEST(ReadImageList, LinesMayBeLong) {
  const TempDir dir;
  const std::string name(1'000'000, 'a');
  EXPECT_THAT(ReadImageList(dir.WriteFile("list.txt", name + " 0 1\n" + name + " b\n")),
              ElementsAre(name, name + " b"));
}

}  // namespace
}  // namespace limn::colmap_ext
