// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/epipolar_chords.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/geometry/epipolar.h"
#include "support/random_numbers.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using Eigen::Vector2d;

double Cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

class EpipolarChordsTest : public ::testing::Test {
 protected:
  // Adds a fragment of edgels at these places, tangents along the chords.
  void AddFragment(const std::vector<Vector2d>& places, bool closed) {
    CurveFragment fragment;
    fragment.closed = closed;
    const size_t count = places.size();
    for (size_t k = 0; k < count; ++k) {
      const Vector2d chord = places[std::min(k + 1, count - 1)] - places[k > 0 ? k - 1 : 0];
      fragment.edgel_ids.push_back(static_cast<EdgelId>(curves_.edge_map.edgels.size()));
      curves_.edge_map.edgels.push_back(
          testing::MakeEdgel(places[k], std::atan2(chord.y(), chord.x())));
    }
    curves_.fragments.push_back(fragment);
  }

  // Wiggly curves that wander over the image in steps of about 1 px.
  void AddRandomFragments(int count) {
    std::mt19937 random(9);
    testing::UniformDistribution<double> x(50, 600), y(50, 430), angle(-M_PI, M_PI);
    testing::NormalDistribution<double> turn(0, 0.1);
    for (int f = 0; f < count; ++f) {
      std::vector<Vector2d> places = {{x(random), y(random)}};
      double direction = angle(random);
      for (int k = 0; k < 100; ++k) {
        direction += turn(random);
        places.push_back(places.back() + 1.05 * Vector2d(std::cos(direction), std::sin(direction)));
      }
      AddFragment(places, false);
    }
    std::vector<Vector2d> circle;
    for (int k = 0; k < 400; ++k) {
      const double at = 2 * M_PI * k / 400;
      circle.push_back({320 + 64 * std::cos(at), 240 + 64 * std::sin(at)});
    }
    AddFragment(circle, true);
  }

  // All (fragment, chord) that the segment crosses, ascending; nothing if the answer hangs on
  // numbers below `margin`.
  std::optional<std::vector<std::pair<int, int>>> BruteForce(const Vector2d& from,
                                                             const Vector2d& to,
                                                             double margin) const {
    std::vector<std::pair<int, int>> crossed;
    const Vector2d unit = (to - from).normalized();
    for (size_t f = 0; f < curves_.fragments.size(); ++f) {
      const auto& ids = curves_.fragments[f].edgel_ids;
      const size_t chords = curves_.fragments[f].closed ? ids.size() : ids.size() - 1;
      for (size_t k = 0; k < chords; ++k) {
        const Vector2d& a = curves_.edge_map.edgels[ids[k]].position_px;
        const Vector2d& b = curves_.edge_map.edgels[ids[(k + 1) % ids.size()]].position_px;
        const double side_a = Cross(unit, a - from), side_b = Cross(unit, b - from);
        if (std::min(std::abs(side_a), std::abs(side_b)) < margin) return std::nullopt;
        if ((side_a > 0) == (side_b > 0)) continue;
        const Vector2d at = a + side_a / (side_a - side_b) * (b - a);
        const double along = unit.dot(at - from);
        if (std::abs(along) < margin || std::abs(along - (to - from).norm()) < margin) {
          return std::nullopt;
        }
        if (along > 0 && along < (to - from).norm()) {
          crossed.push_back({static_cast<int>(f), static_cast<int>(k)});
        }
      }
    }
    return crossed;
  }

  ImageCurves curves_;
};

// What the ray of a primary pixel meets in another view between two depths.
struct EpipolarSegment {
  Vector2d from = Vector2d::Zero();
  Vector2d to = Vector2d::Zero();
};

std::optional<EpipolarSegment> ProjectRay(const View& primary, const View& other,
                                          const Vector2d& pixel) {
  const auto relative = MakeRelativeProjection(primary.camera, primary.cam_from_world, other.camera,
                                               other.cam_from_world);
  const auto at = [&](double depth) -> Eigen::Vector3d {
    return depth * (relative.infinite_homography * pixel.homogeneous()) + relative.epipole;
  };
  const Eigen::Vector3d near = at(2), far = at(9);
  if (near.z() < 0.1 || far.z() < 0.1) return std::nullopt;
  return EpipolarSegment{near.hnormalized(), far.hnormalized()};
}

