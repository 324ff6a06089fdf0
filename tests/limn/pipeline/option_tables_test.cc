// SPDX-License-Identifier: BSD-3-Clause
#include <charconv>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "limn/pipeline/pipeline_options.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

// Values of options by name, "Group.name".
using Values = std::map<std::string, std::string>;

std::string TextOf(bool value, const OptionValues&) { return value ? "true" : "false"; }
std::string TextOf(double value, const OptionValues&) {
  char text[32];
  return {text, std::to_chars(text, std::end(text), value).ptr};
}
std::string TextOf(int value, const OptionValues&) { return std::to_string(value); }
template <typename Enum>
std::string TextOf(Enum value, const OptionValues& values) {
  return WordOf(value, values);
}

Values Defaults() {
  const PipelineOptions options;
  Values defaults = {{"Drawing.method", DrawingMethodName(options.method)}};
  const auto add = [&](const std::string& group, const auto& fields) {
    fields.VisitFields(
        fields, [&](const std::string& name, const auto& field, const OptionValues& values,
                    const OptionHelp&) { defaults[group + "." + name] = TextOf(field, values); });
  };
  VisitGroups(options, add);
  add("EdgeMaps", RidgeOptions());
  add("DenseFusion", DenseOptions());
  return defaults;
}

// The files that may have tables of options.
std::vector<fs::path> Documents() {
  const fs::path folder = LIMN_SOURCE_DIR "/src/limn";
  std::vector<fs::path> found;
  if (fs::exists(folder / "ALGORITHM.md")) found.push_back(folder / "ALGORITHM.md");
  if (fs::exists(folder / "algorithm")) {
    for (const auto& entry : fs::directory_iterator(folder / "algorithm")) {
      if (entry.path().extension() == ".md") found.push_back(entry.path());
    }
  }
  return found;
}

std::vector<std::string> Matches(const std::string& text, const std::regex& pattern) {
  std::vector<std::string> found;
  for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i) {
    found.push_back((*i)[1]);
  }
  return found;
}

// Of the tables whose first line is "| `Group.` | default | ...": rows "| `name`, `name` | value,
// value | ...", but for those whose first cell says "(fixed)", which are of no options.
Values ValuesInTables() {
  const std::regex header("^\\| `([A-Za-z]+\\.)` \\| default \\|.*");
  const std::regex row("^\\| ([^|]*`[^|]*)\\| ([^|]*) \\|.*");
  const std::regex name("`([a-z_0-9]+)`");
  const std::regex value("([^, ]+)");
  Values found;
  for (const fs::path& path : Documents()) {
    std::ifstream in(path);
    std::string group;
    for (std::string line; std::getline(in, line);) {
      std::smatch match;
      if (std::regex_match(line, match, header)) {
        group = match[1];
        continue;
      }
      if (!line.starts_with('|')) group.clear();
      if (group.empty() || !std::regex_match(line, match, row)) continue;
      const std::vector<std::string> names = Matches(match[1], name);
      const std::vector<std::string> values = Matches(match[2], value);
      EXPECT_EQ(names.size(), values.size()) << path << ": " << line;
      for (size_t i = 0; i < std::min(names.size(), values.size()); ++i) {
        EXPECT_TRUE(found.emplace(group + names[i], values[i]).second)
            << path << ": " << group << names[i] << " is in two tables";
      }
    }
  }
  return found;
}

TEST(OptionTables, HaveEveryOptionWithItsDefault) { EXPECT_EQ(ValuesInTables(), Defaults()); }

}  // namespace
}  // namespace limn
