// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/trust.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/host/terminal_console.h"
#include "support/synthetic_scene.h"

namespace limn::colmap_ext {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// Twelve views of the origin, each four of one image.
ViewSet ThreeImagesInParts() {
  ViewSet set;
  set.views = limn::testing::DomeViews(12, 5);
  for (int v = 0; v < 12; ++v) {
    ViewFile file;
    file.image_name = std::string(1, static_cast<char>('a' + v / 4));
    file.window = ImageWindow{v % 4, 0, 1, 1, 4, 1};
    set.files.push_back(file);
  }
  return set;
}

DrawingLink LinkSeenBy(std::vector<ViewId> views, double length) {
  DrawingLink link;
  link.points_in_world = {{0, 0, 0}, {length, 0, 0}};
  link.sigma = {0.01, 0.01};
  link.supporting_views = std::move(views);
  return link;
}

TEST(MeasureTrust, CountsImagesNotTheirParts) {
  ViewSet set = ThreeImagesInParts();
  DrawingGraph graph;
  graph.links = {LinkSeenBy({0, 1, 4, 5, 8, 9}, 0.75), LinkSeenBy({0, 4, 8}, 0.25)};
  const Trust of_parts = MeasureTrust(set, set.views, {}, graph, {});
  EXPECT_EQ(of_parts.num_images, 3u);
  EXPECT_EQ(of_parts.well_seen.value(), 0);
  for (size_t v = 0; v < set.files.size(); ++v) set.files[v].image_name = std::to_string(v);
  const Trust of_images = MeasureTrust(set, set.views, {}, graph, {});
  EXPECT_EQ(of_images.num_images, 12u);
  EXPECT_DOUBLE_EQ(of_images.well_seen.value(), 0.75);
}

TEST(MeasureTrust, TellsWhatHasNoMeasuredDepth) {
  const ViewSet set = ThreeImagesInParts();
  DrawingGraph graph;
  graph.links = {LinkSeenBy({0, 4}, 1), LinkSeenBy({0, 4}, 2), LinkSeenBy({0, 4}, 1)};
  graph.links[1].tentative = graph.links[2].tentative = true;
  graph.links[1].doubt = LinkDoubt::kDepth;
  graph.links[2].doubt = LinkDoubt::kChance;
  const Trust trust = MeasureTrust(set, set.views, {}, graph, {});
  EXPECT_DOUBLE_EQ(trust.tentative.value(), 0.75);
  EXPECT_DOUBLE_EQ(trust.unmeasured.value(), 0.5);
}

TEST(MeasureTrust, TellsHowMuchOfWhatWasFoundIsRight) {
  const ViewSet set = ThreeImagesInParts();
  DrawingGraph graph;
  graph.links = {LinkSeenBy({0, 4}, 3), LinkSeenBy({0, 4}, 1), LinkSeenBy({0, 4}, 2)};
  EXPECT_FALSE(MeasureTrust(set, set.views, {}, graph, {}).right);
  graph.links[0].confidence = 0.9;
  graph.links[1].confidence = 0.1;
  graph.links[1].tentative = true;
  EXPECT_DOUBLE_EQ(MeasureTrust(set, set.views, {}, graph, {}).right.value(), 0.7);
}

Trust TrustIn(double right, double explained, double unmeasured) {
  Trust trust;
  trust.right = right;
  trust.explained = explained;
  trust.unmeasured = unmeasured;
  return trust;
}

TEST(VerdictOf, NeedsEvidenceAgreementAndDepth) {
  EXPECT_EQ(VerdictOf(TrustIn(0.51, 0.3, 0), false), Verdict::kGood);
  EXPECT_EQ(VerdictOf(TrustIn(0.49, 0.3, 0), false), Verdict::kDoubtful);
  EXPECT_EQ(VerdictOf(TrustIn(0.04, 0.3, 0), false), Verdict::kDoubtful);
  EXPECT_EQ(VerdictOf(TrustIn(0.02, 0.3, 0), false), Verdict::kNonsense);
  EXPECT_EQ(VerdictOf(TrustIn(0.9, 0.019, 0), false), Verdict::kNonsense);
  EXPECT_EQ(VerdictOf(TrustIn(0.9, 0.019, 0), true), Verdict::kGood);
  EXPECT_EQ(VerdictOf(TrustIn(0.9, 0.3, 0.51), false), Verdict::kNonsense);
  EXPECT_EQ(VerdictOf({}, false), Verdict::kDoubtful);
}

// As of an object on a turntable, whose background is most of the edges.
TEST(VerdictOf, EdgesThatStandStillNeedNoExplanation) {
  Trust trust = TrustIn(0.44, 0.019, 0);
  trust.still = 0.76;
  EXPECT_EQ(VerdictOf(trust, false), Verdict::kDoubtful);
  trust.explained = 0.004;
  EXPECT_EQ(VerdictOf(trust, false), Verdict::kNonsense);
}

std::string SaidOf(const Trust& trust) {
  ::testing::internal::CaptureStdout();
  {
    TerminalConsole console(1);
    SayTrust(trust, false, &console);
  }
  return ::testing::internal::GetCapturedStdout();
}

TEST(SayTrust, VerdictWithCausesWhereItIsNonsense) {
  EXPECT_THAT(SaidOf(TrustIn(0.87, 0.3, 0)),
              HasSubstr("Verdict: good, 87 % of the length found is expected to be right"));
  EXPECT_THAT(SaidOf(TrustIn(0.87, 0.3, 0)), Not(HasSubstr("WARNING")));
  EXPECT_THAT(SaidOf(TrustIn(0.02, 0.3, 0)), HasSubstr("WARNING: only 2 % of the length found"));
  EXPECT_THAT(SaidOf(TrustIn(0.05, 0.01, 0)), HasSubstr("WARNING: the drawing explains next to"));
  Trust of_paper;
  of_paper.explained = 0.3;
  EXPECT_THAT(SaidOf(of_paper), Not(HasSubstr("Verdict")));
}

TEST(SayTrust, DepthThatWasNotMeasuredComesWithTheRemedy) {
  EXPECT_THAT(SaidOf(TrustIn(0.87, 0.3, 0.09)), Not(HasSubstr("WARNING")));
  EXPECT_THAT(SaidOf(TrustIn(0.87, 0.3, 0.11)),
              AllOf(HasSubstr("the depth of 11 %"), HasSubstr("Verdict: good")));
  EXPECT_THAT(SaidOf(TrustIn(0.87, 0.3, 0.98)),
              AllOf(HasSubstr("WARNING: the depth of 98 %"), HasSubstr("places farther apart"),
                    HasSubstr("Verdict: nonsense"), Not(HasSubstr("Usual causes"))));
}

TEST(SayTrust, WhatStandsStillComesWithTheRemedy) {
  Trust trust = TrustIn(0.87, 0.3, 0);
  trust.still = 0.09;
  EXPECT_THAT(SaidOf(trust), Not(HasSubstr("WARNING")));
  trust.still = 0.4;
  EXPECT_THAT(SaidOf(trust), AllOf(HasSubstr("WARNING: 40 % of the edges stand at the same pixels"),
                                   HasSubstr("--mask_path"), HasSubstr("drawn only where")));
}

TEST(SayTrust, ImagesThatDoNotFitTheOthersAreNamed) {
  Trust trust = TrustIn(0.87, 0.3, 0);
  trust.num_images = 12;
  trust.apart = {"a.jpg", "b.jpg"};
  trust.shared_if_apart = 0.4;
  EXPECT_EQ(VerdictOf(trust, false), Verdict::kDoubtful);
  EXPECT_THAT(SaidOf(trust), AllOf(HasSubstr("WARNING: the cameras of 2 of 12 images do not fit "
                                             "those of the others: a.jpg, b.jpg. "),
                                   HasSubstr("share 40 %"), HasSubstr("Verdict: doubtful")));
}

TEST(SayTrust, WhatRepeatsInStepWithTheCamerasComesWithTheRemedy) {
  Trust trust = TrustIn(0.87, 0.3, 0);
  trust.at_other_depths = 0.03;
  EXPECT_THAT(SaidOf(trust), Not(HasSubstr("WARNING")));
  trust.at_other_depths = 0.06;
  EXPECT_THAT(SaidOf(trust), AllOf(HasSubstr("WARNING: 6 % of the edges that are drawn"),
                                   HasSubstr("from other distances")));
}

TEST(SayTrust, MuchDoubtIsAWarning) {
  Trust trust = TrustIn(0.6, 0.3, 0);
  trust.tentative = 0.2;
  EXPECT_THAT(SaidOf(trust),
              AllOf(HasSubstr("20 % of the length found is doubtful"), Not(HasSubstr("WARNING"))));
  trust.tentative = 0.53;
  EXPECT_THAT(SaidOf(trust), HasSubstr("WARNING: 53 % of the length found is doubtful"));
}

TEST(SayTrust, LittleThatIsRightIsAWarning) {
  Trust trust = TrustIn(0.31, 0.3, 0);
  trust.tentative = 0.2;
  EXPECT_THAT(SaidOf(trust), Not(HasSubstr("WARNING")));
  trust.right = 0.29;
  EXPECT_THAT(SaidOf(trust),
              AllOf(HasSubstr("WARNING: only 29 % of the length found is expected to be right"),
                    HasSubstr("Verdict: doubtful")));
  trust.tentative = 0.53;  // the same, said before
  EXPECT_THAT(SaidOf(trust), Not(HasSubstr("WARNING: only")));
}

}  // namespace
}  // namespace limn::colmap_ext
