// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/LU>

#include "limn/editing/edit_session.h"
#include "limn/geometry/angle_between.h"
#include "limn/topology/join_ends.h"
#include "limn/topology/meetings.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// Ends farther apart also need the way from one to the other to be within this angle.
constexpr double kMaxGapAngleRad = 45 * kDeg;
// A corner where the lines of two ends meet may be as far from both as this multiple of their
// distance, or as ends that meet in the drawing.
constexpr double kCornerReach = 2;
// A link whose ends meet at a corner is at least this long, px, and longer than their distance by
// this factor: what is nearly straight encloses nothing.
constexpr double kMinLoopPx = 16;
constexpr double kMinLoopOverGap = 1.5;
// Links between two nodes that become one go with them if they are no longer than this multiple of
// the distance.
constexpr double kMaxCollapse = 2;

std::string Name(const LinkEnd& end) {
  return "end " + std::to_string(end.end) + " of link " + std::to_string(end.link);
}

// Whether one smooth curve could lead from one end into the other.
bool ContinueEachOther(const EditSession& session, const LinkEnd& a, const LinkEnd& b) {
  const LinkTip tip_a = session.TipAt(a);
  const LinkTip tip_b = session.TipAt(b);
  if (TurnBetween(tip_a, tip_b) >= session.MaxTurnRad()) return false;
  const Eigen::Vector3d gap =
      EndPoint(session.link(b.link), b.end) - EndPoint(session.link(a.link), a.end);
  return gap.norm() <= kSmallGapPx * tip_a.footprint ||
         LineAngleBetween(tip_a.outward, gap.stableNormalized()) <= kMaxGapAngleRad;
}

bool LiesBehind(const Eigen::Vector3d& place, const LinkTip& tip) {
  return (place - tip.point).dot(tip.outward) < 0;
}

// Where the lines of two ends come nearest to each other, if that is near the ends, else halfway.
// The ends of one link are not cut back, since they might meet in its middle.
Eigen::Vector3d CornerOf(const EditSession& session, const LinkEnd& a, const LinkEnd& b) {
  const Eigen::Vector3d& end_a = EndPoint(session.link(a.link), a.end);
  const Eigen::Vector3d& end_b = EndPoint(session.link(b.link), b.end);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const LinkTip tips[2] = {session.TipAt(a), session.TipAt(b)};
  for (const LinkTip& tip : tips) {
    const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - tip.outward * tip.outward.transpose();
    sum += across;
    right += across * (tip.point - end_a);
  }
  const Eigen::Vector3d middle = 0.5 * (end_a + end_b);
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(sum);
  // The determinant is the sine of the angle between the lines, squared.
  const double least_sine = std::sin(std::min(session.MaxTurnRad(), M_PI / 2));
  if (!(solver.determinant() > least_sine * least_sine)) return middle;
  const Eigen::Vector3d corner = end_a + solver.solve(right);
  const double reach =
      std::max(kCornerReach * (end_b - end_a).norm(),
               session.topology().max_junction_gap_px * session.FootprintAt(middle));
  const double farther = std::max((corner - end_a).norm(), (corner - end_b).norm());
  const bool cuts_back = LiesBehind(corner, tips[0]) || LiesBehind(corner, tips[1]);
  return farther <= reach && !(a.link == b.link && cuts_back) ? corner : middle;
}

// Whether a link encloses something if both of its ends meet at a corner.
bool MayMeetItself(const EditSession& session, LinkId id) {
  const DrawingLink& link = session.link(id);
  const double length = Length(link.points_in_world);
  const double gap = (EndPoint(link, 1) - EndPoint(link, 0)).norm();
  return length >= kMinLoopPx * session.FootprintAt(EndPoint(link, 0)) &&
         length >= kMinLoopOverGap * gap;
}

EditOutcome TooShortToClose(LinkId id) {
  return {EditStatus::kNoSense,
          "link " + std::to_string(id) + " is too short to be closed over the gap"};
}

void EndAtNode(const LinkEnd& end, NodeId node, EditSession* session) {
  GraphEditor& editor = session->editor();
  session->NoteGap(EndPoint(editor.link(end.link), end.end), editor.node(node).position_in_world);
  editor.EndAt(end, node);
  session->Touch(end.link);
}

