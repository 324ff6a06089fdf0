#include "colmap_ext/python/option_texts.h"

#include "limn/util/errors.h"

namespace limn::colmap_ext {

OptionTexts Merged(OptionTexts texts, const OptionTexts& more) {
  for (const auto& [name, text] : more) texts[name] = text;
  return texts;
}

CommandLine::CommandLine(const std::string& command, const OptionTexts& options) {
  arguments_.push_back(command);
  for (const auto& [name, text] : options) {
    if (name.empty() || name.find('=') != std::string::npos) {
      throw OptionError("unknown option '" + name + "'");
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
