// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/options/retired_options.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/options/option_parser.h"
#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// A command that has two groups.
struct Command {
  Command() {
    parser.AddOption("Linking.min_length_px", &min_length_px, "");
    parser.AddOption("Paper.merge_distance_px", &merge_distance_px, "");
    parser.AddOption("Drawing.method", &method, {"traced", "paper"}, "");
  }

  void Parse(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "command");
    parser.Parse(static_cast<int>(arguments.size()), arguments.data());
  }

  std::string ErrorOf(const std::vector<const char*>& arguments) {
    try {
      Parse(arguments);
    } catch (const OptionError& error) {
      return error.what();
    }
    return "";
  }

  OptionParser parser{"command", "for tests"};
  double min_length_px = 6;
  double merge_distance_px = 0.7;
  std::string method = "traced";
};

TEST(RetiredOptions, AtTheirValueThereIsOneNote) {
  Command command;
  command.Parse({"--Linking.corner_arm_px", "5.0", "--Linking.min_length_px", "7"});
  EXPECT_EQ(command.min_length_px, 7);
  EXPECT_EQ(command.parser.NoteOnRetired(),
            "Linking.corner_arm_px is fixed now, at the value given");
  Command other;
  other.Parse({"--Linking.corner_arm_px=5", "--Linking.corner_angle_deg=35"});
  EXPECT_EQ(other.parser.NoteOnRetired(),
            "2 options, such as Linking.corner_arm_px, are fixed now, at the value given");
  EXPECT_EQ(Command().parser.NoteOnRetired(), "");
}

TEST(RetiredOptions, AtAnotherValueAreErrors) {
  EXPECT_EQ(Command().ErrorOf({"--Linking.corner_arm_px", "6"}),
            "Linking.corner_arm_px = 6: is no longer an option; it is fixed at 5");
}

TEST(RetiredOptions, AreUnknownToCommandsWithoutTheirGroup) {
  EXPECT_THAT(Command().ErrorOf({"--Sketch.depth_gate_px", "1.5"}), HasSubstr("unknown option"));
}

TEST(RetiredOptions, AreReadFromFilesOfEarlierVersions) {
  const TempDir dir;
  const std::string path = (dir / "project.ini").string();
  const auto write = [&](const std::string& text) { std::ofstream(path) << text; };
  write("[Linking]\ncorner_arm_px=5\nmin_length_px=8\n[Drawing]\nmerge_distance_px=1.25\n");
  Command command;
  command.Parse({"--project_path", path.c_str()});
  EXPECT_EQ(command.min_length_px, 8);
  EXPECT_EQ(command.merge_distance_px, 1.25);  // moved to Paper
  EXPECT_THAT(command.parser.NoteOnRetired(), StartsWith("Linking.corner_arm_px"));
  write("[Linking]\ncorner_arm_px=5.5\n");
  EXPECT_EQ(
      Command().ErrorOf({"--project_path", path.c_str()}),
      path + ": line 2: Linking.corner_arm_px = 5.5: is no longer an option; it is fixed at 5");
}

TEST(RetiredOptions, ARetiredWordIsToldFromANewOne) {
  EXPECT_EQ(Command().ErrorOf({"--Drawing.method", "merged"}),
            "Drawing.method = merged: is no longer a choice; must be one of {traced, paper}");
  EXPECT_EQ(Command().ErrorOf({"--Drawing.method", "merge"}),
            "Drawing.method = merge: must be one of {traced, paper}");
}

TEST(RetiredOptions, NamesAreOfNoPresentOption) {
  for (const RetiredOption& option : RetiredOptions()) {
    EXPECT_EQ(FixedValue(option.name), option.value) << option.name << " is there twice";
    EXPECT_FALSE(NewName(option.name)) << option.name;
  }
  for (const char* name : FormerNames()) EXPECT_FALSE(FixedValue(name)) << name;
}

}  // namespace
}  // namespace limn
