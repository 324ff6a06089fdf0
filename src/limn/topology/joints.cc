// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/joints.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limn/topology/link_geometry.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// A view shows a joint if it supports a link within this distance, px.
constexpr double kVisibleStretchPx = 10;
// A direction within this angle of a link is taken by that link. For F see kExplainedRad of
// joint_rays.cc.
constexpr double kTakenRad = 20 * kDeg;
// Spacing of the points of a straight link, px.
constexpr double kSpacingPx = 2;

void MarkViews(const DrawingLink& link, int end, std::vector<uint8_t>* visible) {
  double arc_px = 0;
  for (int k = 0; k < link.size() && arc_px <= kVisibleStretchPx; ++k) {
    const int at = end == 0 ? k : link.size() - 1 - k;
    for (const EdgelRef& ref : link.vertices[at].support) (*visible)[ref.view] = 1;
    if (k + 1 < link.size()) arc_px += end == 0 ? ArcPx(link, at, at + 1) : ArcPx(link, at - 1, at);
  }
}

LinkVertex MakeVertex(const TopologyInput& input, const Eigen::Vector3d& position,
                      const Eigen::Vector3d& direction, double footprint,
                      const std::vector<ViewId>& in_views) {
  LinkVertex vertex;
  vertex.footprint = footprint;
  vertex.support = SupportAt(input, position, direction, in_views, kJointGate);
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - direction * direction.transpose();
  vertex.information = across * input.Information(vertex.support, position) * across;
  return vertex;
}

}  // namespace

std::vector<Joint> CollectJoints(const DrawingGraph& graph, size_t num_views) {
  std::vector<Joint> joints;
  std::vector<int> of_node(graph.nodes.size(), -1);
  for (LinkId id = 0; id < static_cast<LinkId>(graph.links.size()); ++id) {
    const DrawingLink& link = graph.links[id];
    if (link.closed || link.vertices.empty()) continue;
    for (const int end : {0, 1}) {
      const NodeId node = link.NodeAt(end);
      if (of_node[node] < 0) {
        of_node[node] = static_cast<int>(joints.size());
        joints.push_back(
            {node, graph.nodes[node].position_in_world, 0, {}, std::vector<uint8_t>(num_views, 0)});
      }
      Joint& joint = joints[of_node[node]];
      const LinkTip tip = TipOf(link, end);
      joint.footprint += tip.footprint;
      joint.leaving.push_back(-tip.outward);
      MarkViews(link, end, &joint.visible);
    }
  }
  for (Joint& joint : joints) joint.footprint /= static_cast<double>(joint.leaving.size());
  return joints;
}

bool IsTaken(const Joint& joint, const Eigen::Vector3d& direction) {
  const double min_cosine = std::cos(kTakenRad);
  return std::any_of(
      joint.leaving.begin(), joint.leaving.end(),
      [&](const Eigen::Vector3d& leaving) { return leaving.dot(direction) > min_cosine; });
}

std::vector<EdgelRef> SupportAt(const TopologyInput& input, const Eigen::Vector3d& position,
                                const Eigen::Vector3d& direction,
                                const std::vector<ViewId>& in_views, const SupportGate& gate) {
  std::vector<EdgelRef> support;
  for (const ViewId v : in_views) {
    const auto edgel = input.EdgelAt(v, position, direction, gate);
    if (edgel) support.push_back(*edgel);
  }
  return support;
}

bool IsTaken(const Joint& joint, const Eigen::Vector3d& end, const Joint* target) {
  const Eigen::Vector3d direction = (end - joint.position).normalized();
  return IsTaken(joint, direction) || (target && IsTaken(*target, -direction));
}

void AddStraightLink(const TopologyInput& input, const Eigen::Vector3d& end,
                     const std::vector<ViewId>& in_views, Joint* joint, Joint* target,
                     GraphEditor* editor) {
  const Eigen::Vector3d begin = joint->position;
  const Eigen::Vector3d direction = (end - begin).normalized();
  const double length_px = (end - begin).norm() / joint->footprint;
  const int count = std::max(3, static_cast<int>(std::lround(length_px / kSpacingPx)) + 1);
  DrawingLink link;
  link.node0 = joint->node;
  if (target) link.node1 = target->node;
  link.supporting_views = in_views;
  for (int k = 0; k < count; ++k) {
    const Eigen::Vector3d position = begin + (end - begin) * k / (count - 1.0);
    link.points_in_world.push_back(position);
    link.vertices.push_back(MakeVertex(input, position, direction, joint->footprint, in_views));
    link.sigma.push_back(SigmaAcross(link.vertices.back().information, joint->footprint));
  }
  editor->Add(std::move(link));
  joint->leaving.push_back(direction);
  if (target) target->leaving.push_back(-direction);
}

}  // namespace limn
