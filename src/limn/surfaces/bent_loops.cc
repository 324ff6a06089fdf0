// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/bent_loops.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include <Eigen/Geometry>

#include "limn/geometry/polygon_triangulation.h"
#include "limn/geometry/spatial_index.h"
#include "limn/topology/link_geometry.h"
#include "limn/util/sort_unique.h"

namespace limn {
namespace {

constexpr size_t kMaxLinks = 6;
// Below this turn (sine) one side continues; beyond the other (cosine) a loop turns back.
constexpr double kMinTurnSine = 0.17;
constexpr double kMaxTurnCosine = -0.94;
// Normals at corners differ by less than 60 degrees.
constexpr double kMinNormalCosine = 0.5;

class LoopFinder {
 public:
  LoopFinder(const std::vector<FaceLink>& links, const DrawingGraph& graph,
             const SurfaceOptions& options)
      : links_(links), graph_(graph), options_(options), index_(NodePlaces(graph)) {
    steps_from_.resize(graph.nodes.size());
    for (const FaceLink& link : links) {
      const DrawingLink& drawn = graph.links[link.link];
      auto& outward = outward_.emplace_back();
      for (const int end : {0, 1}) {
        outward[end] = TipOf(drawn, end, link.footprint).bent_outward;
      }
      if (drawn.closed) continue;
      for (const bool reversed : {false, true}) {
        steps_from_[drawn.NodeAt(reversed ? 1 : 0)].push_back({&link, reversed});
      }
    }
  }

  std::vector<BentLoop> Run() {
    for (const FaceLink& link : links_) {
      if (!IsBent(link) || graph_.links[link.link].closed) continue;
      way_ = {{&link, false}};
      nodes_ = {FirstNode(way_[0]), LastNode(way_[0])};
      corners_.clear();
      Walk();
    }
    return std::move(loops_);
  }

 private:
  static std::vector<Eigen::Vector3d> NodePlaces(const DrawingGraph& graph) {
    std::vector<Eigen::Vector3d> places;
    for (const DrawingNode& node : graph.nodes) places.push_back(node.position_in_world);
    return places;
  }

  bool IsBent(const FaceLink& link) const {
    return !link.IsStraight(2 * options_.plane_tolerance_px);
  }

  NodeId FirstNode(const LoopStep& step) const {
    return graph_.links[step.link->link].NodeAt(step.reversed ? 1 : 0);
  }
  NodeId LastNode(const LoopStep& step) const {
    return graph_.links[step.link->link].NodeAt(step.reversed ? 0 : 1);
  }
  // How the loop enters and leaves a link.
  Eigen::Vector3d DirectionIn(const LoopStep& step) const {
    return -outward_[step.link - links_.data()][step.reversed ? 1 : 0];
  }
  Eigen::Vector3d DirectionOut(const LoopStep& step) const {
    return outward_[step.link - links_.data()][step.reversed ? 0 : 1];
  }

  // Goes on from the end of the way in all directions.
  void Walk() {
    const double footprint = way_.back().link->footprint;
    if (way_.size() > 1 && IsBeside(nodes_.back(), nodes_.front(), footprint)) {
      Close();
    } else if (way_.size() < kMaxLinks) {
      for (const NodeId node : NodesBeside(nodes_.back(), footprint)) {
        for (const LoopStep& step : steps_from_[node]) GoOn(step);
      }
    }
  }

  void GoOn(const LoopStep& step) {
    const FaceLink& first = *way_.front().link;
    // A loop is found from the first of its bent links.
    if (IsBent(*step.link) && step.link <= &first) return;
    const NodeId from = FirstNode(step), to = LastNode(step);
    const bool closes = IsBeside(to, nodes_.front(), step.link->footprint);
    if (from != nodes_.back() && Knows(from)) return;
    if (from == nodes_.front() || (!closes && Knows(to))) return;
    const auto corner = CornerBetween(way_.back(), step);
    if (!corner) return;
    way_.push_back(step);
    nodes_.push_back(from);
    nodes_.push_back(to);
    corners_.push_back(*corner);
    Walk();
    corners_.pop_back();
    nodes_.resize(nodes_.size() - 2);
    way_.pop_back();
  }

  void Close() {
    const auto corner = CornerBetween(way_.back(), way_.front());
    if (!corner) return;
    corners_.push_back(*corner);
    if (!IsFlat() && !HasChord() && AgreeAll()) loops_.push_back(way_);
    corners_.pop_back();
  }

