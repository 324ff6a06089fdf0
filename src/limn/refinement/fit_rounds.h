// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "limn/refinement/control_graph.h"
#include "limn/refinement/refinement_input.h"
#include "limn/refinement/refinement_options.h"
#include "limn/topology/topology_input.h"
#include "limn/util/parallel.h"

namespace limn {

// Per link, whether to fit it; the others keep their shape.
using FittedLinks = std::vector<uint8_t>;

// The links of a drawing as the unknowns of fits to the images, in rounds of matching and fitting.
// Shared by the refinement of a whole drawing and of some links. Holds references.
class FitRounds {
 public:
  FitRounds(const RefinementInput& input, const RefinementOptions& options,
            const RunContext& context);

  // Sets up the unknowns for the graph as it is now.
  void TakeGraph();
  // `reach`: multiple of max_distance_px.
  TopologyInput Images(double reach) const;
  void Match(double reach);
  // Matches and fits the links once. In the last round the points get covariances.
  void Fit(const FittedLinks& fitted, bool is_last);
  // Matches the links a last time and describes them: points, sigmas, and, where they were fitted,
  // supporting views and residuals.
  void Finish(const FittedLinks& fitted);
  // Moves nodes and links of the graph to the control points; frozen links follow their nodes.
  void SetGeometry(const FittedLinks& fitted);
  // The same after the last fit, with sigmas that tell how well the views agree. Call it once.
  void SetFinalGeometry(const FittedLinks& fitted);
  FittedLinks AllLinks() const { return FittedLinks(graph.links.size(), 1); }

  std::vector<View> views;  // with the cameras as they are now
  DrawingGraph graph;
  ControlGraph control;

 private:
  void ScaleCovariances();
  void KeepShape(const ControlLink& unfitted, DrawingLink* link) const;
  void SetPoints(const ControlLink& fitted, DrawingLink* link) const;
  double Sigma(const ControlLink& link, int k) const;

  const std::vector<ImageCurves>& curves_;
  const RefinementOptions& options_;
  const RunContext& context_;
  std::vector<std::unique_ptr<ViewEdgels>> edgels_;
};

}  // namespace limn
