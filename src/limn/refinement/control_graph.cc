#include "limn/refinement/control_graph.h"

#include <algorithm>
#include <cmath>

#include "limn/model/footprint.h"

namespace limn {
namespace {

// Length at a corner, where image edges are rounded, that is not matched, px, and its largest share
// of a link.
constexpr double kCornerSkipPx = 3;
constexpr double kMaxSkippedShare = 0.25;

// Returns whether two ends continue each other and no other link ends here.
bool IsSmooth(const DrawingNode& node) {
  return node.Degree() == 2 && node.continuations.size() == 1;
}

// Returns whether the link end has a smooth continuation.
bool GoesOn(const DrawingNode& node, const LinkEnd& end) {
  return std::any_of(node.continuations.begin(), node.continuations.end(),
                     [&](const auto& pair) { return pair.first == end || pair.second == end; });
}

class ControlGraphBuilder {
 public:
  ControlGraphBuilder(const DrawingGraph& graph, const std::vector<View>& views, double spacing_px)
      : graph_(graph), views_(views), spacing_px_(spacing_px) {}

  ControlGraph Run() {
    for (const DrawingNode& node : graph_.nodes) {
      control_.position.push_back(node.position_in_world);
      control_.footprint.push_back(0);
      control_.corner.push_back(node.Degree() >= 2 && !IsSmooth(node));
    }
    for (size_t l = 0; l < graph_.links.size(); ++l) AddLink(static_cast<LinkId>(l));
    for (const DrawingNode& node : graph_.nodes) AddBendsThrough(node);
    control_.start = control_.position;
    return std::move(control_);
  }

 private:
  void AddLink(LinkId id) {
    const DrawingLink& link = graph_.links[id];
    const double unit = LinkFootprint(link, views_);
    const double length = Length(link.points_in_world);
    // A link that no camera sees has no footprint: it keeps its two ends.
    const double step = unit > 0 ? spacing_px_ * unit : length;
    const Polyline3d points =
        ResampleUniform(link.points_in_world, link.closed ? std::min(step, length / 6) : step);
    ControlLink out;
    out.views = link.supporting_views;
    out.points.push_back(link.node0);
    for (size_t k = 1; k + 1 < points.size(); ++k) {
      out.points.push_back(static_cast<int>(control_.position.size()));
      control_.position.push_back(points[k]);
      control_.footprint.push_back(LinkFootprint(link, points[k], views_));
      control_.corner.push_back(0);
    }
    out.points.push_back(link.node1);
    for (const int end : {0, 1}) {
      const NodeId node = link.NodeAt(end);
      double& footprint = control_.footprint[node];
      footprint = std::max(footprint, LinkFootprint(link, control_.position[node], views_));
      if (control_.corner[node] && unit > 0 && !GoesOn(graph_.nodes[node], {id, end})) {
        out.skip_px[end] = std::min(kCornerSkipPx, kMaxSkippedShare * length / unit);
      }
    }
    for (int k = 1; k < out.NumSegments(); ++k) {
      control_.bends.push_back({out.points[k - 1], out.points[k], out.points[k + 1]});
    }
    control_.links.push_back(std::move(out));
  }

  int NextTo(const LinkEnd& end) const {
    const std::vector<int>& points = control_.links[end.link].points;
    return end.end == 0 ? points[1] : points[points.size() - 2];
  }

  void AddBendsThrough(const DrawingNode& node) {
    for (const auto& [a, b] : node.continuations) {
      const Bend bend = {NextTo(a), graph_.links[a.link].NodeAt(a.end), NextTo(b)};
      if (bend[0] != bend[1] && bend[1] != bend[2] && bend[0] != bend[2]) {
        control_.bends.push_back(bend);
      }
    }
  }

  const DrawingGraph& graph_;
  const std::vector<View>& views_;
  double spacing_px_;
  ControlGraph control_;
};

}  // namespace

ControlGraph MakeControlGraph(const DrawingGraph& graph, const std::vector<View>& views,
                              double spacing_px) {
  return ControlGraphBuilder(graph, views, spacing_px).Run();
}

Eigen::Vector3d Chord(const ControlGraph& control, const ControlLink& link, int first, int last) {
  return control.position[link.points[std::min(last, link.NumSegments())]] -
         control.position[link.points[std::max(first, 0)]];
}

void UpdateTangents(ControlGraph* control) {
  std::vector<Eigen::Vector3d>& tangent = control->tangent;
  tangent.assign(control->position.size(), Eigen::Vector3d::UnitX());
  for (const ControlLink& link : control->links) {
    for (int k = 0; k <= link.NumSegments(); ++k) {
      const Eigen::Vector3d chord = Chord(*control, link, k - 1, k + 1);
      if (chord.norm() > 0) tangent[link.points[k]] = chord.normalized();
    }
  }
}

void FollowEnds(const Eigen::Vector3d& first, const Eigen::Vector3d& last, Polyline3d* points) {
  const Eigen::Vector3d moved[2] = {first - points->front(), last - points->back()};
  for (size_t k = 0; k < points->size(); ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(points->size() - 1);
    (*points)[k] += (1 - t) * moved[0] + t * moved[1];
  }
  // Rounding must not part them from their nodes.
  points->front() = first;
  points->back() = last;
}

void FollowNodes(const std::vector<uint8_t>& frozen, const std::vector<Eigen::Vector3d>& before,
                 ControlGraph* control) {
  for (size_t l = 0; l < control->links.size(); ++l) {
    if (!frozen[l]) continue;
    const std::vector<int>& ids = control->links[l].points;
    Polyline3d points;
    for (const int id : ids) points.push_back(before[id]);
    FollowEnds(control->position[ids.front()], control->position[ids.back()], &points);
    for (size_t k = 0; k < ids.size(); ++k) control->position[ids[k]] = points[k];
  }
}

}  // namespace limn
