#include "colmap_ext/workspace/to_views.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <system_error>
#include <tuple>
#include <unordered_map>
#include <utility>

#include <Eigen/LU>

#include "colmap_ext/model/camera_lens_map.h"
#include "colmap_ext/model/scene_reach.h"
#include "colmap_ext/workspace/camera_check.h"
#include "colmap_ext/workspace/select_images.h"
#include "limn/model/lens_jacobian.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// Median error of the model's points beyond which a camera is not good enough to draw from. COLMAP
// keeps no point beyond 4 px in an image, and right cameras have a median well below 1 px.
constexpr double kDoubtfulCameraPx = 2;

// The file may be a resized version of what the camera describes; anything else is a wrong image.
void CheckSizeFitsCamera(const std::string& path, ImageSize file, const Camera& camera) {
  const double width = static_cast<double>(camera.width);
  const double height = static_cast<double>(camera.height);
  const double error = std::min(std::abs(file.width * height / width - file.height),
                                std::abs(file.height * width / height - file.width));
  if (error <= 1) return;
  throw IoError(path, "the image is " + std::to_string(file.width) + " x " +
                          std::to_string(file.height) + " pixels, but its camera " +
                          std::to_string(camera.id) + " is " + std::to_string(camera.width) +
                          " x " + std::to_string(camera.height) +
                          ": not the images of this model? (raw and undistorted ones differ)");
}

// What all images of one camera and one file size share.
struct Optics {
  PinholeCamera camera;
  std::shared_ptr<const LensMap> lens;
  ImageRegion region;  // without mask
};

Optics MakeOptics(const Camera& stored, ImageSize file, const ViewOptions& options) {
  const ImageSize size = ShrunkSize(file, options.max_image_size);
  const Intrinsics intrinsics =
      Rescaled(IntrinsicsOf(stored), size.width / static_cast<double>(stored.width),
               size.height / static_cast<double>(stored.height));
  Optics optics;
  optics.camera = VirtualPinhole(intrinsics, size.width, size.height);
  if (!IsPinhole(intrinsics)) optics.lens = std::make_shared<CameraLensMap>(intrinsics);
  optics.region = MakeImageRegion(optics.camera, optics.lens.get(), {}, options.border_margin_px);
  return optics;
}

using OpticsKey = std::tuple<uint32_t, int, int>;

// One Optics per camera and file size, made in parallel.
std::map<OpticsKey, Optics> MakeAllOptics(
    const std::map<OpticsKey, std::pair<const Camera*, ImageSize>>& inputs,
    const ViewOptions& options, const RunContext& context) {
  std::map<OpticsKey, Optics> result;
  std::vector<std::pair<Optics*, const std::pair<const Camera*, ImageSize>*>> jobs;
  for (const auto& [key, input] : inputs) jobs.emplace_back(&result[key], &input);
  ParallelFor(context, "cameras", jobs.size(), [&](size_t i) {
    const auto& [camera, size] = *jobs[i].second;
    *jobs[i].first = MakeOptics(*camera, size, options);
  });
  return result;
}

std::string MaskPath(const std::string& mask_dir, const std::string& image_name) {
  if (mask_dir.empty()) return "";
  const fs::path path = fs::path(mask_dir) / (image_name + ".png");
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) ? path.string() : "";
}

// Nothing if the observation is missing, of another point, no number, or beyond what the lens maps.
std::optional<PointPixel> PixelOf(const SparseModel& model, const std::vector<View>& views,
                                  ViewId id, uint64_t point_id, uint32_t observation) {
  const View& view = views[id];
  const ModelImage& image = model.images[view.model_index];
  if (!image.Shows(point_id, observation)) return std::nullopt;
  const Camera& camera = model.cameras[view.camera_index];
  const Eigen::Vector2d scale(view.camera.width / static_cast<double>(camera.width),
                              view.camera.height / static_cast<double>(camera.height));
  const Eigen::Vector2d stored_px =
      scale.cwiseProduct(image.observations[observation].position) - Eigen::Vector2d(0.5, 0.5);
  if (!stored_px.allFinite()) return std::nullopt;
  if (!view.lens) return PointPixel{id, stored_px};
  const auto virtual_px = view.lens->VirtualFromStored(stored_px);
  const auto jacobian = VirtualFromStoredJacobian(*view.lens, stored_px);
  if (!virtual_px || !jacobian) return std::nullopt;
  return PointPixel{id, *virtual_px, jacobian->inverse()};
}

// Indices into model.points, sorted by id: COLMAP writes points in the order of a hash table.
std::vector<int> PointsById(const SparseModel& model) {
  std::vector<int> order(model.points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return model.points[a].id < model.points[b].id; });
  return order;
}

// The views that see a point and its observations there, ascending; a view may see it twice.
std::vector<std::pair<ViewId, uint32_t>> Sights(
    const ModelPoint& point, const std::unordered_map<uint32_t, ViewId>& view_of_image) {
  std::vector<std::pair<ViewId, uint32_t>> sights;
  for (const TrackElement& element : point.track) {
    const auto view = view_of_image.find(element.image_id);
    if (view != view_of_image.end()) sights.emplace_back(view->second, element.observation);
  }
  std::sort(sights.begin(), sights.end());
  return sights;
}

