// SPDX-License-Identifier: BSD-3-Clause
// What every command says about its options.

#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/commands/help_text.h"

namespace limn::colmap_ext {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsSubsetOf;
using ::testing::IsSupersetOf;
using ::testing::Not;

// What a help text of a user's size holds.
constexpr size_t kMaxBasicOptions = 20;

TEST(Help, OfEveryCommandShowsNoMoreThanAUserUnderstands) {
  for (const Command& command : Commands()) {
    const std::string help = HelpOf(command, "-h");
    const std::set<std::string> basic = OptionsIn(help);
    const std::set<std::string> all = OptionsIn(HelpOf(command, "--help_all"));
    EXPECT_LE(basic.size(), kMaxBasicOptions) << help;
    EXPECT_THAT(basic, IsSubsetOf(all)) << command.name;
    EXPECT_LT(basic.size(), all.size()) << command.name;
    EXPECT_THAT(help, HasSubstr(std::to_string(all.size() - basic.size()) + " more options: limn " +
                                command.name + " --help_all"));
  }
}

TEST(Help, OfTheMainJobNamesWhatUsersSet) {
  const Command& drawer = Commands().front();
  const std::set<std::string> basic = OptionsIn(HelpOf(drawer, "-h"));
  EXPECT_THAT(basic, IsSupersetOf({"help", "help_all", "project_path", "workspace_path",
                                   "output_path", "image_path", "box", "quality", "mode",
                                   "overwrite", "num_threads", "max_image_size", "account",
                                   "Drawing.min_supporting_views", "refine_cameras"}));
  const std::string all = HelpOf(drawer, "--help_all");
  EXPECT_THAT(OptionsIn(all),
              IsSupersetOf({"shard", "Linking.max_bridge_px", "Tiles.max_views",
                            "DrawingRefinement.bending_sigma", "taus", "output_cameras"}));
  EXPECT_THAT(OptionsIn(HelpOf(*FindCommand("camera_refiner"), "--help_all")),
              Not(Contains("output_cameras")));
  EXPECT_THAT(all, AllOf(HasSubstr("box"), Not(HasSubstr("more options"))));
}

TEST(Help, OfACommandWithoutPhotographsNamesItsFiles) {
  EXPECT_THAT(OptionsIn(HelpOf(*FindCommand("drawing_evaluator"), "-h")),
              IsSupersetOf({"input_path", "truth_path", "taus", "box", "output_csv"}));
  EXPECT_THAT(OptionsIn(HelpOf(*FindCommand("drawing_exporter"), "-h")),
              IsSupersetOf({"input_path", "output_path", "output_type", "scale", "up_axis"}));
}

}  // namespace
}  // namespace limn::colmap_ext
