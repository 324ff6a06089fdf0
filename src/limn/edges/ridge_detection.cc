// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/ridge_detection.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Eigenvalues>

#include "limn/edges/edgel_selection.h"
#include "limn/edges/gaussian_derivatives.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using Eigen::Vector2d;

constexpr int kMaxRidgeSteps = 4;
constexpr double kMaxRidgeStepPx = 0.6;
constexpr double kRidgeConvergedPx = 0.05;
// Ridges further from the center of their pixel are those of another.
constexpr double kMaxRidgeShiftPx = 0.7;
// Of the curvature across, times sigma^2, relative to the value: plateaus have less.
constexpr double kMinRidgeSharpness = 0.02;
// Of the curvature along, relative to that across: peaks have more.
constexpr double kMaxPeakShare = 0.8;
// Of the slope along, relative to the curvature across times sigma: flanks of peaks and round
// borders of areas have more.
constexpr double kMaxSlopeAlong = 0.4;

// The map at one place, in the frame of its greatest curvature.
struct Ridge {
  Vector2d across;
  double slope;      // across
  double curvature;  // across
  double value;
};

// Nothing where the map is not curved like a ridge.
std::optional<Ridge> RidgeAt(const SubpixelDerivatives& derivatives, const Vector2d& px,
                             double sigma_px) {
  const Jet jet = derivatives.At(px);
  Eigen::Matrix2d hessian;
  hessian << jet.xx, jet.xy, jet.xy, jet.yy;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(hessian);
  const double curvature = solver.eigenvalues()[0];  // ascending
  const double along = solver.eigenvalues()[1];
  if (!(-curvature * sigma_px * sigma_px > kMinRidgeSharpness * jet.value)) return std::nullopt;
  if (std::abs(along) > kMaxPeakShare * -curvature) return std::nullopt;
  const Vector2d across = solver.eigenvectors().col(0);
  const double slope_along = jet.y * across.x() - jet.x * across.y();
  if (std::abs(slope_along) > kMaxSlopeAlong * sigma_px * -curvature) return std::nullopt;
  return Ridge{across, jet.x * across.x() + jet.y * across.y(), curvature, jet.value};
}

// The edgel of the ridge that passes through a pixel, except its strength, and the value of the map
// there.
std::optional<std::pair<Edgel, double>> FindRidge(const SubpixelDerivatives& derivatives, int x,
                                                  int y, double sigma_px) {
  const Vector2d pixel(x, y);
  Vector2d place = pixel;
  for (int step = 0; step < kMaxRidgeSteps; ++step) {
    const auto ridge = RidgeAt(derivatives, place, sigma_px);
    if (!ridge) return std::nullopt;
    const double shift =
        std::clamp(-ridge->slope / ridge->curvature, -kMaxRidgeStepPx, kMaxRidgeStepPx);
    const Vector2d next = place + shift * ridge->across;
    if ((next - pixel).cwiseAbs().maxCoeff() > kMaxRidgeShiftPx) return std::nullopt;
    if (std::abs(shift) < kRidgeConvergedPx) {
      Edgel edgel;
      edgel.position_px = next;
      edgel.stored_px = next.cast<float>();
      // The normal of the ridge, turned to the left, so that tangents are directed to the right.
      const Vector2d tangent(-ridge->across.y(), ridge->across.x());
      edgel.tangent_rad = std::atan(tangent.y() / tangent.x());
      return std::pair(edgel, ridge->value);
    }
    place = derivatives.NearestNode(next);
  }
  return std::nullopt;
}

// The largest probability in the 3 x 3 pixels around an inner one.
float LargestAround(const ProbabilityMap& map, int x, int y) {
  float largest = 0;
  for (int v = y - 1; v <= y + 1; ++v) {
    const float* row = map.values.data() + static_cast<size_t>(v) * map.width;
    largest = std::max({largest, row[x - 1], row[x], row[x + 1]});
  }
  return largest;
}

void CheckMap(const ProbabilityMap& map) {
  if (map.width <= 0 || map.height <= 0 ||
      map.values.size() != static_cast<size_t>(map.width) * map.height) {
    throw InputError("map of edges has no pixels, or not those of its size");
  }
}

}  // namespace

EdgeMap DetectRidges(const ProbabilityMap& map, const RidgeOptions& options) {
  options.Check();
  CheckMap(map);
  const double sigma_px = options.sigma_px;
  const PaddedPlane plane =
      MakePaddedPlane(map.values, map.width, map.height, GaussianPadding(sigma_px, 1));
  const GaussianKernels kernels(sigma_px, 1);
  const SubpixelDerivatives derivatives(plane, kernels, Eigen::Array2d::Ones());
  const double of_thin_line = std::sqrt(2 * M_PI) * sigma_px;
  std::vector<RefinedEdgel> edgels;
  for (int y = 1; y < map.height - 1; ++y) {
    for (int x = 1; x < map.width - 1; ++x) {
      const float largest = LargestAround(map, x, y);
      if (largest < options.min_probability) continue;
      const auto found = FindRidge(derivatives, x, y, sigma_px);
      if (!found) continue;
      RefinedEdgel refined{found->first};
      const double probability = std::min<double>(largest, of_thin_line * found->second);
      if (probability < options.min_probability) continue;
      refined.edgel.strength = static_cast<float>(probability);
      edgels.push_back(refined);
    }
  }
  EdgelRaster raster(map.width, map.height);
  raster.AddStrongestFirst(edgels);
  EdgeMap result;
  result.width = map.width;
  result.height = map.height;
  result.edgels = raster.Edgels();
  return result;
}

}  // namespace limn
