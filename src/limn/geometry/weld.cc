// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/weld.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace limn {

std::vector<int> WeldPoints(const std::vector<Eigen::Vector3d>& points) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int i) { return std::tuple(points[i].x(), points[i].y(), points[i].z()); };
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return key(i) != key(j) ? key(i) < key(j) : i < j; });
  std::vector<int> representative(points.size());
  for (size_t k = 0; k < order.size(); ++k) {
    const bool same = k > 0 && key(order[k]) == key(order[k - 1]);
    representative[order[k]] = same ? representative[order[k - 1]] : order[k];
  }
  return representative;
}

}  // namespace limn
