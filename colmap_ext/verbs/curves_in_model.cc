// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/curves_in_model.h"

#include <string>
#include <utility>

#include "colmap_ext/dense_files/sparse_with_curves.h"
#include "colmap_ext/verbs/views_of_drawing.h"
#include "limn/dense/drawing_samples.h"
#include "limn/formats/colors.h"
#include "limn/model/drawing_paths.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

void CheckHasNoPanoramas(const SparseModel& model) {
  for (const ModelImage& image : model.images) {
    if (!model.CameraOf(image).IsPanorama()) continue;
    throw InputError("camera " + std::to_string(image.camera_id) +
                     " is EQUIRECTANGULAR: its images take no points of curves");
  }
}

std::vector<CurvePoint> ColoredPoints(const DrawingGraph& graph, const std::vector<View>& views,
                                      double spacing_px) {
  const std::vector<LinkId> curves = CurvesOf(graph);
  const DrawingSamples samples = SampleDrawing(graph, views, spacing_px);
  std::vector<CurvePoint> points(samples.size());
  for (size_t s = 0; s < samples.size(); ++s) {
    const LinkId link = samples.link[s];
    const Color color = ColorOfCurve(curves[link]);
    points[s].position = samples.position[s];
    points[s].views = graph.links[link].supporting_views;
    points[s].link = link;
    points[s].color = {color.red, color.green, color.blue};
  }
  return points;
}

}  // namespace

SparseModel WithCurves(DrawingFile drawing, SparseModel model, const std::vector<View>& views,
                       double spacing_px) {
  CheckHasNoPanoramas(model);
  const DrawingGraph graph = WithViewsOf(model, views, std::move(drawing));
  return AddCurvePoints(std::move(model), ColoredPoints(graph, views, spacing_px), views,
                        /*every=*/1);
}

}  // namespace limn::colmap_ext
