// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limn/topology/joints.h"

namespace limn {

// A direction in space in which image edges, but no link, leave a joint.
struct JointDirection {
  Eigen::Vector3d unit = Eigen::Vector3d::Zero();
  std::vector<ViewId> views;  // with a ray that agrees
};

// Collects, in every view that shows the joint, the straight edges that begin at its projection and
// that none of its links explains (rays). Rays of two views define a direction in space. Returns
// the direction that chance explains least, if rays of at least min_views views agree with it
// (algorithm/topology.md#rays). Time: views times pairs of rays in the proposing views, of which
// there are at most 24.
std::optional<JointDirection> FindJointDirection(const TopologyInput& input, const Joint& joint,
                                                 size_t min_views);

}  // namespace limn
