// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/face_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include <Eigen/Eigenvalues>

#include "limn/geometry/spatial_index.h"

namespace limn {
namespace {

// Two straight links tell a plane if their directions differ by more than 20 degrees.
constexpr double kMaxCosine = 0.94;
// Ends are neighbors within this many bridges, and of the inside of another link within one.
constexpr double kNeighborBridges = 1.5;

struct Plane {
  Eigen::Vector3d normal;
  double offset;
};

// Sums from which the plane of links follows, weighted by length, in px. Coordinates may be large
// where a scene is in a national grid: sums are of offsets from a place among the links.
class PlaneFit {
 public:
  explicit PlaneFit(const Eigen::Vector3d& origin) : origin_(origin) {}

  void Add(const FaceLink& link) {
    const double weight = link.length_px / static_cast<double>(link.samples.size()) /
                          (link.footprint * link.footprint);
    for (const Eigen::Vector3d& sample : link.samples) {
      const Eigen::Vector3d offset = sample - origin_;
      weight_ += weight;
      first_ += weight * offset;
      second_ += weight * offset * offset.transpose();
    }
  }
  Plane Fit() const {
    const Eigen::Vector3d center = first_ / weight_;
    const Eigen::Matrix3d moments = second_ / weight_ - center * center.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
    const Eigen::Vector3d normal = solver.eigenvectors().col(0);
    return {normal, normal.dot(origin_ + center)};
  }

 private:
  Eigen::Vector3d origin_;
  double weight_ = 0;
  Eigen::Vector3d first_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second_ = Eigen::Matrix3d::Zero();
};

// Per link, the links that meet it or come near, ascending.
std::vector<std::vector<int>> FindNeighbors(const std::vector<FaceLink>& links,
                                            const SurfaceOptions& options) {
  std::vector<Eigen::Vector3d> places;
  std::vector<int> link_of;
  for (size_t l = 0; l < links.size(); ++l) {
    places.insert(places.end(), links[l].samples.begin(), links[l].samples.end());
    link_of.insert(link_of.end(), links[l].samples.size(), static_cast<int>(l));
  }
  std::vector<std::vector<int>> neighbors(links.size());
  if (places.empty()) return neighbors;
  const SpatialIndex index(places);
  std::vector<SpatialIndex::Neighbor> found;
  for (size_t l = 0; l < links.size(); ++l) {
    const double radius = kNeighborBridges * options.max_bridge_px * links[l].footprint;
    for (const Eigen::Vector3d& end : {links[l].samples.front(), links[l].samples.back()}) {
      index.FindWithin(end, radius, &found);
      for (const auto& neighbor : found) {
        const int other = link_of[neighbor.index];
        if (other == static_cast<int>(l)) continue;
        neighbors[l].push_back(other);
        neighbors[other].push_back(static_cast<int>(l));
      }
    }
  }
  for (std::vector<int>& of_link : neighbors) {
    std::ranges::sort(of_link);
    of_link.erase(std::unique(of_link.begin(), of_link.end()), of_link.end());
  }
  return neighbors;
}

struct Hypothesis {
  double length_px = 0;    // of the shorter link
  std::vector<int> links;  // ascending
};

bool IsSubset(const std::vector<int>& part, const std::vector<int>& whole) {
  return std::ranges::includes(whole, part);
}

// Adds links that are not there yet.
void Join(const std::vector<int>& more, std::vector<int>* members) {
  std::vector<int> joined;
  std::ranges::set_union(*members, more, std::back_inserter(joined));
  *members = std::move(joined);
}

// Planes as they are found, by their links.
class GrownPlanes {
 public:
  explicit GrownPlanes(size_t num_links) : planes_of_(num_links) {}

  // Whether links, at least one, are all in one plane.
  bool Have(const std::vector<int>& links) const {
    return std::ranges::any_of(planes_of_[links.front()],
                               [&](int p) { return IsSubset(links, planes_[p].members); });
  }
  void Add(FacePlane plane) {
    for (const int l : plane.members) planes_of_[l].push_back(static_cast<int>(planes_.size()));
    planes_.push_back(std::move(plane));
  }
  std::vector<FacePlane> Take() { return std::move(planes_); }

 private:
  std::vector<FacePlane> planes_;
  std::vector<std::vector<int>> planes_of_;  // per link
};

class FacePlaneFinder {
 public:
  FacePlaneFinder(const std::vector<FaceLink>& links, const DrawingGraph& graph,
                  const SurfaceOptions& options)
      : links_(links),
        graph_(graph),
        options_(options),
        neighbors_(FindNeighbors(links, options)) {}