EditOutcome MakeOneLink(const LinkEnd& a, const LinkEnd& b, EditSession* session) {
  GraphEditor& editor = session->editor();
  const Eigen::Vector3d from = EndPoint(editor.link(a.link), a.end);
  const Eigen::Vector3d to = EndPoint(editor.link(b.link), b.end);
  if (a.link == b.link) {
    const double footprint = session->FootprintAt(from);
    const double length = Length(editor.link(a.link).points_in_world);
    if (!MayClose(length / footprint, (to - from).norm() / footprint)) {
      return TooShortToClose(a.link);
    }
  }
  session->NoteGap(from, to);
  if (editor.IsFree(a)) editor.DropOvershoot(a, to);
  session->Join(a, b);
  return {EditStatus::kApplied, a.link == b.link ? "link " + std::to_string(a.link) + " is closed"
                                                 : "links " + std::to_string(a.link) + " and " +
                                                       std::to_string(b.link) + " are one"};
}

EditOutcome MergeNodes(NodeId a, NodeId b, EditSession* session) {
  GraphEditor& editor = session->editor();
  const NodeId to = editor.node(b).Degree() > editor.node(a).Degree() ? b : a;
  const NodeId from = to == a ? b : a;
  const Eigen::Vector3d places[2] = {editor.node(a).position_in_world,
                                     editor.node(b).position_in_world};
  const double distance = (places[1] - places[0]).norm();
  int num_removed = 0;
  for (const LinkEnd& end : std::vector(editor.node(from).incident)) {
    const bool connects = editor.IsLink(end.link) && editor.NodeAt({end.link, 1 - end.end}) == to;
    if (!connects) continue;
    if (Length(editor.link(end.link).points_in_world) > kMaxCollapse * distance) continue;
    session->Remove(end.link);
    ++num_removed;
  }
  const std::string removed =
      num_removed == 0 ? "" : "; links between them are removed: " + std::to_string(num_removed);
  if (!editor.IsNode(from) || !editor.IsNode(to)) {
    return {EditStatus::kApplied, "the ends are at one node" + removed};
  }
  session->NoteGap(places[0], places[1]);
  editor.MoveNode(to, 0.5 * (places[0] + places[1]));
  editor.MoveEnds(from, to);
  session->TouchAllAt(to);
  session->PairAt(to);
  return {EditStatus::kApplied, "the two nodes are one" + removed};
}

EditOutcome MakeNode(const LinkEnd& a, const LinkEnd& b, EditSession* session) {
  GraphEditor& editor = session->editor();
  const bool is_free[2] = {editor.IsFree(a), editor.IsFree(b)};
  if (!is_free[0] && !is_free[1]) return MergeNodes(editor.NodeAt(a), editor.NodeAt(b), session);
  if (a.link == b.link && !MayMeetItself(*session, a.link)) return TooShortToClose(a.link);
  if (is_free[0] && is_free[1]) {
    const NodeId node = editor.AddNode(CornerOf(*session, a, b));
    EndAtNode(a, node, session);
    EndAtNode(b, node, session);
    session->PairAt(node);
    return {EditStatus::kApplied, Name(a) + " and " + Name(b) + " meet at a new node"};
  }
  const LinkEnd& free = is_free[0] ? a : b;
  const NodeId node = editor.NodeAt(is_free[0] ? b : a);
  const bool opens = editor.node(node).kind == NodeKind::kLoopAnchor;
  const LinkId loop = editor.node(node).incident.front().link;
  EndAtNode(free, node, session);
  if (opens) session->Touch(loop);
  session->PairAt(node);
  return {EditStatus::kApplied, Name(free) + " is at the node of the other"};
}

}  // namespace

EditOutcome ApplyJoin(const JoinEnds& edit, EditSession* session) {
  const auto [a, problem_a] = session->FindEnd(edit.ends[0]);
  if (!a) return problem_a;
  const auto [b, problem_b] = session->FindEnd(edit.ends[1]);
  if (!b) return problem_b;
  GraphEditor& editor = session->editor();
  if (*a == *b) return {EditStatus::kNoSense, "both are " + Name(*a)};
  const NodeId node = editor.NodeAt(*a);
  if (node == editor.NodeAt(*b)) {
    const bool may_join = editor.node(node).Degree() == 2 && a->link != b->link &&
                          ContinueEachOther(*session, *a, *b);
    if (may_join) return MakeOneLink(*a, *b, session);
    return {EditStatus::kNoSense, Name(*a) + " and " + Name(*b) + " are at one node already"};
  }
  const bool are_free = editor.IsFree(*a) && editor.IsFree(*b);
  if (are_free && ContinueEachOther(*session, *a, *b)) return MakeOneLink(*a, *b, session);
  return MakeNode(*a, *b, session);
}

}  // namespace limn
