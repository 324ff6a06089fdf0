// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "limn/editing/edit_session.h"
#include "limn/geometry/angle_between.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// Mean distance up to which two links can show the same curve, px, and the share of their common
// stretch along which they must be nearly parallel.
constexpr double kMaxApartPx = 15;
constexpr double kMaxParallelRad = 45 * kDeg;
constexpr double kMinParallelShare = 0.7;
// What sticks out less than this beyond the other link is dropped, px.
constexpr double kMinRestPx = 2;
// A node this near to an end of the merged link, along it, goes there, px.
constexpr double kNearEndPx = 5;

// Where one of two links runs along the other one.
struct Beside {
  int first = 0;  // points of the link: [first, last] lie beside the base
  int last = 0;
  // Per end of the link: the end of the base beyond which it goes, -1 if it does not.
  std::array<int, 2> beyond = {-1, -1};
};

Eigen::Vector3d DirectionOf(const DrawingLink& link, int segment) {
  return (link.points_in_world[segment + 1] - link.points_in_world[segment]).stableNormalized();
}

// The end of an open base that a point lies beyond, by more than this along the base; -1 if it lies
// beside it.
int BeyondEnd(const DrawingLink& base, const Eigen::Vector3d& point, const PolylinePoint& on_base,
              double tolerance) {
  if (base.closed) return -1;
  const double along = (point - on_base.position).dot(DirectionOf(base, on_base.segment));
  if (on_base.segment == 0 && on_base.t <= 0 && along < -tolerance) return 0;
  return on_base.segment + 2 == base.size() && on_base.t >= 1 && along > tolerance ? 1 : -1;
}

// Nothing if they do not run along each other.
std::optional<Beside> FindBeside(const EditSession& session, const DrawingLink& base,
                                 const DrawingLink& other) {
  const double footprint = session.FootprintAt(other.points_in_world[other.size() / 2]);
  std::vector<int> beyond;
  std::vector<int> beside;
  double distance = 0;
  int num_parallel = 0;
  for (int k = 0; k < other.size(); ++k) {
    const PolylinePoint on_base = ClosestPoint(base.points_in_world, other.points_in_world[k]);
    beyond.push_back(BeyondEnd(base, other.points_in_world[k], on_base, footprint));
    if (beyond.back() >= 0) continue;
    beside.push_back(k);
    distance += std::sqrt(on_base.squared_distance) / footprint;
    num_parallel += LineAngleBetween(TangentAt(other, k), DirectionOf(base, on_base.segment)) <=
                    kMaxParallelRad;
  }
  const auto count = static_cast<double>(beside.size());
  if (count < 2 || distance > kMaxApartPx * count || num_parallel < kMinParallelShare * count) {
    return std::nullopt;
  }
  Beside overlap = {beside.front(), beside.back(), {beyond.front(), beyond.back()}};
  const std::vector<double> arc = CumulativeLength(other.points_in_world);
  if (arc[overlap.first] < kMinRestPx * footprint) overlap.beyond[0] = -1;
  if (arc.back() - arc[overlap.last] < kMinRestPx * footprint) overlap.beyond[1] = -1;
  return overlap;
}

// Share of the way from a point to one on another link, by their variances.
double ShareOfWay(double sigma, double other_sigma) {
  if (!std::isfinite(sigma)) return std::isfinite(other_sigma) ? 1 : 0.5;
  const double sum = sigma * sigma + other_sigma * other_sigma;
  return sum > 0 ? sigma * sigma / sum : 0.5;
}

// Moves the base to the mean of both links where they run side by side.
void MoveToMean(LinkId base, const DrawingLink& other, EditSession* session) {
  GraphEditor& editor = session->editor();
  const double footprint = session->FootprintAt(other.points_in_world.front());
  const int size = session->link(base).size();
  for (int k = 0; k < size; ++k) {
    const Eigen::Vector3d point = session->link(base).points_in_world[k];
    const PolylinePoint beside = ClosestPoint(other.points_in_world, point);
    if (BeyondEnd(other, point, beside, footprint) >= 0) continue;
    const double share = ShareOfWay(session->link(base).sigma[k], other.sigma[beside.segment]);
    const Eigen::Vector3d mean = point + share * (beside.position - point);
    if (k > 0 && k + 1 < size) {
      editor.MovePoint(base, k, mean);
    } else if (editor.IsFree({base, k == 0 ? 0 : 1})) {
      editor.MoveNode(editor.NodeAt({base, k == 0 ? 0 : 1}), mean);
    }
  }
}

