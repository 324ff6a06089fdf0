// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/area_samples.h"

#include <algorithm>
#include <atomic>
#include <string>

#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr size_t kTrianglesPerTask = 256;

using TriangleCorners = std::array<Eigen::Vector3d, 3>;

// What the parts of one triangle have in common.
struct TriangleCutting {
  double spacing = 0;
  const std::function<double(const Eigen::Vector3d&)>& unit_at;
  const std::optional<Eigen::AlignedBox3d>& region;
  int max_samples = 0;
  std::atomic<int>* num_samples = nullptr;
};

bool MayReach(const TriangleCorners& triangle, const std::optional<Eigen::AlignedBox3d>& region) {
  if (!region) return true;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& corner : triangle) box.extend(corner);
  return region->intersects(box);
}

void AddAreaSample(const AreaSample& sample, const TriangleCutting& cutting,
                   std::vector<AreaSample>* samples) {
  if (cutting.region && !cutting.region->contains(sample.position)) return;
  if (cutting.num_samples->fetch_add(1, std::memory_order_relaxed) >= cutting.max_samples) {
    throw InputError("the surface has more than " + std::to_string(cutting.max_samples) +
                     " places to look at: choose a smaller box");
  }
  samples->push_back(sample);
}

void CutTriangle(const TriangleCorners& triangle, int id, const TriangleCutting& cutting,
                 std::vector<AreaSample>* samples) {
  if (!MayReach(triangle, cutting.region)) return;
  const auto& [a, b, c] = triangle;
  const Eigen::Vector3d middle = (a + b + c) / 3;
  const double unit = cutting.unit_at(middle);
  // Opposite to each corner.
  const double sides[] = {(c - b).norm(), (a - c).norm(), (b - a).norm()};
  const auto longest = std::max_element(std::begin(sides), std::end(sides)) - std::begin(sides);
  if (sides[longest] <= cutting.spacing * unit) {
    AddAreaSample({middle, 0.5 * (b - a).cross(c - a).norm(), unit, id}, cutting, samples);
    return;
  }
  const Eigen::Vector3d& apex = triangle[longest];
  const Eigen::Vector3d& from = triangle[(longest + 1) % 3];
  const Eigen::Vector3d& to = triangle[(longest + 2) % 3];
  const Eigen::Vector3d half = 0.5 * (from + to);
  CutTriangle({apex, from, half}, id, cutting, samples);
  CutTriangle({apex, half, to}, id, cutting, samples);
}

}  // namespace

std::vector<AreaSample> SampleArea(const std::vector<Eigen::Vector3d>& vertices,
                                   const std::vector<std::array<int, 3>>& triangles, double spacing,
                                   const std::function<double(const Eigen::Vector3d&)>& unit_at,
                                   const std::optional<Eigen::AlignedBox3d>& region,
                                   const RunContext& context, int max_samples) {
  const size_t num_tasks = (triangles.size() + kTrianglesPerTask - 1) / kTrianglesPerTask;
  std::atomic<int> num_samples = 0;
  const TriangleCutting cutting{spacing, unit_at, region, max_samples, &num_samples};
  std::vector<std::vector<AreaSample>> parts(num_tasks);
  ParallelFor(context, "places on the surface", num_tasks, [&](size_t task) {
    const size_t end = std::min((task + 1) * kTrianglesPerTask, triangles.size());
    for (size_t t = task * kTrianglesPerTask; t < end; ++t) {
      const auto& [a, b, c] = triangles[t];
      CutTriangle({vertices[a], vertices[b], vertices[c]}, static_cast<int>(t), cutting,
                  &parts[task]);
    }
  });
  std::vector<AreaSample> samples;
  for (const std::vector<AreaSample>& part : parts) {
    samples.insert(samples.end(), part.begin(), part.end());
  }
  return samples;
}

}  // namespace limn
