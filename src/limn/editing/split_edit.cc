// SPDX-License-Identifier: BSD-3-Clause
#include <numeric>

#include "limn/editing/edit_session.h"

namespace limn {
namespace {

// A link is not cut nearer to its ends than this, px.
constexpr double kMinPartPx = 2;

double PxToNearerEnd(const EditSession& session, const LinkPlace& place) {
  const Polyline3d& points = session.link(place.link).points_in_world;
  const std::vector<double> arc = CumulativeLength(points);
  const int segment = place.point.segment;
  const double at = arc[segment] + place.point.t * (arc[segment + 1] - arc[segment]);
  return std::min(at, arc.back() - at) / session.FootprintAt(place.point.position);
}

// Cuts a closed link that was cut before: it becomes two links between two nodes.
void CutOpen(const LinkPlace& place, EditSession* session) {
  GraphEditor& editor = session->editor();
  const NodeId anchor = editor.NodeAt({place.link, 0});
  editor.Free({place.link, 1});
  LinkId second = -1;
  const NodeId node = session->SplitAt(place, &second);
  editor.EndAt({second, 1}, anchor);
  session->Touch(second);
  session->PairAt(node);
  session->PairAt(anchor);
}

}  // namespace

EditOutcome ApplySplit(const SplitLink& edit, EditSession* session) {
  const auto [place, problem] = session->FindPlace(edit.place);
  if (!place) return problem;
  const std::string name = "link " + std::to_string(place->link);
  const bool is_loop = session->link(place->link).closed;
  const bool was_cut = session->cut_loops.contains(place->link);
  const bool is_at_end = PxToNearerEnd(*session, *place) < kMinPartPx;
  if (is_at_end && !(is_loop && !was_cut)) return {EditStatus::kNoSense, name + " ends there"};
  if (is_loop && was_cut) {
    CutOpen(*place, session);
    return {EditStatus::kApplied, name + ", closed and cut before, is in two"};
  }
  LinkId second = -1;
  NodeId node = -1;
  if (!is_at_end) node = session->SplitAt(*place, &second);
  if (is_loop) {
    session->cut_loops.insert(place->link);
    return {EditStatus::kApplied,
            name + ", closed, begins and ends there; another cut makes it two"};
  }
  session->PairAt(node);
  return {EditStatus::kApplied, name + " is in two"};
}

}  // namespace limn
