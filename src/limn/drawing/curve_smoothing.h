#pragma once

#include <vector>

#include <Eigen/Core>

namespace limn {

// A curve to be smoothed; all arrays per sample.
struct SmoothingInput {
  const std::vector<Eigen::Vector3d>& position;
  // Unit tangents.
  const std::vector<Eigen::Vector3d>& tangent;
  // Inverse covariances of the positions across the curve.
  const std::vector<Eigen::Matrix3d>& information;
  // Pixel footprints: the unit of the bending sigma.
  const std::vector<double>& footprint;
  bool closed = false;
};

// Positions that minimize
//   sum (X - Y)' Lambda (X - Y) + sum |change of direction between neighbors|^2 / bending_sigma^2
// where Y are the given positions (ALGORITHM.md 7.2). A penalty on bending leaves lines and circles
// nearly unchanged, hardly moves well determined samples, and bridges what the data determine badly
// (the depth). With fixed_ends the first and last sample stay. Linear time.
std::vector<Eigen::Vector3d> SmoothCurve(const SmoothingInput& input, double bending_sigma_px,
                                         bool fixed_ends);

}  // namespace limn
