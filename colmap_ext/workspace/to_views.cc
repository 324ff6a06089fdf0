#include "colmap_ext/workspace/to_views.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <numeric>
#include <set>
#include <system_error>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
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

// A panorama is four quarter turns wide.
int MaxSizeOf(bool is_panorama, int max_image_size) {
  return is_panorama && max_image_size > 0 ? 4 * max_image_size : max_image_size;
}

// What all images of one camera and one file size share.
struct Optics {
  PinholeCamera camera;
  std::shared_ptr<const LensMap> lens;
  ImageRegion region;  // without mask
  std::optional<ImageWindow> window;
  Eigen::Quaterniond part_from_image = Eigen::Quaterniond::Identity();
};

Optics MakePartOptics(ImageSize size, int part, double margin_px) {
  const int margin = static_cast<int>(std::ceil(margin_px));
  const PanoramaPart made = PanoramaParts(size.width, size.height, margin)[part];
  return {made.camera, made.lens, MakeImageRegion(made.camera, made.lens.get(), {}, margin_px),
          made.window, made.part_from_image};
}

// `part` is that of a panorama.
Optics MakeOptics(const Camera& stored, ImageSize file, int part, const ViewOptions& options) {
  const ImageSize size = ShrunkSize(file, MaxSizeOf(stored.IsPanorama(), options.max_image_size));
  if (stored.IsPanorama()) return MakePartOptics(size, part, options.border_margin_px);
  const Intrinsics intrinsics =
      Rescaled(IntrinsicsOf(stored), size.width / static_cast<double>(stored.width),
               size.height / static_cast<double>(stored.height));
  Optics optics;
  optics.camera = VirtualPinhole(intrinsics, size.width, size.height);
  if (!IsPinhole(intrinsics)) optics.lens = std::make_shared<CameraLensMap>(intrinsics);
  optics.region = MakeImageRegion(optics.camera, optics.lens.get(), {}, options.border_margin_px);
  return optics;
}

// Camera, file size and part.
using OpticsKey = std::tuple<uint32_t, int, int, int>;

// One Optics per key, made in parallel.
std::map<OpticsKey, Optics> MakeAllOptics(const std::map<OpticsKey, const Camera*>& inputs,
                                          const ViewOptions& options, const RunContext& context) {
  std::map<OpticsKey, Optics> result;
  std::vector<std::pair<Optics*, const std::pair<const OpticsKey, const Camera*>*>> jobs;
  for (const auto& input : inputs) jobs.emplace_back(&result[input.first], &input);
  ParallelFor(context, "cameras", jobs.size(), [&](size_t i) {
    const auto& [key, camera] = *jobs[i].second;
    const ImageSize size{std::get<1>(key), std::get<2>(key)};
    *jobs[i].first = MakeOptics(*camera, size, std::get<3>(key), options);
  });
  return result;
}

std::string MaskPath(const std::string& mask_dir, const std::string& image_name) {
  if (mask_dir.empty()) return "";
  const fs::path path = fs::path(mask_dir) / (image_name + ".png");
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) ? path.string() : "";
}

// Nothing if the observation is missing, of another point, no number, beyond what the lens maps, or
// not in the part that the view is.
std::optional<PointPixel> PixelOf(const SparseModel& model, const ViewSet& set, ViewId id,
                                  uint64_t point_id, uint32_t observation) {
  const View& view = set.views[id];
  const ImageWindow* window = set.Window(id);
  const ModelImage& image = model.images[view.model_index];
  if (!image.Shows(point_id, observation)) return std::nullopt;
  const Camera& camera = model.cameras[view.camera_index];
  const Eigen::Vector2d size(window ? window->image_width : view.camera.width,
                             window ? window->image_height : view.camera.height);
  const Eigen::Vector2d scale(size.x() / static_cast<double>(camera.width),
                              size.y() / static_cast<double>(camera.height));
  Eigen::Vector2d stored_px =
      scale.cwiseProduct(image.observations[observation].position) - Eigen::Vector2d(0.5, 0.5);
  if (!stored_px.allFinite()) return std::nullopt;
  if (window) stored_px = window->WindowFromImage(stored_px);
  if (!view.lens) return PointPixel{id, stored_px};
  const auto virtual_px = view.lens->VirtualFromStored(stored_px);
  const auto jacobian = VirtualFromStoredJacobian(*view.lens, stored_px);
  if (!virtual_px || !jacobian) return std::nullopt;
  if (window && !view.region.Contains(*virtual_px)) return std::nullopt;
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
    const ModelPoint& point,
    const std::unordered_map<uint32_t, std::vector<ViewId>>& views_of_image) {
  std::vector<std::pair<ViewId, uint32_t>> sights;
  for (const TrackElement& element : point.track) {
    const auto views = views_of_image.find(element.image_id);
    if (views == views_of_image.end()) continue;
    for (const ViewId view : views->second) sights.emplace_back(view, element.observation);
  }
  std::sort(sights.begin(), sights.end());
  return sights;
}