// The views of a pair; the images are 640 x 480, the scene is around the origin.
struct Pair {
  const char* name;
  View primary;
  View other;
};

std::vector<Pair> Pairs() {
  return {{"side by side", testing::LookAt({5, 0, 1}, {0, 0, 0}),
           testing::LookAt({4.6, 1.9, 1.2}, {0, 0, 0})},
          {"one above the other", testing::LookAt({5, 0, 0}, {0, 0, 0}),
           testing::LookAt({4.8, 0, 1.5}, {0, 0, 0})},
          {"forward: the epipole is in the image", testing::LookAt({6, 0.1, 0}, {0, 0, 0}),
           testing::LookAt({4.5, 0, 0.1}, {0, 0, 0})},
          {"backward", testing::LookAt({4.5, 0, 0.1}, {0, 0, 0}),
           testing::LookAt({6, 0.1, 0}, {0, 0, 0})}};
}

TEST_F(EpipolarChordsTest, EveryCrossingOfRandomLinesExactlyOnce) {
  AddRandomFragments(60);
  for (const Pair& pair : Pairs()) {
    SCOPED_TRACE(pair.name);
    const FragmentChords chords_of_other(curves_);
    const EpipolarChords chords(pair.primary, pair.other, chords_of_other);
    std::mt19937 random(10);
    testing::UniformDistribution<double> x(0, 639), y(0, 479);
    int num_lines = 0;
    size_t num_crossings = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vector2d pixel(x(random), y(random));
      const auto segment = ProjectRay(pair.primary, pair.other, pixel);
      if (!segment) continue;
      const auto expected = BruteForce(segment->from, segment->to, 2e-3);
      if (!expected) continue;
      const Vector2d along = (segment->to - segment->from).normalized();
      const double length = (segment->to - segment->from).norm();
      std::vector<LineCrossing> crossings;
      chords.Find(pixel, &crossings);
      std::vector<std::pair<int, int>> found;
      for (const LineCrossing& crossing : crossings) {
        EXPECT_LT(std::abs(Cross(along, crossing.position_px - segment->from)), 2e-3);
        EXPECT_NEAR(crossing.tangent.norm(), 1, 1e-9);
        const double at = along.dot(crossing.position_px - segment->from);
        if (at < 0 || at > length) continue;
        const FragmentPlace place = chords_of_other.PlaceOf(crossing.chord);
        found.push_back({place.fragment, place.index});
      }
      EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
      EXPECT_EQ(found, *expected) << "pixel " << pixel.transpose();
      ++num_lines;
      num_crossings += found.size();
    }
    EXPECT_GT(num_lines, 500);
    EXPECT_GT(num_crossings, 500u);
  }
}

// A pair whose epipolar lines are the columns of the image: the other camera is right above.
class UprightLinesTest : public EpipolarChordsTest {
 protected:
  UprightLinesTest() : primary_(testing::LookAt({5, 0, 0}, {0, 0, 0})), other_(primary_) {
    // Up in the camera.
    other_.cam_from_world.translation += Eigen::Vector3d(0, 1, 0);
  }

  std::vector<LineCrossing> OnColumn(double x) const {
    const FragmentChords chords(curves_);
    std::vector<LineCrossing> crossings;
    EpipolarChords(primary_, other_, chords).Find({x, 100}, &crossings);
    return crossings;
  }

  // The place of a crossing on its fragment, in vertices.
  double Parameter(const LineCrossing& crossing) const {
    return FragmentChords(curves_).PlaceOf(crossing.chord).index + crossing.fraction;
  }

  View primary_;
  View other_;
};

TEST_F(UprightLinesTest, LineThroughASharedVertexCrossesOnce) {
  std::vector<Vector2d> places;
  for (int k = 0; k < 41; ++k) places.push_back({100.0 + k, 200.0});
  AddFragment(places, false);
  for (int k = 1; k < 40; ++k) {
    const auto crossings = OnColumn(100.0 + k);
    ASSERT_EQ(crossings.size(), 1u) << "vertex " << k;
    EXPECT_NEAR(Parameter(crossings[0]), k, 1e-4);
  }
}

