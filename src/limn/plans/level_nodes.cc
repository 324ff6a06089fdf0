// SPDX-License-Identifier: BSD-3-Clause
#include "limn/plans/level_nodes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "limn/util/angles.h"

namespace limn {
namespace {

constexpr double kSigmas = 2;
// Lines that differ from level or plumb by a larger slope, of 1 degree, are meant to.
const double kMaxSlope = std::tan(1 * kDeg);

// Nodes that share a coordinate.
struct Group {
  std::vector<NodeId> nodes;
  double weight = 0;
  double sum = 0;

  double Mean() const { return sum / weight; }
};

// Groups of nodes by one coordinate.
class SharedCoordinate {
 public:
  SharedCoordinate(int axis, const std::vector<Eigen::Vector3d>& places,
                   const std::vector<Eigen::Matrix3d>& covariances)
      : axis_(axis), places_(places), of_node_(places.size()), groups_(places.size()) {
    std::iota(of_node_.begin(), of_node_.end(), 0);
    for (size_t node = 0; node < places.size(); ++node) {
      variances_.push_back(covariances[node](axis, axis));
      const double weight = variances_[node] > 0 ? 1 / variances_[node] : 0;
      groups_[node] = {{static_cast<NodeId>(node)}, weight, weight * places[node][axis]};
    }
  }

  // Joins what is at both ends of a line, if no node has to move too far.
  void Join(const FlatLine& line) {
    const int a = of_node_[line.node0], b = of_node_[line.node1];
    if (a == b || !(variances_[line.node0] > 0) || !(variances_[line.node1] > 0)) return;
    const double mean = (groups_[a].sum + groups_[b].sum) / (groups_[a].weight + groups_[b].weight);
    if (!AllMayMove(groups_[a], mean) || !AllMayMove(groups_[b], mean)) return;
    const int into = groups_[a].nodes.size() >= groups_[b].nodes.size() ? a : b;
    Group& kept = groups_[into];
    Group& joined = groups_[into == a ? b : a];
    kept.weight += joined.weight;
    kept.sum += joined.sum;
    for (const NodeId node : joined.nodes) of_node_[node] = into;
    kept.nodes.insert(kept.nodes.end(), joined.nodes.begin(), joined.nodes.end());
    joined = {};
  }

  void Apply(std::vector<Eigen::Vector3d>* places) const {
    for (const Group& group : groups_) {
      if (group.nodes.size() < 2) continue;
      for (const NodeId node : group.nodes) (*places)[node][axis_] = group.Mean();
    }
  }

 private:
  bool AllMayMove(const Group& group, double to) const {
    return std::ranges::all_of(group.nodes, [&](NodeId node) {
      return std::abs(places_[node][axis_] - to) <= kSigmas * std::sqrt(variances_[node]);
    });
  }

  int axis_;
  const std::vector<Eigen::Vector3d>& places_;
  std::vector<double> variances_;
  std::vector<int> of_node_;
  std::vector<Group> groups_;
};

// Lines along the other axis, the longest first.
std::vector<FlatLine> LinesAcross(int axis, const std::vector<Eigen::Vector3d>& places,
                                  const std::vector<FlatLine>& lines) {
  const auto way = [&](const FlatLine& line) {
    return Eigen::Vector3d((places[line.node1] - places[line.node0]).cwiseAbs());
  };
  std::vector<FlatLine> across;
  for (const FlatLine& line : lines) {
    if (way(line)[axis] <= kMaxSlope * way(line)[1 - axis]) across.push_back(line);
  }
  std::ranges::stable_sort(across, std::greater<>(),
                           [&](const FlatLine& line) { return way(line)[1 - axis]; });
  return across;
}

// Gives back their places to the nodes of lines that would be no longer than a tenth of what they
// were, until there are none.
void UndoShrinking(const std::vector<Eigen::Vector3d>& measured, const std::vector<FlatLine>& lines,
                   std::vector<Eigen::Vector3d>* places) {
  constexpr double kLeastShare = 0.1;
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (const auto& [a, b] : lines) {
      const double before = (measured[b] - measured[a]).norm();
      const bool is_moved = (*places)[a] != measured[a] || (*places)[b] != measured[b];
      if (!is_moved || ((*places)[b] - (*places)[a]).norm() > kLeastShare * before) continue;
      (*places)[a] = measured[a];
      (*places)[b] = measured[b];
      has_changed = true;
    }
  }
}

}  // namespace

std::vector<Eigen::Vector3d> LevelNodes(std::vector<Eigen::Vector3d> places,
                                        const std::vector<Eigen::Matrix3d>& covariances,
                                        const std::vector<FlatLine>& lines) {
  const std::vector<Eigen::Vector3d> measured = places;
  for (const int axis : {0, 1}) {
    SharedCoordinate shared(axis, measured, covariances);
    for (const FlatLine& line : LinesAcross(axis, measured, lines)) shared.Join(line);
    shared.Apply(&places);
  }
  UndoShrinking(measured, lines, &places);
  return places;
}

}  // namespace limn
