// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/link_fitting.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "limn/drawing/sample_curves.h"
#include "limn/topology/graph_editor.h"
#include "limn/topology/graph_fixture.h"
#include "limn/topology/link_geometry.h"

namespace limn {
namespace {

using Eigen::Vector3d;

// A link per curve that is a link of its own, with the samples of the others at its points.
struct Merged {
  SampleSet samples;
  CurveConsistency network;
  DrawingGraph graph;

  explicit Merged(const std::vector<std::vector<Vector3d>>& curves)
      : samples(testing::MakeSamples(curves)) {
    network.overlaps.resize(curves.size());
  }

  void AddLink(int curve, NodeId node0 = -1) {
    DrawingLink link;
    for (int k = 0; k < samples.Size(curve); ++k) {
      const int s = samples.curve_begin[curve] + k;
      link.points_in_world.push_back(samples.position[s]);
      link.vertices.push_back({samples.information[s], samples.footprint[s], 0, {}, {{curve, k}}});
    }
    link.sigma.assign(link.points_in_world.size(), 0);
    link.node0 = node0;
    GraphEditor(&graph).Add(std::move(link));
  }
  void Fit() {
    FitLinks(samples, network, &graph);
    testing::ExpectValid(graph);
  }
};

TEST(FitLinksTest, SamplesAreNamedWithThoseThatTheyStandFor) {
  Merged merged({testing::Row({0, 0, 0}, {1, 0, 0}, 3)});
  merged.samples.origins[0] = {4, 30, 0, false, 2, 35};
  merged.AddLink(0);
  merged.Fit();
  const std::vector<LinkVertex>& vertices = merged.graph.links[0].vertices;
  EXPECT_EQ(vertices[1].samples, (std::vector<SketchSample>{{4, 32}, {4, 33}}));
  EXPECT_EQ(vertices[2].samples, (std::vector<SketchSample>{{4, 34}}));
}

TEST(FitLinksTest, VerticesHaveWhatIsKnownOfAllTheirSamples) {
  Merged merged({testing::Row({0, 0, 0}, {1, 0, 0}, 10), testing::Row({3, 0.2, 0}, {1, 0, 0}, 2)});
  merged.samples.origins[0] = {4, 30, 0, false};
  merged.samples.origins[1] = {2, 7, 1, false};
  merged.samples.support = {};
  for (int s = 0; s < 12; ++s) {
    merged.samples.support.Append(std::vector<EdgelRef>{{s < 10 ? 1 : 0, s}, {2, 5}});
  }
  merged.AddLink(0);
  merged.graph.links[0].vertices[3].samples.push_back({1, 0});
  // Only the second curve overlaps the other one.
  merged.network.overlaps[1] = {{0, {3, 4}}};
  merged.Fit();
  const DrawingLink& link = merged.graph.links[0];
  const LinkVertex& both = link.vertices[3];
  EXPECT_EQ(both.samples, (std::vector<SketchSample>{{4, 33}, {2, 7}}));
  EXPECT_EQ(both.support, (std::vector<EdgelRef>{{0, 10}, {1, 3}, {2, 5}}));
  EXPECT_EQ(both.agreeing_views, 2);
  EXPECT_EQ(link.vertices[4].samples, (std::vector<SketchSample>{{4, 34}}));
  EXPECT_EQ(link.vertices[4].support, (std::vector<EdgelRef>{{1, 4}, {2, 5}}));
  EXPECT_EQ(link.vertices[4].agreeing_views, 1);
  for (int k = 0; k < link.size(); ++k) {
    EXPECT_EQ(link.sigma[k], SigmaAcross(link.vertices[k].information, link.vertices[k].footprint));
    EXPECT_NEAR(link.sigma[k], 0.1, 1e-9);
  }
}

TEST(FitLinksTest, NodeIsAtTheMeanOfItsEnds) {
  // Three straight links from the origin. The first end of each has samples merged into it, which
  // take it aside; the nodes at their other ends, which have none, stay.
  const std::vector<Vector3d> ways = {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  std::vector<std::vector<Vector3d>> curves;
  for (const Vector3d& way : ways) curves.push_back(testing::Row({0, 0, 0}, way, 30));
  for (const Vector3d& way : ways) {
    curves.push_back(testing::Row({0, 0, 0.6}, way, 30));  // along it, above
  }
  Merged merged(curves);
  merged.AddLink(0);
  merged.AddLink(1, merged.graph.links[0].node0);
  merged.AddLink(2, merged.graph.links[0].node0);
  // Of the first two links all points are at 0.3 after the fit, of the third at 0.
  for (const int link : {0, 1}) {
    for (int k = 0; k < 30; ++k)
      merged.graph.links[link].vertices[k].samples.push_back({link + 3, k});
  }
  merged.Fit();
  const DrawingNode& node = merged.graph.nodes[merged.graph.links[0].node0];
  ASSERT_EQ(node.Degree(), 3);
  // The weak prior holds the points back by a part in ten thousand.
  EXPECT_LT((node.position_in_world - Vector3d(0, 0, 0.2)).norm(), 1e-3);
}

}  // namespace
}  // namespace limn
