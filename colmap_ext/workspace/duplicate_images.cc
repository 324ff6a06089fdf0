// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/duplicate_images.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

#include <Eigen/Geometry>

#include "colmap_ext/model/camera_projection.h"
#include "limn/util/median.h"

namespace limn::colmap_ext {
namespace {

constexpr double kSamePosePx = 0.25;
// Copies that structure from motion gave poses of their own.
constexpr double kCopyPosePx = 2;
constexpr double kSamePictureLevels = 2;
constexpr int kPictureSize = 64;
// Copies differ, px by px, by less than this share of what the difference of their poses would
// change. Where that is less than the second in pictures of this size, nothing tells.
constexpr int kCopySize = 1024;
constexpr double kCopyShare = 0.5;
constexpr double kLeastTellingPx = 0.5;
// A picture is compared with so many others.
constexpr int kMaxCompared = 8;
// Of the distances of cameras from their middle: poses that differ by more are never compared.
constexpr double kMaxRelativeDistance = 1e-2;

// Of the numbers among them; 0 if there are none.
double MedianOf(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  return Median(std::move(values));
}

// Of each file that has the size of another one; empty for others.
std::vector<std::string> IdentitiesOfEqualSizes(const std::vector<std::string>& paths,
                                                const PhotoStore& photos,
                                                const RunContext& context) {
  std::map<uint64_t, std::vector<size_t>> of_size;
  for (size_t i = 0; i < paths.size(); ++i) of_size[photos.NumBytes(paths[i])].push_back(i);
  std::vector<size_t> jobs;
  for (const auto& [size, files] : of_size) {
    if (files.size() > 1) jobs.insert(jobs.end(), files.begin(), files.end());
  }
  std::vector<std::string> identities(paths.size());
  ParallelFor(context, "image files of equal size", jobs.size(),
              [&](size_t i) { identities[jobs[i]] = photos.Identity(paths[jobs[i]]); });
  return identities;
}

double MeanDifference(const Image& a, const Image& b, int shift_x, int shift_y) {
  double sum = 0;
  int64_t count = 0;
  for (int y = 0; y < a.height - shift_y; ++y) {
    for (int x = 0; x < a.width - shift_x; ++x) {
      const size_t at = (static_cast<size_t>(y) * a.width + x) * a.channels;
      const size_t shifted =
          (static_cast<size_t>(y + shift_y) * a.width + x + shift_x) * a.channels;
      for (int c = 0; c < a.channels; ++c) sum += std::abs(a.data[at + c] - b.data[shifted + c]);
      count += a.channels;
    }
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

// Pictures of the same place that were taken apart, by so many px of the large image, are
// displaced; copies are not.
bool AreCopies(const Image& a, const Image& b, double apart_px) {
  if (a.data.empty() || a.width != b.width || a.height != b.height || a.channels != b.channels) {
    return false;
  }
  if (apart_px < kLeastTellingPx) return false;
  const double of_px = (MeanDifference(a, a, 1, 0) + MeanDifference(a, a, 0, 1)) / 2;
  return MeanDifference(a, b, 0, 0) <= kCopyShare * std::min(1.0, apart_px) * of_px;
}

// Looks for nearly the same pictures from nearly the same poses.
class PoseComparison {
 public:
  PoseComparison(const SparseModel& model, const std::vector<int>& images,
                 const std::vector<std::string>& paths, const PhotoStore& photos)
      : model_(model), images_(images), paths_(paths), photos_(photos) {
    for (const int image : images) {
      centers_.push_back(Inverse(model.images[image].cam_from_world).translation);
      const Camera& camera = model.CameraOf(model.images[image]);
      const double panorama_focal = static_cast<double>(camera.width) / (2 * M_PI);
      focal_lengths_.push_back(camera.IsPanorama() ? panorama_focal : IntrinsicsOf(camera).fx);
    }
    max_distance_ = kMaxRelativeDistance * SpreadOfCenters();
    SortAlongLongestAxis();
  }

  // The first image before i that has no original and is the same view, or -1.
  int FirstSameView(int i, const std::vector<int>& original) {
    int first = -1;
    int num_compared = 0;
    Image large;
    const double x = centers_[i][axis_];
    auto near = std::lower_bound(order_.begin(), order_.end(), x - max_distance_,
                                 [&](int k, double value) { return centers_[k][axis_] < value; });
    for (; near != order_.end() && centers_[*near][axis_] <= x + max_distance_; ++near) {
      const int k = *near;
      if (k >= i || original[k] >= 0 || (first >= 0 && k > first)) continue;
      const double px = PoseDifferencePx(k, i);
      if (!(px <= kCopyPosePx) || !IsSamePicture(PictureOf(k), PictureOf(i))) continue;
      if (px <= kSamePosePx) {
        first = k;
      } else if (++num_compared <= kMaxCompared) {
        if (large.data.empty()) large = ReadPicture(i, kCopySize);
        const double longer = std::max(CameraOf(i).width, CameraOf(i).height);
        if (AreCopies(ReadPicture(k, kCopySize), large, px * std::min(1.0, kCopySize / longer))) {
          first = k;
        }
      }
    }
    return first;
  }

 private:
  // Median distance from their middle.
  double SpreadOfCenters() const {
    Eigen::Vector3d middle;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double> values;
      for (const Eigen::Vector3d& center : centers_) values.push_back(center[axis]);
      middle[axis] = MedianOf(values);
    }
    std::vector<double> distances;
    for (const Eigen::Vector3d& center : centers_) distances.push_back((center - middle).norm());
    return MedianOf(distances);
  }

  void SortAlongLongestAxis() {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& center : centers_) box.extend(center);
    box.sizes().maxCoeff(&axis_);
    order_.resize(centers_.size());
    std::iota(order_.begin(), order_.end(), 0);
    std::stable_sort(order_.begin(), order_.end(),
                     [&](int a, int b) { return centers_[a][axis_] < centers_[b][axis_]; });
  }

  const Camera& CameraOf(int i) const { return model_.CameraOf(model_.images[images_[i]]); }

  // By how much the difference of two poses moves what is at the median depth of the points;
  // without any it may be near. Infinite if it is much.
  double PoseDifferencePx(int a, int b) {
    const double distance = (centers_[a] - centers_[b]).norm();
    if (!(distance <= max_distance_) || !(TurnPx(a, b) <= kCopyPosePx)) return HUGE_VAL;
    if (distance == 0) return TurnPx(a, b);
    const double depth = DepthOf(a);
    return std::max(TurnPx(a, b),
                    distance * focal_lengths_[a] / (depth > 0 ? depth : max_distance_));
  }

  double TurnPx(int a, int b) const {
    return focal_lengths_[a] * model_.images[images_[a]].cam_from_world.rotation.angularDistance(
                                   model_.images[images_[b]].cam_from_world.rotation);
  }

  // Median of the points that the image sees, of a panorama all around; 0 if there are none.
  double DepthOf(int i) {
    const auto [known, is_new] = depths_.try_emplace(i);
    if (is_new) known->second = MeasureDepth(i);
    return known->second;
  }

  double MeasureDepth(int i) {
    if (positions_.empty()) {
      for (const ModelPoint& point : model_.points) positions_[point.id] = point.position;
    }
    const ModelImage& image = model_.images[images_[i]];
    const bool is_panorama = model_.CameraOf(image).IsPanorama();
    std::vector<double> depths;
    for (const Observation& observation : image.observations) {
      const auto found = positions_.find(observation.point3D_id);
      if (found == positions_.end()) continue;
      const Eigen::Vector3d point = image.cam_from_world * found->second;
      depths.push_back(is_panorama ? point.norm() : point.z());
    }
    return MedianOf(depths);
  }

  // Small; empty if the file is damaged.
  const Image& PictureOf(int i) {
    const auto [found, is_new] = pictures_.try_emplace(i);
    if (is_new) found->second = ReadPicture(i, kPictureSize);
    return found->second;
  }

  Image ReadPicture(int i, int size) const {
    const auto complaint = photos_.Check(paths_[i], size).complaint;
    return complaint && complaint->is_damage ? Image() : photos_.Read(paths_[i], size);
  }

  static bool IsSamePicture(const Image& a, const Image& b) {
    if (a.data.empty() || a.width != b.width || a.height != b.height || a.channels != b.channels) {
      return false;
    }
    const double limit = kSamePictureLevels * static_cast<double>(a.data.size());
    double sum = 0;
    for (size_t i = 0; i < a.data.size() && sum <= limit; ++i) {
      sum += std::abs(a.data[i] - b.data[i]);
    }
    return sum <= limit;
  }

  const SparseModel& model_;
  const std::vector<int>& images_;
  const std::vector<std::string>& paths_;
  const PhotoStore& photos_;
  std::vector<Eigen::Vector3d> centers_;
  std::vector<double> focal_lengths_;
  double max_distance_ = 0;
  int axis_ = 0;
  std::vector<int> order_;  // of centers_ along the axis
  std::unordered_map<uint64_t, Eigen::Vector3d> positions_;
  std::unordered_map<int, Image> pictures_;
  std::unordered_map<int, double> depths_;
};

}  // namespace

std::vector<DuplicateImage> FindDuplicateImages(const SparseModel& model,
                                                const std::vector<int>& images,
                                                const std::vector<std::string>& paths,
                                                const RunContext& context,
                                                const PhotoStore& photos) {
  std::vector<int> original(images.size(), -1);
  const std::vector<std::string> identities = IdentitiesOfEqualSizes(paths, photos, context);
  std::map<std::string, int> first_of;
  for (size_t i = 0; i < paths.size(); ++i) {
    if (identities[i].empty()) continue;
    const auto [first, is_new] = first_of.emplace(identities[i], static_cast<int>(i));
    if (!is_new) original[i] = first->second;
  }
  PoseComparison comparison(model, images, paths, photos);
  std::vector<DuplicateImage> duplicates;
  for (int i = 0; i < static_cast<int>(original.size()); ++i) {
    if (original[i] < 0) original[i] = comparison.FirstSameView(i, original);
    if (original[i] >= 0) duplicates.push_back({i, original[i]});
  }
  return duplicates;
}

}  // namespace limn::colmap_ext
