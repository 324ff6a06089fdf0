// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/face_scores.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "support/meshes.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::CubeMesh;
using testing::FrontalViews;
using testing::kFrontalPx;
using testing::LookAt;

// Rows of FaceScores with the default taus.
constexpr size_t kHalfPx = 0, kTwoPx = 2, kFourPx = 3, kEightPx = 4;

// A horizontal rectangle below FrontalViews, corners and height in px.
std::vector<Eigen::Vector3d> Rectangle(double x0, double y0, double x1, double y1, double z = 0) {
  return {kFrontalPx * Eigen::Vector3d(x0, y0, z), kFrontalPx * Eigen::Vector3d(x1, y0, z),
          kFrontalPx * Eigen::Vector3d(x1, y1, z), kFrontalPx * Eigen::Vector3d(x0, y1, z)};
}

TriangleMesh MeshOf(const std::vector<std::vector<Eigen::Vector3d>>& rectangles) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::vector<int>> polygons;
  for (const std::vector<Eigen::Vector3d>& corners : rectangles) {
    const int first = static_cast<int>(vertices.size());
    vertices.insert(vertices.end(), corners.begin(), corners.end());
    polygons.push_back({first, first + 1, first + 2, first + 3});
  }
  return MakeTriangleMesh(vertices, polygons);
}

DrawingFace FaceOf(const std::vector<Eigen::Vector3d>& rectangle) {
  DrawingFace face;
  face.vertices = rectangle;
  face.triangles = {{0, 1, 2}, {0, 2, 3}};
  return face;
}

std::vector<Eigen::Vector3d> TurnedAboutY(std::vector<Eigen::Vector3d> corners, double angle_deg) {
  const Eigen::AngleAxisd turn(angle_deg * kDeg, Eigen::Vector3d::UnitY());
  for (Eigen::Vector3d& corner : corners) corner = turn * corner;
  return corners;
}

// The truth is a square of 200 px that four views look straight down on.
class SquareBelow : public ::testing::Test {
 protected:
  FaceScores Score(const std::vector<DrawingFace>& faces) const {
    return ScoreFaces(SurfaceOf(faces), truth_, views_, options_);
  }

  std::vector<View> views_ = FrontalViews(2, 2, 0.2);
  std::vector<Eigen::Vector3d> square_ = Rectangle(-100, -100, 100, 100);
  TriangleMesh truth_ = MeshOf({square_});
  FaceScoreOptions options_;
};

TEST_F(SquareBelow, TheSameSurfaceIsAllRight) {
  const FaceScores scores = Score({FaceOf(square_)});
  ASSERT_EQ(scores.rows.size(), 5u);
  for (const FaceTauResult& row : scores.rows) {
    EXPECT_DOUBLE_EQ(*row.precision, 1);
    EXPECT_DOUBLE_EQ(*row.recall, 1);
    EXPECT_DOUBLE_EQ(*row.f, 1);
    EXPECT_EQ(row.num_right_faces, 1);
    EXPECT_EQ(row.num_covered_regions, 1);
  }
  const double area = 200 * 200 * kFrontalPx * kFrontalPx;
  EXPECT_NEAR(scores.area, area, 1e-9);
  EXPECT_NEAR(scores.true_area, area, 1e-9);
}

TEST_F(SquareBelow, AboveTheTruthItIsRightFromThatDistanceOn) {
  const FaceScores scores = Score({FaceOf(Rectangle(-100, -100, 100, 100, 3))});
  EXPECT_EQ(*scores.rows[kTwoPx].precision, 0);
  EXPECT_EQ(*scores.rows[kTwoPx].recall, 0);
  EXPECT_EQ(*scores.rows[kTwoPx].f, 0);
  EXPECT_EQ(scores.rows[kTwoPx].num_right_faces, 0);
  EXPECT_DOUBLE_EQ(*scores.rows[kFourPx].precision, 1);
  EXPECT_DOUBLE_EQ(*scores.rows[kFourPx].recall, 1);
}

TEST_F(SquareBelow, BesideTheTruthAQuarterIsWrong) {
  const FaceScores scores = Score({FaceOf(Rectangle(-50, -100, 150, 100))});
  for (const auto& [row, tau] : {std::pair(kHalfPx, 0.5), {kTwoPx, 2}, {kEightPx, 8}}) {
    EXPECT_NEAR(*scores.rows[row].precision, 0.75 + tau / 200, 0.006);
    EXPECT_NEAR(*scores.rows[row].recall, 0.75 + tau / 200, 0.006);
  }
  EXPECT_EQ(scores.rows[kTwoPx].num_right_faces, 1);
  EXPECT_EQ(scores.rows[kTwoPx].num_covered_regions, 0);
}

