// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/mean_value.h"

#include <vector>

namespace limn {
namespace {

// A corner and the next one, as a place sees them.
struct SeenSide {
  double distance = 0;  // of the corner
  double cross = 0;     // twice the area of the triangle with the next one
  double dot = 0;
};

// Its part of the weight of a corner; `other` is the distance of its other corner.
double HalfWeight(const SeenSide& side, double corner, double other) {
  return side.cross == 0 ? 0 : (other - side.dot / corner) / side.cross;
}

}  // namespace

double MeanValueAt(std::span<const Eigen::Vector2d> corners, std::span<const double> values,
                   const Eigen::Vector2d& place) {
  const size_t size = corners.size();
  std::vector<SeenSide> sides(size);
  for (size_t i = 0; i < size; ++i) {
    const size_t next = (i + 1) % size;
    const Eigen::Vector2d to_this = corners[i] - place;
    const Eigen::Vector2d to_next = corners[next] - place;
    sides[i] = {to_this.norm(), Cross(to_this, to_next), to_this.dot(to_next)};
    if (sides[i].distance == 0) return values[i];
    if (sides[i].cross == 0 && sides[i].dot < 0) {
      const double whole = sides[i].distance + to_next.norm();
      return (to_next.norm() * values[i] + sides[i].distance * values[next]) / whole;
    }
  }
  double sum = 0;
  double sum_weights = 0;
  for (size_t i = 0; i < size; ++i) {
    const SeenSide& before = sides[(i + size - 1) % size];
    const SeenSide& after = sides[i];
    const double distance = after.distance;
    const double weight = HalfWeight(before, distance, before.distance) +
                          HalfWeight(after, distance, sides[(i + 1) % size].distance);
    sum += weight * values[i];
    sum_weights += weight;
  }
  return sum / sum_weights;
}

}  // namespace limn
