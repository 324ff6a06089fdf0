// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/choose_cells.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "limn/surfaces/flat_candidates.h"
#include "limn/topology/graph_fixture.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::DrawLink;
using testing::FrontalPoint;

// Squares of links at several heights, two halves each if `halved`, and choices among their cells.
struct Squares {
  std::vector<View> views = testing::FrontalViews(4, 4, 0.3);
  DrawingGraph graph;
  std::vector<PlaneCells> planes;
  std::vector<CellChoice> choices;

  void Add(double half_px, double z, bool halved = false) {
    const auto corner = [&](double x, double y) {
      return Eigen::Vector3d(FrontalPoint(x * half_px, y * half_px) + Eigen::Vector3d(0, 0, z));
    };
    DrawLink({corner(-1, -1), corner(1, -1)}, {}, &graph);
    DrawLink({corner(1, -1), corner(1, 0)}, {}, &graph);
    DrawLink({corner(1, 0), corner(1, 1)}, {}, &graph);
    DrawLink({corner(1, 1), corner(-1, 1)}, {}, &graph);
    DrawLink({corner(-1, 1), corner(-1, 0)}, {}, &graph);
    DrawLink({corner(-1, 0), corner(-1, -1)}, {}, &graph);
    if (halved) DrawLink({corner(-1, 0), corner(1, 0)}, {}, &graph);
  }

  // With all places seen by the first `num_views` views.
  void FindChoices(int num_views) {
    const SurfaceOptions options;
    const auto links = MeasureFaceLinks(graph, views, options);
    for (const FacePlane& plane : FindFacePlanes(links, graph, options, {})) {
      planes.push_back(FindPlaneCells(plane, links, graph, options));
    }
    for (size_t p = 0; p < planes.size(); ++p) {
      for (size_t c = 0; c < planes[p].cells.size(); ++c) {
        choices.push_back({static_cast<int>(p),
                           static_cast<int>(c),
                           FlatCandidate(planes[p], planes[p].cells[c]),
                           {}});
        for (ViewId v = 0; v < num_views; ++v) See(v, &choices.back());
      }
    }
  }
  static void See(ViewId view, CellChoice* choice) {
    choice->evidence.sights[view].assign(choice->candidate.places.size(), PlaceSight::kSeen);
  }

  std::vector<CellFate> Fates() const { return ChooseCells(views, graph, planes, choices, {}, {}); }
};

TEST(ChooseCells, TwoViewsMustSeeIt) {
  for (const int num_views : {0, 1, 2, 16}) {
    Squares squares;
    squares.Add(40, 0);
    squares.FindChoices(num_views);
    EXPECT_EQ(squares.Fates(), (std::vector{num_views < 2 ? CellFate::kUnseen : CellFate::kFace}));
  }
}

TEST(ChooseCells, DifferentViewsOfDifferentHalvesDoNotSeeItWhole) {
  Squares squares;
  squares.Add(40, 0);
  squares.FindChoices(0);
  CellChoice& choice = squares.choices[0];
  // Each view sees a third of the places, each place is seen by several.
  const auto see_thirds = [&](PlaceSight others) {
    for (ViewId v = 0; v < 9; ++v) {
      std::vector<PlaceSight>& sights = choice.evidence.sights[v];
      sights.clear();
      for (size_t p = 0; p < choice.candidate.places.size(); ++p) {
        sights.push_back(p % 3 == v % 3u ? PlaceSight::kSeen : others);
      }
    }
  };
  // Of a large surface there may be no more in the image.
  see_thirds(PlaceSight::kUnknown);
  EXPECT_EQ(squares.Fates(), (std::vector{CellFate::kFace}));
  see_thirds(PlaceSight::kHidden);
  EXPECT_EQ(squares.Fates(), (std::vector{CellFate::kUnseen}));
  // Of a bent surface no view sees all.
  choice.candidate.flat.reset();
  choice.plane = -1;
  EXPECT_EQ(squares.Fates(), (std::vector{CellFate::kFace}));
}

