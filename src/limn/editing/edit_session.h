// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limn/editing/edit_outcome.h"
#include "limn/editing/edits.h"
#include "limn/editing/match_links.h"
#include "limn/geometry/polyline.h"
#include "limn/topology/graph_editor.h"
#include "limn/topology/link_geometry.h"
#include "limn/topology/topology_options.h"
#include "limn/util/angles.h"

namespace limn {

// A place on a link of the drawing.
struct LinkPlace {
  LinkId link = -1;
  PolylinePoint point;
};

// What a reference means, or why it means nothing.
template <typename Found>
struct Search {
  std::optional<Found> found;
  EditOutcome problem;
};

// The state that edits share while they are applied to a drawing.
class EditSession {
 public:
  EditSession(const std::vector<View>& views, const TopologyOptions& topology, DrawingGraph* graph);

  GraphEditor& editor() { return editor_; }
  const TopologyOptions& topology() const { return topology_; }
  // Ends continue each other below this turn.
  double MaxTurnRad() const { return topology_.max_continuation_angle_deg * kDeg; }
  const LinkMatcher& matcher() const { return matcher_; }
  const DrawingLink& link(LinkId id) const { return editor_.link(id); }
  // World units per px.
  double FootprintAt(const Eigen::Vector3d& place) const { return matcher_.FootprintAt(place); }

  // The one link that the whole reference means.
  Search<LinkId> FindLink(const LinkRef& ref) const;
  Search<LinkPlace> FindPlace(const PlaceRef& ref) const;
  Search<LinkEnd> FindEnd(const EndRef& ref) const;

  // Marks a link as changed. A link that has shrunk to a point is removed.
  void Touch(LinkId id);
  void TouchAllAt(NodeId id);
  void Remove(LinkId id);
  void SetKindByHand(LinkId id, LinkKind kind);
  // Records that part of the link `from` is now `to`; a kind set by hand carries over.
  void ShareKind(LinkId from, LinkId to);
  // Joins two ends (GraphEditor::Join). A kind set by hand stays.
  void Join(const LinkEnd& a, const LinkEnd& b);
  // Adds a link to another that shows the same curve (GraphEditor::Unify).
  void Unify(LinkId id, LinkId other);
  // Splits a link at a place; returns the node, and the second part if there is one.
  NodeId SplitAt(const LinkPlace& place, LinkId* second);
  // Finds out which ends at a node continue each other.
  void PairAt(NodeId id);
  LinkTip TipAt(const LinkEnd& end) const;
  void NoteGap(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

  size_t edit = 0;                // index of the one that is being applied
  std::set<LinkId> touched;       // may name links that were removed since
  std::set<LinkId> kind_by_hand;  // likewise
  std::set<LinkId> cut_loops;     // closed links that begin where a user cut them
  std::vector<BridgedGap> gaps;

 private:
  GraphEditor editor_;
  LinkMatcher matcher_;
  const TopologyOptions& topology_;
};

// One function per edit; the remaining edits are in apply_edits.cc.
EditOutcome ApplySplit(const SplitLink& edit, EditSession* session);
EditOutcome ApplyJoin(const JoinEnds& edit, EditSession* session);
EditOutcome ApplyMerge(const MergeLinks& edit, EditSession* session);

}  // namespace limn
