#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "limn/support/segment_support.h"
#include "limn/topology/graph_editor.h"
#include "limn/topology/topology_input.h"

namespace limn {

// A node from which edges may grow.
struct Joint {
  NodeId node = -1;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double footprint = 0;                  // mean over its ends
  std::vector<Eigen::Vector3d> leaving;  // unit directions into the links
  std::vector<uint8_t> visible;          // per view: whether edgels support a link near the joint
};

// All nodes but those of loops, in the order of their first links.
std::vector<Joint> CollectJoints(const DrawingGraph& graph, size_t num_views);

// Whether a link leaves the joint within the angle of the direction.
bool IsTaken(const Joint& joint, const Eigen::Vector3d& direction, double max_angle_rad);

// Per view, the edgels of fragments: all of them, and those that support no link. Neighbors, along
// the fragment, of a supporting edgel count as supporting.
struct EdgelClaims {
  EdgelIndexes all;        // those of the input, which must outlive this
  EdgelIndexes unclaimed;  // point into `owned`
  std::vector<EdgelIndex> owned;
};
EdgelClaims CollectClaims(const TopologyInput& input, const DrawingGraph& graph);

// The gate near corners, where edges are rounded: wider than that of samples (ALGORITHM.md 1.4).
SupportGate CornerGate();

// Edgels of the given views that support a point of an edge with this direction.
std::vector<EdgelRef> SupportAt(const Eigen::Vector3d& position, const Eigen::Vector3d& direction,
                                const std::vector<ViewId>& in_views, const std::vector<View>& views,
                                const EdgelIndexes& edgels, const SupportGate& gate);

// Adds a straight link from a joint to a free end, or to another joint if `target` is not null,
// supported by the edgels of `in_views`. Updates the joints.
void AddStraightLink(const TopologyInput& input, const EdgelIndexes& edgels,
                     const Eigen::Vector3d& end, const std::vector<ViewId>& in_views, Joint* joint,
                     Joint* target, GraphEditor* editor);

}  // namespace limn
