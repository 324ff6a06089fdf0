// SPDX-License-Identifier: BSD-3-Clause
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

#include "colmap_ext/model/camera_calibration.h"
#include "colmap_ext/model/scene_reach.h"
#include "colmap_ext/workspace/camera_check.h"
#include "colmap_ext/workspace/find_image_forms.h"
#include "colmap_ext/workspace/find_masks.h"
#include "colmap_ext/workspace/hold_images.h"
#include "colmap_ext/workspace/image_header.h"
#include "colmap_ext/workspace/mounts_of_model.h"
#include "colmap_ext/workspace/point_frames.h"
#include "colmap_ext/workspace/select_images.h"
#include "limn/edges/edge_blur.h"
#include "limn/model/lens_jacobian.h"
#include "limn/util/errors.h"
#include "limn/util/median.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// Median error of the model's points beyond which a camera is not good enough to draw from. COLMAP
// keeps no point beyond 4 px in an image, and right cameras have a median well below 1 px.
constexpr double kDoubtfulCameraPx = 2;

// The file may be a resized version of what the camera describes; anything else is a wrong image.
void CheckSizeFitsCamera(const std::string& path, ImageSize file, const Camera& camera) {
  const auto width = static_cast<double>(camera.width);
  const auto height = static_cast<double>(camera.height);
  if (IsResized(file, width, height)) return;
  const bool is_turned = IsResized(file, height, width);
  throw IoError(
      path, "the image is " + std::to_string(file.width) + " x " + std::to_string(file.height) +
                " pixels, but its camera " + std::to_string(camera.id) + " is " +
                std::to_string(camera.width) + " x " + std::to_string(camera.height) +
                (is_turned ? ": is one of them turned? The file has no EXIF orientation that says "
                             "so: turn it as it was for structure from motion"
                           : ": not the images of this model? (raw and undistorted ones differ)"));
}

// What all images of one camera and one file size share.
struct SharedOptics {
  Optics optics;
  ImageRegion region;  // without mask
  std::optional<ImageWindow> window;
  Eigen::Quaterniond part_from_image = Eigen::Quaterniond::Identity();
};

SharedOptics MakePartOptics(ImageSize size, int part, double margin_px) {
  const int margin = static_cast<int>(std::ceil(margin_px));
  const PanoramaPart made = PanoramaParts(size.width, size.height, margin)[part];
  return {{made.camera, made.lens, nullptr},
          MakeImageRegion(made.camera, made.lens.get(), {}, margin_px),
          made.window,
          made.part_from_image};
}

int Enlarged(int side, double scale) { return static_cast<int>(std::lround(scale * side)); }

// `part` is that of a panorama.
SharedOptics MakeSharedOptics(const Camera& stored, ImageSize file, int part, double scale,
                              const ViewOptions& options) {
  const ImageSize size =
      ShrunkSize(file, MaxSizeOfFile(stored.IsPanorama(), options.max_image_size));
  if (stored.IsPanorama()) return MakePartOptics(size, part, options.border_margin_px);
  SharedOptics shared;
  shared.optics = MakeOptics(stored, Enlarged(size.width, scale), Enlarged(size.height, scale));
  shared.region = MakeImageRegion(shared.optics.camera, shared.optics.lens.get(), {},
                                  scale * options.border_margin_px);
  return shared;
}

// Camera, file size, part and scale.
using OpticsKey = std::tuple<uint32_t, int, int, int, double>;

// One per key, made in parallel.
std::map<OpticsKey, SharedOptics> MakeAllOptics(const std::map<OpticsKey, const Camera*>& inputs,
                                                const ViewOptions& options,
                                                const RunContext& context) {
  std::map<OpticsKey, SharedOptics> result;
  std::vector<std::pair<SharedOptics*, const std::pair<const OpticsKey, const Camera*>*>> jobs;
  for (const auto& input : inputs) jobs.emplace_back(&result[input.first], &input);
  ParallelFor(context, "cameras", jobs.size(), [&](size_t i) {
    const auto& [key, camera] = *jobs[i].second;
    const ImageSize size{std::get<1>(key), std::get<2>(key)};
    *jobs[i].first = MakeSharedOptics(*camera, size, std::get<3>(key), std::get<4>(key), options);
  });
  return result;
}

