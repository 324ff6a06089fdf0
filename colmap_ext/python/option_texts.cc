// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/python/option_texts.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

// What a command would print, instead of running.
constexpr std::string_view kHelpOptions[] = {"help", "help_all", "help_format"};
constexpr std::string_view kNotInNames("=\0", 2);

bool CanBeOption(const std::string& name) {
  return !name.empty() && name.find_first_of(kNotInNames) == std::string::npos &&
         std::ranges::find(kHelpOptions, name) == std::end(kHelpOptions);
}

}  // namespace

void RefuseOptions(const std::string& function, const OptionTexts& options,
                   std::initializer_list<const char*> unused) {
  for (const char* name : unused) {
    if (options.contains(name)) {
      throw OptionError(function + ": option '" + name + "' has no use here");
    }
  }
}

OptionTexts Merged(OptionTexts texts, const OptionTexts& more) {
  for (const auto& [name, text] : more) texts[name] = text;
  return texts;
}

CommandLine::CommandLine(const std::string& command, const OptionTexts& options) {
  arguments_.push_back(command);
  for (const auto& [name, text] : options) {
    if (!CanBeOption(name)) throw OptionError("unknown option '" + name + "'");
    if (text.find('\0') != std::string::npos) {
      throw OptionError(name + ": must be without zero bytes");
    }
    // A value in an argument of its own must not begin with a minus, one beside its name not be
    // empty.
    arguments_.push_back("--" + name + (text.empty() ? "" : "=" + text));
    if (text.empty()) arguments_.push_back(text);
  }
  for (const std::string& argument : arguments_) argv_.push_back(argument.c_str());
}

RunOptions ParseTexts(const std::string& function, const OptionGroups& groups,
                      const OptionTexts& texts,
                      const std::function<void(OptionParser*)>& add_more) {
  const CommandLine line(function, texts);
  RunOptions options;
  ParseRunOptions(function, "", groups, line.argc(), line.argv(), &options, add_more);
  return options;
}

}  // namespace limn::colmap_ext