  bool Knows(NodeId node) const { return std::ranges::find(nodes_, node) != nodes_.end(); }
  bool IsBeside(NodeId a, NodeId b, double footprint) const {
    const double distance =
        (graph_.nodes[a].position_in_world - graph_.nodes[b].position_in_world).norm();
    return distance <= options_.max_bridge_px * footprint;
  }
  // The node and those that a bridge may lead to.
  std::vector<NodeId> NodesBeside(NodeId node, double footprint) const {
    std::vector<SpatialIndex::Neighbor> found;
    index_.FindWithin(graph_.nodes[node].position_in_world, options_.max_bridge_px * footprint,
                      &found);
    std::vector<NodeId> nodes = {node};
    for (const auto& neighbor : found) nodes.push_back(static_cast<NodeId>(neighbor.index));
    SortUnique(&nodes);
    return nodes;
  }

  // The normal of the surface at a corner, zero where one side continues; nothing if no surface
  // bends smoothly around it.
  std::optional<Eigen::Vector3d> CornerBetween(const LoopStep& from, const LoopStep& to) const {
    const Eigen::Vector3d in = DirectionOut(from);
    const Eigen::Vector3d out = DirectionIn(to);
    if (in.dot(out) < kMaxTurnCosine) return std::nullopt;
    const Eigen::Vector3d turn = in.cross(out);
    if (turn.norm() < kMinTurnSine) return Eigen::Vector3d::Zero();
    const Eigen::Vector3d normal = turn.normalized();
    const auto before = std::ranges::find_if(corners_.rbegin(), corners_.rend(),
                                             [](const Eigen::Vector3d& n) { return !n.isZero(); });
    if (before != corners_.rend() && before->dot(normal) < kMinNormalCosine) return std::nullopt;
    return normal;
  }

  // Whether the last corner agrees with the first, too, and all with their mean.
  bool AgreeAll() const {
    std::vector<Eigen::Vector3d> normals;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& normal : corners_) {
      if (normal.isZero()) continue;
      normals.push_back(normal);
      sum += normal;
    }
    if (normals.size() < 2 || normals.back().dot(normals.front()) < kMinNormalCosine) return false;
    const Eigen::Vector3d mean = sum.normalized();
    return std::ranges::all_of(
        normals, [&](const auto& normal) { return mean.dot(normal) >= kMinNormalCosine; });
  }

  bool IsFlat() const {
    const Polyline3d points = PointsOf(way_, graph_);
    const Eigen::Vector3d normal = PolygonAreaVector(points).normalized();
    const Eigen::Vector3d center =
        std::accumulate(points.begin(), points.end(), Eigen::Vector3d(0, 0, 0)) /
        static_cast<double>(points.size());
    return std::ranges::all_of(way_, [&](const LoopStep& step) {
      return LiesIn(*step.link, normal, normal.dot(center), 2 * options_.plane_tolerance_px);
    });
  }

  // Whether a link that is not of the loop joins nodes of it that are not neighbors.
  bool HasChord() const {
    const size_t size = nodes_.size();
    for (size_t i = 0; i < size; ++i) {
      for (const LoopStep& step : steps_from_[nodes_[i]]) {
        const NodeId to = LastNode(step);
        const auto at = std::ranges::find(nodes_, to);
        if (at == nodes_.end() || IsOfWay(*step.link)) continue;
        // Nodes go in pairs, first and last of each link.
        const size_t a = i / 2, b = static_cast<size_t>(at - nodes_.begin()) / 2;
        const size_t apart = (a + way_.size() - b) % way_.size();
        if (apart > 1 && apart + 1 < way_.size()) return true;
      }
    }
    return false;
  }
  bool IsOfWay(const FaceLink& link) const {
    return std::ranges::any_of(way_, [&](const LoopStep& step) { return step.link == &link; });
  }

  const std::vector<FaceLink>& links_;
  const DrawingGraph& graph_;
  const SurfaceOptions& options_;
  SpatialIndex index_;
  std::vector<std::array<Eigen::Vector3d, 2>> outward_;  // per link and end
  std::vector<std::vector<LoopStep>> steps_from_;        // per node
  // The way so far: its links, their first and last nodes, and the corners between them.
  BentLoop way_;
  std::vector<NodeId> nodes_;
  std::vector<Eigen::Vector3d> corners_;
  std::vector<BentLoop> loops_;
};

}  // namespace

Polyline3d PointsOf(const BentLoop& loop, const DrawingGraph& graph) {
  Polyline3d points;
  for (const LoopStep& step : loop) {
    const Polyline3d& of_link = graph.links[step.link->link].points_in_world;
    if (step.reversed) {
      points.insert(points.end(), of_link.rbegin(), of_link.rend());
    } else {
      points.insert(points.end(), of_link.begin(), of_link.end());
    }
  }
  return points;
}

std::vector<BentLoop> FindBentLoops(const std::vector<FaceLink>& links, const DrawingGraph& graph,
                                    const SurfaceOptions& options) {
  if (links.empty()) return {};
  return LoopFinder(links, graph, options).Run();
}

}  // namespace limn