  // Longest first.
  std::vector<Hypothesis> Hypotheses() const {
    const double tolerance = options_.plane_tolerance_px;
    std::vector<Hypothesis> hypotheses;
    for (size_t l = 0; l < links_.size(); ++l) {
      const FaceLink& link = links_[l];
      const int id = static_cast<int>(l);
      if (!link.IsStraight(2 * tolerance) && link.twist_px <= tolerance) {
        hypotheses.push_back({link.length_px, {id}});
      }
      for (const int other : neighbors_[l]) {
        if (other < id || std::abs(link.direction.dot(links_[other].direction)) > kMaxCosine) {
          continue;
        }
        hypotheses.push_back({std::min(link.length_px, links_[other].length_px), {id, other}});
      }
    }
    std::ranges::stable_sort(hypotheses, std::greater<>(), &Hypothesis::length_px);
    return hypotheses;
  }

  // Empty members if the links of the hypothesis are in no plane.
  FacePlane Grow(const Hypothesis& hypothesis) const {
    std::set<int> members(hypothesis.links.begin(), hypothesis.links.end());
    PlaneFit fit(links_[hypothesis.links.front()].center);
    for (const int l : members) fit.Add(links_[l]);
    Plane plane = fit.Fit();
    std::vector<int> fresh = hypothesis.links;
    while (!fresh.empty()) {
      std::set<int> next;
      for (const int l : fresh) next.insert(neighbors_[l].begin(), neighbors_[l].end());
      fresh.clear();
      for (const int l : next) {
        if (!members.contains(l) && IsIn(l, plane)) fresh.push_back(l);
      }
      for (const int l : fresh) fit.Add(links_[l]);
      members.insert(fresh.begin(), fresh.end());
      plane = fit.Fit();
    }
    FacePlane grown = {plane.normal, plane.offset, {}};
    std::ranges::copy_if(members, std::back_inserter(grown.members),
                         [&](int l) { return IsIn(l, plane); });
    if (!IsSubset(hypothesis.links, grown.members) || !MayBound(grown.members)) {
      grown.members.clear();
    }
    return grown;
  }

  bool AreIn(const std::vector<int>& members, const FacePlane& plane) const {
    return std::ranges::all_of(members, [&](int l) {
      return LiesIn(links_[l], plane.normal, plane.offset, options_.plane_tolerance_px);
    });
  }

  double LengthPx(const FacePlane& plane) const {
    double length = 0;
    for (const int l : plane.members) length += links_[l].length_px;
    return length;
  }

 private:
  bool IsIn(int l, const Plane& plane) const {
    return LiesIn(links_[l], plane.normal, plane.offset, options_.plane_tolerance_px);
  }
  bool MayBound(const std::vector<int>& members) const {
    return members.size() >= 3 ||
           std::ranges::any_of(members, [&](int l) { return graph_.links[links_[l].link].closed; });
  }

  const std::vector<FaceLink>& links_;
  const DrawingGraph& graph_;
  const SurfaceOptions& options_;
  std::vector<std::vector<int>> neighbors_;
};

}  // namespace

std::vector<FacePlane> FindFacePlanes(const std::vector<FaceLink>& links, const DrawingGraph& graph,
                                      const SurfaceOptions& options, const RunContext& context) {
  const FacePlaneFinder finder(links, graph, options);
  GrownPlanes found(links.size());
  for (const Hypothesis& hypothesis : finder.Hypotheses()) {
    ThrowIfCancelled(context);
    if (found.Have(hypothesis.links)) continue;
    FacePlane plane = finder.Grow(hypothesis);
    if (!plane.members.empty() && !found.Have(plane.members)) found.Add(std::move(plane));
  }
  std::vector<FacePlane> grown = found.Take();
  std::ranges::stable_sort(grown, std::greater<>(),
                           [&](const FacePlane& plane) { return finder.LengthPx(plane); });
  std::vector<FacePlane> planes;
  for (FacePlane& plane : grown) {
    const auto known = std::ranges::find_if(
        planes, [&](const FacePlane& other) { return finder.AreIn(plane.members, other); });
    if (known == planes.end()) {
      planes.push_back(std::move(plane));
    } else {
      Join(plane.members, &known->members);
    }
  }
  return planes;
}

}  // namespace limn
