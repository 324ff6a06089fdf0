#include "limn/refinement/graph_editor.h"

#include <algorithm>
#include <cmath>

#include "limn/geometry/polyline.h"
#include "limn/model/footprint.h"

namespace limn {
namespace {

// How far an end may overshoot what it meets, px.
constexpr double kMaxOvershootPx = 3;
// Largest bound on the chance that edgels run along a gap by accident.
constexpr double kMaxChance = 0.05;

// Points one px apart.
void Densify(double footprint, DrawingLink* link) {
  const Polyline3d old = link->points_in_world;
  const std::vector<double> arc = CumulativeLength(old);
  link->points_in_world = ResampleUniform(old, footprint);
  std::vector<double> sigma;
  for (const double at : CumulativeLength(link->points_in_world)) {
    const auto next = std::lower_bound(arc.begin(), arc.end(), at);
    sigma.push_back(link->sigma[std::min<size_t>(next - arc.begin(), arc.size() - 1)]);
  }
  link->sigma = std::move(sigma);
}

}  // namespace

double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::acos(std::clamp(a.dot(b), -1.0, 1.0));
}

double LineAngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::acos(std::min(std::abs(a.dot(b)), 1.0));
}

GraphEditor::GraphEditor(const std::vector<View>& views,
                         const std::vector<std::unique_ptr<EdgelIndex>>& edgels,
                         const RefinementOptions& options, const std::vector<uint8_t>& frozen,
                         DrawingGraph* graph)
    : views_(views), options_(options), graph_(graph) {
  for (const auto& index : edgels) edgels_.push_back(index.get());
  for (size_t l = 0; l < graph->links.size(); ++l) {
    DrawingLink& link = graph->links[l];
    footprint_.push_back(LinkFootprint(link, views));
    left_alone_.push_back(frozen[l] || !(footprint_.back() > 0));
    if (!left_alone_.back()) Densify(footprint_.back(), &link);
  }
}

bool GraphEditor::HasPlaces() const {
  return std::find(left_alone_.begin(), left_alone_.end(), 0) != left_alone_.end();
}

std::vector<LinkEnd> GraphEditor::FreeEnds() const {
  std::vector<LinkEnd> ends;
  for (const DrawingNode& node : graph_->nodes) {
    if (node.Degree() == 1 && !left_alone_[node.incident[0].link]) {
      ends.push_back(node.incident[0]);
    }
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

LinkTip GraphEditor::Tip(const LinkEnd& end) const {
  return TipOf(graph_->links[end.link], end.end, footprint_[end.link]);
}

Eigen::Vector3d GraphEditor::DirectionAt(LinkId id, int index) const {
  const auto& points = graph_->links[id].points_in_world;
  const int last = static_cast<int>(points.size()) - 1;
  return (points[std::min(index + 2, last)] - points[std::max(index - 2, 0)]).normalized();
}

GraphEditor::Places GraphEditor::CollectPlaces() const {
  Places places;
  for (LinkId id = 0; id < static_cast<LinkId>(graph_->links.size()); ++id) {
    if (left_alone_[id]) continue;
    const auto& points = graph_->links[id].points_in_world;
    for (int k = 0; k < static_cast<int>(points.size()); ++k) {
      places.position.push_back(points[k]);
      places.direction.push_back(DirectionAt(id, k));
      places.point.push_back({id, k});
    }
  }
  return places;
}

std::optional<GraphEditor::Offset> GraphEditor::Reaches(const LinkTip& tip,
                                                        const Eigen::Vector3d& place,
                                                        double footprint, double turn_rad) const {
  const Eigen::Vector3d offset = (place - tip.point) / footprint;
  const double along = offset.dot(tip.outward);
  const double miss = (offset - along * tip.outward).norm();
  if (along > kMaxGapPx || along < -kMaxOvershootPx) return std::nullopt;
  if (miss > kMaxMissPx + 0.5 * turn_rad * std::abs(along)) return std::nullopt;
  return Offset{along, miss};
}

bool GraphEditor::ImagesShow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, LinkId a,
                             LinkId b) const {
  std::vector<uint8_t> asked(views_.size(), 0);
  for (const LinkId id : {a, b}) {
    for (const ViewId view : graph_->links[id].supporting_views) asked[view] = 1;
  }
  const SupportGate gate = {options_.max_distance_px, 1.0, options_.max_angle_deg * M_PI / 180};
  const SegmentEvidence evidence = FindEvidence(from, to, asked, views_, edgels_, gate);
  const int seen = static_cast<int>(evidence.seen_in.size());
  return seen >= options_.min_views &&
         LogChance(seen, evidence.num_views, evidence.background) < std::log(kMaxChance);
}

void GraphEditor::CutTo(int begin, int end, LinkId id) {
  DrawingLink& link = graph_->links[id];
  const auto cut = [&](auto* values) {
    values->erase(values->begin() + end, values->end());
    values->erase(values->begin(), values->begin() + begin);
  };
  cut(&link.points_in_world);
  cut(&link.sigma);
  graph_->nodes[link.node0].position_in_world = link.points_in_world.front();
  graph_->nodes[link.node1].position_in_world = link.points_in_world.back();
}

NodeId GraphEditor::Split(LinkId id, int index, bool smooth) {
  const bool was_closed = graph_->links[id].closed;
  const NodeId node = SplitLink(id, index, graph_);
  if (!was_closed) {
    footprint_.push_back(footprint_[id]);
    left_alone_.push_back(left_alone_[id]);
  }
  if (smooth) {
    const LinkId second = static_cast<LinkId>(graph_->links.size()) - 1;
    const LinkEnd before = was_closed ? LinkEnd{id, 0} : LinkEnd{id, 1};
    const LinkEnd after = was_closed ? LinkEnd{id, 1} : LinkEnd{second, 0};
    graph_->nodes[node].continuations.push_back({before, after});
  }
  return node;
}

void GraphEditor::Keep(const std::vector<uint8_t>& keep) {
  std::vector<double> footprint;
  std::vector<uint8_t> left_alone;
  for (size_t l = 0; l < keep.size(); ++l) {
    if (!keep[l]) continue;
    footprint.push_back(footprint_[l]);
    left_alone.push_back(left_alone_[l]);
  }
  footprint_ = std::move(footprint);
  left_alone_ = std::move(left_alone);
  RemoveLinks(keep, graph_);
  for (DrawingLink& link : graph_->links) {
    if (link.node0 == link.node1 && graph_->nodes[link.node0].Degree() == 2) link.closed = true;
  }
  RebuildIncidence(graph_);
}

}  // namespace limn
