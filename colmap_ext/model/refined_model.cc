#include "colmap_ext/model/refined_model.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

#include <Eigen/Geometry>

#include "limn/util/errors.h"
#include "limn/util/median.h"

namespace limn::colmap_ext {

namespace {

bool Fits(const SparseModel& model, const View& view) {
  if (static_cast<size_t>(view.model_index) >= model.images.size()) return false;
  if (static_cast<size_t>(view.camera_index) >= model.cameras.size()) return false;
  const ModelImage& image = model.images[view.model_index];
  return image.name == view.name && image.camera_id == model.cameras[view.camera_index].id;
}

void CheckUnchanged(const RefinedScene& refined, const SparseModel& model) {
  const auto view_fits = [&](const View& view) { return Fits(model, view); };
  const auto hint_fits = [&](const ScenePoint& hint) {
    return hint.model_index < static_cast<int>(model.points.size());
  };
  const std::vector<ScenePoint>& hints = refined.hints.points;
  if (std::all_of(refined.views.begin(), refined.views.end(), view_fits) &&
      std::all_of(hints.begin(), hints.end(), hint_fits)) {
    return;
  }
  throw IoError(model.folder.string(), "the model was changed while Limn was running");
}

}  // namespace

void ApplyRefinement(const RefinedScene& refined, SparseModel* model) {
  CheckUnchanged(refined, *model);
  std::set<int> done;
  for (size_t v = 0; v < refined.views.size(); ++v) {
    const View& view = refined.views[v];
    model->images[view.model_index].cam_from_world = view.cam_from_world;
    if (!done.insert(view.camera_index).second) continue;
    Camera& camera = model->cameras[view.camera_index];
    const int num_focals = FindCameraModel(static_cast<int32_t>(camera.model))->num_focals;
    const double factor = view.camera.fx / refined.given_views[v].camera.fx;
    for (int i = 0; i < num_focals; ++i) camera.params[i] *= factor;
  }
  for (size_t p = 0; p < refined.points.size(); ++p) {
    const int index = refined.hints.points[p].model_index;
    if (index < 0) continue;
    ModelPoint& point = model->points[index];
    point.position = refined.points[p];
    point.error = -1;
  }
}

std::vector<double> PoseShiftsPx(const std::set<size_t>& images, const SparseModel& from,
                                 const SparseModel& to) {
  std::unordered_map<uint64_t, const ModelPoint*> point_of_id;
  for (const ModelPoint& point : from.points) point_of_id.emplace(point.id, &point);
  std::vector<double> shifts;
  for (const size_t i : images) {
    const ModelImage& image = from.images[i];
    const double focal = from.CameraOf(image).params.front();
    std::vector<double> of_points;
    for (const Observation& observation : image.observations) {
      const auto point = point_of_id.find(observation.point3D_id);
      if (point == point_of_id.end()) continue;
      const Eigen::Vector3d before = image.cam_from_world * point->second->position;
      const Eigen::Vector3d after = to.images[i].cam_from_world * point->second->position;
      const double px = focal * (after.hnormalized() - before.hnormalized()).norm();
      if (std::isfinite(px)) of_points.push_back(px);
    }
    if (!of_points.empty()) shifts.push_back(Median(of_points));
  }
  return shifts;
}

}  // namespace limn::colmap_ext
