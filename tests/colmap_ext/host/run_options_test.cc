// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/run_options.h"

#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

constexpr OptionGroups kAllGroups{.linking = true, .sketch = true, .drawing = true};

std::optional<OptionParser> Parse(std::vector<const char*> arguments, RunOptions* options,
                                  const OptionGroups& groups = kAllGroups) {
  arguments.insert(arguments.begin(), "command");
  return ParseRunOptions("command", "for tests", groups, static_cast<int>(arguments.size()),
                         arguments.data(), options);
}

TEST(RunOptions, QualitySetsDefaults) {
  RunOptions options;
  ASSERT_TRUE(Parse({"--workspace_path", "w", "--quality", "low"}, &options));
  const QualityPreset low = PresetOf(Quality::kLow);
  EXPECT_EQ(options.view.max_image_size, low.max_image_size);
  EXPECT_EQ(OptionsAsJson(options.pipeline), OptionsAsJson(low.options));
}

TEST(RunOptions, SingleOptionsOverrideQualityInAnyOrder) {
  for (const auto& arguments :
       {std::vector<const char*>{"--workspace_path", "w", "--quality", "low",
                                 "--ViewSelection.max_second_views", "9"},
        std::vector<const char*>{"--ViewSelection.max_second_views", "9", "--quality", "low",
                                 "--workspace_path", "w"}}) {
    RunOptions options;
    ASSERT_TRUE(Parse(arguments, &options));
    EXPECT_EQ(options.pipeline.sketch.view_selection.max_second_views, 9);
    EXPECT_EQ(options.view.max_image_size, PresetOf(Quality::kLow).max_image_size);
  }
}

TEST(RunOptions, MethodPaperSetsDefaults) {
  RunOptions options;
  ASSERT_TRUE(Parse({"--workspace_path", "w", "--mode", "enhanced", "--Drawing.method", "paper",
                     "--Sketch.min_supporting_views", "4"},
                    &options));
  const PipelineOptions& pipeline = options.pipeline;
  EXPECT_EQ(pipeline.sketch.averaging, DepthAveraging::kPaper);
  EXPECT_EQ(pipeline.sketch.min_supporting_views, 4);
  EXPECT_EQ(pipeline.paper.strong_link_views, 3);
  EXPECT_EQ(pipeline.paper.dense_link_views, 2);
  EXPECT_EQ(pipeline.paper.min_strong_links, 5);
  RunOptions of_file;
  ASSERT_TRUE(Parse({"--workspace_path", "w", "--project_path",
                     LIMN_SOURCE_DIR "/scripts/paper.ini", "--Sketch.min_supporting_views", "4"},
                    &of_file));
  EXPECT_EQ(OptionsAsJson(of_file.pipeline), OptionsAsJson(pipeline));
}

TEST(RunOptions, IniFileOfARunRepeatsIt) {
  const TempDir dir;
  RunOptions options;
  const auto parser = Parse({"--workspace_path", "w", "--quality", "high", "--box=0,1,-2,2,3,4",
                             "--Paper.merge_distance_px=1.25", "--max_image_size", "700"},
                            &options);
  ASSERT_TRUE(parser);
  const std::string ini = (dir / "project.ini").string();
  parser->WriteIni(ini);
  RunOptions again;
  ASSERT_TRUE(Parse({"--project_path", ini.c_str()}, &again));
  EXPECT_EQ(OptionsAsJson(again.pipeline), OptionsAsJson(options.pipeline));
  EXPECT_EQ(again.box, options.box);
  EXPECT_EQ(again.view.max_image_size, 700);
  EXPECT_EQ(again.layout.workspace_path, "w");
}

TEST(RunOptions, MarginOfViewsIsThatOfEdges) {
  RunOptions options;
  ASSERT_TRUE(Parse({"--workspace_path", "w", "--EdgeDetection.margin_px", "3"}, &options));
  EXPECT_EQ(options.view.border_margin_px, 3);
}

TEST(RunOptions, CommandsHaveOnlyTheirGroups) {
  RunOptions options;
  EXPECT_THROW(Parse({"--workspace_path", "w", "--Linking.min_length_px", "7"}, &options, {}),
               OptionError);
  EXPECT_THROW(Parse({"--workspace_path", "w", "--box", "0,1,0,1,0,1"}, &options,
                     {.linking = true, .drawing = true}),
               OptionError);
}

TEST(RunOptions, BadValuesAreRefused) {
  RunOptions options;
  EXPECT_THROW(Parse({"--workspace_path", "w", "--num_threads", "0"}, &options), OptionError);
  EXPECT_THROW(Parse({"--workspace_path", "w", "--box", "0,1,0,1,1,0"}, &options), OptionError);
  EXPECT_THROW(Parse({"--workspace_path", "w", "--Sketch.max_support_distance_px", "0"}, &options),
               OptionError);
  EXPECT_THROW(Parse({}, &options), OptionError);
}

TEST(BoxFromNumbers, SixNumbersOrNone) {
  EXPECT_FALSE(BoxFromNumbers({}));
  const auto box = BoxFromNumbers({-1, 2, -3, 4, -5, 6});
  ASSERT_TRUE(box);
  EXPECT_EQ(box->min(), Eigen::Vector3d(-1, -3, -5));
  EXPECT_EQ(box->max(), Eigen::Vector3d(2, 4, 6));
  EXPECT_THROW(BoxFromNumbers({0, 1, 0, 1, 0}), OptionError);
  EXPECT_THROW(BoxFromNumbers({0, 1, 0, 1, 2, 2}), OptionError);
}

}  // namespace
}  // namespace limn::colmap_ext
