// SPDX-License-Identifier: BSD-3-Clause
#include "limn/drawing/curve_smoothing.h"

#include <algorithm>
#include <cmath>

#include "limn/geometry/banded_cholesky.h"

namespace limn {
namespace {

// Standard deviation of a sample's place along the curve, px, and of its place at all.
constexpr double kAlongSigmaPx = 0.5;
constexpr double kWeakSigmaPx = 300;
// Smallest spacing assumed between neighbors, px: the change of direction diverges as it goes to 0.
constexpr double kMinSpacingPx = 0.2;
// Samples of a closed curve that are repeated beyond its ends.
constexpr int kClosedOverlap = 20;

// In the two below, unknown k is the displacement of sample s.

void AddData(const SampleArrays& curve, int s, int k, BandedSystem* system) {
  const double footprint = curve.footprint[s];
  const Eigen::Vector3d& tangent = curve.tangent[s];
  const Eigen::Matrix3d weight =
      curve.information[s] +
      tangent * tangent.transpose() / std::pow(kAlongSigmaPx * footprint, 2) +
      Eigen::Matrix3d::Identity() / std::pow(kWeakSigmaPx * footprint, 2);
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b <= a; ++b) system->Add(3 * k + a, 3 * k + b, weight(a, b));
  }
}

void AddBending(const SampleArrays& curve, int before, int s, int after, int k,
                double bending_sigma_px, BandedSystem* system) {
  const double footprint = curve.footprint[s];
  const Eigen::Vector3d first = curve.position[s] - curve.position[before];
  const Eigen::Vector3d second = curve.position[after] - curve.position[s];
  const double h0 = std::max(first.norm() / footprint, kMinSpacingPx);
  const double h1 = std::max(second.norm() / footprint, kMinSpacingPx);
  const double coefficient[3] = {1 / h0, -1 / h0 - 1 / h1, 1 / h1};
  const Eigen::Vector3d bend = second / h1 - first / h0;
  const double weight = 1 / std::pow(bending_sigma_px * footprint, 2);
  for (int a = 0; a < 3; ++a) {
    for (int axis = 0; axis < 3; ++axis) {
      const int row = 3 * (k - 1 + a) + axis;
      for (int b = 0; b <= a; ++b) {
        system->Add(row, 3 * (k - 1 + b) + axis, weight * coefficient[a] * coefficient[b]);
      }
      system->Right(row) -= weight * coefficient[a] * bend[axis];
    }
  }
}

}  // namespace

std::vector<Eigen::Vector3d> SmoothCurve(const SampleArrays& curve, bool closed,
                                         double bending_sigma_px) {
  const int size = curve.NumSamples();
  if (size < 3) return curve.position;
  const int overlap = closed ? std::min(kClosedOverlap, size) : 0;
  const int count = size + 2 * overlap;
  const auto sample = [&](int k) { return (k - overlap + size) % size; };
  BandedSystem system(3 * count, 8);
  for (int k = 0; k < count; ++k) AddData(curve, sample(k), k, &system);
  for (int k = 1; k + 1 < count; ++k) {
    AddBending(curve, sample(k - 1), sample(k), sample(k + 1), k, bending_sigma_px, &system);
  }
  std::vector<Eigen::Vector3d> smooth = curve.position;
  // Only numerical overflow makes the system indefinite; the samples then stay.
  if (!system.Solve()) return smooth;
  for (int s = 0; s < size; ++s) {
    for (int axis = 0; axis < 3; ++axis) smooth[s][axis] += system.Right(3 * (s + overlap) + axis);
  }
  return smooth;
}

}  // namespace limn