TEST_F(SquareBelow, TiltedItIsRightNearTheAxis) {
  // 2 px above the truth at 2 / sin(5 degrees) = 22.9 px along the face.
  const FaceScores scores = Score({FaceOf(TurnedAboutY(square_, 5))});
  EXPECT_NEAR(*scores.rows[kTwoPx].precision, 0.229, 0.01);
  EXPECT_NEAR(*scores.rows[kEightPx].precision, 0.918, 0.01);
  EXPECT_NEAR(*scores.rows[kTwoPx].recall, 0.229, 0.01);
}

TEST_F(SquareBelow, TiltedTooMuchItIsWrongWhereverItIs) {
  const std::vector<DrawingFace> faces = {FaceOf(TurnedAboutY(square_, 15))};
  EXPECT_EQ(*Score(faces).rows[kEightPx].precision, 0);
  EXPECT_EQ(*Score(faces).rows[kEightPx].recall, 0);
  options_.max_angle_deg = 16;
  EXPECT_NEAR(*Score(faces).rows[kEightPx].precision, 8 / std::sin(15 * kDeg) / 100, 0.01);
}

TEST_F(SquareBelow, HalfOfItIsHalfOfTheRecall) {
  // Seen from below: orientations do not matter.
  std::vector<Eigen::Vector3d> half = Rectangle(-100, -100, 0, 100);
  std::reverse(half.begin(), half.end());
  const FaceScores scores = Score({FaceOf(half), FaceOf(Rectangle(-100, -100, 0, 100, 100))});
  EXPECT_NEAR(*scores.rows[kHalfPx].recall, 0.5, 0.006);
  EXPECT_NEAR(*scores.rows[kTwoPx].precision, 0.5, 0.006);
  EXPECT_NEAR(*scores.rows[kTwoPx].f, 0.5, 0.01);
  EXPECT_EQ(scores.rows[kTwoPx].num_right_faces, 1);
  ASSERT_EQ(scores.faces.size(), 2u);
  EXPECT_EQ(scores.faces[0].within[kTwoPx], 1);
  EXPECT_EQ(scores.faces[1].within[kTwoPx], 0);
  EXPECT_NEAR(scores.faces[0].area, 20000 * kFrontalPx * kFrontalPx, 1e-9);
}

TEST_F(SquareBelow, WithoutFacesNothingIsFound) {
  const FaceScores scores = Score({});
  EXPECT_FALSE(scores.rows[kTwoPx].precision);
  EXPECT_FALSE(scores.rows[kTwoPx].f);
  EXPECT_EQ(*scores.rows[kTwoPx].recall, 0);
}

TEST_F(SquareBelow, WhatIsHiddenIsNotAskedFor) {
  // Another square 250 px below; the first covers it in all views.
  truth_ = MeshOf({square_, Rectangle(-30, -30, 30, 30, -250)});
  EXPECT_DOUBLE_EQ(*Score({FaceOf(square_)}).rows[kTwoPx].recall, 1);
  EXPECT_EQ(Score({FaceOf(square_)}).regions.size(), 1u);
  // A face there is right all the same.
  const FaceScores of_both = Score({FaceOf(square_), FaceOf(Rectangle(-30, -30, 30, 30, -250))});
  EXPECT_DOUBLE_EQ(*of_both.rows[kTwoPx].precision, 1);
  // Without the first it is seen.
  truth_ = MeshOf({Rectangle(-30, -30, 30, 30, -250)});
  EXPECT_EQ(*Score({FaceOf(square_)}).rows[kTwoPx].recall, 0);
}

TEST_F(SquareBelow, WhatTooFewViewsSeeIsNotAskedFor) {
  // The second view sees half of the square at most: 640 px wide, moved by 320 px.
  views_ = {FrontalViews(1, 1, 0)[0], FrontalViews(2, 1, 640 * kFrontalPx)[1]};
  const double area = 200 * 200 * kFrontalPx * kFrontalPx;
  EXPECT_NEAR(Score({}).true_area, 0.5 * area, 0.02 * area);
  options_.min_views = 1;
  EXPECT_NEAR(Score({}).true_area, area, 1e-9);
  options_.min_views = 3;
  EXPECT_THROW(Score({}), OptionError);
}

