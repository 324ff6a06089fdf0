// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/assignment.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace limn {
namespace {

using AssignedPoints = std::vector<Eigen::Vector3d>;

auto OrderKey(const Eigen::Vector3d& point) { return std::tuple(point.x(), point.y(), point.z()); }

// Indices in the order of coordinates.
std::vector<int> OrderOf(const AssignedPoints& points) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int i) { return OrderKey(points[i]); });
  return order;
}

AssignedPoints InOrder(const AssignedPoints& points, const std::vector<int>& order) {
  AssignedPoints ordered;
  for (const int i : order) ordered.push_back(points[i]);
  return ordered;
}

// Takes in one row after another, each on the cheapest path of exchanges that ends in a free
// column. Prices keep what is assigned at cost - row price - column price = 0, and all else at 0 or
// more.
class RowAssigner {
 public:
  // No more rows than columns.
  RowAssigner(const AssignedPoints& rows, const AssignedPoints& columns)
      : rows_(rows),
        columns_(columns),
        row_of_(columns.size(), -1),
        row_price_(rows.size(), 0),
        column_price_(columns.size(), 0),
        reach_(columns.size()),
        came_from_(columns.size()),
        is_done_(columns.size()) {}

  void TakeIn(int new_row) {
    std::ranges::fill(reach_, std::numeric_limits<double>::infinity());
    std::ranges::fill(came_from_, -1);
    std::ranges::fill(is_done_, 0);
    int row = new_row, last = -1;
    double reached = 0;
    std::vector<int> done;
    for (;;) {
      const int column = ReachFrom(row, last, reached);
      reached = reach_[column];
      last = column;
      if (row_of_[column] < 0) break;
      is_done_[column] = 1;
      done.push_back(column);
      row = row_of_[column];
    }
    row_price_[new_row] += reached;
    for (const int column : done) {
      row_price_[row_of_[column]] += reached - reach_[column];
      column_price_[column] -= reached - reach_[column];
    }
    Exchange(new_row, last);
  }

  const std::vector<int>& row_of() const { return row_of_; }

 private:
  // Goes on from a row to all columns; returns the nearest that is not done, a free one on ties.
  int ReachFrom(int row, int by, double reached) {
    int nearest = -1;
    for (size_t c = 0; c < columns_.size(); ++c) {
      if (is_done_[c]) continue;
      const double cost = (rows_[row] - columns_[c]).norm();
      const double reach = reached + (cost - row_price_[row] - column_price_[c]);
      if (reach < reach_[c]) {
        reach_[c] = reach;
        came_from_[c] = by;
      }
      const bool is_nearest =
          nearest < 0 || reach_[c] < reach_[nearest] ||
          (reach_[c] == reach_[nearest] && row_of_[c] < 0 && row_of_[nearest] >= 0);
      if (is_nearest) nearest = static_cast<int>(c);
    }
    return nearest;
  }

  void Exchange(int new_row, int column) {
    while (came_from_[column] >= 0) {
      row_of_[column] = row_of_[came_from_[column]];
      column = came_from_[column];
    }
    row_of_[column] = new_row;
  }

  const AssignedPoints& rows_;
  const AssignedPoints& columns_;
  std::vector<int> row_of_;  // per column
  std::vector<double> row_price_, column_price_;
  std::vector<double> reach_;
  std::vector<int> came_from_;  // the column before; -1: from the new row
  std::vector<char> is_done_;
};

}  // namespace

std::vector<int> AssignPoints(const std::vector<Eigen::Vector3d>& points,
                              const std::vector<Eigen::Vector3d>& targets,
                              const RunContext& context) {
  const std::vector<int> point_order = OrderOf(points), target_order = OrderOf(targets);
  const AssignedPoints ordered_points = InOrder(points, point_order);
  const AssignedPoints ordered_targets = InOrder(targets, target_order);
  const auto is_before = [](const AssignedPoints& a, const AssignedPoints& b) {
    return std::ranges::lexicographical_compare(a, b, {}, OrderKey, OrderKey);
  };
  const bool points_are_rows = points.size() != targets.size()
                                   ? points.size() < targets.size()
                                   : is_before(ordered_points, ordered_targets);
  const AssignedPoints& rows = points_are_rows ? ordered_points : ordered_targets;
  RowAssigner assigner(rows, points_are_rows ? ordered_targets : ordered_points);
  for (size_t row = 0; row < rows.size(); ++row) {
    ThrowIfCancelled(context);
    assigner.TakeIn(static_cast<int>(row));
  }
  std::vector<int> target_of(points.size(), -1);
  for (size_t column = 0; column < assigner.row_of().size(); ++column) {
    const int row = assigner.row_of()[column];
    if (row < 0) continue;
    const size_t point = points_are_rows ? row : column, target = points_are_rows ? column : row;
    target_of[point_order[point]] = target_order[target];
  }
  return target_of;
}

}  // namespace limn
