// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/edgel_claims.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "limn/topology/frontal_scene.h"

namespace limn {
namespace {

using testing::FrontalPoint;

// One view with an edge of 21 edgels and one that is in no fragment, and a link made from some.
class UnclaimedEdgelsTest : public ::testing::Test {
 protected:
  UnclaimedEdgelsTest() {
    curves_ =
        testing::ProjectCurves(views_, {testing::Segment(FrontalPoint(0, 0), FrontalPoint(20, 0))});
    for (ImageCurves& of_view : curves_) {
      lone_ = static_cast<EdgelId>(of_view.edge_map.edgels.size());
      of_view.edge_map.edgels.push_back(testing::MakeEdgel({200, 100}, 0));
    }
  }

  // Positions on the fragment, of 21, of the edgels of a view that nobody has when a link has
  // these of view 0.
  std::vector<int> Unclaimed(const std::vector<int>& places, ViewId view = 0) {
    const auto& ids = curves_[0].fragments[0].edgel_ids;
    DrawingGraph graph;
    graph.links.emplace_back();
    for (const int place : places) {
      graph.links[0].vertices.emplace_back();
      graph.links[0].vertices.back().support = {{0, ids[place]}};
    }
    const auto support = BuildViewEdgels(curves_, {});
    return Held(UnclaimedEdgels({views_, curves_, support, {}}, graph, {})[view], view);
  }

  std::vector<int> Held(const EdgelIndex& index, ViewId view) const {
    std::vector<int> held;
    const auto& ids = curves_[view].fragments[0].edgel_ids;
    for (size_t k = 0; k < ids.size(); ++k) {
      if (index.AnyWithin(curves_[view].edge_map.edgels[ids[k]].position_px, 1e-6)) {
        held.push_back(static_cast<int>(k));
      }
    }
    EXPECT_FALSE(index.AnyWithin(curves_[view].edge_map.edgels[lone_].position_px, 1e-6));
    return held;
  }

  // 0 to 20 without these.
  static std::vector<int> Without(const std::vector<int>& places) {
    std::vector<int> others;
    for (int k = 0; k <= 20; ++k) {
      if (std::find(places.begin(), places.end(), k) == places.end()) others.push_back(k);
    }
    return others;
  }

  const std::vector<View> views_ = testing::FrontalViews(2, 1, 0.75);
  std::vector<ImageCurves> curves_;
  EdgelId lone_ = kInvalidEdgel;
};

TEST_F(UnclaimedEdgelsTest, NeighborsOfAClaimedEdgelAreClaimed) {
  EXPECT_EQ(Unclaimed({}), Without({}));
  EXPECT_EQ(Unclaimed({10}), Without({9, 10, 11}));
  EXPECT_EQ(Unclaimed({6, 8}), Without({5, 6, 7, 8, 9}));
}

TEST_F(UnclaimedEdgelsTest, FragmentsEnd) {
  EXPECT_EQ(Unclaimed({0}), Without({0, 1}));
  EXPECT_EQ(Unclaimed({20}), Without({19, 20}));
}

TEST_F(UnclaimedEdgelsTest, OtherViewsAreNotConcerned) {
  EXPECT_EQ(Unclaimed({10}, 1), Without({}));
}

TEST_F(UnclaimedEdgelsTest, ClaimsNameThePointOfTheLink) {
  const auto& ids = curves_[0].fragments[0].edgel_ids;
  DrawingGraph graph;
  graph.links.resize(2);
  graph.links[1].vertices.resize(3);
  graph.links[1].vertices[2].support = {{0, ids[7]}};
  const auto support = BuildViewEdgels(curves_, {});
  const EdgelClaims claims = CollectClaims({views_, curves_, support, {}}, graph);
  EXPECT_EQ(claims.at(0).at(ids[7]), (LinkPoint{1, 2}));
  EXPECT_EQ(claims.at(0).at(ids[8]), LinkPoint());
  EXPECT_EQ(claims.at(1).at(curves_[1].fragments[0].edgel_ids[7]), LinkPoint());
}

}  // namespace
}  // namespace limn