TEST_F(SquareBelow, WhatIsSeenAtAGrazingAngleIsNotAskedFor) {
  // Upright, not far from below the views: rays meet it at less than 8 degrees.
  truth_ = MeshOf({{{0.4, -0.5, 0}, {0.4, 0.5, 0}, {0.4, 0.5, 1}, {0.4, -0.5, 1}}});
  EXPECT_EQ(Score({}).true_area, 0);
  EXPECT_FALSE(Score({}).rows[kTwoPx].recall);
  EXPECT_TRUE(Score({}).regions.empty());
  options_.min_grazing_deg = 1;
  EXPECT_NEAR(Score({}).true_area, 1, 1e-9);
}

TEST_F(SquareBelow, OnlyWhatIsInTheRegionCounts) {
  const double reach = 100 * kFrontalPx;
  options_.region.emplace(Eigen::Vector3d(-reach, -reach, -1), Eigen::Vector3d(0, reach, 1));
  const FaceScores scores = Score({FaceOf(Rectangle(-50, -100, 150, 100))});
  EXPECT_DOUBLE_EQ(*scores.rows[kTwoPx].precision, 1);
  EXPECT_NEAR(*scores.rows[kHalfPx].recall, 0.5, 0.01);
}

TEST_F(SquareBelow, SmallRegionsAreNotCounted) {
  truth_ = MeshOf({square_, Rectangle(110, 0, 125, 15)});
  EXPECT_EQ(Score({}).regions.size(), 1u);
  options_.min_region_px = 14;
  EXPECT_EQ(Score({}).regions.size(), 2u);
}

TEST_F(SquareBelow, BadOptionsAreRefused) {
  options_.taus = {2, 0};
  EXPECT_THROW(Score({}), OptionError);
  options_ = {};
  options_.max_angle_deg = 91;
  EXPECT_THROW(Score({}), OptionError);
  views_.clear();
  EXPECT_THROW(ScoreFaces({}, truth_, views_, {}), InputError);
}

// Three views of the same side of a cube, which see three of its faces.
class CubeOfFaces : public ::testing::Test {
 protected:
  std::vector<View> views_{LookAt({3, 2.5, 2}, {0, 0, 0}), LookAt({2.5, 3, 2.2}, {0, 0, 0}),
                           LookAt({2.6, 2.7, 3}, {0, 0, 0})};
  TriangleMesh cube_ = CubeMesh({0, 0, 0}, 0.5);
};

TEST_F(CubeOfFaces, AgainstItselfIsRightAndItsFarSideIsNotAskedFor) {
  const FaceScores scores = ScoreFaces(SurfaceOf(cube_), cube_, views_, {});
  EXPECT_DOUBLE_EQ(*scores.rows[kHalfPx].precision, 1);
  EXPECT_DOUBLE_EQ(*scores.rows[kHalfPx].recall, 1);
  EXPECT_NEAR(scores.area, 6, 1e-9);
  EXPECT_NEAR(scores.true_area, 3, 0.1);
  EXPECT_EQ(scores.rows[kTwoPx].num_covered_regions, static_cast<int>(scores.regions.size()));
}

TEST_F(CubeOfFaces, WithoutOneOfTheSeenFacesTwoThirdsAreFound) {
  const FaceScores scores =
      ScoreFaces(SurfaceOf(CubeMesh({0, 0, 0}, 0.5, 1 << 5)), cube_, views_, {});
  EXPECT_DOUBLE_EQ(*scores.rows[kTwoPx].precision, 1);
  EXPECT_NEAR(*scores.rows[kTwoPx].recall, 2.0 / 3, 0.02);
}

TEST_F(CubeOfFaces, ThreadsDoNotMatter) {
  const auto with_threads = [&](int num_threads) {
    RunContext context;
    context.num_threads = num_threads;
    return ScoreFaces(SurfaceOf(CubeMesh({0.01, 0.02, 0}, 0.51)), cube_, views_, {}, context);
  };
  const FaceScores one = with_threads(1);
  const FaceScores four = with_threads(4);
  EXPECT_EQ(one.true_area, four.true_area);
  for (size_t t = 0; t < one.rows.size(); ++t) {
    EXPECT_EQ(one.rows[t].precision, four.rows[t].precision);
    EXPECT_EQ(one.rows[t].recall, four.rows[t].recall);
  }
}

}  // namespace
}  // namespace limn
