// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"

namespace limn {

// A straight link of a flat drawing, by the nodes at its ends.
struct FlatLine {
  NodeId node0 = -1;
  NodeId node1 = -1;
};

// The places of the nodes of a flat drawing (x to the right, y up) after lines that are level or
// plumb within the uncertainties of their ends have been made so exactly: nodes of a chain of level
// lines share their y, of plumb ones their x, the mean weighted by the inverse of their variances.
// No node moves by more than two of its standard deviations; lines by ends without a covariance (of
// the plane, above) stay, and so do those that would lose nine tenths of their length. Longer lines
// come first. Time: lines times the nodes that become one.
std::vector<Eigen::Vector3d> LevelNodes(std::vector<Eigen::Vector3d> places,
                                        const std::vector<Eigen::Matrix3d>& covariances,
                                        const std::vector<FlatLine>& lines);

}  // namespace limn
