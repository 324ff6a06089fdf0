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

TEST(LinkSelectionTest, ByDefaultOutlinesAndTentativeLinksAreLeftOut) {
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

TEST(LinkSelectionTest, UnknownNamesAreRefused) {
  for (const char* bad : {"", "edges", "edge,", "edge,,paint", "all,edge", "Edge"}) {
    EXPECT_THROW(KindsFromNames(bad), OptionError) << bad;
  }
}

}  // namespace
}  // namespace limn
