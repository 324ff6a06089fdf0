// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/util/parallel.h"

namespace limn {

// Assigns points to targets one to one, as many as the smaller set has, so that the sum of their
// distances is smallest (shortest augmenting paths: Kuhn 1955, Jonker & Volgenant 1987). Returns
// per point the index of its target, or -1. No distance is too large. Where several assignments are
// equally good, which one it is depends on the coordinates, not on the order of the points or on
// which set is called the targets. Only points that differ are told apart: of equal ones the first
// get a target first. Precondition: all are finite. O(s^2 l) for s points in the smaller set and l
// in the larger one at worst, linear memory. Throws Cancelled.
std::vector<int> AssignPoints(const std::vector<Eigen::Vector3d>& points,
                              const std::vector<Eigen::Vector3d>& targets,
                              const RunContext& context = {});

}  // namespace limn
