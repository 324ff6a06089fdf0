#pragma once

#include <map>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"

namespace limn {

// Changes of a drawing's topology. They leave `incident` and `kind` of the nodes to
// RebuildIncidence, and may leave nodes without links to RemoveLinks.

// The straight line on which a link leaves at an end, through its last pixels without the outermost
// ones, which corners round. Zero direction for a link without extent.
struct LinkTip {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // of the line, nearest to the end
  Eigen::Vector3d outward = Eigen::Vector3d::Zero();
};
LinkTip TipOf(const DrawingLink& link, int end, double footprint);

NodeId NodeAt(const DrawingLink& link, int end);

// Cut an open link at an inner point, or begin and end a closed one there. Returns the new node;
// the second part of an open link is the last link. The parts share the members.
NodeId SplitLink(LinkId id, int index, DrawingGraph* graph);

// A free end goes to a node: what overshoots it is cut.
void EndLinkAt(const LinkEnd& end, NodeId node, DrawingGraph* graph);

// Two free ends become one: the link of `b` is appended to that of `a` and keeps nothing; it must
// be removed. If both are of one link it is closed then.
void JoinEnds(const LinkEnd& a, const LinkEnd& b, DrawingGraph* graph);

// Where ends are after links were appended to others.
class EndMoves {
 public:
  LinkEnd Now(LinkEnd end) const;
  // After JoinEnds of two links.
  void Joined(const LinkEnd& a, const LinkEnd& b);

 private:
  std::map<LinkEnd, LinkEnd> moved_;
};

}  // namespace limn
