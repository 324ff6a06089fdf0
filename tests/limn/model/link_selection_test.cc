// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/link_selection.h"

#include <gtest/gtest.h>

#include "limn/util/errors.h"

namespace limn {
namespace {

// A link of every kind from node 0, and a tentative edge.
DrawingGraph Fan() {
  DrawingGraph graph;
  graph.nodes.resize(1);
  for (int k = 0; k <= kNumLinkKinds; ++k) {
    DrawingLink link;
    link.points_in_world = {{0, 0, 0}, {1, 1.0 * k, 0}};
    link.sigma = {0, 0};
    link.node0 = 0;
    link.node1 = k + 1;
    link.tentative = k == kNumLinkKinds;
    link.kind = link.tentative ? LinkKind::kEdge : static_cast<LinkKind>(k);
    link.rod_radius = link.kind == LinkKind::kRod ? 0.5 : 0;
    graph.nodes.emplace_back();
    graph.nodes.back().position_in_world = link.points_in_world.back();
    graph.links.push_back(link);
  }
  RebuildIncidence(&graph);
  EXPECT_TRUE(Validate(graph).empty());
  return graph;
}

std::vector<LinkKind> KindsOf(const DrawingGraph& graph) {
  EXPECT_TRUE(Validate(graph).empty());
  std::vector<LinkKind> kinds;
  for (const DrawingLink& link : graph.links) kinds.push_back(link.kind);
  return kinds;
}

using Kinds = std::vector<LinkKind>;

TEST(LinkSelectionTest, ByDefaultOutlinesTextureAndTentativeLinksAreLeftOut) {
  EXPECT_EQ(KindsOf(Selected(Fan(), {})),
            (Kinds{LinkKind::kUnknown, LinkKind::kEdge, LinkKind::kPaint, LinkKind::kShadow,
                   LinkKind::kRod}));
}

TEST(LinkSelectionTest, NamedKindsAndTentativeLinksAreUsed) {
  LinkSelection selection;
  selection.kinds = KindsFromNames("contour,edge");
  EXPECT_EQ(KindsOf(Selected(Fan(), selection)), (Kinds{LinkKind::kEdge, LinkKind::kContour}));
  selection.tentative = true;
  EXPECT_EQ(KindsOf(Selected(Fan(), selection)),
            (Kinds{LinkKind::kEdge, LinkKind::kContour, LinkKind::kEdge}));
  selection.kinds = KindsFromNames("all");
  EXPECT_EQ(Selected(Fan(), selection).links.size(), Fan().links.size());
  selection.kinds = KindsFromNames("default");
  selection.tentative = false;
  EXPECT_EQ(Selected(Fan(), selection).links.size(), Selected(Fan(), {}).links.size());
}

TEST(LinkSelectionTest, RodsAreCenterLinesOrOutlines) {
  DrawingGraph fan = Fan();
  fan.links.back().doubt = LinkDoubt::kRodOutline;
  EXPECT_EQ(KindsOf(Selected(fan, {})).back(), LinkKind::kRod);
  EXPECT_EQ(KindsOf(Selected(fan, LinkSelection::AsSeen())),
            (Kinds{LinkKind::kUnknown, LinkKind::kEdge, LinkKind::kPaint, LinkKind::kShadow,
                   LinkKind::kEdge}));
  LinkSelection paint = LinkSelection::AsSeen();
  paint.kinds = KindsFromNames("paint");
  EXPECT_EQ(KindsOf(Selected(fan, paint)), Kinds{LinkKind::kPaint});
}

std::vector<LinkKind> KindsAt(Detail detail, const DrawingGraph& graph) {
  LinkSelection selection;
  selection.Set(detail);
  return KindsOf(Selected(graph, selection));
}

TEST(LinkSelectionTest, DetailBringsTextureBackOrLeavesShortCurvesOut) {
  DrawingGraph fan = Fan();
  for (DrawingLink& link : fan.links) link.curve_px = 79.9;
  fan.links[static_cast<int>(LinkKind::kEdge)].curve_px = 80;
  fan.links[static_cast<int>(LinkKind::kTexture)].curve_px = 200;
  fan.links[static_cast<int>(LinkKind::kPaint)].curve_px = 0;  // unknown
  EXPECT_EQ(KindsAt(Detail::kNormal, fan), KindsOf(Selected(fan, {})));
  EXPECT_EQ(KindsAt(Detail::kAll, fan),
            (Kinds{LinkKind::kUnknown, LinkKind::kEdge, LinkKind::kPaint, LinkKind::kShadow,
                   LinkKind::kRod, LinkKind::kTexture}));
  EXPECT_EQ(KindsAt(Detail::kCoarse, fan), (Kinds{LinkKind::kEdge, LinkKind::kPaint}));
}

TEST(LinkSelectionTest, NormalDetailLeavesNamedKindsAsTheyAre) {
  LinkSelection selection;
  selection.kinds = KindsFromNames("texture");
  selection.Set(Detail::kNormal);
  EXPECT_EQ(KindsOf(Selected(Fan(), selection)), Kinds{LinkKind::kTexture});
  selection.Set(Detail::kCoarse);
  EXPECT_TRUE(Selected(Fan(), selection).links.empty());
}

TEST(LinkSelectionTest, NodesForgetTexture) {
  // Of two links and one of texture, that meet.
  DrawingGraph fan = Fan();
  RemoveLinks({0, 1, 1, 0, 0, 0, 1, 0}, &fan);
  EXPECT_EQ(fan.nodes[0].kind, NodeKind::kJunction);
  EXPECT_EQ(Selected(fan, {}).nodes[0].kind, NodeKind::kEnd);
}

TEST(LinkSelectionTest, DetailsHaveNames) {
  for (const Detail detail : {Detail::kCoarse, Detail::kNormal, Detail::kAll}) {
    EXPECT_EQ(DetailFromName(DetailName(detail)), detail);
  }
  for (const char* bad : {"", "fine", "Normal"}) EXPECT_THROW(DetailFromName(bad), OptionError);
}

TEST(LinkSelectionTest, UnknownNamesAreRefused) {
  for (const char* bad : {"", "edges", "edge,", "edge,,paint", "all,edge", "Edge"}) {
    EXPECT_THROW(KindsFromNames(bad), OptionError) << bad;
  }
}

}  // namespace
}  // namespace limn
