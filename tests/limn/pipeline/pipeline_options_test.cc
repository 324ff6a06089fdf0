// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/pipeline_options.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/util/errors.h"

namespace limn {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(OptionGroups, OptionsHaveNamesHelpAndDefaultsInTheirRanges) {
  std::set<std::string> names;
  const PipelineOptions options;
  VisitGroups(options, [&](const std::string& group, const auto& fields) {
    fields.VisitFields(fields, [&](const std::string& name, const auto& field,
                                   const OptionValues& values, const OptionHelp& help) {
      EXPECT_TRUE(names.insert(group + "." + name).second) << group << "." << name;
      EXPECT_FALSE(help.text.empty()) << group << "." << name;
      EXPECT_NO_THROW(CheckOptionValue(name.c_str(), static_cast<double>(field), values));
    });
  });
  // With Drawing.method and the groups EdgeMaps and DenseFusion. Who adds one asks first whether
  // anybody would set it.
  EXPECT_LE(names.size() + 5, 60u);
}

TEST(PipelineOptions, PresetsAreValid) {
  for (const Quality quality : {Quality::kLow, Quality::kMedium, Quality::kHigh}) {
    EXPECT_NO_THROW(PresetOf(quality).options.Check());
  }
}

TEST(PipelineOptions, MediumIsTheDefaults) {
  EXPECT_EQ(OptionsAsJson(PresetOf(Quality::kMedium).options), OptionsAsJson(PipelineOptions()));
  EXPECT_EQ(PresetOf(Quality::kMedium).max_image_size, 2048);
}

TEST(PipelineOptions, HigherQualityPairsMoreViews) {
  const auto second_views = [](Quality quality) {
    return PresetOf(quality).options.sketch.view_selection.max_second_views;
  };
  EXPECT_LT(second_views(Quality::kLow), second_views(Quality::kMedium));
  EXPECT_LT(second_views(Quality::kMedium), second_views(Quality::kHigh));
}

TEST(PipelineOptions, CheckNamesGroupAndOption) {
  PipelineOptions options;
  options.linking.max_bridge_px = -1;
  try {
    options.Check();
    FAIL() << "no exception";
  } catch (const OptionError& error) {
    EXPECT_THAT(error.what(), StartsWith("Linking.max_bridge_px = -1"));
  }
  options = PipelineOptions();
  options.sketch.view_selection.max_second_views = 0;
  try {
    options.Check();
    FAIL() << "no exception";
  } catch (const OptionError& error) {
    EXPECT_THAT(error.what(), StartsWith("ViewSelection.max_second_views = 0"));
  }
}

TEST(PipelineOptions, ThePaperHasNoRefinementOfCameras) {
  PipelineOptions options;
  options.method = DrawingMethod::kPaper;
  EXPECT_NO_THROW(options.Check());
  options.refine_cameras = CameraRefinement::kOn;
  EXPECT_THROW(options.Check(), OptionError);
}

TEST(PipelineOptions, DrawingsFitGivenCamerasOnlyWhereTheseMayBeRefined) {
  PipelineOptions options;
  options.output_cameras = OutputCameras::kGiven;
  EXPECT_NO_THROW(options.Check());
  options.refinement.num_rounds = 0;
  EXPECT_THROW(options.Check(), OptionError);
  options.refinement.num_rounds = 1;
  options.refine_cameras = CameraRefinement::kOff;
  EXPECT_THROW(options.Check(), OptionError);
}

TEST(PipelineOptions, JsonHasWordsOfEnumsAndThePaperOnlyWithItsMethod) {
  PipelineOptions options;
  options.edges.channel = EdgeChannel::kLuminance;
  EXPECT_THAT(OptionsAsJson(options), HasSubstr(R"("channel":"luminance")"));
  EXPECT_THAT(OptionsAsJson(options), Not(HasSubstr("merge_distance_px")));
  SetMethodDefaults(DrawingMethod::kPaper, &options);
  EXPECT_THAT(OptionsAsJson(options), HasSubstr(R"("averaging":"paper")"));
  EXPECT_THAT(OptionsAsJson(options), HasSubstr("merge_distance_px"));
}

TEST(PipelineOptions, TextTellsOptionsApart) {
  EdgeDetectionOptions options;
  const std::string before = OptionsAsText(options);
  EXPECT_THAT(before, HasSubstr("sigma_px=1.5\n"));
  options.sigma_px = 1.5 + 1e-15;
  EXPECT_NE(OptionsAsText(options), before);
}

}  // namespace
}  // namespace limn
