// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/curve_chains.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

using Eigen::Vector3d;

EdgeSoup OnXAxis(int num_vertices, std::vector<std::pair<int, int>> edges) {
  EdgeSoup soup;
  for (int i = 0; i < num_vertices; ++i) soup.vertices.emplace_back(i, 0, 0);
  soup.edges = std::move(edges);
  return soup;
}

std::vector<double> XOf(const Polyline3d& polyline) {
  std::vector<double> xs;
  for (const Vector3d& point : polyline) xs.push_back(point.x());
  return xs;
}

TEST(ChainEdges, JoinsShuffledAndReversedEdges) {
  const CurveSet set = ChainEdges(OnXAxis(6, {{2, 1}, {2, 3}, {1, 0}, {4, 3}}));
  ASSERT_EQ(set.polylines.size(), 1u);
  EXPECT_EQ(XOf(set.polylines[0]), (std::vector<double>{0, 1, 2, 3, 4}));
  ASSERT_EQ(set.points.size(), 1u);
  EXPECT_EQ(set.points[0].x(), 5);
}

TEST(ChainEdges, EndsAtJunctions) {
  const CurveSet set = ChainEdges(OnXAxis(5, {{0, 1}, {1, 2}, {1, 3}, {3, 4}}));
  ASSERT_EQ(set.polylines.size(), 3u);
  EXPECT_EQ(XOf(set.polylines[0]), (std::vector<double>{0, 1}));
  EXPECT_EQ(XOf(set.polylines[1]), (std::vector<double>{1, 2}));
  EXPECT_EQ(XOf(set.polylines[2]), (std::vector<double>{1, 3, 4}));
}

TEST(ChainEdges, CycleReturnsToItsFirstPoint) {
  const CurveSet set = ChainEdges(OnXAxis(3, {{0, 1}, {2, 1}, {2, 0}}));
  ASSERT_EQ(set.polylines.size(), 1u);
  EXPECT_EQ(XOf(set.polylines[0]), (std::vector<double>{0, 1, 2, 0}));
}

TEST(ChainEdges, LoopAtAJunctionIsOnePolyline) {
  const CurveSet set = ChainEdges(OnXAxis(4, {{0, 1}, {1, 2}, {2, 3}, {3, 1}}));
  ASSERT_EQ(set.polylines.size(), 2u);
  EXPECT_EQ(XOf(set.polylines[1]), (std::vector<double>{1, 2, 3, 1}));
}

TEST(ChainEdges, LabelsKeepCurvesApart) {
  EdgeSoup soup = OnXAxis(4, {{0, 1}, {1, 2}, {2, 3}});
  soup.labels = {7, 7, 9};
  const CurveSet set = ChainEdges(soup);
  ASSERT_EQ(set.polylines.size(), 2u);
  EXPECT_EQ(XOf(set.polylines[0]), (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(XOf(set.polylines[1]), (std::vector<double>{2, 3}));
}

TEST(ChainEdges, WeldsEqualPositionsAndDropsEdgesOfNoLength) {
  EdgeSoup soup = OnXAxis(3, {{0, 1}, {3, 2}, {1, 3}, {1, 1}, {1, 0}});
  soup.vertices.emplace_back(1, 0, 0);  // vertex 3 = vertex 1
  const CurveSet set = ChainEdges(soup);
  ASSERT_EQ(set.polylines.size(), 1u);
  EXPECT_EQ(XOf(set.polylines[0]), (std::vector<double>{0, 1, 2}));
}

TEST(ChainEdges, CopiesStayUnlessAskedFor) {
  EdgeSoup soup = OnXAxis(2, {{0, 1}, {2, 3}});
  soup.vertices.emplace_back(0, 0, 0);
  soup.vertices.emplace_back(1, 0, 0);
  soup.labels = {0, 1};
  EXPECT_EQ(ChainEdges(soup).polylines.size(), 2u);
  soup.labels = {};
  soup.merge_copies = true;
  EXPECT_EQ(ChainEdges(soup).polylines.size(), 1u);
}

}  // namespace
}  // namespace limn
