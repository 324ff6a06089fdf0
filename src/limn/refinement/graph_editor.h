#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"
#include "limn/model/graph_edits.h"
#include "limn/model/view.h"
#include "limn/refinement/refinement_options.h"
#include "limn/support/edgel_index.h"
#include "limn/support/segment_evidence.h"

namespace limn {

// Links that meet part by more than this, rad; those nearer to each other are one edge.
constexpr double kMinPartingRad = 0.44;
// Ends that go on in each other turn by less than this, rad.
constexpr double kMaxTurnRad = 0.52;
// A gap of up to so many px needs no edgels of its own.
constexpr double kSmallGapPx = 3;
// Largest gap that is closed, and how far its sides may miss each other sideways, px.
constexpr double kMaxGapPx = 12;
constexpr double kMaxMissPx = 1.5;

// A drawing while its topology is edited: links that are not frozen have a point every px at the
// beginning, and each knows its pixel footprint. What all edits (topology_edits.h) ask and do. The
// incidence of the graph's nodes holds between edits.
class GraphEditor {
 public:
  GraphEditor(const std::vector<View>& views,
              const std::vector<std::unique_ptr<EdgelIndex>>& edgels,
              const RefinementOptions& options, const std::vector<uint8_t>& frozen,
              DrawingGraph* graph);

  DrawingGraph& graph() { return *graph_; }
  const DrawingGraph& graph() const { return *graph_; }
  const DrawingLink& link(LinkId id) const { return graph_->links[id]; }
  // World units per px at its middle; 0 if no view sees it.
  double FootprintOf(LinkId id) const { return footprint_[id]; }
  // Frozen, or no view sees it.
  bool IsLeftAlone(LinkId id) const { return left_alone_[id] != 0; }

  bool HasPlaces() const;  // not all links are left alone
  // Ends that are alone at their node, ascending.
  std::vector<LinkEnd> FreeEnds() const;
  LinkTip Tip(const LinkEnd& end) const;
  // Unit direction of a link at one of its points.
  Eigen::Vector3d DirectionAt(LinkId id, int index) const;

  // All points of all links that are not left alone.
  struct Places {
    std::vector<Eigen::Vector3d> position;
    std::vector<Eigen::Vector3d> direction;
    std::vector<std::pair<LinkId, int>> point;  // link, index
  };
  Places CollectPlaces() const;

  // A place seen from a tip, px: along the tip's line and beside it.
  struct Offset {
    double along_px = 0;
    double miss_px = 0;
  };
  // Nothing out of reach. On a curve that turns by `turn_rad` on the way it may miss by more.
  std::optional<Offset> Reaches(const LinkTip& tip, const Eigen::Vector3d& place, double footprint,
                                double turn_rad = 0) const;

  // Whether edgels run from one place to the other in enough of the views that show either link,
  // more than by chance.
  bool ImagesShow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, LinkId a, LinkId b) const;

  // Keep the points [begin, end) of an open link with free ends where points go.
  void CutTo(int begin, int end, LinkId id);

  // SplitLink; `smooth`: the parts continue each other.
  NodeId Split(LinkId id, int index, bool smooth);

  // Remove links marked 0, after which ids have changed. Links that return to their own node, alone
  // there, are closed.
  void Keep(const std::vector<uint8_t>& keep);

 private:
  const std::vector<View>& views_;
  const RefinementOptions& options_;
  EdgelIndexes edgels_;
  DrawingGraph* graph_;
  std::vector<double> footprint_;
  std::vector<uint8_t> left_alone_;
};

// The angle between two unit directions, rad, and the angle between the lines along them.
double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);
double LineAngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace limn
