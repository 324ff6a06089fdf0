// SPDX-License-Identifier: BSD-3-Clause
#include "limn/drawing/traced_graph.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "limn/topology/graph_editor.h"
#include "limn/topology/link_geometry.h"

namespace limn {
namespace {

// A meeting within this many vertices of the end of a curve is at its end.
constexpr int kNearEnd = 4;
// Spacing of the points that bridge gaps, px.
constexpr double kVertexSpacingPx = 1.2;
// The point before a meeting is at least this far from it, px.
constexpr double kClearancePx = 0.5;

void Reverse(DrawingLink* link) {
  std::ranges::reverse(link->points_in_world);
  std::ranges::reverse(link->vertices);
}

class GraphMaker {
 public:
  GraphMaker(const SampleSet& samples, const Consensus& consensus, const TracedCurves& traced)
      : samples_(samples), consensus_(consensus), traced_(traced), editor_(&graph_) {}

  DrawingGraph Run() {
    for (const TracedCurve& curve : traced_.curves) {
      for (const int met : curve.meets) {
        if (met >= 0) cuts_.insert(PlaceOf(met));
      }
    }
    for (const TracedCurve& curve : traced_.curves) AddCurve(curve);
    editor_.Compact();
    return std::move(graph_);
  }

 private:
  // The vertex at which a meeting with this one takes place.
  int PlaceOf(int vertex) const {
    // An end that meets a curve is where it meets it. The number only bounds the search where a
    // curve's two ends meet each other.
    constexpr int kMaxMeetings = 8;
    for (int meetings = 0;; ++meetings) {
      const TracedCurve& curve = traced_.curves[traced_.vertices[vertex].curve];
      const auto first = std::ranges::find(curve.vertices, vertex) - curve.vertices.begin();
      const auto last = std::ssize(curve.vertices) - 1 - first;
      if (curve.closed || std::min(first, last) > kNearEnd) return vertex;
      const int end = first < last ? 0 : 1;
      if (curve.meets[end] < 0 || meetings == kMaxMeetings) {
        return end == 0 ? curve.vertices.front() : curve.vertices.back();
      }
      vertex = curve.meets[end];
    }
  }

  NodeId NodeOf(int vertex) {
    const auto [place, is_new] = nodes_.try_emplace(vertex, -1);
    if (is_new) place->second = editor_.AddNode(traced_.vertices[vertex].position);
    return place->second;
  }

  void AddCurve(const TracedCurve& curve) {
    std::vector<int> vertices = curve.vertices;
    if (curve.closed) {
      const auto cut = std::ranges::find_if(vertices, [&](int v) { return cuts_.contains(v); });
      if (cut == vertices.end()) {
        DrawingLink link = MakeLink(vertices);
        BridgeGap(traced_.vertices[vertices.front()], &link);
        link.sigma.assign(link.points_in_world.size(), 0);
        const LinkId id = editor_.Add(std::move(link));
        editor_.Join({id, 0}, {id, 1});
        return;
      }
      std::rotate(vertices.begin(), cut, vertices.end());
      vertices.push_back(vertices.front());
    }
    const auto last = std::ssize(vertices) - 1;
    std::ptrdiff_t begin = 0;
    for (std::ptrdiff_t end = 1; end <= last; ++end) {
      if (end < last && !cuts_.contains(vertices[end])) continue;
      DrawingLink link =
          MakeLink(std::vector(vertices.begin() + begin, vertices.begin() + end + 1));
      // The samples at a cut belong to the part before it.
      if (begin > 0 || curve.closed) link.vertices.front() = Bare(link.vertices.front());
      link.node0 = NodeOf(vertices[begin]);
      link.node1 = NodeOf(vertices[end]);
      if (begin == 0) End(curve.meets[0], 0, &link);
      if (end == last) End(curve.meets[1], 1, &link);
      editor_.Add(std::move(link));
      begin = end;
    }
  }

  // Ends a link at the place where its curve meets a vertex, if it does.
  void End(int met, int end, DrawingLink* link) {
    if (met < 0) return;
    const TracedVertex& other = traced_.vertices[PlaceOf(met)];
    (end == 0 ? link->node0 : link->node1) = NodeOf(PlaceOf(met));
    if (end == 0) Reverse(link);
    std::vector<Eigen::Vector3d>& points = link->points_in_world;
    while (points.size() > 2) {
      const Eigen::Vector3d direction = (points.back() - points.end()[-2]).normalized();
      if ((other.position - points.back()).dot(direction) > kClearancePx * other.footprint) break;
      DropLast(link);
    }
    BridgeGap(other, link);
    AddPoint(other.position, Bare(link->vertices.back()), link);
    if (end == 0) Reverse(link);
    link->sigma.assign(points.size(), 0);
  }

  // The point before the last one takes over its samples and edgels.
  static void DropLast(DrawingLink* link) {
    const LinkVertex dropped = std::move(link->vertices.back());
    link->points_in_world.pop_back();
    link->vertices.pop_back();
    LinkVertex& last = link->vertices.back();
    last.agreeing_views = std::max(last.agreeing_views, dropped.agreeing_views);
    last.samples.insert(last.samples.end(), dropped.samples.begin(), dropped.samples.end());
    std::vector<EdgelRef> support;
    std::ranges::set_union(last.support, dropped.support, std::back_inserter(support));
    last.support = std::move(support);
  }

  static void AddPoint(const Eigen::Vector3d& position, LinkVertex vertex, DrawingLink* link) {
    link->points_in_world.push_back(position);
    link->vertices.push_back(std::move(vertex));
  }

  DrawingLink MakeLink(const std::vector<int>& vertices) const {
    DrawingLink link;
    for (const int v : vertices) {
      const TracedVertex& vertex = traced_.vertices[v];
      if (!link.vertices.empty()) BridgeGap(vertex, &link);
      AddPoint(vertex.position, Describe(vertex), &link);
      if (vertex.samples.empty() && link.size() > 1) {
        link.vertices.back().information = link.vertices.end()[-2].information;
      }
    }
    link.sigma.assign(link.points_in_world.size(), 0);
    return link;
  }

  static void BridgeGap(const TracedVertex& vertex, DrawingLink* link) {
    const Eigen::Vector3d from = link->points_in_world.back();
    const Eigen::Vector3d gap = vertex.position - from;
    const auto steps = std::lround(gap.norm() / (kVertexSpacingPx * vertex.footprint));
    for (int k = 1; k < steps; ++k) {
      AddPoint(from + gap * k / static_cast<double>(steps), Bare(link->vertices.back()), link);
    }
  }

  LinkVertex Describe(const TracedVertex& vertex) const {
    LinkVertex described;
    described.footprint = vertex.footprint;
    for (const int s : vertex.samples) {
      described.information += samples_.information[s] / static_cast<double>(vertex.samples.size());
      described.agreeing_views = std::max(described.agreeing_views, consensus_.num_views[s]);
      described.samples.push_back(samples_.NameOf(s));
    }
    NameInSketch(samples_, &described);
    return described;
  }

  const SampleSet& samples_;
  const Consensus& consensus_;
  const TracedCurves& traced_;
  DrawingGraph graph_;
  GraphEditor editor_;
  std::set<int> cuts_;           // vertices at which curves are cut
  std::map<int, NodeId> nodes_;  // by vertex
};

}  // namespace

DrawingGraph MakeTracedGraph(const SampleSet& samples, const Consensus& consensus,
                             const TracedCurves& traced) {
  return GraphMaker(samples, consensus, traced).Run();
}

}  // namespace limn
