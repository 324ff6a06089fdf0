#include "colmap_ext/host/terminal_console.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn::colmap_ext {
namespace {

// Names of images get into all of these lines.
TEST(TerminalConsole, PrintsNoControlCharacters) {
  ::testing::internal::CaptureStdout();
  {
    TerminalConsole console(1);
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

}  // namespace
}  // namespace limn::colmap_ext
