// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/ranks.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"

namespace limn::colmap_ext {
namespace {

TEST(Ranks, TheErrorOfTheOnlyOneIsThrown) {
  EXPECT_EQ(ErrorText<std::runtime_error>([] { MeetAllRanks("a.bin: bad"); }), "a.bin: bad");
  EXPECT_NO_THROW(MeetAllRanks(""));
}

}  // namespace
}  // namespace limn::colmap_ext
