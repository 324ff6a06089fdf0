// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cameras/camera_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limn/model/lens_jacobian.h"
#include "limn/model/shrunk.h"
#include "limn/model/usable_edgels.h"
#include "limn/refinement/scene_unit.h"

namespace limn {
namespace {

// Pixels along a side at which effects of parameters are compared.
constexpr int kEffectSteps = 8;

Eigen::VectorXd ParametersPerPx(const View& view) {
  Eigen::VectorXd effect_px = Eigen::VectorXd::Zero(view.calibration->Parameters().size());
  for (int i = 0; i <= kEffectSteps; ++i) {
    for (int j = 0; j <= kEffectSteps; ++j) {
      const Eigen::Vector2d stored(i * (view.camera.width - 1.0) / kEffectSteps,
                                   j * (view.camera.height - 1.0) / kEffectSteps);
      const auto px = view.VirtualFromStored(stored);
      if (!px) continue;
      if (const auto columns = view.calibration->StoredByParameters(*px)) {
        effect_px = effect_px.cwiseMax(columns->colwise().norm().transpose());
      }
    }
  }
  return effect_px.unaryExpr([](double px) { return px > 0 ? 1 / px : 0; });
}

// Curves that lenses have mapped, back in stored pixels.
ImageCurves AsStored(ImageCurves curves) {
  for (Edgel& edgel : curves.edge_map.edgels) {
    const Eigen::Vector2d tangent = edgel.stored_from_virtual.cast<double>() * edgel.Tangent();
    edgel.position_px = edgel.stored_px.cast<double>();
    edgel.tangent_rad = std::atan2(tangent.y(), tangent.x());
    edgel.stored_from_virtual.setIdentity();
  }
  return curves;
}

void ApplyLensTo(const View& view, ImageCurves* curves) {
  RemoveUnusableEdgels(ApplyLens(view.lens.get(), &curves->edge_map), curves);
}

std::vector<ImageCurves> CurvesThroughLenses(const std::vector<View>& shrunk_views,
                                             const PictureLevel& level, const RunContext& context) {
  if (level.factor == 1) return CurvesThroughOtherLenses(shrunk_views, level.curves, context);
  std::vector<ImageCurves> curves = level.curves;
  ParallelFor(context, "lenses", curves.size(),
              [&](size_t v) { ApplyLensTo(shrunk_views[v], &curves[v]); });
  return curves;
}

}  // namespace

CameraScene MakeCameraScene(const std::vector<View>& views, const SceneHints& hints,
                            const CameraMounts& mounts) {
  CameraScene scene = {views, mounts, views, {}};
  for (const ScenePoint& hint : hints.points) {
    SeenPoint& point = scene.points.emplace_back();
    point.position = hint.position_in_world;
    for (const PointPixel& pixel : hint.pixels) {
      const auto stored_px = views[pixel.view].StoredFromVirtual(pixel.position_px);
      if (stored_px) point.sights.push_back({pixel.view, *stored_px});
    }
  }
  return scene;
}

SceneHints HintsOf(const CameraScene& scene, const SceneHints& given,
                   const std::vector<View>& views) {
  SceneHints hints = given;
  for (size_t p = 0; p < hints.points.size(); ++p) {
    ScenePoint& hint = hints.points[p];
    hint.position_in_world = scene.points[p].position;
    hint.pixels.clear();
    for (const SeenPoint::Sight& sight : scene.points[p].sights) {
      const auto pixel = ThroughLens(views[sight.view].lens.get(), sight.stored_px);
      if (!pixel) continue;
      hint.pixels.push_back({sight.view, pixel->virtual_px, pixel->stored_from_virtual});
    }
  }
  return hints;
}

CameraScene Scaled(CameraScene scene, double factor) {
  scene.given = Scaled(std::move(scene.given), factor);
  scene.views = Scaled(std::move(scene.views), factor);
  for (CameraMount& mount : scene.mounts.of_view) mount.view_from_body.translation *= factor;
  for (SeenPoint& point : scene.points) point.position *= factor;
  return scene;
}

double ViewPxPerPicturePx(const View& view, int factor) {
  return factor == 1 ? 1 : factor * view.scale;
}

std::vector<View> ShrunkViews(const std::vector<View>& views, int factor) {
  std::vector<View> shrunk;
  for (const View& view : views) shrunk.push_back(Shrunk(view, ViewPxPerPicturePx(view, factor)));
  return shrunk;
}

const std::vector<ImageCurves>& CurvesSeenNow(const CameraScene& scene, const RunContext& context,
                                              PictureLevel* level) {
  const bool are_as_made =
      level->factor == 1
          ? std::ranges::equal(scene.views, scene.given, {}, &View::lens, &View::lens)
          : std::ranges::none_of(scene.views,
                                 [](const View& view) { return view.lens != nullptr; });
  if (!are_as_made && std::ranges::equal(scene.views, level->seen_through, {}, &View::lens)) {
    return level->seen;
  }
  level->seen_through = {};
  level->seen = {};  // before there are new ones
  if (are_as_made) return level->curves;
  level->seen = CurvesThroughLenses(ShrunkViews(scene.views, level->factor), *level, context);
  for (const View& view : scene.views) level->seen_through.push_back(view.lens);
  return level->seen;
}

std::vector<ImageCurves> CurvesThroughOtherLenses(const std::vector<View>& views,
                                                  const std::vector<ImageCurves>& curves,
                                                  const RunContext& context) {
  std::vector<ImageCurves> seen(curves.size());
  ParallelFor(context, "lenses", curves.size(), [&](size_t v) {
    seen[v] = AsStored(curves[v]);
    ApplyLensTo(views[v], &seen[v]);
  });
  return seen;
}

View WithOptics(View view, const Optics& optics) {
  const bool is_pinhole = !view.lens && !optics.lens;
  if (!is_pinhole) {
    const View before = view;
    view.region = MakeImageRegion(optics.camera, optics.lens.get(), [&](const auto& stored_px) {
      const auto px = before.VirtualFromStored(stored_px);
      return px && before.region.Contains(*px);
    });
  }
  SetOptics(optics, &view);
  return view;
}

std::map<int, Eigen::VectorXd> ParametersPerPx(const std::vector<View>& views) {
  std::map<int, Eigen::VectorXd> per_px;
  for (const View& view : views) {
    if (!view.calibration || per_px.contains(view.camera_index)) continue;
    per_px[view.camera_index] = ParametersPerPx(view);
  }
  return per_px;
}

}  // namespace limn
