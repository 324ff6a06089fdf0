#include "limn/support/fragment_index.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

using Eigen::Vector2d;

double Cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

class FragmentIndexTest : public ::testing::Test {
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
    std::uniform_real_distribution<double> x(50, 600), y(50, 430), angle(-M_PI, M_PI);
    std::normal_distribution<double> turn(0, 0.1);
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

TEST_F(FragmentIndexTest, EveryCrossingOfRandomLinesExactlyOnce) {
  AddRandomFragments(60);
  const FragmentIndex index(curves_);
  std::mt19937 random(10);
  std::uniform_real_distribution<double> x(-100, 740), y(-100, 580);
  int num_lines = 0;
  size_t num_crossings = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vector2d from(x(random), y(random));
    Vector2d to(x(random), y(random));
    if (i % 10 == 0) to.x() = from.x();  // upright and level lines run along the grid
    if (i % 10 == 1) to.y() = from.y();
    const auto expected = BruteForce(from, to, 1e-3);
    if (!expected) continue;
    std::vector<LineCrossing> crossings;
    index.Crossings(from, to, &crossings);
    std::vector<std::pair<int, int>> found;
    for (const LineCrossing& crossing : crossings) {
      found.push_back({crossing.fragment, static_cast<int>(crossing.parameter)});
      EXPECT_LT(std::abs(Cross((to - from).normalized(), crossing.position_px - from)), 1e-3);
      EXPECT_NEAR(crossing.tangent.norm(), 1, 1e-9);
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, *expected) << "line " << i << ": " << from.transpose() << " to "
                                << to.transpose();
    ++num_lines;
    num_crossings += found.size();
  }
  EXPECT_GT(num_lines, 1500);
  EXPECT_GT(num_crossings, 5000u);
}

TEST_F(FragmentIndexTest, LineThroughASharedVertexCrossesOnce) {
  std::vector<Vector2d> places;
  for (int k = 0; k < 41; ++k) places.push_back({100.0 + k, 200.0});
  AddFragment(places, false);
  const FragmentIndex index(curves_);
  for (int k = 1; k < 40; ++k) {
    std::vector<LineCrossing> crossings;
    index.Crossings({100.0 + k, 150}, {100.0 + k, 250}, &crossings);
    ASSERT_EQ(crossings.size(), 1u) << "vertex " << k;
    EXPECT_NEAR(crossings[0].parameter, k, 1e-6);
  }
}

TEST_F(FragmentIndexTest, PositionParameterAndTangentAreInterpolated) {
  AddFragment({{10, 10}, {11, 10}, {12, 10.5}}, false);
  curves_.edge_map.edgels[1].tangent_rad = 0.2;
  curves_.edge_map.edgels[2].tangent_rad = 0.4 - M_PI;  // the same direction, stored backwards
  const FragmentIndex index(curves_);
  std::vector<LineCrossing> crossings;
  index.Crossings({11.5, 0}, {11.5, 20}, &crossings);
  ASSERT_EQ(crossings.size(), 1u);
  EXPECT_EQ(crossings[0].fragment, 0);
  EXPECT_NEAR(crossings[0].parameter, 1.5, 1e-5);
  EXPECT_NEAR((crossings[0].position_px - Vector2d(11.5, 10.25)).norm(), 0, 1e-4);
  EXPECT_NEAR(std::atan2(crossings[0].tangent.y(), crossings[0].tangent.x()), 0.3, 1e-4);
}

TEST_F(FragmentIndexTest, ClosedFragmentIsClosed) {
  AddFragment({{10, 10}, {20, 10}, {20, 20}, {10, 20}}, true);
  const FragmentIndex index(curves_);
  std::vector<LineCrossing> crossings;
  index.Crossings({5, 15}, {15, 15}, &crossings);
  ASSERT_EQ(crossings.size(), 1u);
  EXPECT_NEAR(crossings[0].parameter, 3.5, 1e-5);
}

TEST_F(FragmentIndexTest, CrossingsAreAppended) {
  AddFragment({{10, 10}, {20, 10}}, false);
  const FragmentIndex index(curves_);
  std::vector<LineCrossing> crossings(2);
  index.Crossings({15, 5}, {15, 15}, &crossings);
  EXPECT_EQ(crossings.size(), 3u);
}

TEST_F(FragmentIndexTest, NoFragmentsNoCrossings) {
  const FragmentIndex index(curves_);
  std::vector<LineCrossing> crossings;
  index.Crossings({0, 0}, {100, 100}, &crossings);
  EXPECT_TRUE(crossings.empty());
}

}  // namespace
}  // namespace limn
