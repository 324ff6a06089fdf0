// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/reduce_to_wireframe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "limn/geometry/spatial_index.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr double kToleranceShare = 0.01;
constexpr double kLeftOutShare = 0.02;

using CornerEdges = std::set<std::pair<int, int>>;

auto CoordinatesOf(const Eigen::Vector3d& point) {
  return std::tuple(point.x(), point.y(), point.z());
}

bool ComesBefore(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return CoordinatesOf(a) < CoordinatesOf(b);
}

// Of an edge of two corners, which it sorts; nothing of one.
void AddEdge(int a, int b, CornerEdges* edges) {
  if (a != b) edges->insert(std::minmax(a, b));
}

// A closed line turned so that it begins at the point that is farthest from its first: a corner.
Polyline3d TurnedToFarthest(Polyline3d line) {
  const Eigen::Vector3d first = line.front();
  const auto distance = [&](const Eigen::Vector3d& point) { return (point - first).norm(); };
  line.pop_back();
  std::rotate(line.begin(), std::ranges::max_element(line, {}, distance), line.end());
  line.push_back(line.front());
  return line;
}

// The graph of polylines that share positions; its corners are in the order of coordinates.
class CornerGraph {
 public:
  explicit CornerGraph(const std::vector<Polyline3d>& polylines) {
    for (const Polyline3d& line : polylines) {
      corners_.insert(corners_.end(), line.begin(), line.end());
    }
    std::ranges::sort(corners_, ComesBefore);
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    for (const Polyline3d& line : polylines) {
      for (size_t i = 1; i < line.size(); ++i) {
        AddEdge(IndexOf(line[i - 1]), IndexOf(line[i]), &edges_);
      }
    }
  }

  // Moves corners to others; a corner is moved to itself or to one that stays.
  void Merge(double distance) {
    const std::vector<int> home = HomesOf(distance);
    CornerEdges merged;
    for (const auto& [a, b] : edges_) AddEdge(home[a], home[b], &merged);
    edges_ = std::move(merged);
  }

  // From corner to corner of a degree other than 2, from the first of the two; then closed ones
  // without such a corner.
  std::vector<Polyline3d> Chains() const {
    const std::vector<std::vector<int>> neighbors = Neighbors();
    CornerEdges left = edges_;
    std::vector<Polyline3d> chains;
    const auto walk = [&](int from, int to) {
      Polyline3d chain = {corners_[from]};
      while (left.erase(std::minmax(from, to)) > 0) {
        chain.push_back(corners_[to]);
        if (neighbors[to].size() != 2) break;
        const int next = neighbors[to][neighbors[to][0] == from ? 1 : 0];
        from = std::exchange(to, next);
      }
      return chain;
    };
    for (size_t i = 0; i < neighbors.size(); ++i) {
      if (neighbors[i].size() == 2) continue;
      for (const int neighbor : neighbors[i]) {
        if (left.contains(std::minmax(static_cast<int>(i), neighbor))) {
          chains.push_back(walk(static_cast<int>(i), neighbor));
        }
      }
    }
    while (!left.empty()) {
      const auto [first, second] = *left.begin();
      chains.push_back(TurnedToFarthest(walk(first, second)));
    }
    return chains;
  }

  Wireframe ToWireframe() const {
    Wireframe wireframe;
    std::map<int, int> places;
    for (const auto& [a, b] : edges_) places[a] = places[b] = 0;
    for (auto& [corner, place] : places) {
      place = static_cast<int>(wireframe.vertices.size());
      wireframe.vertices.push_back(corners_[corner]);
    }
    for (const auto& [a, b] : edges_) wireframe.edges.emplace_back(places.at(a), places.at(b));
    return wireframe;
  }

 private:
  int IndexOf(const Eigen::Vector3d& point) const {
    const auto found = std::lower_bound(corners_.begin(), corners_.end(), point, ComesBefore);
    return static_cast<int>(found - corners_.begin());
  }

  std::vector<std::vector<int>> Neighbors() const {
    std::vector<std::vector<int>> neighbors(corners_.size());
    for (const auto& [a, b] : edges_) {
      neighbors[a].push_back(b);
      neighbors[b].push_back(a);
    }
    return neighbors;
  }

  // Per corner, the one that it is moved to.
  std::vector<int> HomesOf(double distance) const {
    const std::vector<std::vector<int>> neighbors = Neighbors();
    std::vector<int> order(corners_.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::greater(),
                             [&](int corner) { return neighbors[corner].size(); });
    std::vector<int> home(corners_.size(), -1);
    const SpatialIndex index(corners_);
    std::vector<SpatialIndex::Neighbor> found;
    for (const int corner : order) {
      if (home[corner] >= 0) continue;
      home[corner] = corner;
      // FindWithin leaves out what is at exactly this distance.
      index.FindWithin(corners_[corner], std::nextafter(distance, 2 * distance), &found);
      for (const SpatialIndex::Neighbor& near : found) {
        if (home[near.index] < 0) home[near.index] = corner;
      }
    }
    return home;
  }

  std::vector<Eigen::Vector3d> corners_;
  CornerEdges edges_;
};

std::vector<Polyline3d> ChordsOf(const std::vector<Polyline3d>& lines, double max_distance) {
  std::vector<Polyline3d> chords;
  for (const Polyline3d& line : lines) chords.push_back(Simplified(line, max_distance));
  return chords;
}

struct CoordinateOfLength {
  double at = 0;
  double length = 0;
};

// What is left between the ends that are left out.
double ExtentOf(std::vector<CoordinateOfLength> places) {
  std::ranges::sort(places, {}, &CoordinateOfLength::at);
  double total = 0;
  for (const CoordinateOfLength& place : places) total += place.length;
  const auto reached = [&](double length) {
    for (const CoordinateOfLength& place : places) {
      length -= place.length;
      if (length <= 0) return place.at;
    }
    return places.back().at;
  };
  return reached((1 - kLeftOutShare) * total) - reached(kLeftOutShare * total);
}

}  // namespace

double DefaultWireframeTolerance(const std::vector<Polyline3d>& polylines) {
  std::array<std::vector<CoordinateOfLength>, 3> places;
  for (const Polyline3d& line : polylines) {
    for (size_t i = 1; i < line.size(); ++i) {
      const double length = (line[i] - line[i - 1]).norm();
      if (!std::isfinite(length)) continue;  // ReduceToWireframe refuses it
      for (int axis = 0; axis < 3; ++axis) {
        // Half of a segment at either end.
        places[axis].push_back({line[i - 1][axis], length / 2});
        places[axis].push_back({line[i][axis], length / 2});
      }
    }
  }
  if (places[0].empty()) return 0;
  return kToleranceShare *
         Eigen::Vector3d(ExtentOf(places[0]), ExtentOf(places[1]), ExtentOf(places[2])).norm();
}

Wireframe ReduceToWireframe(const std::vector<Polyline3d>& polylines,
                            const WireframeOptions& options) {
  options.Check();
  for (const Polyline3d& line : polylines) {
    for (const Eigen::Vector3d& point : line) {
      if (!point.allFinite()) throw InputError("wireframe: a point is not finite");
    }
  }
  const double tolerance =
      options.tolerance > 0 ? options.tolerance : DefaultWireframeTolerance(polylines);
  CornerGraph graph(ChordsOf(CornerGraph(polylines).Chains(), tolerance / 2));
  graph.Merge(tolerance);
  return CornerGraph(ChordsOf(graph.Chains(), tolerance / 2)).ToWireframe();
}

}  // namespace limn
