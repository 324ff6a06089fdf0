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

// How far from the end of a link, seen along its line, something may be that it is taken to, px.
struct Reach {
  double gap_px = 0;        // ahead of the end
  double overshoot_px = 0;  // behind it: edges are rounded where they meet
  double miss_px = 0;       // beside the line

  // Of links as they were drawn; and of links fitted to the images, which are better known.
  static Reach Drawn(const TopologyOptions& options);
  static Reach Fitted(const TopologyOptions& options);

  double Radius() const { return gap_px + overshoot_px + miss_px; }

  // A place seen from a tip: along the tip's line and beside it, px.
  struct Offset {
    double along_px = 0;
    double miss_px = 0;
  };
  // Nothing out of reach. A curve that turns by `turn_rad` on the way may miss by
  // more.
  std::optional<Offset> To(const LinkTip& tip, const Eigen::Vector3d& place,
                           double turn_rad = 0) const;
};

// A gap this small needs no support in the images.
constexpr double kSmallGapPx = 3;

// All points of the links that have vertices.
struct Places {
  std::vector<Eigen::Vector3d> position;
  std::vector<std::pair<LinkId, int>> point;  // link, index
};
Places CollectPlaces(const DrawingGraph& graph);

// The fragments, per view, that support a stretch of a link.
using FragmentsByView = std::map<ViewId, std::set<int>>;
FragmentsByView FragmentsAround(const TopologyInput& input, const DrawingLink& link, int index);
FragmentsByView FragmentsAtEnd(const TopologyInput& input, const DrawingLink& link, int end);

// In `min_views` views image curves of both stretches come near the projection of the point.
bool ImagesAgree(const TopologyInput& input, const Eigen::Vector3d& point, const FragmentsByView& a,
                 const FragmentsByView& b, int min_views);

// Pair the ends at a node that go on most smoothly in each other, each at most once. Nodes stay as
// they are at which no link has vertices.
void PairContinuations(const TopologyOptions& options, NodeId node, DrawingGraph* graph);

struct MeetingCounts {
  int64_t joined = 0;    // pairs of ends that became one
  int64_t corners = 0;   // nodes made of two or more free ends
  int64_t to_nodes = 0;  // ends taken to a node, and to the inside of a link
  int64_t to_links = 0;
  int64_t refused = 0;  // meetings in space that the images do not show
};

}  // namespace limn
