// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/drawing/samples.h"

namespace limn {

// Positions that minimize
//   sum (X - Y)' Lambda (X - Y) + sum |change of direction between neighbors|^2 / bending_sigma^2
// where Y are the positions of the samples of a curve and Lambda their information
// (algorithm/drawing.md#smoothing). A penalty on bending leaves lines and circles nearly unchanged,
// hardly moves well determined samples, and bridges what the data determine badly (the depth).
// Linear time.
std::vector<Eigen::Vector3d> SmoothCurve(const SampleArrays& curve, bool closed,
                                         double bending_sigma_px);

}  // namespace limn
