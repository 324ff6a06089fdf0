#include "colmap_ext/host/terminal_console.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

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
  EXPECT_THAT(out, ::testing::HasSubstr("WARNING: image \\x1b]0;x\\x07\\x1b[2J.png\n"));
  EXPECT_THAT(out, ::testing::HasSubstr("of \\x1b[31m.png\n"));
  EXPECT_THAT(out, ::testing::HasSubstr("WARNING: a\\x0d\\x0ab\n"));
}

TEST(TerminalConsole, ARunWhoseLinesNobodyReadsIsInterrupted) {
  EXPECT_EXIT(
      {
        int ends[2];
        if (pipe(ends) != 0 || dup2(ends[1], STDOUT_FILENO) < 0) _exit(2);
        close(ends[0]);
        close(ends[1]);
        TerminalConsole console(1);
        console.Say("a line");
        console.Say("another line");
        for (int i = 0; i < 90 && !*console.context().cancelled; ++i) usleep(10'000);
        _exit(*console.context().cancelled ? 0 : 1);
      },
      ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace limn::colmap_ext
