// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/given_curves.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn {
namespace {

using ::testing::ElementsAre;

ImageCurves RowOfPoints(const std::vector<double>& tangents, std::vector<CurveFragment> fragments) {
  ImageCurves curves;
  for (size_t i = 0; i < tangents.size(); ++i) {
    Edgel edgel;
    edgel.position_px = {static_cast<double>(i), 5};
    edgel.tangent_rad = tangents[i];
    curves.edge_map.edgels.push_back(edgel);
  }
  curves.fragments = std::move(fragments);
  return curves;
}

TEST(CurvesOfPolylines, EdgelsAreAPixelApartAlongTheCurve) {
  const ImageCurves curves = CurvesOfPolylines({{{2, 3}, {12, 3}, {12, 7}}}, 64, 48);
  EXPECT_EQ(curves.edge_map.width, 64);
  EXPECT_EQ(curves.edge_map.height, 48);
  ASSERT_EQ(curves.fragments.size(), 1u);
  EXPECT_FALSE(curves.fragments[0].closed);
  const auto& edgels = curves.edge_map.edgels;
  ASSERT_EQ(edgels.size(), 15u);
  EXPECT_EQ(edgels.front().position_px, Eigen::Vector2d(2, 3));
  EXPECT_NEAR((edgels.back().position_px - Eigen::Vector2d(12, 7)).norm(), 0, 1e-12);
  EXPECT_NEAR(edgels[4].position_px.x(), 6, 1e-12);
  EXPECT_NEAR(edgels[4].tangent_rad, 0, 1e-12);
  EXPECT_NEAR(edgels[13].tangent_rad, M_PI / 2, 1e-12);
}

TEST(CurvesOfPolylines, EqualEndsCloseACurve) {
  const ImageCurves curves =
      CurvesOfPolylines({{{2, 2}, {12, 2}, {12, 12}, {2, 12}, {2, 2}}}, 64, 48);
  ASSERT_EQ(curves.fragments.size(), 1u);
  EXPECT_TRUE(curves.fragments[0].closed);
  EXPECT_EQ(curves.fragments[0].edgel_ids.size(), 40u);
  // Between the side that ends there and the one that begins.
  EXPECT_NEAR(curves.edge_map.edgels[0].tangent_rad, -M_PI / 4, 1e-9);
}

TEST(MakeConsistent, GoodFragmentsStay) {
  ImageCurves curves = RowOfPoints({0.1, -0.2, 0, 0}, {{{0, 1, 2, 3}, false}});
  MakeConsistent(&curves);
  ASSERT_EQ(curves.fragments.size(), 1u);
  EXPECT_THAT(curves.fragments[0].edgel_ids, ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(curves.edge_map.edgels[0].tangent_rad, 0.1);
  EXPECT_EQ(curves.edge_map.edgels[1].tangent_rad, -0.2);
}

TEST(MakeConsistent, FragmentsRunAlongMostTangents) {
  ImageCurves curves = RowOfPoints({0, 0, M_PI - 0.1, 0}, {{{3, 2, 1, 0}, false}});
  MakeConsistent(&curves);
  EXPECT_THAT(curves.fragments[0].edgel_ids, ElementsAre(0, 1, 2, 3));
  EXPECT_NEAR(curves.edge_map.edgels[2].tangent_rad, -0.1, 1e-12);
}

TEST(MakeConsistent, SharedEdgelsAreCopied) {
  ImageCurves curves =
      RowOfPoints({0, 0, 0, 0}, {{{0, 1, 1, 2}, false}, {{2, 3}, false}, {{3}, false}});
  MakeConsistent(&curves);
  ASSERT_EQ(curves.fragments.size(), 2u);
  EXPECT_THAT(curves.fragments[0].edgel_ids, ElementsAre(0, 1, 2));
  EXPECT_THAT(curves.fragments[1].edgel_ids, ElementsAre(4, 3));
  EXPECT_EQ(curves.edge_map.edgels[4].position_px, curves.edge_map.edgels[2].position_px);
}

TEST(MakeConsistent, GapsCutFragments) {
  ImageCurves curves = RowOfPoints(std::vector<double>(30, 0), {{{0, 1, 2, 20, 9, 10}, false}});
  MakeConsistent(&curves);
  ASSERT_EQ(curves.fragments.size(), 2u);
  EXPECT_THAT(curves.fragments[0].edgel_ids, ElementsAre(0, 1, 2));
  EXPECT_THAT(curves.fragments[1].edgel_ids, ElementsAre(9, 10));
}

TEST(MakeConsistent, GapsOpenClosedFragments) {
  ImageCurves curves =
      RowOfPoints(std::vector<double>(30, 0), {{{1, 2, 20, 21, 10, 0}, true}, {{3, 8, 14}, true}});
  MakeConsistent(&curves);
  ASSERT_EQ(curves.fragments.size(), 3u);
  EXPECT_THAT(curves.fragments[0].edgel_ids, ElementsAre(20, 21));
  EXPECT_THAT(curves.fragments[1].edgel_ids, ElementsAre(2, 1, 0, 10));
  EXPECT_THAT(curves.fragments[2].edgel_ids, ElementsAre(3, 8, 14));
  for (const CurveFragment& fragment : curves.fragments) EXPECT_FALSE(fragment.closed);
}

TEST(MakeConsistent, TwoEdgelsOrOnePlaceAreNotClosed) {
  ImageCurves curves = RowOfPoints(std::vector<double>(12, 0),
                                   {{{0, 1}, true}, {{2, 10, 3, 4, 11}, true}, {{5, 9}, false}});
  std::vector<Edgel>& edgels = curves.edge_map.edgels;
  edgels[10].position_px = edgels[11].position_px = edgels[2].position_px;
  edgels[9].position_px = edgels[5].position_px;
  MakeConsistent(&curves);
  ASSERT_EQ(curves.fragments.size(), 2u);
  EXPECT_FALSE(curves.fragments[0].closed);
  EXPECT_THAT(curves.fragments[1].edgel_ids, ElementsAre(2, 3, 4));
  EXPECT_TRUE(curves.fragments[1].closed);
}

TEST(TurnAround, TurnsOrderAndTangents) {
  ImageCurves curves = RowOfPoints({0, 0.1}, {{{0, 1}, false}});
  TurnAround(&curves.fragments[0], &curves.edge_map.edgels);
  EXPECT_THAT(curves.fragments[0].edgel_ids, ElementsAre(1, 0));
  EXPECT_NEAR(curves.edge_map.edgels[1].tangent_rad, 0.1 - M_PI, 1e-12);
}

}  // namespace
}  // namespace limn
