// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/point_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "colmap_ext/model/camera_projection.h"
#include "limn/util/median.h"
#include "limn/util/name_list.h"
#include "limn/util/number_text.h"

namespace limn::colmap_ext {
namespace {

constexpr size_t kMinPointsOfFrame = 10;
constexpr double kMinGain = 5;
// Scaling by less is a wrong camera rather than another picture.
constexpr double kMinScaling = .03;
// A wrong focal length scales about the principal point; share of the image's size.
constexpr double kMaxShiftOfFocal = .02;
// Points outside the image of their camera, which a wrong camera does not make.
constexpr double kMinShareOutside = .02;

// Of frames of pictures of one size: in scale, and of the size.
constexpr double kMaxDifference = .01;
constexpr double kMinShareAlike = .8;
constexpr size_t kMinAlike = 3;

struct PointPair {
  Eigen::Vector2d point;   // as stored
  Eigen::Vector2d camera;  // where the camera sees the 3D point
};

std::unordered_map<uint64_t, const ModelPoint*> PointsByIdOf(const SparseModel& model) {
  std::unordered_map<uint64_t, const ModelPoint*> points;
  for (const ModelPoint& point : model.points) points.emplace(point.id, &point);
  return points;
}

std::vector<PointPair> PairsOf(const ModelImage& image, const Camera& camera,
                               const CameraProjection& projection,
                               const std::unordered_map<uint64_t, const ModelPoint*>& points) {
  std::vector<PointPair> pairs;
  const Eigen::Array2d size(static_cast<double>(camera.width), static_cast<double>(camera.height));
  for (const Observation& observation : image.observations) {
    const auto point = points.find(observation.point3D_id);
    if (point == points.end() || !observation.position.allFinite()) continue;
    const Eigen::Vector3d ray = image.cam_from_world * point->second->position;
    if (!(ray.z() > 0)) continue;
    const auto pixel = projection.PixelFromRay(ray.hnormalized());
    const bool is_near =
        pixel && (pixel->array() > -size).all() && (pixel->array() < 2 * size).all();
    if (is_near) pairs.push_back({observation.position, *pixel});
  }
  return pairs;
}

double MedianMiss(const std::vector<PointPair>& pairs, const PointFrame& frame) {
  std::vector<double> misses;
  for (const PointPair& pair : pairs) {
    misses.push_back((frame.CameraPixel(pair.point) - pair.camera).norm());
  }
  return Median(std::move(misses));
}

// The median slope of pairs that are half the list apart (Theil and Sen), and the median rest.
bool FitAxis(int axis, std::vector<PointPair> pairs, PointFrame* frame) {
  std::ranges::sort(pairs, {}, [&](const PointPair& pair) { return pair.camera[axis]; });
  std::vector<double> slopes;
  const size_t half = pairs.size() / 2;
  for (size_t i = 0; i + half < pairs.size(); ++i) {
    const double run = pairs[i + half].camera[axis] - pairs[i].camera[axis];
    if (run > 1) slopes.push_back((pairs[i + half].point[axis] - pairs[i].point[axis]) / run);
  }
  if (slopes.size() < half / 2) return false;
  const double scale = Median(std::move(slopes));
  if (!(scale > 1e-3 && scale < 1e3)) return false;
  std::vector<double> rests;
  for (const PointPair& pair : pairs) rests.push_back(pair.point[axis] - scale * pair.camera[axis]);
  frame->scale[axis] = scale;
  frame->shift[axis] = Median(std::move(rests));
  return true;
}

Eigen::Array2d SizeOf(const Camera& camera) {
  return {static_cast<double>(camera.width), static_cast<double>(camera.height)};
}

bool AreOutside(const std::vector<PointPair>& pairs, const Eigen::Array2d& size) {
  const auto num_outside = std::ranges::count_if(pairs, [&](const PointPair& pair) {
    return (pair.point.array() < -1).any() || (pair.point.array() > size + 1).any();
  });
  return static_cast<double>(num_outside) > kMinShareOutside * static_cast<double>(pairs.size());
}

// Whether it is a wrong camera that explains the difference as well.
bool MayBeCamera(const PointFrame& frame, const Camera& camera) {
  const Eigen::Array2d size = SizeOf(camera);
  if (((frame.scale - 1).abs() < kMinScaling).all()) return true;
  const Intrinsics intrinsics = IntrinsicsOf(camera);
  const Eigen::Array2d center(intrinsics.cx, intrinsics.cy);
  const Eigen::Array2d moved = frame.scale * center + frame.shift - center;
  return (moved.abs() < kMaxShiftOfFocal * size).all();
}

// An image with enough points.
struct JudgedImage {
  int index = 0;
  std::optional<PointFrame> frame;
  bool is_outside = false;
};

std::optional<PointFrame> FrameOf(const std::vector<PointPair>& pairs, bool is_outside,
                                  const Camera& camera, double doubtful_px) {
  const double miss = MedianMiss(pairs, {});
  if (miss <= doubtful_px) return std::nullopt;
  PointFrame frame;
  for (const int axis : {0, 1}) {
    if (!FitAxis(axis, pairs, &frame)) return std::nullopt;
  }
  const double rest = MedianMiss(pairs, frame);
  if (rest > doubtful_px || kMinGain * rest > miss) return std::nullopt;
  if (!is_outside && MayBeCamera(frame, camera)) return std::nullopt;
  return frame;
}

// Programs treat pictures of one size alike; errors of poses differ.
void KeepAlike(const Eigen::Array2d& size, std::vector<JudgedImage>* images) {
  std::array<std::vector<double>, 4> numbers;
  for (const JudgedImage& image : *images) {
    if (!image.frame) continue;
    for (const int axis : {0, 1}) {
      numbers[axis].push_back(image.frame->scale[axis]);
      numbers[2 + axis].push_back(image.frame->shift[axis]);
    }
  }
  if (numbers[0].empty()) return;
  const Eigen::Array2d scale(Median(numbers[0]), Median(numbers[1]));
  const Eigen::Array2d shift(Median(numbers[2]), Median(numbers[3]));
  size_t num_alike = 0, num_outside = 0;
  for (JudgedImage& image : *images) {
    if (!image.frame) continue;
    const bool is_alike =
        ((image.frame->scale / scale - 1).abs() < kMaxDifference).all() &&
        ((image.frame->shift - shift).abs() < kMaxDifference * scale * size).all();
    if (!is_alike) image.frame.reset();
    num_alike += is_alike;
    num_outside += is_alike && image.is_outside;
  }
  const bool are_enough = num_alike >= kMinAlike || num_outside > 0;
  if (are_enough &&
      static_cast<double>(num_alike) >= kMinShareAlike * static_cast<double>(images->size())) {
    return;
  }
  for (JudgedImage& image : *images) image.frame.reset();
}

std::string Pair(const Eigen::Array2d& values) {
  return values.x() == values.y() || std::abs(values.x() / values.y() - 1) < 1e-3
             ? ShortNumber(values.mean())
             : ShortNumber(values.x()) + " and " + ShortNumber(values.y());
}

}  // namespace

PointFrames FindPointFrames(const SparseModel& model, const std::vector<int>& images,
                            double doubtful_px) {
  const auto points = PointsByIdOf(model);
  std::map<uint32_t, std::unique_ptr<CameraProjection>> projections;
  std::map<std::pair<uint64_t, uint64_t>, std::vector<JudgedImage>> judged;
  for (const int index : images) {
    const ModelImage& image = model.images[index];
    const Camera& camera = model.CameraOf(image);
    if (camera.IsPanorama()) continue;
    std::unique_ptr<CameraProjection>& projection = projections[camera.id];
    if (!projection) projection = std::make_unique<CameraProjection>(IntrinsicsOf(camera));
    const std::vector<PointPair> pairs = PairsOf(image, camera, *projection, points);
    if (pairs.size() < kMinPointsOfFrame) continue;
    const bool is_outside = AreOutside(pairs, SizeOf(camera));
    judged[{camera.width, camera.height}].push_back(
        {index, FrameOf(pairs, is_outside, camera, doubtful_px), is_outside});
  }
  PointFrames frames;
  for (auto& [size, alike] : judged) {
    KeepAlike({static_cast<double>(size.first), static_cast<double>(size.second)}, &alike);
    for (const JudgedImage& image : alike) {
      if (image.frame) frames.emplace(image.index, *image.frame);
    }
  }
  return frames;
}

std::string DescribeFrames(const PointFrames& frames, const SparseModel& model, size_t num_images) {
  int first = frames.begin()->first;
  for (const auto& [index, frame] : frames) {
    if (model.images[index].name < model.images[first].name) first = index;
  }
  const PointFrame& frame = frames.at(first);
  return "the 2D points of " + std::to_string(frames.size()) + " of " + std::to_string(num_images) +
         " images are pixels of pictures of another size, such as resized, padded or cropped "
         "ones: they fit the cameras after scaling by " +
         Pair(1 / frame.scale) + " (" + model.images[first].name +
         "). They are used so; cameras and images are used as they are";
}

}  // namespace limn::colmap_ext