SceneHints MakeHints(const SparseModel& model, const SceneReach& reach,
                     const std::vector<View>& views) {
  std::unordered_map<uint32_t, ViewId> view_of_image;
  for (size_t view = 0; view < views.size(); ++view) {
    view_of_image[model.images[views[view].model_index].id] = static_cast<ViewId>(view);
  }
  SceneHints hints;
  for (const int p : PointsById(model)) {
    if (!reach.Contains(model.points[p].position)) continue;
    ScenePoint hint;
    hint.position_in_world = model.points[p].position;
    hint.model_index = p;
    for (const auto& [view, observation] : Sights(model.points[p], view_of_image)) {
      if (hint.views.empty() || hint.views.back() != view) hint.views.push_back(view);
      if (!hint.pixels.empty() && hint.pixels.back().view == view) continue;
      const auto pixel = PixelOf(model, views, view, model.points[p].id, observation);
      if (pixel) hint.pixels.push_back(*pixel);
    }
    if (!hint.views.empty()) hints.points.push_back(std::move(hint));
  }
  return hints;
}

void AddComplaints(const std::vector<std::optional<JpegComplaint>>& complaints, ViewSet* set) {
  for (size_t i = 0; i < complaints.size(); ++i) {
    set->is_damaged.push_back(complaints[i] && complaints[i]->is_damage);
    if (!complaints[i]) continue;
    set->warnings.push_back(set->image_paths[i] + ": " + complaints[i]->text +
                            (complaints[i]->is_damage ? "; the whole image counts as masked" : ""));
  }
}

Image BlackImage(int width, int height) {
  Image image;
  image.width = width;
  image.height = height;
  image.channels = 1;
  image.data.assign(static_cast<size_t>(width) * height, 0);
  return image;
}

// Nothing if all images have one, or none was asked for.
void AddMaskWarning(const std::string& mask_dir, ViewSet* set) {
  const auto num_without = std::count(set->mask_paths.begin(), set->mask_paths.end(), "");
  if (mask_dir.empty() || num_without == 0) return;
  set->warnings.push_back(mask_dir + ": " + std::to_string(num_without) + " of " +
                          std::to_string(set->mask_paths.size()) +
                          " images have no mask there (<image name>.png) and are used entirely");
}

void AddWarnings(const SparseModel& model, const std::vector<int>& selected, ViewSet* set) {
  int num_resized = 0;
  for (size_t i = 0; i < selected.size(); ++i) {
    const Camera& camera = model.CameraOf(model.images[selected[i]]);
    num_resized += static_cast<uint64_t>(set->stored_sizes[i].width) != camera.width ||
                   static_cast<uint64_t>(set->stored_sizes[i].height) != camera.height;
  }
  if (num_resized > 0) {
    set->warnings.push_back(std::to_string(num_resized) +
                            " images differ in size from their camera; intrinsics were rescaled");
  }
  if (selected.size() == model.images.size() && set->hints.points.size() < model.points.size()) {
    set->warnings.push_back(
        std::to_string(model.points.size() - set->hints.points.size()) +
        " 3D points are seen by no image or far outside the scene, and were left out");
  }
}

// Keeps what is not left out, in order.
template <typename T>
void Keep(const std::vector<uint8_t>& keep, std::vector<T>* items) {
  std::vector<T> kept;
  for (size_t i = 0; i < items->size(); ++i) {
    if (keep[i]) kept.push_back(std::move((*items)[i]));
  }
  *items = std::move(kept);
}

void LeaveOutMisfits(const SparseModel& model, const SceneReach& reach, double max_px,
                     ViewSet* set) {
  const CameraCheck check = CheckCameras(set->views, set->hints, max_px);
  if (check.misfits.empty()) return;
  const std::string misses = Describe(check, set->views, max_px);
  if (check.misfits.size() == set->views.size()) {
    throw InputError(model.folder.string() + ": no image is left, points miss " + misses +
                     " (max_reprojection_px)");
  }
  set->left_out.push_back("left out (max_reprojection_px), since points miss " + misses);
  set->warnings.push_back(set->left_out.back());
  std::vector<uint8_t> keep(set->views.size(), 1);
  for (const Misfit& misfit : check.misfits) keep[misfit.view] = 0;
  Keep(keep, &set->views);
  Keep(keep, &set->image_paths);
  Keep(keep, &set->mask_paths);
  Keep(keep, &set->stored_sizes);
  Keep(keep, &set->is_damaged);
  set->hints = MakeHints(model, reach, set->views);
}

void WarnOfMisfits(ViewSet* set) {
  const CameraCheck check = CheckCameras(set->views, set->hints, kDoubtfulCameraPx);
  if (check.misfits.empty()) return;
  const bool some_fit = check.num_fits > 0;
  set->warnings.push_back("points of the sparse model miss " +
                          Describe(check, set->views, kDoubtfulCameraPx) +
                          ". Their poses, focal lengths or lenses are wrong" +
                          (some_fit ? "; --max_reprojection_px leaves such images out" : ""));
}

}  // namespace

