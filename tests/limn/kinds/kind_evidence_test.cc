// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/kind_evidence.h"

#include <cmath>

#include <gtest/gtest.h>

namespace limn {
namespace {

// sRGB value, gray levels, of a linear intensity from 0 to 1.
float EncodedGray(double linear) {
  return static_cast<float>(
      255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055));
}

SideColor ColorOf(double red, double green, double blue) {
  return {EncodedGray(red), EncodedGray(green), EncodedGray(blue)};
}

LinkProfile ProfileOf(LinkId link, float width_px, const SideColor& left, const SideColor& right,
                      float depth = 1, int place = 0) {
  return {link, place, depth, {width_px, 50, left, right}};
}

const SideColor kGray = ColorOf(0.4, 0.4, 0.4);
const SideColor kHalf = ColorOf(0.2, 0.2, 0.2);

TEST(KindEvidenceTest, BlurIsRelativeToSharpEdgesAtTheSameDepth) {
  // Far away everything is out of focus, and twice as wide.
  std::vector<LinkProfile> view;
  const auto add = [&](LinkId link, float width, float depth) {
    for (int k = 0; k < 30; ++k) view.push_back(ProfileOf(link, width, kGray, kHalf, depth));
  };
  add(0, 0.7F, 1);
  add(1, 0.7F, 2);
  add(2, 1.4F, 3);
  add(3, 1.4F, 4);
  add(4, 1.4F, 1.1F);
  const std::vector<KindEvidence> links = GatherEvidence(6, {view});
  EXPECT_NEAR(links[0].blur_ratio, 1, 1e-6);
  EXPECT_NEAR(links[3].blur_ratio, 1, 1e-6);
  EXPECT_NEAR(links[4].blur_ratio, 2, 1e-6);
  EXPECT_EQ(links[4].num_profiles, 30);
  EXPECT_EQ(links[4].num_views, 1);
  EXPECT_EQ(links[5].num_profiles, 0);
}

TEST(KindEvidenceTest, FewProfilesOfAViewAreComparedWithAnySharpPhotograph) {
  const std::vector<KindEvidence> links =
      GatherEvidence(1, {{ProfileOf(0, 2.1F, kGray, kHalf), ProfileOf(0, 2.0F, kGray, kHalf)}});
  EXPECT_GT(links[0].blur_ratio, 2);
}

TEST(KindEvidenceTest, ChromaChangeIsThatOfColorAndNotOfBrightness) {
  const SideColor orange = ColorOf(0.6, 0.3, 0.1);
  const SideColor dark_orange = ColorOf(0.15, 0.075, 0.025);
  const SideColor blue = ColorOf(0.1, 0.2, 0.4);
  const std::vector<LinkProfile> view = {
      ProfileOf(0, 1, orange, dark_orange), ProfileOf(0, 1, dark_orange, orange),
      ProfileOf(1, 1, orange, blue), ProfileOf(1, 1, orange, blue)};
  const std::vector<KindEvidence> links = GatherEvidence(2, {view});
  // What is added to dark values (0.002) changes a ratio by up to 6 %.
  EXPECT_NEAR(links[0].chroma_change, 0, 0.06);
  // log(6), log(1.5), log(1/4): largest deviation from their mean.
  const double changes[] = {std::log(6.0), std::log(1.5), std::log(0.25)};
  const double mean = (changes[0] + changes[1] + changes[2]) / 3;
  EXPECT_NEAR(links[1].chroma_change, std::abs(changes[2] - mean), 0.06);
}

TEST(KindEvidenceTest, SpreadsAreThoseOfTheSidesBetweenViews) {
  // The darker side is the same in all views, the brighter one is not.
  std::vector<std::vector<LinkProfile>> views;
  for (const double background : {0.4, 0.5, 0.8, 0.3, 0.6}) {
    views.push_back({ProfileOf(0, 1, ColorOf(background, background, background), kHalf)});
  }
  const KindEvidence link = GatherEvidence(1, views)[0];
  EXPECT_EQ(link.num_views, 5);
  EXPECT_NEAR(link.darker_spread, 0, 1e-6);
  // Deviations from log(0.5): 0.22, 0, 0.47, 0.51, 0.18; their median, without the added 0.002.
  EXPECT_NEAR(link.brighter_spread, std::log(0.5 / 0.4), 0.01);
  EXPECT_NEAR(link.change_spread, link.brighter_spread, 1e-6);
}

TEST(KindEvidenceTest, ExposureOfAViewIsWhatItShowsOfAllLinks) {
  // Views are exposed differently; of the last link both sides change with the light besides.
  std::vector<std::vector<LinkProfile>> views;
  constexpr double kExposures[] = {1, 0.25, 0.7, 0.5, 0.35};
  constexpr double kLights[] = {1, 0.5, 0.7, 0.2, 0.4};
  for (int v = 0; v < 5; ++v) {
    const double exposure = kExposures[v];
    const auto gray = [&](double value) {
      return ColorOf(exposure * value, exposure * value, exposure * value);
    };
    const double light = kLights[v];
    views.push_back({ProfileOf(0, 1, gray(0.4), gray(0.2)), ProfileOf(1, 1, gray(0.6), gray(0.3)),
                     ProfileOf(2, 1, gray(0.5), gray(0.1)),
                     ProfileOf(3, 1, gray(0.4 * light), gray(0.2 * light))});
  }
  const std::vector<KindEvidence> links = GatherEvidence(4, views);
  for (int l = 0; l < 3; ++l) {
    EXPECT_GT(links[l].darker_spread, 0.3) << l;
    EXPECT_NEAR(links[l].steadier_spread_exposed, 0, 0.02) << l;
  }
  EXPECT_GT(links[3].steadier_spread_exposed, 0.25);
}

TEST(KindEvidenceTest, SidesAreTakenByBrightnessInEachView) {
  const std::vector<KindEvidence> links =
      GatherEvidence(1, {{ProfileOf(0, 1, kGray, kHalf)}, {ProfileOf(0, 1, kHalf, kGray)}});
  EXPECT_NEAR(links[0].darker_spread, 0, 1e-6);
  EXPECT_NEAR(links[0].change_spread, 0, 1e-6);
}

// A profile per place; the change at each is the logarithm of the ratio.
std::vector<LinkProfile> WithRatios(const std::vector<double>& ratios) {
  std::vector<LinkProfile> view;
  for (size_t k = 0; k < ratios.size(); ++k) {
    const double dark = 0.4 / ratios[k];
    view.push_back(ProfileOf(0, 1, kGray, ColorOf(dark, dark, dark), 1, static_cast<int>(k)));
  }
  return view;
}

TEST(KindEvidenceTest, UnevennessIsTheDifferenceOfNeighborsAlongTheLink) {
  EXPECT_NEAR(GatherEvidence(1, {WithRatios({2, 2, 2, 2, 2})})[0].unevenness, 0, 1e-6);
  // Slow change is even, change at every place is not.
  EXPECT_NEAR(GatherEvidence(1, {WithRatios({2, 2.1, 2.2, 2.3, 2.4})})[0].unevenness, 0.047, 0.005);
  EXPECT_NEAR(GatherEvidence(1, {WithRatios({2, 3, 2, 3, 2})})[0].unevenness, std::log(1.5), 0.01);
  // What one of three views shows is noise.
  const std::vector<LinkProfile> even = WithRatios({2, 2, 2, 2});
  EXPECT_NEAR(GatherEvidence(1, {even, WithRatios({2, 3, 2, 3}), even})[0].unevenness, 0, 1e-6);
  EXPECT_TRUE(std::isinf(GatherEvidence(1, {WithRatios({2, 2, 2})})[0].unevenness));
}

}  // namespace
}  // namespace limn
