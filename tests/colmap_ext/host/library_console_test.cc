// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/library_console.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using ::testing::ElementsAre;

TEST(LibraryConsole, PrintsNothingAndKeepsItsLog) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  RunMonitor monitor;
  LibraryConsole console(1, &monitor);
  console.Say("a line");
  console.Say("WARNING: of a line");
  console.Report(
      {.stage = "stage", .in = {}, .kept = {}, .dropped = {}, .warnings = {"of a stage"}});
  console.RepeatWarnings();
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_THAT(console.log().warnings, ElementsAre("of a line", "of a stage"));
  ASSERT_EQ(console.log().stages.size(), 1u);
  EXPECT_EQ(console.log().stages[0].summary.stage, "stage");
}

TEST(LibraryConsole, TellsTheLatestProgressOnce) {
  RunMonitor monitor;
  const LibraryConsole console(1, &monitor);
  EXPECT_FALSE(monitor.TakeProgress());
  ParallelFor(console.context(), "loop", 10, [](size_t) {});
  const auto progress = monitor.TakeProgress();
  ASSERT_TRUE(progress);
  EXPECT_EQ(progress->stage, "loop");
  EXPECT_EQ(progress->done, 10u);
  EXPECT_EQ(progress->total, 10u);
  EXPECT_FALSE(monitor.TakeProgress());
}

TEST(LibraryConsole, IsCancelledByTheMonitor) {
  RunMonitor monitor;
  const LibraryConsole console(1, &monitor);
  ThrowIfCancelled(console.context());
  monitor.Cancel();
  EXPECT_THROW(ThrowIfCancelled(console.context()), Cancelled);
}

}  // namespace
}  // namespace limn::colmap_ext