// Appends a piece of the other link, from its inner end on, to an end of the base.
void Append(LinkId base, int base_end, const LinkEnd& inner, EditSession* session) {
  GraphEditor& editor = session->editor();
  const LinkEnd end = {base, base_end};
  editor.DropOvershoot(inner, EndPoint(editor.link(base), base_end));
  if (editor.IsFree(end)) return session->Join(end, inner);
  const NodeId node = editor.NodeAt(end);
  editor.EndAt(inner, node);
  session->Touch(inner.link);
  session->PairAt(node);
}

// Takes the other ends at a node of the merged link to the place beside it on the base.
void Attach(NodeId node, std::vector<LinkId>* parts, EditSession* session) {
  GraphEditor& editor = session->editor();
  if (!editor.IsNode(node)) return;
  const Eigen::Vector3d position = editor.node(node).position_in_world;
  LinkPlace place;
  place.point.squared_distance = std::numeric_limits<double>::infinity();
  for (const LinkId part : *parts) {
    if (editor.NodeAt({part, 0}) == node || editor.NodeAt({part, 1}) == node) return;
    const PolylinePoint point = ClosestPoint(editor.link(part).points_in_world, position);
    if (point.squared_distance < place.point.squared_distance) place = {part, point};
  }
  const double near = kNearEndPx * session->FootprintAt(position);
  NodeId target = -1;
  for (const int end : {0, 1}) {
    const Eigen::Vector3d& at = EndPoint(editor.link(place.link), end);
    if ((at - place.point.position).norm() <= near) target = editor.NodeAt({place.link, end});
  }
  if (target < 0) {
    LinkId second = -1;
    target = session->SplitAt(place, &second);
    if (second >= 0) parts->push_back(second);
  }
  editor.MoveEnds(node, target);
  session->TouchAllAt(target);
  session->PairAt(target);
}

// Removes the part of `other` beside the base; parts that extend beyond it are appended.
void TakeOver(LinkId base, LinkId other, const Beside& overlap, EditSession* session) {
  GraphEditor& editor = session->editor();
  const auto& [first, last, beyond] = overlap;
  const int size = editor.link(other).size();
  if (beyond[0] < 0 && beyond[1] < 0) return session->Unify(base, other);
  LinkId second = other;
  int offset = 0;
  if (beyond[0] >= 0 && beyond[1] >= 0) {
    offset = (first + last) / 2;
    second = editor.NumLinks();
    editor.Split(other, offset);
    session->ShareKind(other, second);
  }
  if (beyond[0] >= 0) {
    editor.CutTo(other, 0, first + 1);
    Append(base, beyond[0], {other, 1}, session);
  }
  if (beyond[1] >= 0) {
    editor.CutTo(second, last - offset, size - offset);
    Append(base, beyond[1], {second, 0}, session);
  }
}

}  // namespace

EditOutcome ApplyMerge(const MergeLinks& edit, EditSession* session) {
  std::array<LinkId, 2> ids = {};
  for (const int k : {0, 1}) {
    const auto [found, problem] = session->FindLink(edit.links[k]);
    if (!found) return problem;
    ids[k] = *found;
  }
  if (ids[0] == ids[1]) {
    return {EditStatus::kNoSense, "both are link " + std::to_string(ids[0])};
  }
  GraphEditor& editor = session->editor();
  const auto length = [&](LinkId id) { return Length(session->link(id).points_in_world); };
  const int longer = length(ids[1]) > length(ids[0]) ? 1 : 0;
  const LinkId base = ids[longer];
  const LinkId other = ids[1 - longer];
  const std::string names = "links " + std::to_string(ids[0]) + " and " + std::to_string(ids[1]);
  const auto overlap = FindBeside(*session, session->link(base), session->link(other));
  const bool parts_again =
      overlap && overlap->beyond[0] >= 0 && overlap->beyond[0] == overlap->beyond[1];
  if (!overlap || parts_again || overlap->last - overlap->first < 2) {
    return {EditStatus::kNoSense, names + " do not run along each other"};
  }
  std::vector<NodeId> nodes;  // of the other link, beside the base
  for (const int end : {0, 1}) {
    if (overlap->beyond[end] < 0 && !session->link(other).closed) {
      nodes.push_back(editor.NodeAt({other, end}));
    }
  }
  MoveToMean(base, session->link(other), session);
  session->Touch(base);
  TakeOver(base, other, *overlap, session);
  std::vector<LinkId> parts = {base};
  for (const NodeId node : nodes) Attach(node, &parts, session);
  return {EditStatus::kApplied, names + " are one"};
}

}  // namespace limn
