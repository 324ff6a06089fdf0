// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/true_frame.h"

#include <map>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "colmap_ext/model/camera_calibration.h"
#include "colmap_ext/workspace/model_folder.h"
#include "limn/cameras/camera_scene.h"
#include "limn/cameras/gauge.h"
#include "limn/model/camera_rays.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

// A similarity fits any two cameras all but exactly.
constexpr size_t kMinCommonImages = 3;

// Optics of a model's cameras, made once for all images of a size.
class OpticsOfModel {
 public:
  const Optics& Of(const Camera& camera, const PinholeCamera& size) {
    const auto [entry, is_new] = made_.try_emplace({camera.id, size.width, size.height});
    if (is_new) entry->second = MakeOptics(camera, size.width, size.height);
    return entry->second;
  }

 private:
  std::map<std::tuple<uint32_t, int, int>, Optics> made_;
};

// Those of `views` that `others` has, too.
std::vector<View> InBoth(std::vector<View> views, const std::vector<View>& others) {
  std::unordered_set<std::string> names;
  for (const View& view : others) names.insert(view.name);
  std::erase_if(views, [&](const View& view) { return !names.contains(view.name); });
  return views;
}

// The views that have an image of their name in the model of a folder, with its pose and optics.
std::vector<View> WithCamerasOf(const std::string& model_path, const std::vector<View>& views) {
  const SparseModel model = ReadModel(model_path);
  std::unordered_map<std::string, const ModelImage*> images;
  for (const ModelImage& image : model.images) images[image.name] = &image;
  OpticsOfModel optics;
  std::vector<View> result;
  for (View view : views) {
    const auto image = images.find(view.name);
    if (image == images.end()) continue;
    const Camera& camera = model.CameraOf(*image->second);
    if (camera.IsPanorama()) continue;
    view.cam_from_world = image->second->cam_from_world;
    const Optics& of_image = optics.Of(camera, view.camera);
    result.push_back(WithOptics(std::move(view), of_image));
  }
  return result;
}

}  // namespace

TrueFrame FindTrueFrame(const std::vector<View>& views, const std::string& true_model_path,
                        const Eigen::Vector3d& middle) {
  TrueFrame frame;
  frame.views = WithCamerasOf(true_model_path, views);
  const size_t num_common = frame.views.size();
  if (num_common < kMinCommonImages) {
    throw IoError(true_model_path,
                  "true_model_path: only " + std::to_string(num_common) + " of the drawing's " +
                      std::to_string(views.size()) + " images (the first is " +
                      (views.empty() ? "none" : views.front().name) +
                      ") have a true camera, an image of the same name there; comparing takes " +
                      std::to_string(kMinCommonImages) + ": name the model with the true cameras");
  }
  const std::vector<View> made = InBoth(views, frame.views);
  std::vector<View> by_rays;
  for (size_t v = 0; v < made.size(); ++v) {
    by_rays.push_back(WithRaysInOpticsOf(frame.views[v], made[v]));
  }
  const Gauge gauge = FindGauge(by_rays, frame.views, middle);
  frame.true_from_model = gauge.given_from_refined.inverse();
  frame.cameras = MeasureCameraAccuracy(Moved(made, frame.true_from_model), frame.views);
  frame.cameras.num_wrong = gauge.moved_far.size();
  return frame;
}

}  // namespace limn::colmap_ext
