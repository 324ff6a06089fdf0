// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/refined_model.h"

#include <algorithm>

#include "limn/util/errors.h"

namespace limn::colmap_ext {

namespace {

bool Fits(const SparseModel& model, const View& view) {
  if (static_cast<size_t>(view.model_index) >= model.images.size()) return false;
  if (static_cast<size_t>(view.camera_index) >= model.cameras.size()) return false;
  const ModelImage& image = model.images[view.model_index];
  return image.name == view.name && image.camera_id == model.cameras[view.camera_index].id;
}

void CheckUnchanged(const std::vector<View>& views, const SceneHints& hints,
                    const SparseModel& model) {
  const auto view_fits = [&](const View& view) { return Fits(model, view); };
  const auto hint_fits = [&](const ScenePoint& hint) {
    return hint.model_index < static_cast<int>(model.points.size());
  };
  if (std::ranges::all_of(views, view_fits) && std::ranges::all_of(hints.points, hint_fits)) return;
  throw IoError(model.folder.string(), "the model was changed while Limn was running");
}

}  // namespace

void ApplyRefinement(const std::vector<View>& views, const SceneHints& hints, SparseModel* model) {
  CheckUnchanged(views, hints, *model);
  for (const View& view : views) {
    model->images[view.model_index].cam_from_world = view.cam_from_world;
    if (!view.calibration) continue;
    const Eigen::VectorXd parameters = view.calibration->Parameters();
    model->cameras[view.camera_index].params.assign(parameters.begin(), parameters.end());
  }
  for (const ScenePoint& hint : hints.points) {
    if (hint.model_index < 0) continue;
    ModelPoint& point = model->points[hint.model_index];
    point.position = hint.position_in_world;
    point.error = -1;
  }
}

}  // namespace limn::colmap_ext
