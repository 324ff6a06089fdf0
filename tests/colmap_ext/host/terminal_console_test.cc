// SPDX-License-Identifier: BSD-3-Clause
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
    TerminalConsole console(1, Printing::kCounts);
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

std::string PrintedOfAStage(int log_level) {
  ::testing::internal::CaptureStdout();
  {
    TerminalConsole console(1, PrintingAt(log_level));
    console.Report({.stage = "stage",
                    .in = {{"links", 12}},
                    .kept = {},
                    .dropped = {},
                    .warnings = {"of a stage"}});
    console.SayTotalTime();
  }
  return ::testing::internal::GetCapturedStdout();
}

TEST(TerminalConsole, CountsAreForThoseWhoAsk) {
  const std::string usual = PrintedOfAStage(1);
  EXPECT_THAT(usual,
              ::testing::MatchesRegex("stage: 0\\.0 s\n  WARNING: of a stage\nTotal time: 0 s\n"));
  const std::string full = PrintedOfAStage(2);
  EXPECT_THAT(full, ::testing::HasSubstr("peak memory"));
  EXPECT_THAT(full, ::testing::HasSubstr("12  links\n"));
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
