// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/options/option_parser.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <ostream>
#include <set>
#include <string_view>

#include <boost/program_options.hpp>

#include "colmap_ext/options/colmap_options.h"
#include "colmap_ext/options/ini_file.h"
#include "colmap_ext/options/retired_options.h"
#include "limn/files/atomic_file.h"
#include "limn/util/errors.h"
#include "limn/util/nearest_word.h"
#include "limn/util/number_text.h"
#include "limn/util/parse_number.h"

namespace limn {
namespace {

namespace po = boost::program_options;

constexpr char kProjectPath[] = "project_path";
constexpr char kHelp[] = "help";
constexpr char kHelpAll[] = "help_all";
constexpr char kHelpFormat[] = "help_format";
constexpr char kWord[] = "word";
constexpr char kProjectPathHelp[] =
    "Read options from this ini file; the command line overrides it.";
constexpr unsigned kHelpColumns = 100;

std::optional<double> ParseDouble(std::string_view text) {
  const auto value = ParseSignedNumber<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::vector<double>> ParseDoubles(std::string_view text) {
  std::vector<double> values;
  while (!text.empty()) {
    const size_t comma = std::min(text.find(','), text.size());
    const std::optional<double> value = ParseDouble(text.substr(0, comma));
    if (!value || comma + 1 == text.size()) return std::nullopt;
    values.push_back(*value);
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return values;
}

std::string FormatDoubles(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) {
    if (!text.empty()) text += ',';
    text += NumberText(value);
  }
  return text;
}

std::string ListOf(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "{" : ", ") + word;
  return list + "}";
}

// Files and folders are named by such options.
bool IsPathOption(const std::string& name) {
  return name.ends_with("_path") || name == "output_csv" || name == "output_json";
}

// The parts between semicolons, without white space at their ends and without empty ones.
std::vector<std::string> SplitTexts(std::string_view text) {
  constexpr std::string_view kSpace = " \t";
  std::vector<std::string> parts;
  while (!text.empty()) {
    const size_t end = std::min(text.find(';'), text.size());
    const std::string_view part = text.substr(0, end);
    const size_t first = part.find_first_not_of(kSpace);
    if (first != std::string_view::npos) {
      parts.emplace_back(part.substr(first, part.find_last_not_of(kSpace) - first + 1));
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

std::string JoinTexts(const std::vector<std::string>& texts) {
  std::string joined;
  for (const std::string& text : texts) joined += (joined.empty() ? "" : "; ") + text;
  return joined;
}

// What is given for an option, each time.
std::string AllValues(const std::vector<po::option>& given, const std::string& name) {
  std::vector<std::string> values;
  for (const po::option& option : given) {
    if (option.string_key == name) values.push_back(option.value.front());
  }
  return JoinTexts(values);
}

bool IsHelpOption(const std::string& name) {
  return name == kHelp || name == kHelpAll || name == kHelpFormat;
}

std::string GroupOf(const std::string& name) {
  const size_t dot = name.find('.');
  return dot == std::string::npos ? "" : name.substr(0, dot);
}

// "--name value" and "--name=value", names in full, and "-h". Unknown options are left to the
// caller, who knows what may be meant (po::unknown_option).
std::vector<po::option> SplitCommandLine(int argc, const char* const* argv,
                                         const po::options_description& known) {
  namespace style = po::command_line_style;
  const int allowed = style::allow_long | style::long_allow_next | style::long_allow_adjacent |
                      style::allow_short | style::allow_dash_for_short | style::short_allow_next;
  try {
    return po::command_line_parser(argc, argv).options(known).style(allowed).run().options;
  } catch (const po::unknown_option&) {
    throw;
  } catch (const po::error& error) {
    throw OptionError(error.what());
  }
}

}  // namespace

OptionParser::OptionParser(std::string command, std::string summary)
    : command_(std::move(command)), summary_(std::move(summary)) {}

void OptionParser::Add(Option option) {
  if (option.name == kProjectPath || IsHelpOption(option.name) || Find(option.name)) {
    throw std::logic_error("option " + option.name + " is declared twice");
  }
  options_.push_back(std::move(option));
}

void OptionParser::AddOption(const std::string& name, double* value, const OptionHelp& help) {
  const auto set = [value](const std::string& text) -> std::string {
    const auto parsed = ParseDouble(text);
    if (!parsed) return "a number";
    *value = *parsed;
    return "";
  };
  Add({name, help, "number", {}, set, [value] { return NumberText(*value); }});
}

void OptionParser::AddOption(const std::string& name, int* value, const OptionHelp& help) {
  const auto set = [value](const std::string& text) -> std::string {
    const auto parsed = ParseSignedNumber<int>(text);
    if (!parsed) return "a whole number";
    *value = *parsed;
    return "";
  };
  Add({name, help, "integer", {}, set, [value] { return std::to_string(*value); }});
}

void OptionParser::AddOption(const std::string& name, bool* value, const OptionHelp& help) {
  const auto set = [value](const std::string& text) -> std::string {
    *value = text == "1" || text == "true";
    return *value || text == "0" || text == "false" ? "" : "0, 1, true or false";
  };
  Add({name, help, "switch", {"0", "1"}, set, [value] { return std::string(*value ? "1" : "0"); }});
}

void OptionParser::AddOption(const std::string& name, std::string* value, const OptionHelp& help) {
  const auto set = [value](const std::string& text) -> std::string {
    // An ini file could not hold it.
    if (text.find_first_of("\r\n") != std::string::npos) return "without line ends";
    constexpr std::string_view kSpace = " \t";
    if (!text.empty() && (kSpace.find(text.front()) != std::string_view::npos ||
                          kSpace.find(text.back()) != std::string_view::npos)) {
      return "without white space at its ends (a slash may follow a folder)";
    }
    *value = text;
    return "";
  };
  const std::string kind = IsPathOption(name) ? "path" : "text";
  Add({name, help, kind, {}, set, [value] { return *value; }});
}

void OptionParser::AddOption(const std::string& name, std::vector<double>* value,
                             const OptionHelp& help) {
  const auto set = [value](const std::string& text) -> std::string {
    const auto parsed = ParseDoubles(text);
    if (!parsed) return "numbers separated by commas";
    *value = *parsed;
    return "";
  };
  Add({name, help, "numbers", {}, set, [value] { return FormatDoubles(*value); }});
}

void OptionParser::AddOption(const std::string& name, std::vector<std::string>* value,
                             const OptionHelp& help) {
  const auto set = [value](const std::string& text) -> std::string {
    if (text.find_first_of("\r\n") != std::string::npos) return "without line ends";
    *value = SplitTexts(text);
    return "";
  };
  Add({name, help, "texts", {}, set, [value] { return JoinTexts(*value); }, /*repeats=*/true});
}

void OptionParser::AddOption(const std::string& name, std::string* value,
                             std::vector<std::string> allowed, const OptionHelp& help) {
  const auto get = [value, allowed] {
    return static_cast<size_t>(std::find(allowed.begin(), allowed.end(), *value) - allowed.begin());
  };
  AddWords(
      name, help, allowed, [value, allowed](size_t word) { *value = allowed[word]; }, get);
}

void OptionParser::AddWords(const std::string& name, const OptionHelp& help,
                            std::vector<std::string> words, std::function<void(size_t)> set,
                            std::function<size_t()> get) {
  const std::string list = ListOf(words);
  if (get() >= words.size())
    throw std::logic_error("the default of " + name + " is not in " + list);
  const auto set_text = [words, set, list](const std::string& text) -> std::string {
    const auto found = std::find(words.begin(), words.end(), text);
    if (found == words.end()) return "one of " + list;
    set(found - words.begin());
    return "";
  };
  Add({name, help, kWord, words, set_text, [words, get] { return words[get()]; }});
}

OptionParser::Option* OptionParser::Find(const std::string& name) {
  const auto found = std::find_if(options_.begin(), options_.end(),
                                  [&](const Option& option) { return option.name == name; });
  return found == options_.end() ? nullptr : &*found;
}

bool OptionParser::Knows(const std::string& name) const {
  const std::string present = NewName(name).value_or(name);
  return std::any_of(options_.begin(), options_.end(),
                     [&](const Option& option) { return option.name == present; });
}

bool OptionParser::WasGiven(const std::string& name) const {
  return std::any_of(options_.begin(), options_.end(),
                     [&](const Option& option) { return option.name == name && option.given; });
}

bool OptionParser::HasGroupOf(const std::string& name) const {
  return std::ranges::any_of(
      options_, [&](const Option& option) { return GroupOf(option.name) == GroupOf(name); });
}

bool OptionParser::TakesRetired(const std::string& name, const std::string& text,
                                const std::string& origin) {
  const std::optional<std::string> fixed = FixedValue(name);
  if (!fixed || !HasGroupOf(name)) return false;
  if (!AreSameValue(text, *fixed)) {
    throw OptionError(origin + name + " = " + text + ": is no longer an option; it is fixed at " +
                      *fixed);
  }
  retired_.push_back(name);
  return true;
}

void OptionParser::Set(const std::string& name, const std::string& text,
                       const std::string& origin) {
  Option* option = Find(NewName(name).value_or(name));
  if (!option) {
    if (TakesRetired(name, text, origin)) return;
    FailUnknown(name, name, origin);
  }
  const std::string expected = option->set(text);
  if (!expected.empty()) {
    throw OptionError(origin + name + " = " + text + ": " +
                      (IsRetiredWord(name, text) ? "is no longer a choice; " : "") + "must be " +
                      expected);
  }
  option->given = true;
}

void OptionParser::FailUnknown(const std::string& written, const std::string& name,
                               const std::string& origin) const {
  std::string text = origin + "unknown option '" + written + "'";
  if (const std::string advice = AdviceOnColmapOption(name); !advice.empty()) {
    throw OptionError(text + ": " + advice);
  }
  std::vector<std::string> names;
  for (const Option& option : options_) names.push_back(option.name);
  throw OptionError(text + DidYouMean(name, names));
}

std::string OptionParser::NoteOnRetired() const {
  if (retired_.empty()) return "";
  const std::string number = std::to_string(retired_.size());
  return (retired_.size() == 1 ? retired_.front() + " is"
                               : number + " options, such as " + retired_.front() + ", are") +
         " fixed now, at the value given";
}

void OptionParser::ReadIni(const std::string& path) {
  std::set<std::string> seen;
  for (const IniEntry& entry : ReadIniFile(path)) {
    const std::string origin = path + ": line " + std::to_string(entry.line) + ": ";
    if (!seen.insert(NewName(entry.key).value_or(entry.key)).second) {
      throw OptionError(origin + "option '" + entry.key + "' is given twice");
    }
    Set(entry.key, entry.value, origin);
  }
}

OptionParser::HelpKind OptionParser::HelpKindOf(const std::string& name, const std::string& value) {
  if (name == kHelp) return HelpKind::kBasic;
  if (name == kHelpAll) return HelpKind::kAll;
  if (value == "man") return HelpKind::kManPage;
  if (value == "words") return HelpKind::kWords;
  throw OptionError(std::string(kHelpFormat) + " = " + value + ": must be man or words");
}

OptionParser::Outcome OptionParser::Parse(int argc, const char* const* argv) {
  po::options_description known;
  known.add_options()("help,h", "");
  known.add_options()(kHelpAll, "");
  known.add_options()(kHelpFormat, po::value<std::string>(), "");
  known.add_options()(kProjectPath, po::value<std::string>(), "");
  for (const Option& option : options_) {
    known.add_options()(option.name.c_str(), po::value<std::string>(), "");
  }
  for (const RetiredOption& option : RetiredOptions()) {
    known.add_options()(option.name, po::value<std::string>(), "");
  }
  for (const char* name : FormerNames()) known.add_options()(name, po::value<std::string>(), "");
  std::vector<po::option> given;
  try {
    given = SplitCommandLine(argc, argv, known);
  } catch (const po::unknown_option& error) {
    // As it was typed: "--name=value".
    std::string name = error.get_option_name();
    name.erase(0, name.find_first_not_of('-'));
    name.erase(std::min(name.find('='), name.size()));
    FailUnknown("--" + name, name);
  }

  help_ = HelpKind::kNone;
  std::set<std::string> seen;
  std::string project_path;
  for (const po::option& option : given) {
    if (IsHelpOption(option.string_key)) {
      help_ = HelpKindOf(option.string_key, option.value.empty() ? "" : option.value.front());
      continue;
    }
    if (option.position_key >= 0 || option.string_key.empty()) {
      throw OptionError("unexpected argument '" + option.value.front() + "'");
    }
    const Option* declared = Find(option.string_key);
    const bool repeats = declared && declared->repeats;
    if (!seen.insert(NewName(option.string_key).value_or(option.string_key)).second && !repeats) {
      throw OptionError("option '--" + option.string_key + "' is given twice");
    }
    if (option.string_key == kProjectPath) project_path = option.value.front();
  }
  if (!project_path.empty()) ReadIni(project_path);
  for (const po::option& option : given) {
    if (option.string_key != kProjectPath && !IsHelpOption(option.string_key)) {
      Set(option.string_key, AllValues(given, option.string_key), "");
    }
  }
  return help_ == HelpKind::kNone ? Outcome::kRun : Outcome::kHelp;
}

void OptionParser::WriteHelp(std::ostream& out) const {
  switch (help_) {
    case HelpKind::kNone:
      throw std::logic_error("no help was asked for");
    case HelpKind::kBasic:
    case HelpKind::kAll:
      return PrintHelp(help_ == HelpKind::kAll, out);
    case HelpKind::kManPage:
      return WriteManPage(Describe(), out);
    case HelpKind::kWords:
      return WriteCompletionWords(Describe(), out);
  }
}

void OptionParser::PrintHelp(bool all, std::ostream& out) const {
  po::options_description table(kHelpColumns, kHelpColumns / 2);
  table.add_options()("help,h", "Print the basic options.");
  table.add_options()(kHelpAll, "Print all options.");
  table.add_options()(kProjectPath, po::value<std::string>(), kProjectPathHelp);
  size_t num_hidden = 0;
  for (const Option& option : options_) {
    if (!all && !option.help.is_basic) {
      ++num_hidden;
      continue;
    }
    const std::string value = option.get();
    auto* semantic = po::value<std::string>();
    if (!value.empty()) semantic->default_value(value);
    std::string text = option.help.text;
    if (option.value == kWord) text += " " + ListOf(option.words);
    table.add_options()(option.name.c_str(), semantic, text.c_str());
  }
  out << "limn " << command_ << ": " << summary_ << "\n\n" << table;
  if (num_hidden > 0) {
    out << "\n" << num_hidden << " more options: limn " << command_ << " --" << kHelpAll << "\n";
  }
}

CommandDescription OptionParser::Describe() const {
  CommandDescription command{command_, summary_, {}};
  command.options.push_back({kProjectPath, kProjectPathHelp, "path", "", {}, true});
  for (const Option& option : options_) {
    command.options.push_back({option.name, option.help.text, option.value, option.get(),
                               option.words, option.help.is_basic});
  }
  return command;
}

void OptionParser::WriteIni(std::ostream& out) const {
  std::vector<std::string> groups = {""};
  for (const Option& option : options_) {
    const std::string group = GroupOf(option.name);
    if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
  }
  for (const std::string& group : groups) {
    if (!group.empty()) out << "[" << group << "]\n";
    for (const Option& option : options_) {
      if (GroupOf(option.name) != group) continue;
      const std::string key = group.empty() ? option.name : option.name.substr(group.size() + 1);
      out << key << "=" << option.get() << "\n";
    }
  }
}

void OptionParser::WriteIni(const OutputPath& path) const {
  WriteFileAtomically(path, [&](std::ostream& out) { WriteIni(out); });
}

}  // namespace limn
