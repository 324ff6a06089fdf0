// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/sketched_scene.h"

#include "limn/drawing/drawing.h"
#include "limn/evaluation/edgel_account.h"
#include "limn/model/curve3d.h"

namespace limn::fuzz {
namespace {

constexpr int kNumEdgels = 10;

View MakeView(double x) {
  View view;
  view.camera = {100, 100, 50, 50, 101, 101};
  view.cam_from_world.translation = {-x, 0, 4};
  view.region.max_px = {100, 100};
  return view;
}

// A vertical line.
ImageCurves MakeCurves(double x_px) {
  ImageCurves curves;
  curves.edge_map.width = curves.edge_map.height = 101;
  curves.fragments.resize(1);
  for (EdgelId id = 0; id < kNumEdgels; ++id) {
    Edgel edgel;
    edgel.position_px = {x_px, 45.0 + id};
    edgel.tangent_rad = M_PI / 2;
    edgel.strength = 9;
    edgel.position_sigma_px = 0.1f;
    curves.edge_map.edgels.push_back(edgel);
    curves.fragments[0].edgel_ids.push_back(id);
  }
  ApplyLens(nullptr, &curves.edge_map);
  return curves;
}

}  // namespace

const std::vector<View>& SketchedViews() {
  static const std::vector<View> views = {MakeView(-0.5), MakeView(0.5)};
  return views;
}

const std::vector<ImageCurves>& SketchedCurves() {
  static const std::vector<ImageCurves> curves = {MakeCurves(62.5), MakeCurves(37.5)};
  return curves;
}

void DrawAndAccount(const CurveSketch& sketch, ViewId view, const std::vector<EdgelFate>& fates) {
  EdgelFates all(2, std::vector<EdgelFate>(kNumEdgels, EdgelFate::kNotSketched));
  if (!fates.empty()) all[view] = fates;
  RunContext context;
  context.num_threads = 1;
  const CurvesScene scene = {SketchedViews(), SketchedCurves()};
  const DrawingResult drawing = BuildDrawing({scene, sketch}, {}, context);
  AccountEdgels({scene, all, sketch, drawing.fates, drawing.graph}, context);
}

}  // namespace limn::fuzz
