// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limn/editing/edits.h"
#include "limn/geometry/spatial_index.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// The links of a drawing that a reference means.
struct LinkMatch {
  // Links that lie along the reference with most of their length: the link itself, or the pieces
  // that it is in now. Ascending.
  std::vector<LinkId> along;
  // Links that contain the reference: most of it lies along them, but they extend much farther.
  std::vector<LinkId> longer;
  // Two links fit equally well, side by side, and the id does not tell which.
  std::vector<LinkId> tied;
  // Share of the reference's length that `along` covers.
  double covered = 0;

  bool IsAmbiguous() const { return !tied.empty(); }
  // Exactly one link along the reference; nothing otherwise.
  std::optional<LinkId> Single() const;
  // Why no link, or no single link, matches; for messages.
  std::string Problem() const;
};

// Matches references to links by geometry: how near and how parallel the two run, in px, and over
// how much of both. Of links side by side the nearest matches; the id decides between equally near
// ones. `graph` and `views` must outlive it.
class LinkMatcher {
 public:
  // Largest distance between a link and a reference to it, px: scenes redrawn from other
  // photographs differ by one or two.
  static constexpr double kMatchPx = 3;

  // O(n log n) in the length of all links in px.
  LinkMatcher(const DrawingGraph& graph, const std::vector<View>& views);

  // Call it when a link was changed, added or removed. Time: on average the square root of the
  // length of all links in px.
  void Update(LinkId id);

  // Time: length of the reference in px, times log n.
  LinkMatch Match(const LinkRef& ref) const;

  // World units per px at a place.
  double FootprintAt(const Eigen::Vector3d& place) const;

 private:
  struct Sample {
    LinkId link = -1;
    int number = 0;  // along the link
    Eigen::Vector3d position, direction;
    double half_step = 0;  // it stands for this length to either side
  };

  void AddSamples(LinkId id, std::vector<Sample>* samples);
  void Rebuild();
  void ForEachWithin(const Eigen::Vector3d& place, double radius,
                     const std::function<void(const Sample&)>& visit) const;

  const DrawingGraph& graph_;
  const std::vector<View>& views_;
  std::vector<Sample> samples_;  // those of changed links are out of date
  std::optional<SpatialIndex> index_;
  std::vector<Sample> changed_samples_;  // of changed links, not in the index
  std::vector<uint8_t> is_changed_;      // per link
  std::vector<int> num_samples_;         // per link
  double longest_half_step_ = 0;         // of all samples
};

}  // namespace limn
