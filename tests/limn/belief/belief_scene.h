// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "limn/belief/image_evidence.h"
#include "limn/belief/link_claims.h"
#include "limn/support/view_edgels.h"
#include "limn/topology/graph_fixture.h"
#include "limn/topology/topology_input.h"
#include "support/synthetic_scene.h"

namespace limn::testing {

// That of the refinement.
inline constexpr SupportGate kShowingGate = {1.0, 1.0, 15 * M_PI / 180};

// Sixteen views straight down, 0.3 apart, from a height of 5 on the plane z = 0, where a pixel is
// kFrontalPx large.
struct BeliefScene {
  std::vector<View> views = FrontalViews(4, 4, 0.3);
  std::vector<std::vector<SceneCurve>> shown = std::vector<std::vector<SceneCurve>>(16);
  DrawingGraph graph;

  // In all views, or in the first `num_views`.
  void Show(const SceneCurve& curve, size_t num_views = 16) {
    for (size_t v = 0; v < num_views; ++v) shown[v].push_back(curve);
  }

  LinkId Draw(const Polyline3d& points, double sigma_px = 0.4) {
    const LinkId id = DrawLink(points, {}, &graph);
    graph.links[id].sigma.assign(points.size(), sigma_px * kFrontalPx);
    return id;
  }

  // What is shown and drawn, too.
  LinkId Add(const Eigen::Vector3d& from, const Eigen::Vector3d& to, size_t num_views = 16) {
    Show(Segment(from, to), num_views);
    return Draw({from, to});
  }

  std::vector<ImageCurves> Curves(double noise_px = 0) const {
    std::vector<ImageCurves> curves;
    for (size_t v = 0; v < views.size(); ++v) {
      curves.push_back(ProjectCurves(views[v], shown[v], noise_px, static_cast<unsigned>(v)));
    }
    return curves;
  }

  // With the claims found.
  std::vector<ImageEvidence> Evidence(double noise_px = 0) const {
    const std::vector<ImageCurves> curves = Curves(noise_px);
    const auto edgels = BuildViewEdgels(curves, {});
    const TopologyInput input = Input(curves, edgels);
    const ViewFinder finder(views);
    std::vector<ImageEvidence> links;
    for (const DrawingLink& link : graph.links) links.push_back(FindEvidence(input, finder, link));
    FindClaims(input, {}, &links);
    return links;
  }

  TopologyInput Input(const std::vector<ImageCurves>& curves,
                      const std::vector<std::unique_ptr<ViewEdgels>>& edgels) const {
    return {views, curves, edgels, {1.0, 1.0, M_PI / 12}};
  }
};

}  // namespace limn::testing
