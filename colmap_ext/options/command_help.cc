// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/options/command_help.h"

#include <algorithm>
#include <cctype>
#include <ostream>
#include <string_view>

#include "limn/version.h"

namespace limn {
namespace {

constexpr char kExitStatus[] =
    ".SH EXIT STATUS\n"
    "0, 1 after a line ERROR: ... on standard error, or 130 after an interruption.\n";

// Text in a man page: no character has a meaning of its own, and hyphens can be copied.
std::string ManText(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else if (c == '\'') {
      result += "\\(aq";
    } else if (c == '.' && result.empty()) {
      result += "\\&.";
    } else {
      result += c;
    }
  }
  return result;
}

std::string Bold(std::string_view text) { return "\\fB" + ManText(text) + "\\fR"; }
std::string Italic(std::string_view text) { return "\\fI" + ManText(text) + "\\fR"; }

void WriteTitle(const std::string& command, const std::string& summary, std::ostream& out) {
  const std::string name = ManPageName(command);
  std::string title = name;
  std::transform(title.begin(), title.end(), title.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  out << ".TH " << ManText(title) << " 1 \"\" \"Limn " LIMN_VERSION "\" \"Limn\"\n"
      << ".SH NAME\n"
      << ManText(name) << " \\- " << ManText(summary) << "\n";
}

void WriteOption(const OptionDescription& option, std::ostream& out) {
  out << ".TP\n" << Bold("--" + option.name) << " ";
  for (size_t i = 0; i < option.words.size(); ++i) {
    out << (i == 0 ? "" : "|\\:") << Bold(option.words[i]);
  }
  if (option.words.empty()) out << Italic(option.value);
  out << "\n" << ManText(option.text);
  if (!option.default_value.empty()) out << "\n(default " << Bold(option.default_value) << ")";
  out << "\n";
}

std::string_view GroupOfOption(const OptionDescription& option) {
  const std::string_view name = option.name;
  const size_t dot = name.find('.');
  return dot == std::string_view::npos ? "" : name.substr(0, dot);
}

// Those that are not basic, which come group by group.
void WriteMoreOptions(const std::vector<OptionDescription>& options, std::ostream& out) {
  std::string_view group;
  out << ".SH MORE OPTIONS\n";
  for (const OptionDescription& option : options) {
    if (option.is_basic) continue;
    if (GroupOfOption(option) != group) {
      group = GroupOfOption(option);
      out << ".SS " << (group.empty() ? "Other" : ManText(group)) << "\n";
    }
    WriteOption(option, out);
  }
}

}  // namespace

std::string ManPageName(const std::string& command) {
  return command.empty() ? "limn" : "limn-" + command;
}

void WriteManPage(const CommandDescription& command, std::ostream& out) {
  WriteTitle(command.name, command.summary, out);
  out << ".SH SYNOPSIS\n"
      << Bold("limn " + command.name) << " [" << Italic("options") << "]\n"
      << ".SH OPTIONS\n"
      << "Options are written " << Bold("--name") << " " << Italic("value") << " or "
      << Bold("--name") << "=" << Italic("value") << ".\n"
      << ".TP\n"
      << Bold("-h") << ", " << Bold("--help")
      << "\nprint the basic options, those of this section\n"
      << ".TP\n"
      << Bold("--help_all") << "\nprint all options\n";
  for (const OptionDescription& option : command.options) {
    if (option.is_basic) WriteOption(option, out);
  }
  WriteMoreOptions(command.options, out);
  out << kExitStatus << ".SH SEE ALSO\n"
      << ".BR limn (1)\n";
}

void WriteManPage(std::span<const CommandDescription> commands, std::ostream& out) {
  WriteTitle("", "3D drawings from COLMAP projects", out);
  out << ".SH SYNOPSIS\n"
      << Bold("limn") << " " << Italic("command") << " [" << Italic("options") << "]\n.br\n"
      << Bold("limn help") << " | " << Bold("--version") << "\n"
      << ".SH DESCRIPTION\n"
      << "Limn draws what photographs show: it takes a COLMAP workspace, finds the curves in "
         "every\n"
      << "image, reconstructs them in space and joins them into a graph of curves.\n"
      << ".SH COMMANDS\n";
  for (const CommandDescription& command : commands) {
    out << ".TP\n" << Bold(command.name) << "\n" << ManText(command.summary) << "\n";
  }
  out << kExitStatus << ".SH SEE ALSO\n";
  for (size_t i = 0; i < commands.size(); ++i) {
    out << ".BR " << ManText(ManPageName(commands[i].name)) << " (1)"
        << (i + 1 < commands.size() ? "," : "") << "\n";
  }
}

void WriteCompletionWords(const CommandDescription& command, std::ostream& out) {
  out << "-h\n--help_all\n";
  for (const OptionDescription& option : command.options) {
    out << "--" << option.name;
    for (const std::string& word : option.words) out << " " << word;
    if (option.words.empty()) out << " <" << option.value << ">";
    out << "\n";
  }
}

}  // namespace limn
