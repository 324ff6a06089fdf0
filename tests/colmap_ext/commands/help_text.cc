// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/commands/help_text.h"

#include <regex>

#include <gtest/gtest.h>

#include "colmap_ext/host/terminal_console.h"

namespace limn::colmap_ext {

std::string HelpOf(const Command& command, const char* flag) {
  const char* arguments[] = {command.name, flag};
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(command.Run(2, arguments, MakeTerminalConsole), 0) << command.name;
  return ::testing::internal::GetCapturedStdout();
}

std::set<std::string> OptionsIn(const std::string& help) {
  const std::regex line_begin("(^|\n)  (-h \\[ )?--([A-Za-z_.]+)");
  std::set<std::string> options;
  for (std::sregex_iterator it(help.begin(), help.end(), line_begin), end; it != end; ++it) {
    options.insert((*it)[3]);
  }
  return options;
}

}  // namespace limn::colmap_ext