TEST_F(UprightLinesTest, PositionParameterAndTangentAreInterpolated) {
  AddFragment({{10, 10}, {11, 10}, {12, 10.5}}, false);
  curves_.edge_map.edgels[1].tangent_rad = 0.2;
  curves_.edge_map.edgels[2].tangent_rad = 0.4 - M_PI;  // the same direction, stored backwards
  const auto crossings = OnColumn(11.5);
  ASSERT_EQ(crossings.size(), 1u);
  EXPECT_EQ(FragmentChords(curves_).PlaceOf(crossings[0].chord).fragment, 0);
  EXPECT_NEAR(Parameter(crossings[0]), 1.5, 1e-4);
  EXPECT_NEAR((crossings[0].position_px - Vector2d(11.5, 10.25)).norm(), 0, 1e-4);
  EXPECT_NEAR(std::atan2(crossings[0].tangent.y(), crossings[0].tangent.x()), 0.3, 1e-4);
}

TEST_F(UprightLinesTest, ClosedFragmentIsClosed) {
  AddFragment({{10, 10}, {20, 15}, {10, 20}}, true);
  const auto crossings = OnColumn(15);
  ASSERT_EQ(crossings.size(), 2u);
  AddFragment({{40, 10}, {42, 15}, {40, 20}, {38, 15}}, true);
  const auto closing = OnColumn(39);
  ASSERT_EQ(closing.size(), 2u);
  EXPECT_NEAR(Parameter(closing[0]), 2.5, 1e-4);
  EXPECT_NEAR(Parameter(closing[1]), 3.5, 1e-4);
}

// The inverse depth at which the column's ray passes through a pixel of the other view, one unit
// above the first: the offset is focal length times inverse depth.
TEST_F(UprightLinesTest, OnlyWhatIsSeenAtAnInverseDepthInARange) {
  std::vector<double> rows = {150, 200, 250, 300};
  for (const double row : rows) AddFragment({{90, row}, {110, row}}, false);
  const FragmentChords chords(curves_);
  const EpipolarChords pair(primary_, other_, chords);
  const auto inverse_depth = [&](double row) { return (row - 100) / primary_.camera.fy; };
  const auto rows_in = [&](const std::vector<InverseDepthRange>& ranges) {
    std::vector<LineCrossing> crossings;
    pair.Find({100, 100}, ranges, &crossings);
    std::vector<double> found;
    for (const LineCrossing& crossing : crossings) found.push_back(crossing.position_px.y());
    return found;
  };
  const auto near = [](double row) { return ::testing::DoubleNear(row, 1e-3); };
  EXPECT_THAT(rows_in({{inverse_depth(190), inverse_depth(260)}}),
              ::testing::ElementsAre(near(200), near(250)));
  EXPECT_THAT(
      rows_in({{inverse_depth(290), inverse_depth(310)}, {inverse_depth(140), inverse_depth(160)}}),
      ::testing::ElementsAre(near(150), near(300)));
  EXPECT_TRUE(rows_in({{inverse_depth(210), inverse_depth(240)}}).empty());
  EXPECT_TRUE(rows_in({}).empty());
}

// More chords on a line than are looked at together.
TEST_F(UprightLinesTest, ManyChordsOnALine) {
  for (int k = 0; k < 300; ++k) AddFragment({{90, 100.0 + k}, {110, 100.0 + k}}, false);
  const auto crossings = OnColumn(100);
  ASSERT_EQ(crossings.size(), 300u);
  for (int k = 0; k < 300; ++k) EXPECT_NEAR(crossings[k].position_px.y(), 100 + k, 1e-3);
}

TEST_F(UprightLinesTest, CrossingsAreAppended) {
  AddFragment({{10, 10}, {20, 10}}, false);
  std::vector<LineCrossing> crossings(2);
  const FragmentChords chords(curves_);
  EpipolarChords(primary_, other_, chords).Find({15, 5}, &crossings);
  EXPECT_EQ(crossings.size(), 3u);
}

TEST_F(UprightLinesTest, NoFragmentsNoCrossings) { EXPECT_TRUE(OnColumn(15).empty()); }

TEST_F(UprightLinesTest, OneCenterHasNoEpipolarLines) {
  AddFragment({{10, 10}, {20, 10}}, false);
  std::vector<LineCrossing> crossings;
  const FragmentChords chords(curves_);
  EpipolarChords(primary_, primary_, chords).Find({15, 5}, &crossings);
  EXPECT_TRUE(crossings.empty());
}

}  // namespace
}  // namespace limn
