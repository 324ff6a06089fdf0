// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/node_scores.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "limn/util/angles.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

constexpr int kMinJunctionDegree = 3;
constexpr double kNearFootprints = 3;
const double kMinArmCosine = std::cos(20 * kDeg);
// True arms in directions nearer than this are one: copies of a curve.
const double kSameArmCosine = std::cos(10 * kDeg);

double RadiusAt(const SampledScene& sampled, const Eigen::Vector3d& point) {
  return sampled.Radius(sampled.scene.options.junction_taus, point);
}

std::vector<Eigen::Vector3d> Positions(const std::vector<const TrueNode*>& nodes) {
  std::vector<Eigen::Vector3d> positions;
  for (const TrueNode* node : nodes) positions.push_back(node->position_in_world);
  return positions;
}

std::vector<const TrueNode*> TrueNodesOfDegree(const TrueChains& chains, int min_degree) {
  std::vector<const TrueNode*> nodes;
  for (const TrueNode& node : chains.nodes) {
    if (node.degree >= min_degree) nodes.push_back(&node);
  }
  return nodes;
}

bool IsNear(const SpatialIndex& index, const Eigen::Vector3d& point, double radius) {
  return index.size() > 0 && std::sqrt(index.Nearest(point).squared_distance) <= radius;
}

std::optional<double> Ratio(double part, double whole) {
  if (!(whole > 0)) return std::nullopt;
  return part / whole;
}

// Whether the node's arms can be distinguished at this tau.
bool IsResolved(const SampledScene& sampled, const TrueChains& chains, const TrueNode& node) {
  if (!sampled.scene.truth.nodes.empty()) return true;
  const double radius = RadiusAt(sampled, node.position_in_world);
  return std::all_of(node.arms.begin(), node.arms.end(),
                     [&](const TrueArm& arm) { return chains.chains[arm.chain].length > radius; });
}

// A candidate for a one-to-one matching; those of small cost are taken first.
struct Candidate {
  double cost;
  int a, b;
};

std::vector<std::pair<int, int>> MatchGreedily(std::vector<Candidate> candidates) {
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) {
    return std::tie(x.cost, x.a, x.b) < std::tie(y.cost, y.a, y.b);
  });
  std::set<int> used_a, used_b;
  std::vector<std::pair<int, int>> matches;
  for (const Candidate& candidate : candidates) {
    if (used_a.contains(candidate.a) || used_b.contains(candidate.b)) continue;
    used_a.insert(candidate.a);
    used_b.insert(candidate.b);
    matches.emplace_back(candidate.a, candidate.b);
  }
  return matches;
}

// True junctions in the region with junctions of the drawing: indices of `truth` and of nodes.
std::vector<std::pair<int, int>> MatchJunctions(const SampledScene& sampled,
                                                const std::vector<const TrueNode*>& truth) {
  const std::vector<CurveNode>& nodes = sampled.scene.topology.nodes;
  std::vector<Eigen::Vector3d> positions;
  std::vector<int> junctions;
  for (size_t node = 0; node < nodes.size(); ++node) {
    if (nodes[node].degree < kMinJunctionDegree) continue;
    positions.push_back(nodes[node].position_in_world);
    junctions.push_back(static_cast<int>(node));
  }
  const SpatialIndex index(positions);
  std::vector<Candidate> candidates;
  std::vector<SpatialIndex::Neighbor> found;
  for (size_t i = 0; i < truth.size(); ++i) {
    const Eigen::Vector3d& position = truth[i]->position_in_world;
    if (!sampled.scene.InRegion(position)) continue;
    index.FindWithin(position, RadiusAt(sampled, position), &found);
    for (const SpatialIndex::Neighbor& neighbor : found) {
      candidates.push_back(
          {neighbor.squared_distance, static_cast<int>(i), junctions[neighbor.index]});
    }
  }
  return MatchGreedily(std::move(candidates));
}

using Directions = std::vector<Eigen::Vector3d>;

Directions TrueDirections(const TrueChains& chains, const TrueNode& node, double reach) {
  Directions directions;
  for (const TrueArm& arm : node.arms) {
    const Eigen::Vector3d direction =
        DirectionFromEnd(chains.chains[arm.chain].points, arm.from_end, reach);
    const bool is_copy = std::any_of(
        directions.begin(), directions.end(),
        [&](const Eigen::Vector3d& other) { return direction.dot(other) > kSameArmCosine; });
    if (!is_copy) directions.push_back(direction);
  }
  return directions;
}

Directions DrawnDirections(const SampledScene& sampled, int node, double reach) {
  const std::vector<Polyline3d>& links = sampled.scene.reconstruction.polylines;
  Directions directions;
  for (size_t link = 0; link < links.size(); ++link) {
    for (const bool from_end : {false, true}) {
      if (sampled.scene.topology.end_nodes[link][from_end] != node) continue;
      directions.push_back(DirectionFromEnd(links[link], from_end, reach));
    }
  }
  return directions;
}