SceneHints MakeHints(const SparseModel& model, const SceneReach& reach, const ViewSet& set) {
  std::unordered_map<uint32_t, std::vector<ViewId>> views_of_image;
  for (size_t view = 0; view < set.views.size(); ++view) {
    const ModelImage& image = model.images[set.views[view].model_index];
    views_of_image[image.id].push_back(static_cast<ViewId>(view));
  }
  SceneHints hints;
  for (const int p : PointsById(model)) {
    if (!reach.Contains(model.points[p].position)) continue;
    ScenePoint hint;
    hint.position_in_world = model.points[p].position;
    hint.model_index = p;
    for (const auto& [view, observation] : Sights(model.points[p], views_of_image)) {
      const auto pixel = PixelOf(model, set, view, model.points[p].id, observation);
      if (set.Window(view) && !pixel) continue;  // in another part
      if (hint.views.empty() || hint.views.back() != view) hint.views.push_back(view);
      if (!hint.pixels.empty() && hint.pixels.back().view == view) continue;
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

// Points that no image sees, though maybe in no part of a panorama, or far outside the scene.
int64_t CountLostPoints(const SparseModel& model, const SceneReach& reach) {
  std::unordered_set<uint32_t> images;
  for (const ModelImage& image : model.images) images.insert(image.id);
  return std::count_if(model.points.begin(), model.points.end(), [&](const ModelPoint& point) {
    return !reach.Contains(point.position) ||
           std::none_of(point.track.begin(), point.track.end(), [&](const TrackElement& element) {
             return images.contains(element.image_id);
           });
  });
}

void AddWarnings(const SparseModel& model, const SceneReach& reach,
                 const std::vector<int>& selected, const std::vector<ImageSize>& sizes,
                 ViewSet* set) {
  int num_resized = 0;
  for (size_t i = 0; i < selected.size(); ++i) {
    const Camera& camera = model.CameraOf(model.images[selected[i]]);
    num_resized += static_cast<uint64_t>(sizes[i].width) != camera.width ||
                   static_cast<uint64_t>(sizes[i].height) != camera.height;
  }
  if (num_resized > 0) {
    set->warnings.push_back(std::to_string(num_resized) +
                            " images differ in size from their camera; intrinsics were rescaled");
  }
  if (selected.size() != model.images.size()) return;
  if (const int64_t num_lost = CountLostPoints(model, reach); num_lost > 0) {
    set->warnings.push_back(
        std::to_string(num_lost) +
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
  const CameraCheck check = CheckCameras(*set, max_px);
  if (check.misfits.empty()) return;
  const std::string misses = Describe(check, max_px);
  if (static_cast<int>(check.misfits.size()) == check.num_images) {
    throw InputError(model.folder.string() + ": no image is left, points miss " + misses +
                     " (max_reprojection_px)");
  }
  set->left_out.push_back("left out (max_reprojection_px), since points miss " + misses);
  set->warnings.push_back(set->left_out.back());
  std::set<std::string> misfits;
  for (const Misfit& misfit : check.misfits) misfits.insert(misfit.image);
  std::vector<uint8_t> keep;
  for (size_t v = 0; v < set->views.size(); ++v) {
    keep.push_back(!misfits.contains(set->ImageName(static_cast<ViewId>(v))));
  }
  Keep(keep, &set->views);
  Keep(keep, &set->image_paths);
  Keep(keep, &set->mask_paths);
  Keep(keep, &set->stored_sizes);
  Keep(keep, &set->is_damaged);
  if (set->HasPanoramas()) {
    Keep(keep, &set->windows);
    Keep(keep, &set->image_names);
    Keep(keep, &set->view_from_image);
  }
  set->hints = MakeHints(model, reach, *set);
}

void WarnOfMisfits(ViewSet* set) {
  const CameraCheck check = CheckCameras(*set, kDoubtfulCameraPx);
  if (check.misfits.empty()) return;
  const bool some_fit = check.num_fits > 0;
  set->warnings.push_back("points of the sparse model miss " + Describe(check, kDoubtfulCameraPx) +
                          ". Their poses, focal lengths or lenses are wrong" +
                          (some_fit ? "; --max_reprojection_px leaves such images out" : ""));
}

// Of a selected image (its place in the list) the whole, or a part of a panorama.
struct ViewSource {
  size_t image = 0;
  int part = 0;
};

std::vector<ViewSource> SourcesOf(const SparseModel& model, const std::vector<int>& selected) {
  std::vector<ViewSource> sources;
  for (size_t i = 0; i < selected.size(); ++i) {
    const bool is_panorama = model.CameraOf(model.images[selected[i]]).IsPanorama();
    for (int part = 0; part < (is_panorama ? kNumPanoramaParts : 1); ++part) {
      sources.push_back({i, part});
    }
  }
  return sources;
}

// From one item per image to one per view.
template <typename T>
void Spread(const std::vector<ViewSource>& sources, std::vector<T>* items) {
  std::vector<T> spread;
  for (const ViewSource& source : sources) spread.push_back((*items)[source.image]);
  *items = std::move(spread);
}

View MakeView(const SparseModel& model, int model_index, int part, const Optics& optics) {
  const ModelImage& image = model.images[model_index];
  View view;
  view.model_index = model_index;
  view.name = image.name;
  view.camera_index = static_cast<int>(&model.CameraOf(image) - model.cameras.data());
  view.camera = optics.camera;
  view.cam_from_world = image.cam_from_world;
  view.lens = optics.lens;
  view.region = optics.region;
  if (!optics.window) return view;
  char suffix[20];
  std::snprintf(suffix, sizeof(suffix), ".part%02d", part);
  view.name += suffix;
  view.cam_from_world =
      Rigid3d{optics.part_from_image, Eigen::Vector3d::Zero()} * image.cam_from_world;
  return view;
}

void CheckDistinctNames(const std::vector<View>& views) {
  std::set<std::string> names;
  for (const View& view : views) {
    if (names.insert(view.name).second) continue;
    throw InputError("image \"" + view.name +
                     "\" has the name of a part of a panorama: rename one of them");
  }
}

// From the pixels of a part to those of the image.
class WholeImageLens : public LensMap {
 public:
  WholeImageLens(std::shared_ptr<const LensMap> part, const ImageWindow& window)
      : part_(std::move(part)), origin_px_(window.x, window.y) {}

  std::optional<Eigen::Vector2d> VirtualFromStored(
      const Eigen::Vector2d& stored_px) const override {
    return part_->VirtualFromStored(stored_px - origin_px_);
  }
  std::optional<Eigen::Vector2d> StoredFromVirtual(
      const Eigen::Vector2d& virtual_px) const override {
    const auto stored_px = part_->StoredFromVirtual(virtual_px);
    if (!stored_px) return std::nullopt;
    return *stored_px + origin_px_;
  }

 private:
  std::shared_ptr<const LensMap> part_;
  Eigen::Vector2d origin_px_;
};

bool IsLastPart(const ViewSet& set, ViewId view) {
  const size_t next = static_cast<size_t>(view) + 1;
  return next == set.views.size() || set.image_paths[next] != set.image_paths[view];
}

Image Cut(const Image& image, const ImageWindow& window) {
  Image part;
  part.width = window.width;
  part.height = window.height;
  part.channels = image.channels;
  part.data = CutPixels(image.data, window, image.channels);
  return part;
}

Image ReadPixels(const ViewSet& set, ViewId view) {
  const std::string& path = set.image_paths[view];
  const auto decode = [&] { return set.photos.Read(path, set.MaxFileSize(view)); };
  const ImageWindow* window = set.Window(view);
  if (!window) return decode();
  const auto whole = set.decoded->images.Get(path, IsLastPart(set, view), decode);
  return window->IsOf(whole->width, whole->height) ? Cut(*whole, *window) : *whole;
}

}  // namespace

size_t ViewSet::CountImages(const std::vector<ViewId>& of_views) const {
  std::set<std::string> names;
  for (const ViewId view : of_views) names.insert(ImageName(view));
  return names.size();
}

int ViewSet::MaxFileSize(ViewId view) const {
  return MaxSizeOf(Window(view) != nullptr, max_image_size);
}

std::vector<View> InWholeImages(const ViewSet& view_set, std::vector<View> views) {
  for (size_t v = 0; v < views.size(); ++v) {
    const ImageWindow* window = view_set.Window(static_cast<ViewId>(v));
    if (!window) continue;
    views[v].name = view_set.image_names[v];
    views[v].lens = std::make_shared<WholeImageLens>(views[v].lens, *window);
  }
  return views;
}

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
    const bool is_panorama = model.CameraOf(model.images[selected[i]]).IsPanorama();
    CheckedImage checked =
        photos.Check(set.image_paths[i], MaxSizeOf(is_panorama, options.max_image_size));
    set.stored_sizes[i] = checked.size;
    complaints[i] = std::move(checked.complaint);
  });
  AddComplaints(complaints, &set);

  const std::vector<ViewSource> sources = SourcesOf(model, selected);
  std::map<OpticsKey, const Camera*> inputs;
  std::vector<OpticsKey> keys;
  for (const auto& [i, part] : sources) {
    const Camera& camera = model.CameraOf(model.images[selected[i]]);
    const ImageSize size = set.stored_sizes[i];
    CheckSizeFitsCamera(set.image_paths[i], size, camera);
    keys.emplace_back(camera.id, size.width, size.height, part);
    inputs[keys.back()] = &camera;
  }
  const std::map<OpticsKey, Optics> optics = MakeAllOptics(inputs, options, context);

  const std::vector<ImageSize> sizes_of_images = set.stored_sizes;
  Spread(sources, &set.image_paths);
  Spread(sources, &set.mask_paths);
  Spread(sources, &set.stored_sizes);
  Spread(sources, &set.is_damaged);
  if (sources.size() > selected.size()) set.decoded = std::make_shared<DecodedPanoramas>();
  for (size_t v = 0; v < sources.size(); ++v) {
    const int image = selected[sources[v].image];
    const Optics& of_view = optics.at(keys[v]);
    set.views.push_back(MakeView(model, image, sources[v].part, of_view));
    if (!set.decoded) continue;
    set.windows.push_back(of_view.window);
    set.image_names.push_back(model.images[image].name);
    set.view_from_image.push_back(of_view.part_from_image);
  }
  CheckDistinctNames(set.views);
  ParallelFor(context, "views", set.views.size(), [&](size_t i) {
    View& view = set.views[i];
    const auto mask = ReadViewMask(set, static_cast<ViewId>(i));
    if (mask.empty()) return;
    view.region = MakeImageRegion(view.camera, view.lens.get(), mask, options.border_margin_px);
  });
  ReleaseDecoded(set);
  set.hints = MakeHints(model, used.reach, set);
  AddWarnings(model, used.reach, selected, sizes_of_images, &set);
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
  const std::string& path = view_set.mask_paths[view];
  if (path.empty()) return {};
  const auto decode = [&] {
    return ReadMask(path, view_set.stored_sizes[view], view_set.MaxFileSize(view));
  };
  const ImageWindow* window = view_set.Window(view);
  if (!window) return decode();
  return CutPixels(*view_set.decoded->masks.Get(path, IsLastPart(view_set, view), decode), *window,
                   1);
}

Image ReadViewImage(const ViewSet& view_set, ViewId view) {
  const PinholeCamera& camera = view_set.views[view].camera;
  Image image;
  if (view_set.is_damaged[view]) {
    image = BlackImage(camera.width, camera.height);
  } else {
    image = ReadPixels(view_set, view);
  }
  if (image.width != camera.width || image.height != camera.height) {
    throw IoError(view_set.image_paths[view], "the image changed its size while Limn was running");
  }
  image.mask = ReadViewMask(view_set, view);
  return image;
}

void ReleaseDecoded(const ViewSet& view_set) {
  if (!view_set.decoded) return;
  view_set.decoded->images.Clear();
  view_set.decoded->masks.Clear();
}

}  // namespace limn::colmap_ext
