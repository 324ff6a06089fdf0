// SPDX-License-Identifier: BSD-3-Clause
// Every number that a command takes has a range with two ends, checked before any work.

#include <charconv>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/commands/help_text.h"
#include "colmap_ext/host/terminal_console.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using ::testing::StartsWith;

// What commands ask for before they look at other options. Nothing of it exists.
constexpr std::pair<const char*, const char*> kRequired[] = {
    {"workspace_path", "/nowhere"},
    {"input_path", "/nowhere/drawing.json"},
    {"output_path", "/nowhere/x.svg"},
    {"view", "photo.jpg"},
    {"truth_path", "/nowhere/t.ply"},
    {"mesh_path", "/nowhere/m.ply"},
    {"taus", "1"},
};

enum class Kind { kOther, kInt, kDouble, kDoubles };

// An option of a command, and the options that it is tried with.
struct Option {
  const Command& command;
  std::string name;
  std::vector<std::string> required;

  // The error that a value makes.
  std::string ErrorOf(const std::string& value) const {
    std::vector<const char*> arguments = {command.name};
    for (const std::string& argument : required) arguments.push_back(argument.c_str());
    const std::string flag = "--" + name;
    arguments.push_back(flag.c_str());
    arguments.push_back(value.c_str());
    try {
      command.Run(static_cast<int>(arguments.size()), arguments.data(), MakeTerminalConsole);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }
};

Option OptionOf(const Command& command, const std::string& name, const std::set<std::string>& all) {
  Option option{command, name, {}};
  for (const auto& [required, value] : kRequired) {
    if (name == required || !all.contains(required)) continue;
    option.required.push_back("--" + std::string(required));
    option.required.push_back(value);
  }
  return option;
}

Kind KindOf(const Option& option) {
  const std::string error = option.ErrorOf("x");
  if (error.ends_with("must be a whole number")) return Kind::kInt;
  if (error.ends_with("must be a number")) return Kind::kDouble;
  return error.ends_with("must be numbers separated by commas") ? Kind::kDoubles : Kind::kOther;
}

std::string ValueText(double value, Kind kind) {
  char text[32];
  const auto [end, error] = kind == Kind::kInt
                                ? std::to_chars(text, text + sizeof(text), std::lround(value))
                                : std::to_chars(text, text + sizeof(text), value);
  const std::string one(text, end);
  if (kind != Kind::kDoubles) return one;
  std::string six = one;
  for (int i = 1; i < 6; ++i) six += "," + one;
  return six;
}

struct Range {
  double low = 0, high = 0;
  bool has_low = false;  // low itself is in it
};

// The range that a line "<name> = <value>: must be [<special> or ]> 0 and <= 9" tells.
std::optional<Range> RangeIn(const std::string& name, const std::string& error) {
  const std::regex line(std::regex_replace(name, std::regex("\\."), "\\.") +
                        " = \\S+: must be (?:\\S+ or )?(>=?) (\\S+) and <= (\\S+)");
  std::smatch match;
  if (!std::regex_match(error, match, line)) return std::nullopt;
  const Range range{std::stod(match[2]), std::stod(match[3]), match[1] == ">="};
  if (!std::isfinite(range.low) || !std::isfinite(range.high)) return std::nullopt;
  return range;
}

// The next number in that direction; int options are recognized by whole numbers.
double Beyond(double value, int direction, Kind kind) {
  if (kind == Kind::kInt) return value + direction;
  return std::nextafter(value, direction * std::numeric_limits<double>::infinity());
}

void ExpectRange(const Option& option, Kind kind) {
  const double most =
      kind == Kind::kInt ? std::numeric_limits<int>::max() : std::numeric_limits<double>::max();
  const std::string error = option.ErrorOf(ValueText(most, kind));
  const std::optional<Range> range = RangeIn(option.name, error);
  ASSERT_TRUE(range) << option.command.name << " --" << option.name << " " << most << ": " << error;
  const double below = range->has_low ? Beyond(range->low, -1, kind) : range->low;
  for (const double value : {Beyond(range->high, 1, kind), below, -most}) {
    if (value == -1 && range->low > 0) continue;  // may stand for a default
    EXPECT_TRUE(RangeIn(option.name, option.ErrorOf(ValueText(value, kind))))
        << option.command.name << " --" << option.name << " " << value;
  }
}

TEST(OptionRanges, OfEveryNumberHaveTwoEnds) {
  int num_numbers = 0;
  for (const Command& command : Commands()) {
    const std::set<std::string> all = OptionsIn(HelpOf(command, "--help_all"));
    for (const std::string& name : all) {
      if (name == "help" || name == "help_all" || name == "project_path") continue;
      const Option option = OptionOf(command, name, all);
      const Kind kind = KindOf(option);
      if (kind == Kind::kOther) continue;
      ++num_numbers;
      ExpectRange(option, kind);
    }
  }
  EXPECT_GT(num_numbers, 250);
}

}  // namespace
}  // namespace limn::colmap_ext
