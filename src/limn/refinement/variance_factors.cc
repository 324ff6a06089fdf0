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
double ReducedChiSquare(std::span<const LinkSample> samples,
                        const std::vector<ImageCurves>& curves) {
  std::map<ViewId, ViewSums> sums;
  for (const LinkSample& sample : samples) {
    for (const EdgelPull& pull : sample.pulls) {
      const double weight = WeightOf(pull, curves);
      ViewSums& of_view = sums[pull.ref.view];
      of_view.weight += weight;
      // Signed by the sides of the link, not by those of the edgel.
      of_view.residual += weight * (pull.bright_left ? 1 : -1) * pull.residual_px;
    }
  }
  double chi_square = 0;
  for (const auto& [view, of_view] : sums) {
    chi_square += of_view.residual * of_view.residual / of_view.weight;
  }
  const double freedoms = std::max(0.0, static_cast<double>(sums.size()) - kFreedoms);
  return std::max(1.0, (kPriorViews + chi_square) / (kPriorViews + freedoms));
}

// The samples on the segments [begin, end).
std::span<const LinkSample> SamplesOn(const LinkMatches& matches, int begin, int end) {
  return {std::ranges::lower_bound(matches, begin, {}, &LinkSample::segment),
          std::ranges::lower_bound(matches, end, {}, &LinkSample::segment)};
}

// Per control point the squared bend there, over its variance; 0 where nothing bends.
std::vector<double> SquaredBends(const ControlGraph& control, const RefinementOptions& options) {
  std::vector<double> squares(control.position.size(), 0);
  for (const auto& bend : control.bends) {
    double& square = squares[bend[1]];
    square = std::max(square, SquaredBend(bend, options, control));
  }
  return squares;
}

}  // namespace

std::vector<double> VarianceFactors(const FitInput& input, const RefinementOptions& options,
                                    const ControlGraph& control) {
  const int half_window =
      std::max(1, static_cast<int>(std::lround(kHalfWindowPx / options.control_spacing_px)));
  const std::vector<double> bends = SquaredBends(control, options);
  std::vector<double> factors(control.position.size(), 1);
  for (size_t l = 0; l < control.links.size(); ++l) {
    if (input.frozen[l]) continue;
    const ControlLink& link = control.links[l];
    for (int k = 0; k <= link.NumSegments(); ++k) {
      const auto samples = SamplesOn(input.matches[l], k - half_window, k + half_window);
      double bend = 0;
      const int end = std::min(k + half_window, link.NumSegments());
      for (int i = std::max(k - half_window, 0); i <= end; ++i) {
        bend = std::max(bend, bends[link.points[i]]);
      }
      double& factor = factors[link.points[k]];
      factor = std::max(factor, ReducedChiSquare(samples, input.curves) * (1 + bend));
    }
  }
  return factors;
}

}  // namespace limn
