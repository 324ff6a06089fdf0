// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "limn/topology/graph_editor.h"
#include "limn/topology/link_geometry.h"
#include "limn/topology/topology_input.h"
#include "limn/topology/topology_options.h"

namespace limn {

// How far from the tip of a link a place may be for the end to go there, px
// (algorithm/topology.md#reach).
struct Reach {
  double gap_px = 0;        // ahead of the end
  double overshoot_px = 0;  // behind it: edges are rounded at corners
  double miss_px = 0;       // beside the line

  // For links before and after they are fitted to the images, which makes them more accurate.
  static Reach Drawn(const TopologyOptions& options);
  static Reach Fitted(const TopologyOptions& options);

  double Radius() const { return gap_px + overshoot_px + miss_px; }

  // Position of a place relative to a tip: along its line, and the distance from that line, px.
  struct Offset {
    double along_px = 0;
    double miss_px = 0;
  };
  // Empty if out of reach. A curve that turns by `turn_rad` on the way may miss by more.
  std::optional<Offset> To(const LinkTip& tip, const Eigen::Vector3d& place,
                           double turn_rad = 0) const;
};

// Gaps up to this need no support in the images. Wider: more false junctions.
constexpr double kSmallGapPx = 3;

struct MeetingCounts {
  int64_t joined = 0;    // pairs of ends merged into one
  int64_t corners = 0;   // nodes made of two or more free ends
  int64_t to_nodes = 0;  // ends moved to a node
  int64_t to_links = 0;  // ends moved to an interior point of a link
  int64_t refused = 0;   // meetings in space that the images do not confirm, last pass
};

// The shared state of the steps that bring free ends together.
struct MeetingTask {
  const TopologyInput& input;
  const TopologyOptions& options;
  Reach reach;
  GraphEditor* editor;
  MeetingCounts* counts;
};

// The points of all links with vertices.
struct Places {
  std::vector<Eigen::Vector3d> position;
  std::vector<std::pair<LinkId, int>> point;  // link, index
};
Places CollectPlaces(const DrawingGraph& graph);

// Per view, the fragments that support a stretch of a link around a point or at an end; none of a
// link without vertices.
using FragmentsByView = std::map<ViewId, std::set<int>>;
FragmentsByView FragmentsAround(const TopologyInput& input, const DrawingLink& link, int index);
FragmentsByView FragmentsAtEnd(const TopologyInput& input, const DrawingLink& link, int end);

// Returns whether, in at least `min_views` views, fragments of both stretches pass near the
// projection of the point (algorithm/topology.md#agreement-of-images).
bool ImagesAgree(const TopologyInput& input, const Eigen::Vector3d& point, const FragmentsByView& a,
                 const FragmentsByView& b, int min_views);

// Pairs the ends at each node that continue each other, smoothest first, each end at most once. A
// node none of whose links has vertices keeps its pairs.
void PairContinuations(const TopologyOptions& options, DrawingGraph* graph);

}  // namespace limn
