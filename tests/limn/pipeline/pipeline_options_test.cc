#include "limn/pipeline/pipeline_options.h"

#include <algorithm>
#include <set>
#include <type_traits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/pipeline/option_fields.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// Lays the visited fields out as the compiler would, from `begin`: a field that the list forgets
// makes a hole or a rest.
template <typename Options>
void ExpectAllFieldsAreVisited(size_t begin) {
  Options options;
  const char* base = reinterpret_cast<const char*>(&options);
  size_t end = begin;
  std::set<std::string> names;
  VisitFields(options, [&](const std::string& name, auto& field, const OptionHelp& help) {
    const size_t alignment = alignof(std::remove_reference_t<decltype(field)>);
    const size_t expected = (end + alignment - 1) / alignment * alignment;
    const size_t offset = reinterpret_cast<const char*>(&field) - base;
    EXPECT_EQ(offset, expected) << "a field before " << name << " is not visited";
    EXPECT_TRUE(names.insert(name).second) << name << " is visited twice";
    EXPECT_FALSE(help.text.empty()) << name;
    end = offset + sizeof(field);
  });
  const size_t alignment = alignof(Options);
  EXPECT_EQ((end + alignment - 1) / alignment * alignment, sizeof(Options))
      << "fields at the end are not visited";
}

TEST(OptionFields, ListsEveryField) {
  ExpectAllFieldsAreVisited<EdgeDetectionOptions>(0);
  ExpectAllFieldsAreVisited<LinkingOptions>(0);
  ExpectAllFieldsAreVisited<ViewSelectionOptions>(0);
  ExpectAllFieldsAreVisited<SketchOptions>(sizeof(ViewSelectionOptions));
  ExpectAllFieldsAreVisited<DrawingOptions>(0);
  ExpectAllFieldsAreVisited<RefinementOptions>(0);
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

TEST(PipelineOptions, ThePaperHasNoRefinementOfPoses) {
  PipelineOptions options;
  options.method = DrawingMethod::kPaper;
  EXPECT_NO_THROW(options.Check());
  options.refinement.refine_poses = true;
  EXPECT_THROW(options.Check(), OptionError);
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
