// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/edge_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Core>

#include "limn/edges/local_jet.h"

namespace limn {
namespace {

using Eigen::Vector2d;

constexpr int kMaxIterations = 4;
constexpr double kMaxStepPx = 0.6;
// The error left after a step this small is far below 0.01 px.
constexpr double kConvergedPx = 0.05;
constexpr double kMaxOffsetPx = 0.7;
// Of the image: sampling by pixels displaces edges.
constexpr double kMinPositionSigmaPx = 0.05;
// What else displaces edgels from curves, of which ResidualVariance counts one pixel of the view.
constexpr double kCurveSigmaPx = 0.2;
// Curvature above this is a corner, where the correction for a smooth curve means nothing.
constexpr double kMaxCurvature = 0.2;

// Step to the maximum of the profile I_n along the normal: Newton on log I_n, exact for a blurred
// step whatever its width. Nothing where the profile is not concave.
std::optional<double> StepToMaximum(const LocalJet& jet) {
  const double slope = jet.nn / jet.n;
  const double bend = jet.nnn / jet.n - slope * slope;
  if (!(bend < 0)) return std::nullopt;
  return std::clamp(-slope / bend, -kMaxStepPx, kMaxStepPx);
}

// Angle from the gradient direction to the normal of the curve I_nn = 0, small. The curve's own
// direction (third order) and the gradient (first order) err differently: in white noise their
// variances are 0.75 r^2 and 1 and their covariance 0.5 r in units of (noise / I_n)^2, where
// r = I_n / (s^2 |I_nnn|) is 1 for a sharp step and grows with its blur. The weight minimizes the
// variance; at r >= 2 the gradient alone is best.
double NormalCorrection(const LocalJet& jet, double sigma_px) {
  const double f_n = jet.n * jet.nnn + 2 * (jet.nn * jet.nn + jet.nt * jet.nt);
  const double f_t = jet.n * jet.nnt + 2 * jet.nt * (jet.nn + jet.tt);
  if (!(f_n < 0)) return 0;
  const double r = jet.n * jet.n / (sigma_px * sigma_px * -f_n);
  if (r >= 2) return 0;
  const double gradient_weight =
      std::clamp((0.75 * r - 0.5) * r / (1 + (0.75 * r - 1) * r), 0.0, 1.0);
  return (1 - gradient_weight) * std::atan(f_t / f_n);
}

// Smoothing moves a curved edge towards its center of curvature by about (s^2 + p^2 / 12) / 2R,
// with pixels of the image of size p. Returns the shift along the normal that undoes it, with the
// curvature shrunk by its noise so that straight noisy edges stay in place.
double CurvatureShift(const LocalJet& jet, double sigma_px, double scale, double noise) {
  const double curvature = std::clamp(jet.tt / jet.n, -kMaxCurvature, kMaxCurvature);
  const double sigma_curvature = noise * std::sqrt(1.5) / (sigma_px * jet.n);
  const double ratio = sigma_curvature / std::max(std::abs(curvature), 1e-9);
  const double shrink = std::max(0.0, 1 - ratio * ratio);
  return 0.5 * shrink * curvature * (sigma_px * sigma_px + scale * scale / 12);
}

// The pixels of an edge do not tell more if a finer view has more edgels. Nor do they if curves, in
// the end, are off by fractions of them (ResidualVariance), not of the view's.
double SigmaInView(double sigma_px, double scale) {
  return std::sqrt(scale * sigma_px * sigma_px +
                   kCurveSigmaPx * kCurveSigmaPx * (scale * scale - 1));
}

LocalJet JetAt(std::span<const SubpixelDerivatives> derivatives, const Vector2d& node) {
  std::array<Jet, kMaxChannels> jets;
  for (size_t k = 0; k < derivatives.size(); ++k) jets[k] = derivatives[k].At(node);
  return derivatives.size() == 1 ? AlongGradient(jets[0]) : AlongJointGradient(jets);
}

}  // namespace

double RefinementContext::NoiseOf(double level, const ChannelShares& shares) const {
  double variance = 0;
  for (size_t k = 0; k < std::min(noise.size(), shares.size()); ++k) {
    const double of_channel = noise[k].At(level);
    variance += shares[k] * of_channel * of_channel;
  }
  return std::sqrt(variance);
}

std::optional<RefinedEdgel> RefineEdgel(std::span<const SubpixelDerivatives> derivatives, int x,
                                        int y, const RefinementContext& context) {
  const Vector2d pixel(x, y);
  Vector2d position = pixel;
  LocalJet jet;
  for (int iteration = 0;; ++iteration) {
    const Vector2d node = derivatives[0].NearestNode(position);
    jet = JetAt(derivatives, node);
    if (jet.n == 0) return std::nullopt;
    const auto step = StepToMaximum(jet);
    if (!step) return std::nullopt;
    position = node + *step * jet.normal;
    if ((position - pixel).lpNorm<Eigen::Infinity>() > kMaxOffsetPx) return std::nullopt;
    if (std::abs(*step) < kConvergedPx) break;
    if (iteration + 1 == kMaxIterations) return std::nullopt;
  }
  const double noise = context.NoiseOf(jet.value, jet.shares);
  const double threshold = context.ThresholdFor(noise);
  if (jet.n < threshold) return std::nullopt;

  const double normal_rad =
      std::atan2(jet.normal.y(), jet.normal.x()) + NormalCorrection(jet, context.sigma_px);
  position += CurvatureShift(jet, context.sigma_px, context.scale, noise) * jet.normal;

  Edgel edgel;
  edgel.position_px = position;
  edgel.stored_px = position.cast<float>();
  // Edgel::Normal() is the tangent turned by -90 degrees.
  edgel.tangent_rad = std::remainder(normal_rad + M_PI_2, 2 * M_PI);
  edgel.strength = static_cast<float>(jet.n);
  const double noise_nn = noise * std::sqrt(1.5) / context.sigma_px;
  const double sigma_px =
      std::max(kMinPositionSigmaPx * context.scale, noise_nn / std::abs(jet.nnn));
  edgel.position_sigma_px = static_cast<float>(SigmaInView(sigma_px, context.scale));
  const double variance = jet.n / -jet.nnn - context.sigma_px * context.sigma_px;
  return RefinedEdgel{edgel, threshold > 0 ? jet.n / threshold : 1,
                      std::sqrt(std::max(0.0, variance))};
}

}  // namespace limn
