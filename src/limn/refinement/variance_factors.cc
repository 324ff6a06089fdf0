// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/variance_factors.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace limn {
namespace {

constexpr double kHalfWindowPx = 6;
// Prior that the weights are right, in views.
constexpr double kPriorViews = 4;
// A curve has two directions across it.
constexpr double kFreedoms = 2;

// Sums over the edgels of one view: weighted residuals and weights.
struct ViewSums {
  double weight = 0;    // 1 / px^2
  double residual = 0;  // 1 / px
};

// Reduced chi-square of the views' mean residuals, at least 1.
double ReducedChiSquare(std::span<const FitSample> samples) {
  std::map<ViewId, ViewSums> sums;
  for (const FitSample& sample : samples) {
    for (const EdgelPull& pull : sample.pulls) {
      ViewSums& of_view = sums[pull.ref.view];
      of_view.weight += pull.weight;
      // Signed by the sides of the link, not by those of the edgel.
      of_view.residual += pull.weight * (pull.bright_left ? 1 : -1) * pull.residual_px;
    }
  }
  double chi_square = 0;
  for (const auto& [view, of_view] : sums) {
    chi_square += of_view.residual * of_view.residual / of_view.weight;
  }
  const double freedoms = std::max(0.0, static_cast<double>(sums.size()) - kFreedoms);
  return std::max(1.0, (kPriorViews + chi_square) / (kPriorViews + freedoms));
}

// Per control point the squared bend there, over its variance; 0 where nothing bends.
std::vector<double> SquaredBends(const ControlGraph& control, const RefinementOptions& options) {
  std::vector<double> squares(control.position.size(), 0);
  for (const Bend& bend : control.bends) {
    double& square = squares[bend[1]];
    square = std::max(square, SquaredBend(bend, options, control));
  }
  return squares;
}

}  // namespace

std::vector<double> VarianceFactors(const RefinementOptions& options, const ControlGraph& control) {
  const int half_window =
      std::max(1, static_cast<int>(std::lround(kHalfWindowPx / options.control_spacing_px)));
  const std::vector<double> bends = SquaredBends(control, options);
  std::vector<double> factors(control.position.size(), 1);
  for (const ControlLink& link : control.links) {
    if (link.frozen) continue;
    for (int k = 0; k <= link.NumSegments(); ++k) {
      const int begin = std::max(k - half_window, 0);
      const int end = std::min(k + half_window, link.NumSegments());
      double bend = 0;
      for (int i = begin; i <= end; ++i) bend = std::max(bend, bends[link.points[i]]);
      const std::span<const FitSample> samples = {
          std::ranges::lower_bound(link.samples, begin, {}, &FitSample::segment),
          std::ranges::lower_bound(link.samples, end, {}, &FitSample::segment)};
      double& factor = factors[link.points[k]];
      factor = std::max(factor, ReducedChiSquare(samples) * (1 + bend));
    }
  }
  return factors;
}

}  // namespace limn
