// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/patch_candidates.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/surfaces/bent_fixture.h"
#include "support/face_drawing.h"

namespace limn {
namespace {

std::vector<BentCandidate> PatchesOf(const DrawingGraph& graph) {
  return testing::BentCandidatesOf(graph, FindPatchCandidates);
}

TEST(PatchCandidates, OverAPentagon) {
  const DrawingGraph graph = testing::PentagonPatch(0.6);
  const auto patches = PatchesOf(graph);
  ASSERT_EQ(patches.size(), 1u);
  const auto& [candidate, face] = patches[0];
  EXPECT_EQ(face.surface, FaceSurface::kPatch);
  EXPECT_EQ(face.side_starts, (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_FALSE(candidate.flat);
  // Slightly more than the flat pentagon.
  const double flat = 2.5 * 4 * std::sin(2 * M_PI / 5);
  EXPECT_GT(AreaOf(face), 1.001 * flat);
  EXPECT_LT(AreaOf(face), 1.15 * flat);
  const double top = graph.links[0].points_in_world[graph.links[0].points_in_world.size() / 2].z();
  EXPECT_GT(candidate.places.size(), 10u);
  for (const CandidatePlace& place : candidate.places) {
    EXPECT_GT(place.position.z(), 0);
    EXPECT_LT(place.position.z(), top);
    EXPECT_GT(std::abs(place.normal.z()), 0.9);
    EXPECT_EQ(place.border.size(), 16u);
  }
}

TEST(PatchCandidates, TheBorderStaysWhereTheLinksAre) {
  const DrawingGraph graph = testing::PentagonPatch(0.6);
  const auto patches = PatchesOf(graph);
  ASSERT_EQ(patches.size(), 1u);
  const Eigen::Vector3d corner = graph.links[0].points_in_world.front();
  double nearest = 1e9;
  for (const Eigen::Vector3d& vertex : patches[0].candidate.vertices) {
    nearest = std::min(nearest, (vertex - corner).norm());
  }
  EXPECT_LT(nearest, 1e-9);
}

}  // namespace
}  // namespace limn
