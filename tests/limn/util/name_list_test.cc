// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/name_list.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(NameList, HasNumbersInTheGivenOrder) {
  EXPECT_EQ(ListNumbers({{"b.jpg", 52.123}, {"a.jpg", 3}}, "px"), "b.jpg (52.1 px), a.jpg (3 px)");
}

TEST(NameList, IsShort) {
  EXPECT_EQ(ListNumbers(std::vector<NamedNumber>(12, {"a", 1}), "%"),
            "a (1 %), a (1 %), a (1 %), a (1 %), a (1 %) and 7 more");
}

}  // namespace
}  // namespace limn