// Nothing if the observation is missing, of another point, no number, beyond what the lens maps, or
// not in the part that the view is.
std::optional<PointPixel> PixelOf(const SparseModel& model, const PointFrames& frames,
                                  const ViewSet& set, ViewId id, uint64_t point_id,
                                  uint32_t observation) {
  const View& view = set.views[id];
  const ImageWindow* window = set.Window(id);
  const ModelImage& image = model.images[view.model_index];
  if (!image.Shows(point_id, observation)) return std::nullopt;
  const Camera& camera = model.cameras[view.camera_index];
  const Eigen::Vector2d size(window ? window->image_width : view.camera.width,
                             window ? window->image_height : view.camera.height);
  const Eigen::Vector2d scale(size.x() / static_cast<double>(camera.width),
                              size.y() / static_cast<double>(camera.height));
  Eigen::Vector2d model_px = image.observations[observation].position;
  const auto frame = frames.find(view.model_index);
  if (frame != frames.end()) model_px = frame->second.CameraPixel(model_px);
  Eigen::Vector2d stored_px = scale.cwiseProduct(model_px) - Eigen::Vector2d(0.5, 0.5);
  if (!stored_px.allFinite()) return std::nullopt;
  if (window) stored_px = window->WindowFromImage(stored_px);
  const auto pixel = ThroughLens(view.lens.get(), stored_px);
  if (!pixel) return std::nullopt;
  if (window && !view.region.Contains(pixel->virtual_px)) return std::nullopt;
  return PointPixel{id, pixel->virtual_px, pixel->stored_from_virtual};
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

SceneHints MakeHints(const SparseModel& model, const SceneReach& reach, const PointFrames& frames,
                     const ViewSet& set) {
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
      const auto pixel = PixelOf(model, frames, set, view, model.points[p].id, observation);
      if (set.Window(view) && !pixel) continue;  // in another part
      if (hint.views.empty() || hint.views.back() != view) hint.views.push_back(view);
      if (!hint.pixels.empty() && hint.pixels.back().view == view) continue;
      if (pixel) hint.pixels.push_back(*pixel);
    }
    if (!hint.views.empty()) hints.points.push_back(std::move(hint));
  }
  return hints;
}

void NoteScaledMasks(const std::vector<ViewFile>& files, std::vector<std::string>* notes) {
  size_t num_scaled = 0;
  std::string example;
  for (const ViewFile& file : files) {
    if (file.mask_path.empty()) continue;
    const auto size = ReadSizeFromHeader(fs::path(file.mask_path));
    if (!size || *size == file.stored_size ||
        !IsResized(*size, file.stored_size.width, file.stored_size.height)) {
      continue;
    }
    if (num_scaled++ == 0) example = Text(*size) + " for " + Text(file.stored_size);
  }
  if (num_scaled == 0) return;
  notes->push_back(std::to_string(num_scaled) + " masks are of another size than their images (" +
                   example + "), and are scaled");
}

// The files of these images, whole; their headers are read in parallel.
std::vector<ViewFile> ReadFiles(const SparseModel& model, const SelectedImages& used,
                                const ViewOptions& options, const PhotoStore& photos,
                                const RunContext& context, ViewSet* set) {
  std::vector<ViewFile> files(used.images.size());
  FoundMasks masks = FindMasks(options.mask_path, model, used.images, used.paths);
  for (size_t i = 0; i < files.size(); ++i) {
    files[i].image_name = model.images[used.images[i]].name;
    files[i].image_path = used.paths[i];
    files[i].mask_path = std::move(masks.paths[i]);
  }
  set->warnings.insert(set->warnings.end(), masks.warnings.begin(), masks.warnings.end());
  set->notes.insert(set->notes.end(), masks.notes.begin(), masks.notes.end());
  std::vector<std::optional<JpegComplaint>> complaints(files.size());
  ParallelFor(context, "image headers", files.size(), [&](size_t i) {
    const bool is_panorama = model.CameraOf(model.images[used.images[i]]).IsPanorama();
    CheckedImage checked =
        photos.Check(files[i].image_path, MaxSizeOfFile(is_panorama, options.max_image_size));
    files[i].stored_size = checked.size;
    complaints[i] = std::move(checked.complaint);
  });
  for (size_t i = 0; i < files.size(); ++i) {
    if (!complaints[i]) continue;
    files[i].is_damaged = complaints[i]->is_damage;
    set->warnings.push_back(files[i].image_path + ": " + complaints[i]->text +
                            (complaints[i]->is_damage ? "; the whole image counts as masked" : ""));
  }
  SetForms(model, used.images, photos, context, &files, &set->notes);
  NoteScaledMasks(files, &set->notes);
  return files;
}

// Images of one camera and size that tell how sharp all of them are.
constexpr size_t kMaxMeasured = 12;
// Of a view that is finer than its image: more would take gigabytes.
constexpr double kMaxViewPixels = 24e6;

