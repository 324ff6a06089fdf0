// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/bent_loops.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "support/face_drawing.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::FaceDrawing;

// The links of every loop.
std::vector<std::set<LinkId>> LoopsOf(const DrawingGraph& graph,
                                      const SurfaceOptions& options = {}) {
  const auto links = MeasureFaceLinks(graph, testing::DomeViews(12, 8), options);
  std::vector<std::set<LinkId>> loops;
  for (const BentLoop& loop : FindBentLoops(links, graph, options)) {
    loops.emplace_back();
    for (const LoopStep& step : loop) loops.back().insert(step.link->link);
    EXPECT_EQ(loops.back().size(), loop.size());
  }
  return loops;
}

// An arc in a vertical plane that rises from one place and ends at another.
CircularArc Bow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double sweep_rad) {
  const Eigen::Vector3d along = (to - from).normalized();
  CircularArc arc;
  arc.sweep_rad = sweep_rad;
  arc.radius = (to - from).norm() / (2 * std::sin(sweep_rad / 2));
  arc.center = (from + to) / 2;
  arc.center.z() -= arc.radius * std::cos(sweep_rad / 2);
  arc.x_axis = (from - arc.center).normalized();
  arc.y_axis = (along - along.dot(arc.x_axis) * arc.x_axis).normalized();
  return arc;
}

// Two bows beside each other and one across, and lines between the ends of the first two.
FaceDrawing Vault(double gap = 0) {
  FaceDrawing drawing;
  drawing.AddShape(Bow({0, 0, 0}, {2, 0, 0}, 0.8));
  drawing.AddLine({2, 0, 0}, {2, 1, 0});
  drawing.AddShape(Bow({2, 1, 0}, {0, 1, 0}, 0.8));
  drawing.AddLine({0, 1 - gap, 0}, {0, gap, 0});
  return drawing;
}

TEST(BentLoops, APentagonOfBowsIsOne) {
  EXPECT_EQ(LoopsOf(testing::PentagonPatch(0.6)), (std::vector<std::set<LinkId>>{{0, 1, 2, 3, 4}}));
}

TEST(BentLoops, BridgesAreShort) {
  EXPECT_EQ(LoopsOf(Vault().graph()), (std::vector<std::set<LinkId>>{{0, 1, 2, 3}}));
  EXPECT_EQ(LoopsOf(Vault(0.02).graph()), (std::vector<std::set<LinkId>>{{0, 1, 2, 3}}));
  EXPECT_TRUE(LoopsOf(Vault(0.2).graph()).empty());
}

TEST(BentLoops, NodesNeedNoBridges) {
  SurfaceOptions options;
  options.max_bridge_px = 0;
  EXPECT_EQ(LoopsOf(Vault().graph(), options), (std::vector<std::set<LinkId>>{{0, 1, 2, 3}}));
}

TEST(BentLoops, WhatIsFlatIsNone) {
  FaceDrawing drawing;
  drawing.AddShape(Bow({0, 0, 0}, {2, 0, 0}, 0.8));
  drawing.AddLine({2, 0, 0}, {2, 0, -1});
  drawing.AddLine({2, 0, -1}, {0, 0, -1});
  drawing.AddLine({0, 0, -1}, {0, 0, 0});
  EXPECT_TRUE(LoopsOf(drawing.graph()).empty());
}

TEST(BentLoops, NoneAroundAFold) {
  // A side up, a bow over, a side down: around two corners of a box.
  FaceDrawing drawing;
  drawing.AddShape(Bow({0, 0, 1}, {2, 0, 1}, 0.8));
  drawing.AddLine({2, 0, 1}, {2, 0, 0});
  drawing.AddLine({2, 0, 0}, {2, 1, 0});
  drawing.AddLine({2, 1, 0}, {0, 1, 1});
  drawing.AddLine({0, 1, 1}, {0, 0, 1});
  EXPECT_TRUE(LoopsOf(drawing.graph()).empty());
}

TEST(BentLoops, AChordCutsThem) {
  FaceDrawing drawing = Vault();
  drawing.AddLine({0, 0, 0}, {2, 1, 0});
  const auto loops = LoopsOf(drawing.graph());
  EXPECT_EQ(std::ranges::count(loops, std::set<LinkId>{0, 1, 2, 3}), 0);
}

}  // namespace
}  // namespace limn
