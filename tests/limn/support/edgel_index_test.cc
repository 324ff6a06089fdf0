// SPDX-License-Identifier: BSD-3-Clause
#include "limn/support/edgel_index.h"

#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "support/random_numbers.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

// How an edgel lies to a query, in shares of the gate.
struct Offset {
  double normal = 0;
  double along = 0;
  double angle = 0;
  bool Inside() const { return normal <= 1 && along <= 1 && angle <= 1; }
};

Offset OffsetOf(const Edgel& edgel, const Eigen::Vector2d& position, double direction,
                const SupportGate& gate) {
  const Eigen::Vector2d offset = position - edgel.position_px;
  const double cosine = std::cos(direction - edgel.tangent_rad);
  return {std::abs(edgel.Normal().dot(offset)) / gate.normal_px,
          std::abs(edgel.Tangent().dot(offset)) / gate.along_px,
          std::acos(std::min(1.0, std::abs(cosine))) / gate.angle_rad};
}

Eigen::Vector2d Direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

class EdgelIndexTest : public ::testing::Test {
 protected:
  EdgelIndexTest() {
    std::mt19937 random(5);
    testing::UniformDistribution<double> x(20, 120), y(30, 90), angle(-M_PI, M_PI);
    std::vector<Edgel> edgels;
    for (int i = 0; i < 4000; ++i) {
      edgels.push_back(testing::MakeEdgel({x(random), y(random)}, angle(random)));
      usable_.push_back(i % 5 != 0);
    }
    for (int i = 0; i < 1500; ++i) {
      queries_.push_back({x(random) * 1.2 - 10, y(random) * 1.2 - 10});
      directions_.push_back(angle(random));
    }
    edge_map_ = testing::MakeEdgeMap(view_, edgels);
  }

  const View view_ = testing::LookAt({5, 0, 0}, {0, 0, 0});
  EdgeMap edge_map_;
  std::vector<bool> usable_;
  std::vector<Eigen::Vector2d> queries_;
  std::vector<double> directions_;
};

TEST_F(EdgelIndexTest, FindsAnEdgelWhereverOneIsInTheGate) {
  const EdgelIndex index(edge_map_, usable_);
  const SupportGate gate;
  int num_found = 0;
  for (size_t q = 0; q < queries_.size(); ++q) {
    std::set<EdgelId> inside;
    for (size_t id = 0; id < edge_map_.edgels.size(); ++id) {
      if (usable_[id] &&
          OffsetOf(edge_map_.edgels[id], queries_[q], directions_[q], gate).Inside()) {
        inside.insert(static_cast<EdgelId>(id));
      }
    }
    const auto best = index.Best(queries_[q], Direction(directions_[q]), gate);
    ASSERT_EQ(best.has_value(), !inside.empty()) << "query " << q;
    if (!best) continue;
    ++num_found;
    EXPECT_TRUE(inside.count(best->edgel)) << "query " << q;
    const Edgel& edgel = edge_map_.edgels[best->edgel];
    // Places and directions are kept in single precision.
    EXPECT_NEAR(best->normal_residual_px, edgel.Normal().dot(queries_[q] - edgel.position_px),
                1e-5);
    // None is better in every respect.
    const Offset of_best = OffsetOf(edgel, queries_[q], directions_[q], gate);
    for (const EdgelId id : inside) {
      if (id == best->edgel) continue;
      const Offset other = OffsetOf(edge_map_.edgels[id], queries_[q], directions_[q], gate);
      EXPECT_FALSE(other.normal < of_best.normal && other.along < of_best.along &&
                   other.angle < of_best.angle)
          << "query " << q << " edgel " << id;
    }
  }
  EXPECT_GT(num_found, 100);
  EXPECT_LT(num_found, static_cast<int>(queries_.size()));
}

