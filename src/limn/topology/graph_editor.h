// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"

namespace limn {

// Edits the topology of a drawing (algorithm/topology.md#edits-of-the-graph). All cutting and
// joining of links is done here. After each edit the graph, apart from removed items, passes
// Validate: ends lie at their nodes, and incidence, kinds of nodes and continuations are
// consistent. A link is closed exactly when its two ends are alone at one node. Ids stay valid
// until Compact(); removed items leave gaps (IsLink, IsNode).
//
// Edits that change the shape of a link drop its primitive, regularity and dense class. The parts
// of a split link share its members, supporting views and kind; joined links unite theirs, take the
// kind of most of their length, weighted by confidence, and are tentative if most of their length
// is.
class GraphEditor {
 public:
  // The graph must pass Validate. It is edited in place, and passes Validate again after Compact().
  // Drops all faces, which must be found again between the edited links.
  explicit GraphEditor(DrawingGraph* graph) : graph_(graph) { graph_->faces.clear(); }

  const DrawingGraph& graph() const { return *graph_; }
  const DrawingLink& link(LinkId id) const { return graph_->links[id]; }
  const DrawingNode& node(NodeId id) const { return graph_->nodes[id]; }
  bool IsLink(LinkId id) const { return graph_->links[id].node0 >= 0; }
  bool IsNode(NodeId id) const { return !graph_->nodes[id].incident.empty(); }
  int NumLinks() const { return static_cast<int>(graph_->links.size()); }
  NodeId NodeAt(const LinkEnd& end) const { return link(end.link).NodeAt(end.end); }
  bool IsFree(const LinkEnd& end) const { return node(NodeAt(end)).Degree() == 1; }
  // Ends that are alone at their nodes, ascending.
  std::vector<LinkEnd> FreeEnds() const;

  // Adds a link with its points, sigmas and other data. Ends without a node (-1) get a new one; the
  // others are moved to their nodes. A link that returns to its first point is closed. Linear in
  // its points.
  LinkId Add(DrawingLink link);
  void Remove(LinkId id);
  // Adds a node for ends to be attached. The next Compact() removes it if there are none.
  NodeId AddNode(Eigen::Vector3d position);

  // Splits an open link at an interior point; the second part becomes the last link. A closed link
  // is only rotated to begin and end at the given point; it opens when one of its ends is freed or
  // another end is attached there. Returns the node at the cut. Linear in the points of the link.
  NodeId Split(LinkId id, int index);

  // Moves a free end to a node: drops points that overshoot it, then appends its position.
  void EndAt(const LinkEnd& end, NodeId node);
  // Moves all ends at a node to another one, as EndAt() does.
  void MoveEnds(NodeId from, NodeId to);
  // Gives an end that shares its node a node of its own, where the link ends.
  void Free(const LinkEnd& end);
  // Keeps only the points [begin, end) of a link, at least two. Ends that were cut are free. The
  // support of the dropped points is lost.
  void CutTo(LinkId id, int begin, int end);
  // Drops points at an end that lie beyond `place` along the link, so that a point appended there
  // does not run back. The new end takes over their support. Keeps two points.
  void DropOvershoot(const LinkEnd& end, Eigen::Vector3d place);

  // Joins two free ends, or the two ends at a node of degree two. The link of `b` is appended to
  // that of `a`, which keeps its direction, and is removed. Joining the two ends of one link closes
  // it. If the two end points coincide, one of them is kept.
  void Join(const LinkEnd& a, const LinkEnd& b);
  // The present name of an end, whose link Join may have appended to another one.
  LinkEnd CurrentEnd(LinkEnd end) const;

  // Removes `other`, which shows the same curve as `id`; `id` gets its members and views.
  void Unify(LinkId id, LinkId other);

  // Adds a point between two neighbors, `t` in (0, 1) from point `segment` to the next one, and
  // returns its index.
  int InsertPoint(LinkId id, int segment, double t);
  void MoveNode(NodeId id, const Eigen::Vector3d& position);
  // Moves an interior point of a link.
  void MovePoint(LinkId id, int index, const Eigen::Vector3d& position);

  // Sets the pairs of ends at a node that continue each other.
  void SetContinuations(NodeId id, std::vector<std::pair<LinkEnd, LinkEnd>> pairs);
  // Sets the kind with full confidence: it is known, not estimated. kRod: of a rod only.
  void SetKind(LinkId id, LinkKind kind);
  // No longer tentative.
  void MakeFirm(LinkId id);

  // Keep removes links marked 0; both then close the gaps. Ids change, the order does not. Linear
  // time.
  void Keep(const std::vector<uint8_t>& keep);
  void Compact();

 private:
  void Attach(const LinkEnd& end, NodeId node);
  void Detach(const LinkEnd& end);
  void Rename(NodeId node, const LinkEnd& from, const LinkEnd& to);
  void UpdateKind(NodeId node);
  void Close(LinkId id);
  void RotateTo(LinkId id, int index);

  DrawingGraph* graph_;
  std::map<LinkEnd, LinkEnd> moved_;  // ends of links that were appended to others
};

}  // namespace limn
