// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/fit_other_cameras.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "limn/refinement/control_graph.h"
#include "limn/refinement/curve_fit.h"
#include "limn/refinement/fit_rounds.h"
#include "limn/refinement/scene_unit.h"
#include "limn/topology/topology_input.h"
#include "limn/util/median.h"

namespace limn {
namespace {

constexpr int kNumFits = 4;
// Scale of the loss, in multiples of the median residual.
constexpr double kScaleOfLoss = 1.5;
// Wrong cameras move curves smoothly, but along a curve other views see it, each with its own
// error: bends of the motion count so much more than those of a curve.
constexpr double kStiffness = 32;

// Calls visit(link, sample) for all samples that are fitted.
template <typename Visit>
void ForSamples(ControlGraph* control, const Visit& visit) {
  for (ControlLink& link : control->links) {
    if (link.frozen) continue;
    for (FitSample& sample : link.samples) visit(link, &sample);
  }
}

// The edgels as these images have them; without those that their lenses cannot map.
void SeeEdgels(const TopologyInput& images, ControlGraph* control) {
  ForSamples(control, [&](const ControlLink&, FitSample* sample) {
    std::erase_if(sample->pulls, [&](const EdgelPull& pull) {
      return images.edgels[pull.ref.view]->place_of[pull.ref.edgel].fragment < 0;
    });
    for (EdgelPull& pull : sample->pulls) pull.line = images.LineOf(pull.ref);
  });
}

// Returns their median size.
double MeasureResiduals(const std::vector<View>& views, ControlGraph* control) {
  std::vector<double> sizes_px;
  ForSamples(control, [&](const ControlLink& link, FitSample* sample) {
    const Eigen::Vector3d& from = control->position[link.points[sample->segment]];
    const Eigen::Vector3d& to = control->position[link.points[sample->segment + 1]];
    sample->position = from + sample->t * (to - from);
    for (EdgelPull& pull : sample->pulls) {
      const auto residual = ResidualToEdgel(views[pull.ref.view], pull.line, sample->position);
      pull.residual_px = residual ? residual->residual_px : kBehindCameraPx;
      sizes_px.push_back(std::abs(pull.residual_px));
    }
  });
  return Median(std::move(sizes_px));
}

// Fits with a loss as wide as the residuals. Returns their medians before and after.
std::pair<double, double> Fit(const std::vector<View>& views, const RefinementOptions& options,
                              const RunContext& context, ControlGraph* control) {
  const double before_px = MeasureResiduals(views, control);
  double residual_px = before_px;
  RefinementOptions widened = options;
  for (int i = 0; i < kNumFits; ++i) {
    widened.robust_residual_px = std::max(options.robust_residual_px, kScaleOfLoss * residual_px);
    FitCurves(views, widened, context, i + 1 == kNumFits, control);
    residual_px = MeasureResiduals(views, control);
  }
  return {before_px, residual_px};
}

// Sigmas, residuals and points of the links after the fit. Returns how many were not fitted.
int64_t Describe(FitRounds* rounds) {
  rounds->SetFinalGeometry(rounds->AllLinks());
  int64_t num_frozen = 0;
  for (size_t l = 0; l < rounds->graph.links.size(); ++l) {
    DrawingLink& link = rounds->graph.links[l];
    const ControlLink& fitted = rounds->control.links[l];
    link.primitive.reset();
    link.regularity.reset();
    link.body.reset();
    num_frozen += fitted.frozen;
    if (!fitted.frozen) link.residual_px = Median(ResidualsPx(fitted));
  }
  rounds->graph.regularities = {};
  rounds->graph.faces.clear();
  return num_frozen;
}

// In units of the scene.
OtherCamerasResult FitInUnits(const OtherCamerasInput& input, const RefinementOptions& options,
                              const RunContext& context) {
  FitRounds own(input.drawing, options, context);
  own.Match(1);
  FreezeUnshown(&own.control);
  RefinementOptions stiff = options;
  stiff.bending_sigma /= kStiffness;
  FitRounds rounds({input.others, input.drawing.graph}, stiff, context);
  rounds.control = std::move(own.control);
  rounds.control.keeps_shape = true;
  SeeEdgels(rounds.Images(1), &rounds.control);
  FreezeUnshown(&rounds.control);
  OtherCamerasResult result;
  std::tie(result.before_px, result.after_px) = Fit(rounds.views, stiff, context, &rounds.control);
  const int64_t num_frozen = Describe(&rounds);
  result.summary.stage = "fit to other cameras";
  result.summary.in = {{"links", std::ssize(rounds.graph.links)}};
  result.summary.kept = {{"links fitted", std::ssize(rounds.graph.links) - num_frozen},
                         {"links not fitted: too few views", num_frozen}};
  result.graph = std::move(rounds.graph);
  return result;
}

}  // namespace

OtherCamerasResult FitOtherCameras(const OtherCamerasInput& input, const RefinementOptions& options,
                                   const RunContext& context) {
  options.Check();
  const double unit = SceneUnit(input.drawing.scene.views, input.drawing.graph);
  const std::vector<View> views = Scaled(input.drawing.scene.views, 1 / unit);
  const std::vector<View> others = Scaled(input.others.views, 1 / unit);
  const DrawingGraph graph = Scaled(input.drawing.graph, 1 / unit);
  OtherCamerasResult result =
      FitInUnits({{{views, input.drawing.scene.curves}, graph}, {others, input.others.curves}},
                 options, context);
  result.graph = Scaled(std::move(result.graph), unit);
  return result;
}

}  // namespace limn
