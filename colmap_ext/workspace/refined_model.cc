#include "colmap_ext/workspace/refined_model.h"

#include <set>

namespace limn::colmap_ext {

void ApplyRefinement(const RefinedScene& refined, SparseModel* model) {
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
    ModelPoint& point = model->points[refined.hints.points[p].model_index];
    point.position = refined.points[p];
    point.error = -1;
  }
}

}  // namespace limn::colmap_ext