int CountMatches(const Directions& a, const Directions& b) {
  std::vector<Candidate> candidates;
  for (size_t i = 0; i < a.size(); ++i) {
    for (size_t j = 0; j < b.size(); ++j) {
      const double cosine = a[i].dot(b[j]);
      if (cosine < kMinArmCosine) continue;
      candidates.push_back({-cosine, static_cast<int>(i), static_cast<int>(j)});
    }
  }
  return static_cast<int>(MatchGreedily(std::move(candidates)).size());
}

// Nodes of the drawing by place, and the links at each.
struct DrawnNodes {
  explicit DrawnNodes(const CurveTopology& topology)
      : index(PlacesOf(topology)), links_at(topology.nodes.size()) {
    for (size_t link = 0; link < topology.end_nodes.size(); ++link) {
      for (const int node : topology.end_nodes[link]) {
        if (node >= 0) links_at[node].push_back(static_cast<int>(link));
      }
    }
  }

  static std::vector<Eigen::Vector3d> PlacesOf(const CurveTopology& topology) {
    std::vector<Eigen::Vector3d> places;
    for (const CurveNode& node : topology.nodes) places.push_back(node.position_in_world);
    return places;
  }

  SpatialIndex index;
  std::vector<std::vector<int>> links_at;
};

// Links are in one set if nodes near the true node connect them.
UnionFind ConnectedNear(const SampledScene& sampled, const DrawnNodes& drawn,
                        const TrueNode& node) {
  std::vector<SpatialIndex::Neighbor> found;
  drawn.index.FindWithin(node.position_in_world, RadiusAt(sampled, node.position_in_world), &found);
  UnionFind sets(static_cast<int>(sampled.scene.reconstruction.polylines.size()));
  for (const SpatialIndex::Neighbor& near : found) {
    const std::vector<int>& links = drawn.links_at[near.index];
    for (const int link : links) sets.Union(links.front(), link);
  }
  return sets;
}

// Links that draw the arm, from among the links that cover its chain.
std::vector<int> LinksOfArm(const SampledScene& sampled, const TrueChains& chains,
                            const ChainCoverage& coverage, const TrueNode& node,
                            const TrueArm& arm) {
  const double unit = sampled.scene.unit_at(node.position_in_world);
  const double length = std::min(kArmTaus * sampled.tau, chains.chains[arm.chain].length / unit);
  std::vector<int> links;
  for (auto cover = coverage.covers.lower_bound({arm.chain, -1});
       cover != coverage.covers.end() && cover->first.first == arm.chain; ++cover) {
    const ChainCover& lengths = cover->second;
    const double covered = arm.from_end ? lengths.near_end : lengths.near_start;
    if (covered >= 0.5 * length) links.push_back(cover->first.second);
  }
  return links;
}

bool AreJoined(const std::vector<int>& a, const std::vector<int>& b, UnionFind* sets) {
  for (const int i : a) {
    for (const int j : b) {
      if (sets->Find(i) == sets->Find(j)) return true;
    }
  }
  return false;
}

// Whether one of the links has an end within kNearFootprints of the node.
bool EndsNear(const SampledScene& sampled, const std::vector<int>& links, const TrueNode& node) {
  const Eigen::Vector3d& position = node.position_in_world;
  const double radius = kNearFootprints * sampled.scene.unit_at(position);
  return std::ranges::any_of(links, [&](int link) {
    const Polyline3d& points = sampled.scene.reconstruction.polylines[link];
    return (points.front() - position).norm() <= radius ||
           (points.back() - position).norm() <= radius;
  });
}

// Two arms of a true node that are drawn near it.
struct Meeting {
  bool is_joined = false;
  bool ends_near = false;  // both have links that do
};

std::vector<Meeting> MeetingsAt(const SampledScene& sampled, const TrueChains& chains,
                                const ChainCoverage& coverage, const TrueNode& node,
                                const DrawnNodes& drawn_nodes) {
  UnionFind sets = ConnectedNear(sampled, drawn_nodes, node);
  std::vector<std::vector<int>> drawn;
  for (const TrueArm& arm : node.arms) {
    drawn.push_back(LinksOfArm(sampled, chains, coverage, node, arm));
    if (drawn.back().empty()) drawn.pop_back();
  }
  std::vector<Meeting> meetings;
  for (size_t i = 0; i < drawn.size(); ++i) {
    for (size_t j = i + 1; j < drawn.size(); ++j) {
      meetings.push_back({AreJoined(drawn[i], drawn[j], &sets),
                          EndsNear(sampled, drawn[i], node) && EndsNear(sampled, drawn[j], node)});
    }
  }
  return meetings;
}

