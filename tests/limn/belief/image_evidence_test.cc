// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/image_evidence.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/belief/belief_scene.h"
#include "limn/support/segment_support.h"

namespace limn {
namespace {

using testing::BeliefScene;
using testing::FrontalPoint;
using testing::Segment;

TEST(FindEvidenceTest, ViewsThatShowALinkExactly) {
  BeliefScene scene;
  scene.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0), 12);
  const ImageEvidence found = scene.Evidence()[0];
  EXPECT_EQ(found.containing_views, 16);
  EXPECT_EQ(found.showing_views, 12);
  // Nothing else is there: the assumed background at a quarter of the gate is 0.02 / 4.
  EXPECT_NEAR(found.evidence, -LogChance(12, 16, 0.005), 1e-9);
}

TEST(FindEvidenceTest, SamplesAreOneAndAHalfPixelsApart) {
  BeliefScene scene;
  scene.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0));
  const ImageEvidence found = scene.Evidence()[0];
  ASSERT_GE(found.samples.size(), 100 / 1.5);
  EXPECT_LE(found.samples.size(), 100 / 1.5 + 1);
  for (const EvidenceSample& sample : found.samples) {
    EXPECT_NEAR(std::abs(sample.tangent.x()), 1, 1e-12);
  }
}

TEST(FindEvidenceTest, NothingSpeaksForWhatNoViewShows) {
  BeliefScene scene;
  scene.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0));
  scene.Draw({FrontalPoint(-50, 30), FrontalPoint(50, 30)});
  const ImageEvidence found = scene.Evidence()[1];
  EXPECT_EQ(found.showing_views, 0);
  EXPECT_EQ(found.evidence, 0);
}

// Accidents lie anywhere in the gate.
TEST(FindEvidenceTest, EdgelsNearTheLinkCountMore) {
  BeliefScene exact;
  exact.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0), 8);
  BeliefScene beside;
  beside.Show(Segment(FrontalPoint(-50, 0.8), FrontalPoint(50, 0.8)), 8);
  beside.Draw({FrontalPoint(-50, 0), FrontalPoint(50, 0)});
  EXPECT_NEAR(beside.Evidence()[0].evidence, -LogChance(8, 16, 0.02), 1e-9);
  EXPECT_GT(exact.Evidence()[0].evidence, beside.Evidence()[0].evidence);
}

TEST(FindEvidenceTest, EdgesAllAroundAreChance) {
  BeliefScene scene;
  scene.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0), 8);
  for (const double shift : {-9, -7, -5, 5, 7, 9}) {
    scene.Show(Segment(FrontalPoint(-50, shift), FrontalPoint(50, shift)), 8);
  }
  // Of the copies in 16 views, those in 8 have edgels: as many as the link.
  EXPECT_LT(scene.Evidence()[0].evidence, 0.1);
}

// A view shows a stretch of a link only if edgels run along half of it.
TEST(FindEvidenceTest, ScatteredEdgelsDoNotCount) {
  BeliefScene scene;
  for (int x = -48; x <= 48; x += 16) {
    scene.Show(Segment(FrontalPoint(x, 0), FrontalPoint(x + 2, 0)));
  }
  scene.Draw({FrontalPoint(-50, 0), FrontalPoint(50, 0)});
  EXPECT_EQ(scene.Evidence()[0].showing_views, 0);
}

}  // namespace
}  // namespace limn
