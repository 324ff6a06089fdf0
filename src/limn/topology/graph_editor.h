#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"

namespace limn {

// Changes the topology of a drawing; every cut and every join of links is made here. After each
// edit the graph without what was removed passes Validate: ends are at their nodes, incidence,
// kinds of nodes and continuations hold. A link is closed exactly when its two ends are alone at
// one node. Ids stay until Compact(): what is removed leaves a gap (IsLink, IsNode).
//
// Edits that change the course of a link drop its primitive and its dense class. Parts of a link
// share its members and supporting views; links that become one unite theirs.
class GraphEditor {
 public:
  // The graph must pass Validate. It is changed in place and valid again after Compact().
  explicit GraphEditor(DrawingGraph* graph);

  const DrawingGraph& graph() const { return *graph_; }
  const DrawingLink& link(LinkId id) const { return graph_->links[id]; }
  const DrawingNode& node(NodeId id) const { return graph_->nodes[id]; }
  bool IsLink(LinkId id) const { return graph_->links[id].node0 >= 0; }
  bool IsNode(NodeId id) const { return !graph_->nodes[id].incident.empty(); }
  int NumLinks() const { return static_cast<int>(graph_->links.size()); }
  NodeId NodeAt(const LinkEnd& end) const { return link(end.link).NodeAt(end.end); }
  bool IsFree(const LinkEnd& end) const { return node(NodeAt(end)).Degree() == 1; }
  // Ends that are alone at their node, ascending.
  std::vector<LinkEnd> FreeEnds() const;

  // Add a link with its points, sigmas and whatever else is known of it. Ends without a node (-1)
  // get a new one; others must be where their node is. A link that returns to its first point is
  // closed. Constant time per point.
  LinkId Add(DrawingLink link);
  void Remove(LinkId id);
  // A node for ends to come: gone with the next Compact() if none has come.
  NodeId AddNode(Eigen::Vector3d position);

  // Cut an open link at an inner point; the second part is the last link. A closed link, cut at any
  // point, begins and ends there, and is open once another end comes to it. Returns the node at the
  // cut. Linear in the points of the link.
  NodeId Split(LinkId id, int index);

  // Cut a closed link at a point: it is open, with two free ends there.
  void Open(LinkId id, int index);

  // Take a free end to a node: points that overshoot it are cut off, then the node is the end.
  void EndAt(const LinkEnd& end, NodeId node);
  // An end that shares its node gets one of its own at the same place.
  void Free(const LinkEnd& end);
  // Cut off all but the points [begin, end) of a link, at least two; ends that are cut are free.
  // What supported the points cut off is gone.
  void CutTo(LinkId id, int begin, int end);
  // The same at one end: cut off points beyond `place` as seen along the end, so that what is added
  // next does not run back. What supported them now supports the new end. Keeps `min_points`.
  void DropOvershoot(const LinkEnd& end, const Eigen::Vector3d& place, int min_points = 2);

  // Make two ends one: two free ends, or the two that are alone at one node. The link of `b` is
  // appended to that of `a`, in whose direction the whole runs, and is removed; the two ends of one
  // link close it. A joint at one place keeps one point of the two.
  void Join(const LinkEnd& a, const LinkEnd& b);
  // Where an end went that Join appended to another link.
  LinkEnd Now(LinkEnd end) const;

  void Reverse(LinkId id);
  void MoveNode(NodeId id, const Eigen::Vector3d& position);
  // Move a point of a link between its ends.
  void MovePoint(LinkId id, int index, const Eigen::Vector3d& position);

  // Remove links marked 0, then close the gaps; ids change, the order does not. Linear time.
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
  std::map<LinkEnd, LinkEnd> moved_;  // of links that were appended to others
};

}  // namespace limn
