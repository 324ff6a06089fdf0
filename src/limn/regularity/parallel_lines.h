// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/regularity/regularity_options.h"
#include "limn/regularity/shape_evidence.h"

namespace limn {

// A direction that several lines share.
struct DirectionClass {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  // unit vector, either way
  // Of small rotations of the direction, rad^2.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  std::vector<int> lines;  // indices of evidence, ascending
  double longest_px = 0;
  std::vector<int> orthogonal_to;  // other classes, ascending
};

// The cost of giving a line a direction, at the length that fits it best.
struct DirectionCost {
  double chi_square = 0;  // units of noise
  double shift_px = 0;    // of its ends
};
DirectionCost CostOfDirection(const LineEvidence& line, const Eigen::Vector3d& direction);

// The directions that lines share (ours). A line is in a class if that describes it with less
// information than a direction of its own, to its accuracy, and moves its ends by no more than
// max_shift_px; a class stays if it saves more than its own direction costs. The class that saves
// most comes first. A line is in one class at most. Time: the square of the number of lines, of
// which the 1000 longest make hypotheses.
std::vector<DirectionClass> FindParallelLines(const std::vector<LineEvidence>& lines,
                                              const RegularityOptions& options);

// Finds the classes that are perpendicular to each other: a right angle must move no line by more
// than max_shift_px and be likelier than any other angle.
void FindOrthogonalClasses(const RegularityOptions& options, std::vector<DirectionClass>* classes);

}  // namespace limn
