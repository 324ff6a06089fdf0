#include "limn/belief/loose_pieces.h"

#include <gtest/gtest.h>

#include "limn/topology/graph_fixture.h"

namespace limn {
namespace {

using testing::GraphOf;

struct Pieces {
  DrawingGraph graph;
  std::vector<double> length_px;
  std::vector<double> evidence;

  std::vector<bool> Doubted() const {
    DrawingGraph judged = graph;
    DoubtLoosePieces(length_px, evidence, &judged);
    std::vector<bool> doubted;
    for (const DrawingLink& link : judged.links) {
      doubted.push_back(link.doubt == LinkDoubt::kChance);
    }
    return doubted;
  }
};

// Two links that meet and one by itself.
Pieces PairAndOne() {
  return {GraphOf({{{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {1, 1, 0}}, {{5, 0, 0}, {6, 0, 0}}}),
          {30, 29, 59},
          {10, 10, 10}};
}

TEST(LoosePiecesTest, WhatIsShortTogetherIsDoubted) {
  EXPECT_EQ(PairAndOne().Doubted(), (std::vector<bool>{true, true, true}));
}

TEST(LoosePiecesTest, LongerPiecesAreNot) {
  Pieces pieces = PairAndOne();
  pieces.length_px = {30, 30, 60};
  EXPECT_EQ(pieces.Doubted(), (std::vector<bool>{false, false, false}));
}

TEST(LoosePiecesTest, OneSureLinkHoldsItsPiece) {
  Pieces pieces = PairAndOne();
  pieces.evidence[1] = 11;
  EXPECT_EQ(pieces.Doubted(), (std::vector<bool>{false, false, true}));
}

TEST(LoosePiecesTest, AClosedLinkHoldsItsPiece) {
  Pieces pieces = PairAndOne();
  pieces.graph.links[0].closed = true;
  EXPECT_EQ(pieces.Doubted(), (std::vector<bool>{false, false, true}));
}

TEST(LoosePiecesTest, DoubtedLinksHoldNothing) {
  Pieces pieces = PairAndOne();
  pieces.length_px = {100, 29, 59};
  pieces.evidence = {50, 10, 10};
  pieces.graph.links[0].doubt = LinkDoubt::kSeenThrough;
  EXPECT_EQ(pieces.Doubted(), (std::vector<bool>{false, true, true}));
}

}  // namespace
}  // namespace limn
