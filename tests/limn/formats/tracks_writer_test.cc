// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/tracks_writer.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

View SmallView() {
  View view = testing::ForwardView();
  view.name = "folder/a b.png";
  return view;
}

// Stored = virtual * 2 + 1, within a radius.
class ToyLens : public LensMap {
 public:
  std::optional<Eigen::Vector2d> VirtualFromStored(const Eigen::Vector2d& stored) const override {
    return Eigen::Vector2d((stored.array() - 1) / 2);
  }
  std::optional<Eigen::Vector2d> StoredFromVirtual(const Eigen::Vector2d& pixel) const override {
    return Eigen::Vector2d(2 * pixel.array() + 1);
  }
};

TEST(ProjectPolyline, ClipsWhereTheLineLeavesTheImage) {
  const auto runs = ProjectPolyline(SmallView(), {{-1, 0, 1}, {1, 0, 1}});
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_NEAR(runs[0].front().x(), 0, 0.01);
  EXPECT_NEAR(runs[0].back().x(), 100, 0.01);
  EXPECT_NEAR(runs[0].front().y(), 50, 1e-9);
}

TEST(ProjectPolyline, SeveralRunsAndNoneBehindTheCamera) {
  // In, out to the right, and in again.
  const auto runs = ProjectPolyline(SmallView(), {{0, 0, 1}, {2, 0, 1}, {2, 0.2, 1}, {0, 0.2, 1}});
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_NEAR(runs[0].back().x(), 100, 0.01);
  EXPECT_NEAR(runs[1].back().y(), 70, 1e-9);
  EXPECT_TRUE(ProjectPolyline(SmallView(), {{-1, 0, -1}, {1, 0, -1}}).empty());
  EXPECT_TRUE(ProjectPolyline(SmallView(), {}).empty());
  // Through the camera plane: only the part in front.
  const auto through = ProjectPolyline(SmallView(), {{0.1, 0, 1}, {0.1, 0, -1}});
  ASSERT_EQ(through.size(), 1u);
  EXPECT_NEAR(through[0].back().x(), 100, 0.1);
}

TEST(ProjectPolyline, GoesThroughTheLens) {
  View view = SmallView();
  view.lens = std::make_shared<ToyLens>();
  const auto runs = ProjectPolyline(view, {{0, 0, 1}, {0.4, 0, 1}});
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_GT(runs[0].size(), 10u);  // bent lines need their inner points
  EXPECT_NEAR(runs[0].front().x(), 101, 1e-9);
  EXPECT_NEAR(runs[0].back().x(), 181, 1e-9);
}

TEST(WriteTracks, OneLinePerRunInColmapsPixels) {
  DrawingGraph graph;
  graph.nodes.resize(2);
  graph.nodes[0].position_in_world = {0, 0, 1};
  graph.nodes[1].position_in_world = {0.25, 0, 1};
  DrawingLink link;
  link.points_in_world = {{0, 0, 1}, {0.25, 0, 1}};
  link.sigma = {0, 0};
  link.node0 = 0;
  link.node1 = 1;
  link.supporting_views = {0};
  graph.links = {link};
  RebuildIncidence(&graph);
  std::ostringstream out;
  WriteTracks(graph, {}, {SmallView()}, out);
  EXPECT_THAT(out.str(), ::testing::EndsWith("\n0 2 50.500 50.500 75.500 50.500 folder/a b.png\n"));
  EXPECT_THAT(out.str(), ::testing::StartsWith("# "));
  graph.links[0].supporting_views = {1};
  EXPECT_THROW(WriteTracks(graph, {}, {SmallView()}, out), InputError);
}

TEST(WriteTracks, OnlySelectedLinksWithTheIdsOfTheDrawing) {
  DrawingLink link;
  link.points_in_world = {{0, 0, 1}, {0.25, 0, 1}};
  link.supporting_views = {0};
  DrawingGraph graph;
  graph.links = {link, link, link};
  graph.links[0].tentative = true;
  graph.links[1].kind = LinkKind::kContour;
  std::ostringstream out;
  WriteTracks(graph, {}, {SmallView()}, out);
  EXPECT_THAT(out.str(), ::testing::HasSubstr("# Number of links: 1 of 3\n2 2 50.500"));
  LinkSelection all;
  all.kinds.fill(true);
  all.tentative = true;
  std::ostringstream out_of_all;
  WriteTracks(graph, all, {SmallView()}, out_of_all);
  EXPECT_THAT(out_of_all.str(), ::testing::HasSubstr("# Number of links: 3 of 3\n0 2 50.500"));
}

TEST(WriteTracks, NamesForgeNoLines) {
  DrawingLink link;
  link.points_in_world = {{0, 0, 1}, {0.25, 0, 1}};
  link.supporting_views = {0, 1};
  DrawingGraph graph;
  graph.links = {link};
  std::vector<View> views = {SmallView(), SmallView()};
  views[0].name = "a\n7 2 1 1 2 2 b.png ";
  views[1].name = "c\\d.png";
  std::ostringstream out;
  WriteTracks(graph, {}, views, out);
  EXPECT_THAT(out.str(),
              ::testing::EndsWith("# Number of links: 1 of 1\n"
                                  "# Some characters of image names are written as \\xHH.\n"
                                  "0 2 50.500 50.500 75.500 50.500 a\\x0A7 2 1 1 2 2 b.png\\x20\n"
                                  "0 2 50.500 50.500 75.500 50.500 c\\x5Cd.png\n"));
}

}  // namespace
}  // namespace limn
