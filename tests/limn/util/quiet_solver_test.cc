// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/quiet_solver.h"

#include <glog/logging.h>
#include <gtest/gtest.h>

namespace limn {
namespace {

std::string Printed() {
  testing::internal::CaptureStderr();
  LOG(ERROR) << "not finite";
  return testing::internal::GetCapturedStderr();
}

TEST(QuietSolver, NothingIsPrintedWhileOneIsAlive) {
  EXPECT_NE(Printed().find("not finite"), std::string::npos);
  {
    const QuietSolver outer;
    { const QuietSolver inner; }
    EXPECT_EQ(Printed(), "");
  }
  EXPECT_NE(Printed().find("not finite"), std::string::npos);
}

}  // namespace
}  // namespace limn
