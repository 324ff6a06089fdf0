// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/refinement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limn/model/footprint.h"
#include "limn/refinement/fit_rounds.h"
#include "limn/refinement/scene_unit.h"
#include "limn/topology/covered_links.h"
#include "limn/topology/edit_topology.h"
#include "limn/util/sort_unique.h"

namespace limn {
namespace {

// Resamples a link to a point per px and gives it vertices with its footprint and, unless frozen,
// the matched edgels, as RepairTopology needs them. A link that no view sees stays unchanged.
void GiveVertices(const std::vector<View>& views, const ControlLink& fitted, DrawingLink* link) {
  const double footprint = LinkFootprint(*link, views);
  if (!(footprint > 0)) return;
  const std::vector<double> arc = CumulativeLength(link->points_in_world);
  link->points_in_world = ResampleUniform(link->points_in_world, footprint);
  // Infinite before the last fit, not read after it.
  link->sigma.assign(link->points_in_world.size(), link->sigma.front());
  link->vertices.resize(link->points_in_world.size());
  for (LinkVertex& vertex : link->vertices) vertex.footprint = footprint;
  if (fitted.frozen) return;
  const double step = arc.back() / static_cast<double>(link->size() - 1);
  for (const FitSample& sample : fitted.samples) {
    const double at = (1 - sample.t) * arc[sample.segment] + sample.t * arc[sample.segment + 1];
    LinkVertex& vertex = link->vertices[std::lround(at / step)];
    for (const EdgelPull& pull : sample.pulls) vertex.support.push_back(pull.ref);
  }
  for (LinkVertex& vertex : link->vertices) SortUnique(&vertex.support);
}

// Refines a whole drawing.
class DrawingRefiner {
 public:
  DrawingRefiner(const RefinementInput& input, const RefinementOptions& options,
                 const TopologyOptions& topology, const RunContext& context)
      : input_(input),
        options_(options),
        topology_(topology),
        context_(context),
        rounds_(input, options, context) {}

  RefinementResult Run() {
    RefinementResult result;
    for (int round = 0; round < options_.num_rounds; ++round) {
      if (round > 0 && round == options_.num_rounds / 2) ChangeTopology();
      rounds_.Fit(rounds_.AllLinks(), round + 1 == options_.num_rounds);
    }
    rounds_.Finish(rounds_.AllLinks());
    result.fitted = RemoveCovered(WithVertices());
    result.summary = Summary();
    result.graph = std::move(rounds_.graph);
    return result;
  }

 private:
  void ChangeTopology() {
    rounds_.SetGeometry(rounds_.AllLinks());
    const DrawingGraph dense = WithVertices();
    for (size_t l = 0; l < rounds_.graph.links.size(); ++l) {
      DrawingLink& link = rounds_.graph.links[l];
      const DrawingLink& with_vertices = dense.links[l];
      if (!rounds_.control.links[l].frozen) {
        link = with_vertices;
      } else if (!with_vertices.vertices.empty()) {
        // It keeps its points; none of these vertices has edgels.
        link.vertices.assign(link.points_in_world.size(), with_vertices.vertices.front());
      }
    }
    RemoveCovered(dense);
    repairs_ = RepairTopology(rounds_.Images(1), topology_, context_, &rounds_.graph);
    for (DrawingLink& link : rounds_.graph.links) link.vertices.clear();
    rounds_.TakeGraph();
  }

  DrawingGraph WithVertices() const {
    DrawingGraph graph = rounds_.graph;
    for (size_t l = 0; l < graph.links.size(); ++l) {
      GiveVertices(rounds_.views, rounds_.control.links[l], &graph.links[l]);
    }
    return graph;
  }

  // `dense`: the graph, with vertices. Returns which of the links that remain are fitted.
  std::vector<uint8_t> RemoveCovered(const DrawingGraph& dense) {
    const std::vector<uint8_t> keep = FindUncoveredLinks(topology_, dense);
    std::vector<uint8_t> fitted;
    for (size_t l = 0; l < keep.size(); ++l) {
      num_covered_ += !keep[l];
      if (keep[l]) fitted.push_back(!rounds_.control.links[l].frozen);
    }
    num_frozen_ = std::ranges::count(fitted, 0);
    RemoveLinks(keep, &rounds_.graph);
    return fitted;
  }

  StageSummary Summary() const {
    StageSummary summary;
    summary.stage = "refinement";
    summary.in = {{"links", std::ssize(input_.graph.links)}};
    summary.kept = {{"links", std::ssize(rounds_.graph.links)},
                    {"links not fitted: too few views", num_frozen_},
                    {"control points", std::ssize(rounds_.control.position)},
                    {"long edges drawn anew", repairs_.long_edges.added},
                    {"circles drawn whole", repairs_.circles.added},
                    {"ends cut back from other links", repairs_.trimmed},
                    {"ends joined", repairs_.meetings.joined},
                    {"ends taken to nodes", repairs_.meetings.to_nodes},
                    {"ends taken to links", repairs_.meetings.to_links},
                    {"links cut at corners", repairs_.splits},
                    {"edges grown between nodes", repairs_.grown},
                    {"short edges between nodes", repairs_.short_edges},
                    {"dissolved nodes", repairs_.dissolved_nodes},
                    {"crossings", repairs_.coincidences.crossings},
                    {"nodes that another link passed", repairs_.coincidences.passed},
                    {"nodes united", repairs_.coincidences.nodes}};
    summary.dropped = {{"links: others run along them", num_covered_},
                       {"links: pieces of long edges", repairs_.long_edges.replaced},
                       {"links: parts of circles", repairs_.circles.replaced}};
    return summary;
  }

  const RefinementInput& input_;
  const RefinementOptions& options_;
  const TopologyOptions& topology_;
  const RunContext& context_;
  FitRounds rounds_;
  RepairCounts repairs_;
  int64_t num_covered_ = 0;
  int64_t num_frozen_ = 0;  // of the links that remain
};

// Refines in units of the scene.
RefinementResult RefineEdges(const RefinementInput& input, const RefinementOptions& options,
                             const TopologyOptions& topology, const RunContext& context) {
  const double unit = SceneUnit(input.scene.views, input.graph);
  const std::vector<View> views = Scaled(input.scene.views, 1 / unit);
  const DrawingGraph graph = Scaled(input.graph, 1 / unit);
  RefinementResult result =
      DrawingRefiner({{views, input.scene.curves}, graph}, options, topology, context).Run();
  result.graph = Scaled(std::move(result.graph), unit);
  return result;
}

}  // namespace

RefinementResult RefineDrawing(const RefinementInput& input, const RefinementOptions& options,
                               const TopologyOptions& topology, const RunContext& context) {
  options.Check();
  topology.Check();
  if (options.num_rounds == 0) {
    RefinementResult unchanged;
    unchanged.graph = input.graph;
    unchanged.summary.stage = "refinement";
    return unchanged;
  }
  return RefineEdges(input, options, topology, context);
}

}  // namespace limn
