// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "limn/util/parallel.h"

namespace limn {

// A small part of a triangle, by its middle. Sums over samples are integrals over area.
struct AreaSample {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double area = 0;  // square world units
  double unit = 0;  // of the place, world units
  int triangle = -1;
};

// About 1 GB.
constexpr int kMaxAreaSamples = 15'000'000;

// Cuts triangles in two across their longest side until that is at most `spacing` times unit_at of
// the middle, which must be positive. Without parts whose middle is outside the region. By
// triangle; areas add up to those of the triangles. Throws InputError for more than `max_samples`.
// Linear in samples and triangles.
std::vector<AreaSample> SampleArea(const std::vector<Eigen::Vector3d>& vertices,
                                   const std::vector<std::array<int, 3>>& triangles, double spacing,
                                   const std::function<double(const Eigen::Vector3d&)>& unit_at,
                                   const std::optional<Eigen::AlignedBox3d>& region,
                                   const RunContext& context, int max_samples = kMaxAreaSamples);

}  // namespace limn
