// SPDX-License-Identifier: BSD-3-Clause
#include "limn/editing/edit_session.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "limn/util/number_text.h"

namespace limn {
namespace {

// A place may be this far from its link, px, and an end from where it was: ends are less certain
// than places along a link.
constexpr double kPlaceReachPx = 6;
constexpr double kEndReachPx = 12;
// A cut within this distance of a point of a link is made there, px.
constexpr double kAtPointPx = 0.25;

std::vector<LinkId> AllOf(const LinkMatch& match) {
  std::vector<LinkId> all = match.along;
  all.insert(all.end(), match.longer.begin(), match.longer.end());
  return all;
}

EditOutcome ProblemOf(const LinkMatch& match) {
  return {match.IsAmbiguous() ? EditStatus::kAmbiguous : EditStatus::kNotFound, match.Problem()};
}

Eigen::Vector3d OutwardOf(const LinkRef& ref, int end) {
  const Polyline3d& points = ref.points;
  const size_t last = points.size() - 1;
  return end == 0 ? points[0] - points[1] : points[last] - points[last - 1];
}

}  // namespace

EditSession::EditSession(const std::vector<View>& views, const TopologyOptions& topology,
                         DrawingGraph* graph)
    : editor_(graph), matcher_(*graph, views), topology_(topology) {}

Search<LinkId> EditSession::FindLink(const LinkRef& ref) const {
  const LinkMatch match = matcher_.Match(ref);
  return {match.Single(), ProblemOf(match)};
}

Search<LinkPlace> EditSession::FindPlace(const PlaceRef& ref) const {
  const LinkMatch match = matcher_.Match(ref.link);
  if (match.IsAmbiguous() || AllOf(match).empty()) return {std::nullopt, ProblemOf(match)};
  LinkPlace best;
  best.point.squared_distance = std::numeric_limits<double>::infinity();
  for (const LinkId id : AllOf(match)) {
    const PolylinePoint point = ClosestPoint(link(id).points_in_world, ref.at);
    if (point.squared_distance < best.point.squared_distance) best = {id, point};
  }
  const double px = std::sqrt(best.point.squared_distance) / FootprintAt(ref.at);
  if (px <= kPlaceReachPx) return {best, {}};
  return {std::nullopt,
          {EditStatus::kNotFound,
           "the place is " + ShortNumber(px) + " px from link " + std::to_string(best.link)}};
}

Search<LinkEnd> EditSession::FindEnd(const EndRef& ref) const {
  const LinkMatch match = matcher_.Match(ref.link);
  if (match.IsAmbiguous() || AllOf(match).empty()) return {std::nullopt, ProblemOf(match)};
  const Eigen::Vector3d& place = ref.end == 0 ? ref.link.points.front() : ref.link.points.back();
  const Eigen::Vector3d outward = OutwardOf(ref.link, ref.end);
  std::optional<LinkEnd> best;
  double best_distance = std::numeric_limits<double>::infinity();
  for (const LinkId id : AllOf(match)) {
    for (const int end : {0, 1}) {
      const double distance = (EndPoint(link(id), end) - place).norm();
      if (distance >= best_distance || TipAt({id, end}).outward.dot(outward) <= 0) continue;
      best = {id, end};
      best_distance = distance;
    }
  }
  const double px = best_distance / FootprintAt(place);
  if (px <= kEndReachPx) return {best, {}};
  return {std::nullopt,
          {EditStatus::kNotFound, best ? "the end of link " + std::to_string(best->link) + " is " +
                                             ShortNumber(px) + " px from where it was"
                                       : "no link along it ends there"}};
}

void EditSession::Touch(LinkId id) {
  // Both ends came to one place.
  if (!(Length(link(id).points_in_world) > 0)) return Remove(id);
  touched.insert(id);
  matcher_.Update(id);
}

void EditSession::TouchAllAt(NodeId id) {
  for (const LinkEnd& end : std::vector(editor_.node(id).incident)) {
    if (editor_.IsLink(end.link)) Touch(end.link);
  }
}

void EditSession::Remove(LinkId id) {
  editor_.Remove(id);
  matcher_.Update(id);
}

void EditSession::SetKindByHand(LinkId id, LinkKind kind) {
  editor_.SetKind(id, kind);
  kind_by_hand.insert(id);
}

void EditSession::ShareKind(LinkId from, LinkId to) {
  if (kind_by_hand.contains(from)) SetKindByHand(to, link(from).kind);
}

void EditSession::Join(const LinkEnd& a, const LinkEnd& b) {
  // Of two kinds set by hand that of `a` stays.
  if (kind_by_hand.contains(a.link)) {
    ShareKind(a.link, b.link);
  } else {
    ShareKind(b.link, a.link);
  }
  editor_.Join(a, b);
  if (a.link != b.link) matcher_.Update(b.link);
  Touch(a.link);
}

void EditSession::Unify(LinkId id, LinkId other) {
  if (kind_by_hand.contains(id)) {
    ShareKind(id, other);
  } else {
    ShareKind(other, id);
  }
  editor_.Unify(id, other);
  matcher_.Update(other);
  Touch(id);
}

NodeId EditSession::SplitAt(const LinkPlace& place, LinkId* second) {
  const auto& [segment, t, position, squared_distance] = place.point;
  const Polyline3d& points = link(place.link).points_in_world;
  const double near = kAtPointPx * FootprintAt(position);
  int index = -1;
  for (const int k : {segment, segment + 1}) {
    const bool is_inside = k > 0 && k + 1 < static_cast<int>(points.size());
    if (is_inside && (points[k] - position).norm() <= near) index = k;
  }
  if (index < 0) index = editor_.InsertPoint(place.link, segment, t);
  const int before = editor_.NumLinks();
  const NodeId node = editor_.Split(place.link, index);
  *second = editor_.NumLinks() > before ? before : -1;
  Touch(place.link);
  if (*second >= 0) {
    ShareKind(place.link, *second);
    Touch(*second);
  }
  return node;
}

LinkTip EditSession::TipAt(const LinkEnd& end) const {
  const DrawingLink& of = link(end.link);
  return TipOf(of, end.end, FootprintAt(EndPoint(of, end.end)));
}

void EditSession::PairAt(NodeId id) {
  const std::vector<LinkEnd> ends = editor_.node(id).incident;
  std::vector<LinkTip> tips;
  for (const LinkEnd& end : ends) tips.push_back(TipAt(end));
  std::vector<std::pair<LinkEnd, LinkEnd>> pairs;
  for (const auto& [i, j] : SmoothPairs(tips, MaxTurnRad())) pairs.push_back({ends[i], ends[j]});
  editor_.SetContinuations(id, std::move(pairs));
}

void EditSession::NoteGap(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  gaps.push_back({edit, from, to, (to - from).norm() / FootprintAt(0.5 * (from + to))});
}

}  // namespace limn