// More edgels in one cell than are looked at together.
TEST_F(EdgelIndexTest, TheBestOfManyInOneCell) {
  std::vector<Edgel> edgels;
  for (int i = 0; i < 150; ++i) edgels.push_back(testing::MakeEdgel({50, 50 + 0.01 * i}, 0));
  const EdgeMap many = testing::MakeEdgeMap(view_, edgels);
  const EdgelIndex index(many, std::vector<bool>(edgels.size(), true));
  for (const int i : {0, 63, 64, 70, 128, 149}) {
    const auto best = index.Best({50, 50 + 0.01 * i + 0.001}, Direction(0), {});
    ASSERT_TRUE(best);
    EXPECT_EQ(best->edgel, i);
  }
}

TEST_F(EdgelIndexTest, ForEachWithinVisitsTheDiscOnce) {
  const EdgelIndex index(edge_map_, usable_);
  for (const double radius : {0.5, 3.0, 11.0}) {
    for (size_t q = 0; q < queries_.size(); q += 10) {
      std::vector<EdgelId> expected;
      for (size_t id = 0; id < edge_map_.edgels.size(); ++id) {
        if (usable_[id] && (edge_map_.edgels[id].position_px - queries_[q]).norm() <= radius) {
          expected.push_back(static_cast<EdgelId>(id));
        }
      }
      std::vector<EdgelId> visited;
      index.ForEachWithin(queries_[q], radius, [&](EdgelId id) { visited.push_back(id); });
      std::sort(visited.begin(), visited.end());
      EXPECT_EQ(visited, expected) << "query " << q << " radius " << radius;
      EXPECT_EQ(index.AnyWithin(queries_[q], radius), !expected.empty());
    }
  }
}

TEST_F(EdgelIndexTest, SmallestIdOnTies) {
  const std::vector<Edgel> twins(3, testing::MakeEdgel({50, 50}, 0.3));
  const EdgeMap edge_map = testing::MakeEdgeMap(view_, twins);
  const EdgelIndex index(edge_map, {false, true, true});
  const auto best = index.Best({50.2, 50.1}, Direction(0.3), SupportGate());
  ASSERT_TRUE(best.has_value());
  EXPECT_EQ(best->edgel, 1);
}

TEST_F(EdgelIndexTest, DirectionIsUndirected) {
  const EdgeMap edge_map = testing::MakeEdgeMap(view_, {testing::MakeEdgel({50, 50}, 3.1)});
  const EdgelIndex index(edge_map, {true});
  EXPECT_TRUE(index.Best({50, 50}, Direction(3.1 - M_PI), SupportGate()).has_value());
  EXPECT_TRUE(index.Best({50, 50}, Direction(-3.1), SupportGate()).has_value());
  EXPECT_FALSE(index.Best({50, 50}, Direction(3.1 - M_PI / 2), SupportGate()).has_value());
}

TEST_F(EdgelIndexTest, GateIsInStoredPixels) {
  Edgel edgel = testing::MakeEdgel({50, 50}, 0);
  edgel.stored_from_virtual = 0.5f * Eigen::Matrix2f::Identity();
  const SupportGate gate;  // 1.5 stored = 3 virtual pixels across
  // Wherever the cells of the index begin: at the first edgel.
  for (const double first : {40.0, 41.1, 42.1, 43.1}) {
    const EdgeMap edge_map =
        testing::MakeEdgeMap(view_, {edgel, testing::MakeEdgel({first, first}, 0)});
    const EdgelIndex index(edge_map, {true, true});
    for (const double side : {-1.0, 1.0}) {
      const auto best = index.Best({50, 50 + side * 2.8}, {1, 0}, gate);
      ASSERT_TRUE(best.has_value()) << first << " " << side;
      EXPECT_NEAR(std::abs(best->normal_residual_px), 1.4, 1e-6);
      EXPECT_FALSE(index.Best({50, 50 + side * 3.2}, {1, 0}, gate).has_value());
    }
  }
}

TEST_F(EdgelIndexTest, EmptyIndexFindsNothing) {
  const EdgelIndex index(edge_map_, std::vector<bool>(edge_map_.edgels.size(), false));
  EXPECT_FALSE(index.Best({50, 50}, {1, 0}, SupportGate()).has_value());
  index.ForEachWithin({50, 50}, 100, [](EdgelId id) { ADD_FAILURE() << id; });
}

}  // namespace
}  // namespace limn
