// SPDX-License-Identifier: BSD-3-Clause
#include "limn/rods/fit_rod.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "limn/rods/rod_sights.h"

namespace limn {
namespace {

// The residual from which on an edgel counts linearly.
constexpr double kOutlineRobustPx = 0.5;
// Standard deviations of a step, px: of an axis point across and along the axis, of the radius; and
// of the second difference of the axis points. They decide what edgels leave open.
constexpr double kStepAcrossPx = 3;
constexpr double kStepAlongPx = 0.05;
constexpr double kStepRadiusPx = 3;
constexpr double kBendPx = 1;

using Row = Eigen::Matrix<double, 7, 1>;  // both axis points of a segment, the radius

// The normal equations of one step. Unknowns: the axis points from `first` on, then the radius.
class RodEquations {
 public:
  RodEquations(const Rod& rod, size_t first)
      : rod_(rod),
        first_(static_cast<int>(first)),
        num_points_(static_cast<int>(rod.axis.size() - first)),
        right_(Eigen::VectorXd::Zero(3 * num_points_ + 1)) {
    AddPriors();
  }

  void Add(const TopologyInput& input, const RodPlace& place) {
    for (const RodSight& sight : place.sights) {
      for (const int side : {0, 1}) {
        const Eigen::Vector3d to_outline = sight.ToOutline(side);
        const EdgelRef& ref = sight.edgels[side];
        const auto residual = input.Residual(ref, place.position + sight.seen_radius * to_outline);
        if (!residual) continue;
        const double size = std::abs(residual->residual_px);
        const double robust = size > kOutlineRobustPx ? kOutlineRobustPx / size : 1;
        Row row;
        row << (1 - place.t) * residual->gradient, place.t * residual->gradient,
            sight.seen_per_radius * residual->gradient.dot(to_outline);
        AddRow(place.segment, robust / ResidualVariance(input.EdgelOf(ref)), row,
               residual->residual_px);
      }
    }
  }

  // The change of the unknowns; empty if the equations have no solution.
  Eigen::VectorXd Solve() const {
    Eigen::SparseMatrix<double> normal(right_.size(), right_.size());
    normal.setFromTriplets(triplets_.begin(), triplets_.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(normal);
    if (factors.info() != Eigen::Success) return {};
    return factors.solve(right_);
  }

 private:
  void AddPriors() {
    const double per_px = 1 / (rod_.footprint * rod_.footprint);
    const double across = per_px / (kStepAcrossPx * kStepAcrossPx);
    const double along = per_px / (kStepAlongPx * kStepAlongPx);
    const int last = static_cast<int>(rod_.axis.size()) - 1;
    for (int i = first_; i <= last; ++i) {
      const Eigen::Vector3d tangent =
          (rod_.axis[std::min(i + 1, last)] - rod_.axis[std::max(i - 1, 0)]).normalized();
      AddBlock(
          i, i,
          across * Eigen::Matrix3d::Identity() + (along - across) * tangent * tangent.transpose());
    }
    const int radius = 3 * num_points_;
    triplets_.emplace_back(radius, radius, per_px / (kStepRadiusPx * kStepRadiusPx));
    for (int i = std::max(1, first_ - 1); i < last; ++i) AddBend(i, per_px / (kBendPx * kBendPx));
  }

  void AddBend(int i, double weight) {
    const double factors[] = {1, -2, 1};
    const Eigen::Vector3d bend = rod_.axis[i - 1] - 2 * rod_.axis[i] + rod_.axis[i + 1];
    for (int a = 0; a < 3; ++a) {
      const int point = i - 1 + a;
      if (point < first_) continue;
      right_.segment<3>(3 * (point - first_)) -= weight * factors[a] * bend;
      for (int b = 0; b < 3; ++b) {
        AddBlock(point, i - 1 + b, weight * factors[a] * factors[b] * Eigen::Matrix3d::Identity());
      }
    }
  }

  void AddBlock(int row_point, int col_point, const Eigen::Matrix3d& block) {
    if (row_point < first_ || col_point < first_) return;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        triplets_.emplace_back(3 * (row_point - first_) + r, 3 * (col_point - first_) + c,
                               block(r, c));
      }
    }
  }

  void AddRow(int segment, double weight, const Row& row, double residual_px) {
    const auto unknown = [&](int k) {
      if (k == 6) return 3 * num_points_;
      return 3 * (segment - first_) + k;  // negative: held
    };
    for (int a = 0; a < 7; ++a) {
      if (unknown(a) < 0) continue;
      right_[unknown(a)] -= weight * residual_px * row[a];
      for (int b = 0; b < 7; ++b) {
        if (unknown(b) >= 0)
          triplets_.emplace_back(unknown(a), unknown(b), weight * row[a] * row[b]);
      }
    }
  }

  const Rod& rod_;
  int first_;
  int num_points_;
  std::vector<Eigen::Triplet<double>> triplets_;
  Eigen::VectorXd right_;
};

}  // namespace

void FitRod(const TopologyInput& input, std::span<const ViewId> views,
            std::span<const SupportGate> gates, size_t first, Rod* rod) {
  for (const SupportGate& gate : gates) {
    RodEquations equations(*rod, first);
    // The segment before the first free point moves, too.
    const size_t from = first > 0 ? first - 1 : 0;
    for (const RodPlace& place : LookAlongRod(input, *rod, from, views, gate)) {
      if (place.IsShown()) equations.Add(input, place);
    }
    const Eigen::VectorXd change = equations.Solve();
    if (change.size() == 0 || !change.allFinite()) return;
    for (size_t i = first; i < rod->axis.size(); ++i) {
      rod->axis[i] += change.segment<3>(3 * static_cast<Eigen::Index>(i - first));
    }
    if (first == 0) rod->radius = std::abs(rod->radius + change[change.size() - 1]);
  }
}

}  // namespace limn
