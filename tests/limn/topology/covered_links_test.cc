// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/covered_links.h"

#include <gtest/gtest.h>

#include "limn/topology/frontal_scene.h"

namespace limn {
namespace {

using testing::FrontalScene;
using Kept = std::vector<uint8_t>;

Kept Uncovered(FrontalScene* scene) {
  return scene->Run(
      [&](const auto&, GraphEditor*) { return FindUncoveredLinks(scene->options, scene->graph); });
}

// A long link, a short one half a pixel beside it, one at 4 px, and one across it.
FrontalScene FourLinks() {
  FrontalScene scene;
  scene.Draw({{-60, 0}, {60, 0}});
  scene.Draw({{-25, 0.5}, {25, 0.5}});
  scene.Draw({{-25, 4}, {25, 4}});
  scene.Draw({{0, -25}, {0, 25}});
  return scene;
}

TEST(FindUncoveredLinksTest, ShorterOfTwoOnTheSameEdgeGoes) {
  FrontalScene scene = FourLinks();
  EXPECT_EQ(Uncovered(&scene), (Kept{1, 0, 1, 1}));
}

TEST(FindUncoveredLinksTest, OneOfTwoAlikeStays) {
  FrontalScene scene;
  scene.Draw({{-60, 0}, {60, 0}});
  scene.Draw({{-60, 0.5}, {59, 0.5}});
  EXPECT_EQ(Uncovered(&scene), (Kept{1, 0}));
}

TEST(FindUncoveredLinksTest, ShareIsAnOption) {
  // Of 50 px, 35 run along the other link.
  const auto kept = [](double covered_share) {
    FrontalScene scene;
    scene.options.covered_share = covered_share;
    scene.Draw({{-60, 0}, {60, 0}});
    scene.Draw({{0, 0.5}, {35, 0.5}, {35, 15.5}});
    return Uncovered(&scene);
  };
  EXPECT_EQ(kept(0.65), (Kept{1, 0}));
  EXPECT_EQ(kept(0.75), (Kept{1, 1}));
}

TEST(FindUncoveredLinksTest, LinksWithoutVerticesAreLeftAlone) {
  for (const LinkId frozen : {0, 1}) {
    FrontalScene scene = FourLinks();
    scene.Freeze(frozen);
    EXPECT_EQ(Uncovered(&scene), (Kept{1, 1, 1, 1}));
  }
}

TEST(FindUncoveredLinksTest, NothingIsCoveredInAnEmptyDrawing) {
  EXPECT_TRUE(FindUncoveredLinks({}, DrawingGraph()).empty());
}

}  // namespace
}  // namespace limn
