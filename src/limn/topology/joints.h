// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "limn/topology/graph_editor.h"
#include "limn/topology/topology_input.h"
#include "limn/util/angles.h"

namespace limn {

// A node from which edges may grow.
struct Joint {
  NodeId node = -1;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double footprint = 0;                  // mean over its ends
  std::vector<Eigen::Vector3d> leaving;  // unit directions into the links
  std::vector<uint8_t> visible;          // per view: whether edgels support a link near the joint
};

// The nodes of open links with vertices, in the order of their first links.
std::vector<Joint> CollectJoints(const DrawingGraph& graph, size_t num_views);

// Returns whether a link leaves the joint within 20 degrees of the direction.
bool IsTaken(const Joint& joint, const Eigen::Vector3d& direction);

// The gate near corners, where edges are rounded: wider than that of samples
// (algorithm/notation.md#support).
inline constexpr SupportGate kJointGate = {1.5, 1.5, 25 * kDeg};

// Edgels of the given views that support a point of an edge with this direction.
std::vector<EdgelRef> SupportAt(const TopologyInput& input, const Eigen::Vector3d& position,
                                const Eigen::Vector3d& direction,
                                const std::vector<ViewId>& in_views, const SupportGate& gate);

// The same for the line to a place, which is that of `target` unless it is null.
bool IsTaken(const Joint& joint, const Eigen::Vector3d& end, const Joint* target);

// Adds a straight link from a joint to a free end, or to another joint if `target` is not null,
// supported by the edgels of `in_views`. Updates the joints.
void AddStraightLink(const TopologyInput& input, const Eigen::Vector3d& end,
                     const std::vector<ViewId>& in_views, Joint* joint, Joint* target,
                     GraphEditor* editor);

}  // namespace limn
