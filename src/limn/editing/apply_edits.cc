// SPDX-License-Identifier: BSD-3-Clause
#include "limn/editing/apply_edits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "limn/editing/edit_session.h"
#include "limn/model/footprint.h"
#include "limn/util/number_text.h"
#include "limn/util/sort_unique.h"

namespace limn {
namespace {

// An edit of which less of a reference is left than this share was applied to a part of it.
constexpr double kMinCoveredShare = 0.5;
// A place of a dimension within this distance of an end of its link is the end, px.
constexpr double kEndPx = 2;

// A place on a curve, or the end that is near there.
Eigen::Vector3d SnapToEnds(const Eigen::Vector3d& place, double footprint,
                           const Polyline3d& points) {
  const Eigen::Vector3d& front = points.front();
  const Eigen::Vector3d& back = points.back();
  const Eigen::Vector3d& nearer =
      (front - place).squaredNorm() <= (back - place).squaredNorm() ? front : back;
  return (nearer - place).norm() <= kEndPx * footprint ? nearer : place;
}

std::string Count(size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

// All links that some references mean.
struct FoundLinks {
  std::vector<LinkId> links;  // ascending
  EditOutcome outcome;        // without the text of what was done
};

FoundLinks FindAll(const std::vector<LinkRef>& refs, const EditSession& session) {
  FoundLinks found;
  size_t num_whole = 0;
  std::string problems;
  bool is_ambiguous = false;
  for (const LinkRef& ref : refs) {
    const LinkMatch match = session.matcher().Match(ref);
    const bool is_found = !match.IsAmbiguous() && !match.along.empty();
    if (is_found) found.links.insert(found.links.end(), match.along.begin(), match.along.end());
    is_ambiguous |= match.IsAmbiguous();
    if (is_found && match.covered >= kMinCoveredShare) {
      ++num_whole;
      continue;
    }
    problems += problems.empty() ? "" : "; ";
    problems += is_found ? ShortNumber(std::round(100 * match.covered)) + " % of it is left"
                         : match.Problem();
  }
  SortUnique(&found.links);
  found.outcome.text = problems;
  if (num_whole == refs.size()) return found;
  found.outcome.status = !found.links.empty() ? EditStatus::kPartly
                         : is_ambiguous       ? EditStatus::kAmbiguous
                                              : EditStatus::kNotFound;
  if (refs.size() > 1) {
    found.outcome.text = std::to_string(refs.size() - num_whole) + " of " +
                         Count(refs.size(), "link") + ": " + problems;
  }
  return found;
}

// Does something to every link that the references mean.
template <typename Act>
EditOutcome ForAll(const std::vector<LinkRef>& refs, const std::string& done,
                   const EditSession& session, Act&& act) {
  auto [links, outcome] = FindAll(refs, session);
  for (const LinkId id : links) act(id);
  if (links.empty()) return outcome;
  outcome.text = Count(links.size(), "link") + " " + done +
                 (outcome.text.empty() ? "" : ", but of " + outcome.text);
  return outcome;
}

class Applier {
 public:
  Applier(const std::vector<View>& views, const TopologyOptions& topology, DrawingGraph* graph)
      : session_(views, topology, graph), graph_(graph), is_new_(graph->dimensions.size(), 0) {}

  EditOutcome operator()(const DeleteLinks& edit) {
    return ForAll(edit.links, "deleted", session_, [&](LinkId id) { session_.Remove(id); });
  }

  EditOutcome operator()(const RestoreLinks& edit) {
    return ForAll(edit.links, "firm", session_, [&](LinkId id) { session_.editor().MakeFirm(id); });
  }

  EditOutcome operator()(const SetLinkKind& edit) {
    return ForAll(edit.links, std::string("of kind ") + LinkKindName(edit.kind), session_,
                  [&](LinkId id) { session_.SetKindByHand(id, edit.kind); });
  }

  EditOutcome operator()(const SplitLink& edit) { return ApplySplit(edit, &session_); }
  EditOutcome operator()(const JoinEnds& edit) { return ApplyJoin(edit, &session_); }
  EditOutcome operator()(const MergeLinks& edit) { return ApplyMerge(edit, &session_); }

  EditOutcome operator()(const AddDimension& edit) {
    const auto [from, no_from] = session_.FindPlace(edit.from);
    if (!from) return no_from;
    const auto [to, no_to] = session_.FindPlace(edit.to);
    if (!to) return no_to;
    const DrawingDimension dimension = {Position(*from), Position(*to), edit.shift};
    if (dimension.from == dimension.to) {
      return {EditStatus::kNoSense, "both places are the same"};
    }
    graph_->dimensions.push_back(dimension);
    is_new_.push_back(1);
    return {EditStatus::kApplied, "a dimension from link " + std::to_string(from->link) +
                                      " to link " + std::to_string(to->link)};
  }

  EditOutcome operator()(const RemoveDimension& edit) {
    const double reach = LinkMatcher::kMatchPx * session_.FootprintAt(edit.from);
    double nearest = std::numeric_limits<double>::infinity();
    size_t best = 0;
    for (size_t d = 0; d < graph_->dimensions.size(); ++d) {
      const auto& [from, to, shift, sigma] = graph_->dimensions[d];
      const double distance = std::min(std::max((from - edit.from).norm(), (to - edit.to).norm()),
                                       std::max((from - edit.to).norm(), (to - edit.from).norm()));
      if (distance < nearest) {
        nearest = distance;
        best = d;
      }
    }
    if (!(nearest <= reach)) return {EditStatus::kNotFound, "there is no dimension there"};
    graph_->dimensions.erase(graph_->dimensions.begin() + static_cast<std::ptrdiff_t>(best));
    is_new_.erase(is_new_.begin() + static_cast<std::ptrdiff_t>(best));
    return {EditStatus::kApplied, "a dimension removed"};
  }

  EditSession& session() { return session_; }
  std::vector<uint8_t> TakeNewDimensions() { return std::move(is_new_); }

 private:
  Eigen::Vector3d Position(const LinkPlace& place) const {
    return SnapToEnds(place.point.position, session_.FootprintAt(place.point.position),
                      session_.link(place.link).points_in_world);
  }

  EditSession session_;
  DrawingGraph* graph_;
  std::vector<uint8_t> is_new_;  // per dimension
};

// A place on a link as near as possible to another one, or the end that is near there.
struct Snapped {
  LinkId link = -1;
  double distance = std::numeric_limits<double>::infinity();
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

Snapped Snap(const Eigen::Vector3d& place, double footprint, const DrawingGraph& graph) {
  Snapped best;
  for (size_t l = 0; l < graph.links.size(); ++l) {
    const Polyline3d& points = graph.links[l].points_in_world;
    const PolylinePoint on_link = ClosestPoint(points, place);
    const double distance = std::sqrt(on_link.squared_distance);
    if (distance >= best.distance) continue;
    best = {static_cast<LinkId>(l), distance, SnapToEnds(on_link.position, footprint, points)};
  }
  return best;
}

}  // namespace

bool HasTouched(const EditedDrawing& edited) { return std::ranges::count(edited.touched, 1) > 0; }

EditedDrawing ApplyEdits(const DrawingGraph& graph, const std::vector<View>& views,
                         const std::vector<Edit>& edits, const TopologyOptions& topology) {
  EditedDrawing edited;
  edited.graph = graph;
  Applier applier(views, topology, &edited.graph);
  EditSession& session = applier.session();
  for (session.edit = 0; session.edit < edits.size(); ++session.edit) {
    edited.outcomes.push_back(std::visit(applier, edits[session.edit]));
  }
  for (LinkId id = 0; id < session.editor().NumLinks(); ++id) {
    if (!session.editor().IsLink(id)) continue;
    edited.touched.push_back(session.touched.contains(id));
    edited.kind_by_hand.push_back(session.kind_by_hand.contains(id));
  }
  session.editor().Compact();
  edited.new_dimension = applier.TakeNewDimensions();
  edited.gaps = std::move(session.gaps);
  const bool is_changed = edited.graph.links.size() < graph.links.size() || HasTouched(edited);
  if (is_changed) {
    edited.num_dropped_faces = graph.faces.size();
  } else {
    edited.graph.faces = graph.faces;
  }
  return edited;
}

void SnapDimensions(const std::vector<View>& views, EditedDrawing* edited) {
  DrawingGraph& graph = edited->graph;
  for (size_t d = 0; d < graph.dimensions.size(); ++d) {
    for (Eigen::Vector3d* place : {&graph.dimensions[d].from, &graph.dimensions[d].to}) {
      const double footprint = PixelFootprint(views, *place);
      const Snapped snapped = Snap(*place, footprint, graph);
      if (snapped.link < 0 || snapped.distance > LinkMatcher::kMatchPx * footprint) continue;
      if (edited->new_dimension[d] || edited->touched[snapped.link]) *place = snapped.position;
    }
  }
}

}  // namespace limn
