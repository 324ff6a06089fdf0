#include "limn/topology/joints.h"

#include <algorithm>
#include <cmath>

#include "limn/support/edgel_residual.h"
#include "limn/topology/link_geometry.h"

namespace limn {
namespace {

// A view shows a joint if it supports a link within this distance, px.
constexpr double kVisibleStretchPx = 10;
// Neighbors of a claimed edgel on its fragment that are claimed, too, to either side: samples are
// about 2 px apart.
constexpr int kClaimedNeighbors = 1;
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

LinkVertex MakeVertex(const TopologyInput& input, const EdgelIndexes& edgels,
                      const Eigen::Vector3d& position, const Eigen::Vector3d& direction,
                      double footprint, const std::vector<ViewId>& in_views) {
  LinkVertex vertex;
  vertex.footprint = footprint;
  vertex.support = SupportAt(position, direction, in_views, input.views, edgels, CornerGate());
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (const EdgelRef& ref : vertex.support) {
    const Edgel& edgel = input.curves[ref.view].edge_map.edgels[ref.edgel];
    const auto residual = ResidualToEdgel(input.views[ref.view], edgel, position);
    if (!residual) continue;
    information += residual->gradient * residual->gradient.transpose() / ResidualVariance(edgel);
  }
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - direction * direction.transpose();
  vertex.information = across * information * across;
  return vertex;
}

}  // namespace

std::vector<Joint> CollectJoints(const DrawingGraph& graph, size_t num_views) {
  std::vector<Joint> joints;
  std::vector<int> of_node(graph.nodes.size(), -1);
  for (LinkId id = 0; id < static_cast<LinkId>(graph.links.size()); ++id) {
    const DrawingLink& link = graph.links[id];
    if (link.closed) continue;
    for (const int end : {0, 1}) {
      const NodeId node = link.NodeAt(end);
      if (of_node[node] < 0) {
        of_node[node] = static_cast<int>(joints.size());
        joints.push_back({node, graph.nodes[node].position_in_world, 0, {}, {}});
        joints.back().visible.assign(num_views, 0);
      }
      Joint& joint = joints[of_node[node]];
      const LinkTip tip = TipOf(link, end);
      joint.footprint += tip.footprint / graph.nodes[node].Degree();
      joint.leaving.push_back(-tip.outward);
      MarkViews(link, end, &joint.visible);
    }
  }
  return joints;
}

bool IsTaken(const Joint& joint, const Eigen::Vector3d& direction, double max_angle_rad) {
  const double min_cosine = std::cos(max_angle_rad);
  return std::any_of(
      joint.leaving.begin(), joint.leaving.end(),
      [&](const Eigen::Vector3d& leaving) { return leaving.dot(direction) > min_cosine; });
}

EdgelClaims CollectClaims(const TopologyInput& input, const DrawingGraph& graph) {
  std::vector<std::vector<bool>> claimed;
  for (const ImageCurves& of_view : input.curves) {
    claimed.emplace_back(of_view.edge_map.edgels.size());
  }
  for (const DrawingLink& link : graph.links) {
    for (const LinkVertex& vertex : link.vertices) {
      for (const EdgelRef& ref : vertex.support) claimed[ref.view][ref.edgel] = true;
    }
  }
  EdgelClaims result;
  for (size_t v = 0; v < input.curves.size(); ++v) {
    std::vector<bool> unclaimed(claimed[v].size(), false);
    for (const CurveFragment& fragment : input.curves[v].fragments) {
      const auto size = static_cast<int>(fragment.edgel_ids.size());
      for (const EdgelId id : fragment.edgel_ids) unclaimed[id] = true;
      for (int i = 0; i < size; ++i) {
        if (!claimed[v][fragment.edgel_ids[i]]) continue;
        const int last = std::min(size - 1, i + kClaimedNeighbors);
        for (int j = std::max(0, i - kClaimedNeighbors); j <= last; ++j) {
          unclaimed[fragment.edgel_ids[j]] = false;
        }
      }
    }
    result.all.push_back(&input.edgels[v]->edgels);
    result.owned.emplace_back(input.curves[v].edge_map, unclaimed);
  }
  for (const EdgelIndex& index : result.owned) result.unclaimed.push_back(&index);
  return result;
}

SupportGate CornerGate() { return {1.5, 1.5, 25 * M_PI / 180}; }

std::vector<EdgelRef> SupportAt(const Eigen::Vector3d& position, const Eigen::Vector3d& direction,
                                const std::vector<ViewId>& in_views, const std::vector<View>& views,
                                const EdgelIndexes& edgels, const SupportGate& gate) {
  std::vector<EdgelRef> support;
  for (const ViewId v : in_views) {
    const auto sight = See(views[v], position, direction);
    if (!sight) continue;
    const auto match = edgels[v]->Best(sight->position_px, sight->direction_rad, gate);
    if (match) support.push_back({v, match->edgel});
  }
  return support;
}

void AddStraightLink(const TopologyInput& input, const EdgelIndexes& edgels,
                     const Eigen::Vector3d& end, const std::vector<ViewId>& in_views, Joint* joint,
                     Joint* target, GraphEditor* editor) {
  const Eigen::Vector3d begin = joint->position;
  const Eigen::Vector3d direction = (end - begin).normalized();
  const double length_px = (end - begin).norm() / joint->footprint;
  const int count = std::max(3, static_cast<int>(std::lround(length_px / kSpacingPx)) + 1);
  DrawingLink link;
  link.node0 = joint->node;
  if (target) link.node1 = target->node;
  for (int k = 0; k < count; ++k) {
    const Eigen::Vector3d position = begin + (end - begin) * k / (count - 1.0);
    link.points_in_world.push_back(position);
    link.vertices.push_back(
        MakeVertex(input, edgels, position, direction, joint->footprint, in_views));
    link.sigma.push_back(SigmaAcross(link.vertices.back().information, joint->footprint));
  }
  editor->Add(std::move(link));
  joint->leaving.push_back(direction);
  if (target) target->leaving.push_back(-direction);
}

}  // namespace limn