void ViewOptions::Check() const {
  LIMN_CHECK_RANGE_OR(max_image_size, -1, >= 16, <= 1e5);
  LIMN_CHECK_RANGE(border_margin_px, >= 0, <= 1e5);
  LIMN_CHECK_RANGE(max_reprojection_px, >= 0, <= 1e6);
}

ViewSet ToViews(const SparseModel& model, const fs::path& image_dir, const ViewOptions& options,
                const RunContext& context, const PhotoStore& photos) {
  options.Check();
  if (std::error_code ignored;
      !options.mask_path.empty() && !fs::is_directory(options.mask_path, ignored)) {
    throw IoError(options.mask_path, "no such folder (mask_path)");
  }
  const SelectedImages used =
      SelectImages(model, image_dir, options.image_list_path, photos, context);
  const std::vector<int>& selected = used.images;
  ViewSet set;
  set.warnings = model.warnings;
  set.warnings.insert(set.warnings.end(), used.warnings.begin(), used.warnings.end());
  set.left_out = used.warnings;
  set.max_image_size = options.max_image_size;
  set.image_paths = used.paths;
  set.photos = photos;
  for (const int index : selected) {
    set.mask_paths.push_back(MaskPath(options.mask_path, model.images[index].name));
  }
  AddMaskWarning(options.mask_path, &set);
  set.stored_sizes.resize(selected.size());
  std::vector<std::optional<JpegComplaint>> complaints(selected.size());
  ParallelFor(context, "image headers", selected.size(), [&](size_t i) {
    CheckedImage checked = photos.Check(set.image_paths[i], options.max_image_size);
    set.stored_sizes[i] = checked.size;
    complaints[i] = std::move(checked.complaint);
  });
  AddComplaints(complaints, &set);

  std::map<OpticsKey, std::pair<const Camera*, ImageSize>> inputs;
  std::vector<OpticsKey> keys;
  for (size_t i = 0; i < selected.size(); ++i) {
    const Camera& camera = model.CameraOf(model.images[selected[i]]);
    const ImageSize size = set.stored_sizes[i];
    CheckSizeFitsCamera(set.image_paths[i], size, camera);
    keys.emplace_back(camera.id, size.width, size.height);
    inputs[keys.back()] = {&camera, size};
  }
  const std::map<OpticsKey, Optics> optics = MakeAllOptics(inputs, options, context);

  set.views.resize(selected.size());
  ParallelFor(context, "views", selected.size(), [&](size_t i) {
    const ModelImage& image = model.images[selected[i]];
    const Optics& of_view = optics.at(keys[i]);
    View& view = set.views[i];
    view.model_index = selected[i];
    view.name = image.name;
    view.camera_index = static_cast<int>(&model.CameraOf(image) - model.cameras.data());
    view.camera = of_view.camera;
    view.cam_from_world = image.cam_from_world;
    view.lens = of_view.lens;
    view.region = of_view.region;
    const auto mask = ReadViewMask(set, static_cast<ViewId>(i));
    if (mask.empty()) return;
    view.region = MakeImageRegion(view.camera, view.lens.get(), mask, options.border_margin_px);
  });
  set.hints = MakeHints(model, used.reach, set.views);
  AddWarnings(model, selected, &set);
  if (options.max_reprojection_px > 0) {
    LeaveOutMisfits(model, used.reach, options.max_reprojection_px, &set);
  }
  WarnOfMisfits(&set);
  return set;
}

Eigen::Vector2d ModelPixel(const View& view, const Camera& camera,
                           const Eigen::Vector2d& stored_px) {
  return {(stored_px.x() + 0.5) * static_cast<double>(camera.width) / view.camera.width,
          (stored_px.y() + 0.5) * static_cast<double>(camera.height) / view.camera.height};
}

std::vector<unsigned char> ReadViewMask(const ViewSet& view_set, ViewId view) {
  const PinholeCamera& camera = view_set.views[view].camera;
  if (view_set.is_damaged[view]) {
    return std::vector<unsigned char>(static_cast<size_t>(camera.width) * camera.height, 0);
  }
  if (view_set.mask_paths[view].empty()) return {};
  return ReadMask(view_set.mask_paths[view], view_set.stored_sizes[view], view_set.max_image_size);
}

Image ReadViewImage(const ViewSet& view_set, ViewId view) {
  const PinholeCamera& camera = view_set.views[view].camera;
  Image image;
  if (view_set.is_damaged[view]) {
    image = BlackImage(camera.width, camera.height);
  } else {
    image = view_set.photos.Read(view_set.image_paths[view], view_set.max_image_size);
  }
  if (image.width != camera.width || image.height != camera.height) {
    throw IoError(view_set.image_paths[view], "the image changed its size while Limn was running");
  }
  image.mask = ReadViewMask(view_set, view);
  return image;
}

}  // namespace limn::colmap_ext
