// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/reliability.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/model/footprint.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr double kWithin = 0.1;
// Cells are at most a quarter of that long.
constexpr double kCellLength = kWithin / 4;

DrawingLink LineTold(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double confidence) {
  DrawingLink link;
  link.points_in_world = {from, to};
  link.sigma = {0, 0};
  link.confidence = confidence;
  return link;
}

CurveSet TrueLine(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  CurveSet truth;
  truth.polylines.push_back({from, to});
  return truth;
}

// One link of 4 along a truth of 3, one of 2 beside it, one of 1 that nothing is near.
DrawingGraph Drawn() {
  DrawingGraph drawing;
  drawing.links = {LineTold({0, 0, 0}, {4, 0, 0}, 0.95), LineTold({0, 1, 0}, {2, 1, 0}, 0.55),
                   LineTold({0, 2, 0}, {1, 2, 0}, 0)};
  return drawing;
}

Reliability Compare(const DrawingGraph& drawing, const CurveSet& dont_care = {},
                    std::optional<Eigen::AlignedBox3d> region = std::nullopt) {
  return CompareConfidences(drawing, TrueLine({0, 0.05, 0}, {3, 0.05, 0}), dont_care, {},
                            {kWithin, 2, region}, {});
}

TEST(Reliability, ToldAndRightPerBin) {
  const Reliability found = Compare(Drawn());
  EXPECT_NEAR(found.bins[9].length, 4, 1e-9);
  EXPECT_NEAR(found.bins[9].told, 3.8, 1e-9);
  EXPECT_NEAR(found.bins[9].right, 3 + 0.0866, 2 * kCellLength);  // tau reaches beyond the end
  EXPECT_NEAR(found.bins[5].told, 1.1, 1e-9);
  EXPECT_EQ(found.bins[5].right, 0);
  EXPECT_NEAR(found.bins[0].length, 1, 1e-9);
  EXPECT_NEAR(found.Length(), 7, 1e-9);
  EXPECT_NEAR(found.CalibrationError(), (3.8 - 3.0866 + 1.1) / 7, kCellLength);
}

TEST(Reliability, CertaintyIsInTheLastBin) {
  DrawingGraph drawing = Drawn();
  drawing.links[0].confidence = 1;
  EXPECT_NEAR(Compare(drawing).bins[9].told, 4, 1e-9);
}

TEST(Reliability, TentativeLinksCount) {
  DrawingGraph drawing = Drawn();
  drawing.links[1].tentative = true;
  EXPECT_NEAR(Compare(drawing).Length(), 7, 1e-9);
}

TEST(Reliability, OutlinesRodsAndTheUnknownDoNot) {
  DrawingGraph drawing = Drawn();
  drawing.links[0].kind = LinkKind::kContour;
  drawing.links[1].kind = LinkKind::kRod;
  drawing.links[2].doubt = LinkDoubt::kRodOutline;
  drawing.links.push_back(LineTold({0, 3, 0}, {1, 3, 0}, -1));
  EXPECT_EQ(Compare(drawing).Length(), 0);
  EXPECT_EQ(Compare(drawing).CalibrationError(), 0);
}

TEST(Reliability, OnlyInsideAndWhereOneCares) {
  const Eigen::AlignedBox3d region(Eigen::Vector3d(-1, 0.5, -1), Eigen::Vector3d(1.5, 3, 1));
  EXPECT_NEAR(Compare(Drawn(), {}, region).Length(), 1.5 + 1, 2 * kCellLength);
  EXPECT_NEAR(Compare(Drawn(), TrueLine({0, 2.1, 0}, {1, 2.1, 0})).Length(), 6, 1e-9);
}

TEST(Reliability, DistancesInFootprints) {
  const std::vector<View> views = testing::DomeViews(8, 5);
  DrawingGraph drawing;
  drawing.links = {LineTold({0, 0, 0}, {0.1, 0, 0}, 0.9)};
  const auto right_at = [&](double distance_px) {
    const double off = distance_px * PixelFootprint(views, Eigen::Vector3d::Zero());
    const CurveSet truth = TrueLine({-1, off, 0}, {1, off, 0});
    return CompareConfidences(drawing, truth, {}, views, {}, {}).bins[9].right;
  };
  EXPECT_NEAR(right_at(1.8), 0.1, 1e-9);
  EXPECT_EQ(right_at(2.2), 0);
}

TEST(Reliability, RejectsSenselessOptions) {
  EXPECT_THROW(CompareConfidences({}, {}, {}, {}, {0, 2, {}}, {}), OptionError);
  EXPECT_THROW(CompareConfidences({}, {}, {}, {}, {1, -1, {}}, {}), OptionError);
}

}  // namespace
}  // namespace limn
