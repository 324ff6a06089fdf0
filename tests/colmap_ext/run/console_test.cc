#include "colmap_ext/run/console.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

// Names of images get into all of these lines.
TEST(Console, PrintsNoControlCharacters) {
  ::testing::internal::CaptureStdout();
  {
    Console console(1);
    console.Say("WARNING: image \x1B]0;x\x07\x1B[2J.png");
    StageSummary summary;
    summary.stage = "stage";
    summary.dropped.push_back({"of \x1B[31m.png", 1});
    summary.warnings.push_back("a\r\nb");
    console.Report(summary);
  }
  const std::string out = ::testing::internal::GetCapturedStdout();
  EXPECT_THAT(out, ::testing::HasSubstr("WARNING: image ?]0;x??[2J.png\n"));
  EXPECT_THAT(out, ::testing::HasSubstr("of ?[31m.png\n"));
  EXPECT_THAT(out, ::testing::HasSubstr("WARNING: a??b\n"));
}

// As a stage of another program: lines and progress go there, and it may stop the run.
TEST(Console, SpeaksToItsHost) {
  ::testing::internal::CaptureStdout();
  std::vector<std::string> lines;
  bool is_stopped = false;
  Console console(1, {.say = [&](const std::string& line) { lines.push_back(line); },
                      .is_stopped = [&] { return is_stopped; }});
  console.Say("WARNING: a\nb");
  StageSummary summary;
  summary.stage = "stage";
  summary.kept.push_back({"links", 1234});
  console.Report(summary);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "WARNING: a?b");
  EXPECT_THAT(lines[1], ::testing::StartsWith("stage: "));
  EXPECT_EQ(lines[2], "  kept            1,234  links");
  ParallelFor(console.context(), "loop", 3, [](size_t) {});
  is_stopped = true;
  int num_done = 0;
  EXPECT_THROW(ParallelFor(console.context(), "loop", 3, [&](size_t) { ++num_done; }), Cancelled);
  EXPECT_EQ(num_done, 1);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

}  // namespace
}  // namespace limn::colmap_ext
