#include "limn/model/graph_edits.h"

#include <algorithm>
#include <utility>

#include <Eigen/Eigenvalues>

namespace limn {
namespace {

constexpr double kTipSkipPx = 2;
constexpr double kTipLengthPx = 10;

// In the continuations of a node.
void RenameEnd(const LinkEnd& from, const LinkEnd& to, DrawingNode* node) {
  for (auto& [first, second] : node->continuations) {
    if (first == from) first = to;
    if (second == from) second = to;
  }
}

void Reverse(DrawingLink* link) {
  std::reverse(link->points_in_world.begin(), link->points_in_world.end());
  std::reverse(link->sigma.begin(), link->sigma.end());
  std::swap(link->node0, link->node1);
}

template <typename T>
void Append(const std::vector<T>& more, std::vector<T>* to) {
  to->insert(to->end(), more.begin(), more.end());
}

// A closed link begins and ends at another of its points.
void Rotate(int index, DrawingLink* link) {
  const auto rotate = [&](auto* values) {
    values->pop_back();
    std::rotate(values->begin(), values->begin() + index, values->end());
    values->push_back(values->front());
  };
  rotate(&link->points_in_world);
  rotate(&link->sigma);
}

}  // namespace

NodeId NodeAt(const DrawingLink& link, int end) { return end == 0 ? link.node0 : link.node1; }

LinkTip TipOf(const DrawingLink& link, int end, double footprint) {
  const std::vector<Eigen::Vector3d>& points = link.points_in_world;
  const int size = static_cast<int>(points.size());
  const auto at = [&](int k) { return points[end == 0 ? k : size - 1 - k]; };
  LinkTip tip;
  tip.point = at(0);
  std::vector<Eigen::Vector3d> used;
  double arc_px = 0;
  for (int k = 0; k < size && arc_px <= kTipLengthPx; ++k) {
    if (k > 0) arc_px += (at(k) - at(k - 1)).norm() / footprint;
    if (arc_px >= kTipSkipPx) used.push_back(at(k));
  }
  if (used.size() < 2) used = {at(0), at(size - 1)};
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : used) mean += point / static_cast<double>(used.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& point : used) {
    scatter += (point - mean) * (point - mean).transpose();
  }
  Eigen::Vector3d direction =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(2);
  const Eigen::Vector3d outwards = used.front() - used.back();
  if (!(outwards.norm() > 0)) return tip;
  if (direction.dot(outwards) < 0) direction = -direction;
  tip.outward = direction;
  tip.point = mean + direction * direction.dot(tip.point - mean);
  return tip;
}

NodeId SplitLink(LinkId id, int index, DrawingGraph* graph) {
  const NodeId node = static_cast<NodeId>(graph->nodes.size());
  graph->nodes.emplace_back();
  graph->nodes.back().position_in_world = graph->links[id].points_in_world[index];
  if (graph->links[id].closed) {
    DrawingLink& loop = graph->links[id];
    Rotate(index, &loop);
    loop.closed = false;
    loop.node0 = loop.node1 = node;
    return node;
  }
  const LinkId second_id = static_cast<LinkId>(graph->links.size());
  DrawingLink second = graph->links[id];
  DrawingLink& first = graph->links[id];
  first.points_in_world.resize(index + 1);
  first.sigma.resize(index + 1);
  RenameEnd({id, 1}, {second_id, 1}, &graph->nodes[first.node1]);
  first.node1 = node;
  second.points_in_world.erase(second.points_in_world.begin(),
                               second.points_in_world.begin() + index);
  second.sigma.erase(second.sigma.begin(), second.sigma.begin() + index);
  second.node0 = node;
  graph->links.push_back(std::move(second));
  return node;
}

void EndLinkAt(const LinkEnd& end, NodeId node, DrawingGraph* graph) {
  DrawingLink& link = graph->links[end.link];
  const Eigen::Vector3d& target = graph->nodes[node].position_in_world;
  if (end.end == 0) Reverse(&link);
  std::vector<Eigen::Vector3d>& points = link.points_in_world;
  while (points.size() > 2) {
    const Eigen::Vector3d ahead = points.back() - points[points.size() - 2];
    if ((target - points.back()).dot(ahead) > 0) break;
    points.pop_back();
    link.sigma.pop_back();
  }
  points.push_back(target);
  link.sigma.push_back(link.sigma.back());
  link.node1 = node;
  if (end.end == 0) Reverse(&link);
}

void JoinEnds(const LinkEnd& a, const LinkEnd& b, DrawingGraph* graph) {
  DrawingLink& first = graph->links[a.link];
  if (a.link == b.link) {
    first.points_in_world.push_back(first.points_in_world.front());
    first.sigma.push_back(first.sigma.front());
    first.node1 = first.node0;
    first.closed = true;
    graph->nodes[first.node0].continuations.push_back({{a.link, 0}, {a.link, 1}});
    return;
  }
  DrawingLink& second = graph->links[b.link];
  const NodeId far = NodeAt(second, 1 - b.end);
  if (b.end == 1) Reverse(&second);
  if (a.end == 0) Reverse(&first);
  Append(second.points_in_world, &first.points_in_world);
  Append(second.sigma, &first.sigma);
  Append(second.members, &first.members);
  Append(second.supporting_views, &first.supporting_views);
  std::vector<ViewId>& views = first.supporting_views;
  std::sort(views.begin(), views.end());
  views.erase(std::unique(views.begin(), views.end()), views.end());
  first.residual_px = std::max(first.residual_px, second.residual_px);
  first.node1 = far;
  if (a.end == 0) Reverse(&first);
  RenameEnd({b.link, 1 - b.end}, a, &graph->nodes[far]);
}

LinkEnd EndMoves::Now(LinkEnd end) const {
  for (auto it = moved_.find(end); it != moved_.end(); it = moved_.find(end)) end = it->second;
  return end;
}

void EndMoves::Joined(const LinkEnd& a, const LinkEnd& b) { moved_[{b.link, 1 - b.end}] = a; }

}  // namespace limn