// View::scale of each image. Decodes some of them, in parallel.
std::vector<double> MeasureScales(const SparseModel& model, const SelectedImages& used,
                                  const std::vector<ViewFile>& files, const ViewOptions& options,
                                  const PhotoStore& photos, const RunContext& context) {
  std::vector<double> scales(files.size(), 1);
  if (options.max_scale == 1) return scales;
  std::map<std::tuple<uint32_t, int, int>, std::vector<size_t>> alike;
  for (size_t i = 0; i < files.size(); ++i) {
    const Camera& camera = model.CameraOf(model.images[used.images[i]]);
    const ViewFile& file = files[i];
    if (camera.IsPanorama()) continue;
    alike[{camera.id, file.stored_size.width, file.stored_size.height}].push_back(i);
  }
  std::vector<size_t> measured;
  for (const auto& [key, of_camera] : alike) {
    const size_t count = std::min(kMaxMeasured, of_camera.size());
    for (size_t k = 0; k < count; ++k) {
      const size_t i = of_camera[k * of_camera.size() / count];
      if (!files[i].is_damaged) measured.push_back(i);
    }
  }
  std::vector<std::optional<double>> blurs(files.size());
  ParallelFor(context, "sharpness of images", measured.size(), [&](size_t k) {
    const ViewFile& file = files[measured[k]];
    Image image = photos.Read(file.image_path, options.max_image_size, file.form);
    image.mask = ReadFileMask(file, options.max_image_size);
    blurs[measured[k]] = MeasureEdgeBlur(image);
  });
  for (const auto& [key, of_camera] : alike) {
    std::vector<double> of_images;
    for (const size_t i : of_camera) {
      if (blurs[i]) of_images.push_back(*blurs[i]);
    }
    if (of_images.empty()) continue;
    const ImageSize stored = files[of_camera[0]].stored_size;
    const ImageSize read = ShrunkSize(stored, options.max_image_size);
    const double most = std::sqrt(kMaxViewPixels / static_cast<double>(read.NumPixels()));
    const double scale = ScaleOf(Median(std::move(of_images)), std::min(options.max_scale, most));
    for (const size_t i : of_camera) scales[i] = scale;
  }
  return scales;
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

void AddWarnings(const SparseModel& model, const SelectedImages& used,
                 const std::vector<ViewFile>& files, std::vector<std::string>* warnings) {
  int num_resized = 0;
  for (size_t i = 0; i < files.size(); ++i) {
    const Camera& camera = model.CameraOf(model.images[used.images[i]]);
    num_resized += static_cast<uint64_t>(files[i].stored_size.width) != camera.width ||
                   static_cast<uint64_t>(files[i].stored_size.height) != camera.height;
  }
  if (num_resized > 0) {
    warnings->push_back(std::to_string(num_resized) +
                        " images differ in size from their camera; intrinsics were rescaled");
  }
  if (files.size() != model.images.size()) return;
  if (const int64_t num_lost = CountLostPoints(model, used.reach); num_lost > 0) {
    warnings->push_back(
        std::to_string(num_lost) +
        " 3D points are seen by no image or far outside the scene, and were left out");
  }
}

// The frames of 2D points that are pixels of other pictures, as the hints then take them.
PointFrames SetHints(const SparseModel& model, const SelectedImages& used, ViewSet* set) {
  set->hints = MakeHints(model, used.reach, {}, *set);
  if (CheckCameras(*set, kDoubtfulCameraPx).misfits.empty()) return {};
  PointFrames frames = FindPointFrames(model, used.images, kDoubtfulCameraPx);
  if (frames.empty()) return frames;
  set->hints = MakeHints(model, used.reach, frames, *set);
  set->notes.push_back(DescribeFrames(frames, model, used.images.size()));
  return frames;
}

void LeaveOutMisfits(const SparseModel& model, const SceneReach& reach, const PointFrames& frames,
                     double max_px, ViewSet* set) {
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
  std::vector<View> views;
  std::vector<ViewFile> files;
  for (size_t v = 0; v < set->views.size(); ++v) {
    if (misfits.contains(set->files[v].image_name)) continue;
    views.push_back(std::move(set->views[v]));
    files.push_back(std::move(set->files[v]));
  }
  set->views = std::move(views);
  set->files = std::move(files);
  set->hints = MakeHints(model, reach, frames, *set);
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

View MakeView(const SparseModel& model, int model_index, int part, double scale,
              const SharedOptics& optics) {
  const ModelImage& image = model.images[model_index];
  View view;
  view.model_index = model_index;
  view.name = image.name;
  view.camera_index = static_cast<int>(&model.CameraOf(image) - model.cameras.data());
  SetOptics(optics.optics, &view);
  view.scale = scale;
  view.cam_from_world = image.cam_from_world;
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

// Adds the views of these images, and their files; `scales` is View::scale of each image.
void AddViews(const SparseModel& model, const std::vector<int>& images,
              const std::vector<ViewFile>& files, const std::vector<double>& scales,
              const ViewOptions& options, const RunContext& context, ViewSet* set) {
  const std::vector<ViewSource> sources = SourcesOf(model, images);
  std::map<OpticsKey, const Camera*> cameras;
  std::vector<OpticsKey> keys;
  for (const auto& [i, part] : sources) {
    const Camera& camera = model.CameraOf(model.images[images[i]]);
    const ImageSize size = files[i].stored_size;
    CheckSizeFitsCamera(files[i].image_path, size, camera);
    keys.emplace_back(camera.id, size.width, size.height, part, scales[i]);
    cameras[keys.back()] = &camera;
  }
  const std::map<OpticsKey, SharedOptics> optics = MakeAllOptics(cameras, options, context);
  for (size_t v = 0; v < sources.size(); ++v) {
    const auto& [i, part] = sources[v];
    const SharedOptics& of_view = optics.at(keys[v]);
    set->views.push_back(MakeView(model, images[i], part, scales[i], of_view));
    set->files.push_back(files[i]);
    set->files.back().window = of_view.window;
    set->files.back().view_from_image = of_view.part_from_image;
  }
  CheckDistinctNames(set->views);
  if (set->HasPanoramas()) set->decoded = std::make_shared<DecodedPanoramas>();
}

// Confines views to what their masks leave of them.
void ApplyMasks(double margin_px, const RunContext& context, ViewSet* set) {
  ParallelFor(context, "views", set->views.size(), [&](size_t i) {
    View& view = set->views[i];
    const auto mask = ReadViewMask(*set, static_cast<ViewId>(i));
    if (mask.empty()) return;
    view.region = MakeImageRegion(view.camera, view.lens.get(), mask, view.scale * margin_px);
  });
  ReleaseDecoded(*set);
}

}  // namespace

void ViewOptions::Check() const {
  LIMN_CHECK_RANGE_OR(max_image_size, -1, >= 16, <= 1e5);
  LIMN_CHECK_RANGE(max_scale, >= 1, <= 4);
  LIMN_CHECK_RANGE(border_margin_px, >= 0, <= 1e5);
  LIMN_CHECK_RANGE(max_reprojection_px, >= 0, <= 1e6);
}

double ScaleOf(double edge_blur_px, double max_scale) {
  constexpr double kBlurInView = 0.8;
  constexpr double kSteps = 4;
  const double scale = std::min(kBlurInView / std::max(edge_blur_px, 1e-3), max_scale);
  return std::max(1.0, std::floor(kSteps * scale + 0.5) / kSteps);
}

ViewSet ToViews(const SparseModel& model, const fs::path& image_dir, const ViewOptions& options,
                const RunContext& context, const PhotoStore& photos) {
  options.Check();
  const SelectedImages used = SelectImages(model, image_dir, options.image_list_path,
                                           options.skip_missing_images, photos, context);
  ViewSet set;
  set.warnings = model.warnings;
  set.warnings.insert(set.warnings.end(), used.warnings.begin(), used.warnings.end());
  set.left_out = used.warnings;
  set.notes = used.notes;
  set.max_image_size = options.max_image_size;
  set.photos = photos;
  const std::vector<ViewFile> files = ReadFiles(model, used, options, photos, context, &set);
  const std::vector<double> scales = MeasureScales(model, used, files, options, photos, context);
  AddViews(model, used.images, files, scales, options, context, &set);
  ApplyMasks(options.border_margin_px, context, &set);
  const PointFrames frames = SetHints(model, used, &set);
  AddWarnings(model, used, files, &set.warnings);
  if (options.max_reprojection_px > 0) {
    LeaveOutMisfits(model, used.reach, frames, options.max_reprojection_px, &set);
  }
  WarnOfMisfits(&set);
  set.mounts = MountsOf(model, set);
  if (!options.hold_images.empty()) HoldImages(model, options.hold_images, &set);
  return set;
}

Eigen::Vector2d ModelPixel(const View& view, const Camera& camera,
                           const Eigen::Vector2d& stored_px) {
  return {(stored_px.x() + 0.5) * static_cast<double>(camera.width) / view.camera.width,
          (stored_px.y() + 0.5) * static_cast<double>(camera.height) / view.camera.height};
}

}  // namespace limn::colmap_ext