bool IsCorner(const CurveSet& truth, const TrueNode& node) {
  const bool has_kinds = std::ranges::any_of(
      truth.nodes, [](const CurveNode& own) { return own.kind != JunctionKind::kUnknown; });
  return !has_kinds || node.kind == JunctionKind::kCorner;
}

void AddCorner(const std::vector<Meeting>& meetings, CornerScores* corners) {
  if (meetings.empty()) return;
  int num_open = 0;
  int num_near = 0;
  for (const Meeting& meeting : meetings) {
    num_open += !meeting.is_joined;
    num_near += !meeting.is_joined && meeting.ends_near;
  }
  ++corners->num_drawn;
  corners->num_open += num_open > 0;
  corners->num_meetings += static_cast<int>(meetings.size());
  corners->num_open_meetings += num_open;
  if (corners->num_open_near) *corners->num_open_near += num_near;
}

}  // namespace

void ScoreFreeEnds(const SampledScene& sampled, const TrueChains& chains, double true_length,
                   StructureScores* scores) {
  const SpatialIndex truth(Positions(TrueNodesOfDegree(chains, 0)));
  int num_ends = 0;
  int num_false = 0;
  for (const CurveNode& node : sampled.scene.topology.nodes) {
    const Eigen::Vector3d& position = node.position_in_world;
    if (node.degree != 1 || !sampled.Counts(position)) continue;
    ++num_ends;
    if (!IsNear(truth, position, RadiusAt(sampled, position))) ++num_false;
  }
  scores->num_free_ends = num_ends;
  if (chains.chains.empty()) return;
  scores->num_false_ends = num_false;
  scores->false_ends_per_length = Ratio(num_false, true_length);
}

void ScoreJunctions(const SampledScene& sampled, const TrueChains& chains, double true_length,
                    StructureScores* scores) {
  const std::vector<const TrueNode*> truth = TrueNodesOfDegree(chains, kMinJunctionDegree);
  const SpatialIndex index(Positions(truth));
  int num_false = 0;
  for (const CurveNode& node : sampled.scene.topology.nodes) {
    const Eigen::Vector3d& position = node.position_in_world;
    if (node.degree < kMinJunctionDegree || !sampled.Counts(position)) continue;
    if (!IsNear(index, position, RadiusAt(sampled, position))) ++num_false;
  }
  scores->num_false_junctions = num_false;
  scores->false_junctions_per_length = Ratio(num_false, true_length);
  int num_right = 0;
  int num_arms = 0;
  int num_true_arms = 0;
  int num_matched_arms = 0;
  for (const auto& [i, node] : MatchJunctions(sampled, truth)) {
    if (!IsResolved(sampled, chains, *truth[i])) continue;
    ++scores->num_matched_junctions;
    const double reach = sampled.Radius(kArmTaus, truth[i]->position_in_world);
    const Directions directions = TrueDirections(chains, *truth[i], reach);
    const Directions drawn = DrawnDirections(sampled, node, reach);
    const int num_directions = static_cast<int>(directions.size());
    const int degree = sampled.scene.truth.nodes.empty() ? num_directions : truth[i]->degree;
    if (degree == sampled.scene.topology.nodes[node].degree) ++num_right;
    num_true_arms += num_directions;
    num_arms += static_cast<int>(drawn.size());
    num_matched_arms += CountMatches(drawn, directions);
  }
  scores->right_degrees = Ratio(num_right, scores->num_matched_junctions);
  scores->arm_precision = Ratio(num_matched_arms, num_arms);
  scores->arm_recall = Ratio(num_matched_arms, num_true_arms);
}

void ScoreConnectivity(const SampledScene& sampled, const TrueChains& chains,
                       const ChainCoverage& coverage, StructureScores* scores,
                       CornerScores* corners) {
  const DrawnNodes drawn(sampled.scene.topology);
  if (sampled.scene.in_footprints) corners->num_open_near = 0;
  int num_joined = 0;
  for (const TrueNode& node : chains.nodes) {
    if (node.arms.size() < 2 || !sampled.scene.InRegion(node.position_in_world)) continue;
    if (!IsResolved(sampled, chains, node)) continue;
    const std::vector<Meeting> meetings = MeetingsAt(sampled, chains, coverage, node, drawn);
    scores->num_drawn_meetings += static_cast<int>(meetings.size());
    num_joined += static_cast<int>(std::ranges::count(meetings, true, &Meeting::is_joined));
    if (IsCorner(sampled.scene.truth, node)) AddCorner(meetings, corners);
  }
  scores->connectivity = Ratio(num_joined, scores->num_drawn_meetings);
}

}  // namespace limn
