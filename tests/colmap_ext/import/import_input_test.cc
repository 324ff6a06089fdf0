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

}  // namespace
}  // namespace limn::colmap_ext
