// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

namespace limn {

// Everything about an option that its help texts are made of.
struct OptionDescription {
  std::string name;
  std::string text;  // of the help
  // What it takes: "number", "integer", "numbers", "path", "text", "texts", "word" or
  // "switch".
  std::string value;
  std::string default_value;       // empty = none
  std::vector<std::string> words;  // of a word or switch, all that may be given; else empty
  bool is_basic = false;
};

struct CommandDescription {
  std::string name;
  std::string summary;  // one line
  std::vector<OptionDescription> options;
};

// The name of the man page of a command (section 1), "limn-curve_drawer"; of the program for "".
std::string ManPageName(const std::string& command);

// The man page of a command. The same description gives the same bytes.
void WriteManPage(const CommandDescription& command, std::ostream& out);

// The man page of the program: its commands, whose options do not matter.
void WriteManPage(std::span<const CommandDescription> commands, std::ostream& out);

// For completion, a line per option: "--name", then all words that may follow, or "<path>",
// "<text>" and the like. Nothing follows "-h" and "--help_all".
void WriteCompletionWords(const CommandDescription& command, std::ostream& out);

}  // namespace limn