TEST(ChooseCells, WhatIsSeenThroughIsNone) {
  Squares squares;
  squares.Add(40, 0);
  squares.FindChoices(16);
  CellChoice& choice = squares.choices[0];
  choice.evidence.seen_through = -SurfaceOptions().prior_evidence - 1;
  EXPECT_EQ(squares.Fates(), (std::vector{CellFate::kSeenThrough}));
  EXPECT_LT(ConfidenceOf(choice, {}), 0.5);
  // What it hides outweighs that.
  choice.evidence.hidden = 2;
  EXPECT_EQ(squares.Fates(), (std::vector{CellFate::kFace}));
  EXPECT_GT(ConfidenceOf(choice, {}), 0.5);
}

TEST(ChooseCells, OtherFacesHideIt) {
  Squares squares;
  squares.Add(60, 1);  // nearer to the views
  squares.Add(30, 0);
  squares.FindChoices(16);
  ASSERT_EQ(squares.choices.size(), 2u);
  const auto is_near = [&](size_t c) {
    return squares.choices[c].candidate.places[0].position.z() > 0.5;
  };
  std::vector<CellFate> fates = squares.Fates();
  for (const size_t c : {0, 1}) {
    EXPECT_EQ(fates[c], is_near(c) ? CellFate::kFace : CellFate::kBehind);
  }
  // Not if the nearer one is none itself.
  for (const size_t c : {0, 1}) {
    if (is_near(c)) squares.choices[c].evidence.seen_through = -100;
  }
  fates = squares.Fates();
  for (const size_t c : {0, 1}) {
    EXPECT_EQ(fates[c], is_near(c) ? CellFate::kSeenThrough : CellFate::kFace);
  }
}

TEST(ChooseCells, OfTwoFacesOnTopOfEachOtherOneStays) {
  // The same plane found again, a little apart or farther.
  for (const double apart_px : {2.5, 10.0}) {
    Squares squares;
    squares.Add(40, 0);
    squares.FindChoices(16);
    squares.planes.push_back(squares.planes[0]);
    squares.choices.push_back(squares.choices[0]);
    CellChoice& again = squares.choices[1];
    again.plane = 1;
    const Eigen::Vector3d apart(0, 0, apart_px * testing::kFrontalPx);
    again.candidate.flat->frame.origin += apart;
    for (CandidatePlace& place : again.candidate.places) place.position += apart;
    for (Eigen::Vector3d& vertex : again.candidate.vertices) vertex += apart;
    const std::vector<CellFate> fates = squares.Fates();
    EXPECT_EQ(std::ranges::count(fates, CellFate::kFace), 1);
    EXPECT_EQ(fates[1], apart_px < 4 ? CellFate::kCopy : CellFate::kFace);
  }
}

TEST(ChooseCells, SurfacesGoOnBesidePaint) {
  for (const LinkKind kind : {LinkKind::kPaint, LinkKind::kShadow, LinkKind::kEdge}) {
    Squares squares;
    squares.Add(40, 0, /*halved=*/true);
    for (DrawingLink& link : squares.graph.links) link.kind = LinkKind::kEdge;
    squares.graph.links.back().kind = kind;
    squares.FindChoices(0);
    ASSERT_EQ(squares.choices.size(), 2u);
    for (ViewId v = 0; v < 16; ++v) Squares::See(v, &squares.choices[1]);
    EXPECT_EQ(squares.Fates(),
              (std::vector{kind == LinkKind::kEdge ? CellFate::kUnseen : CellFate::kFace,
                           CellFate::kFace}));
    // What is seen through stays none.
    squares.choices[0].evidence.seen_through = -100;
    EXPECT_EQ(squares.Fates()[0], CellFate::kSeenThrough);
  }
}

}  // namespace
}  // namespace limn
