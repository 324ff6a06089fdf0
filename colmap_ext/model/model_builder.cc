// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/model_builder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "colmap_ext/model/image_name.h"
#include "limn/util/number_text.h"

namespace limn::colmap_ext {
namespace {

constexpr uint64_t kMaxImageSide = 1000000;
// Focal lengths, in longer sides of the image: beyond any fisheye lens and any telescope.
constexpr double kMinFocalOfSide = 1e-3;
constexpr double kMaxFocalOfSide = 1e5;
constexpr double kNormTolerance = 1e-3;

Eigen::Quaterniond QuaternionOf(const std::array<double, 4>& wxyz) {
  return {wxyz[0], wxyz[1], wxyz[2], wxyz[3]};
}

bool PrincipalPointIsOdd(const Intrinsics& camera, uint64_t width, uint64_t height) {
  return !(camera.cx >= 0 && camera.cx <= static_cast<double>(width) && camera.cy >= 0 &&
           camera.cy <= static_cast<double>(height));
}

// COLMAP projects by the parameters, Limn by the size. Of images that COLMAP has shrunk the
// parameters are a product, which may be beside the number that it stands for.
void CheckPanorama(const Camera& camera, const std::string& what, const FilePlace& place) {
  const auto width = static_cast<double>(camera.width);
  const auto height = static_cast<double>(camera.height);
  if (std::abs(camera.params[0] - width) > 0.5 || std::abs(camera.params[1] - height) > 0.5) {
    place.Fail(what + ": the parameters of an EQUIRECTANGULAR camera must be its width and height");
  }
  if (std::abs(width - 2 * height) > 2) {
    place.Fail(what + ": an EQUIRECTANGULAR image of " + std::to_string(camera.width) + " x " +
               std::to_string(camera.height) + " pixels is not twice as wide as high");
  }
}

void CheckFocal(double focal, const Camera& camera, const std::string& what,
                const FilePlace& place) {
  if (!(focal > 0)) place.Fail(what + ": the focal length is not positive");
  const double sides = focal / static_cast<double>(std::max(camera.width, camera.height));
  if (sides >= kMinFocalOfSide && sides <= kMaxFocalOfSide) return;
  place.Fail(what + ": a focal length of " + ShortNumber(focal) +
             " px makes no sense for images of " + std::to_string(camera.width) + " x " +
             std::to_string(camera.height));
}

}  // namespace

Rigid3d MakePose(const std::array<double, 4>& quaternion, const Eigen::Vector3d& translation,
                 const std::string& what, const FilePlace& place) {
  const Eigen::Quaterniond rotation = QuaternionOf(quaternion);
  if (!rotation.coeffs().allFinite() || !translation.allFinite()) {
    place.Fail(what + ": the pose is not finite");
  }
  if (!(rotation.norm() > 1e-12)) place.Fail(what + ": the rotation is a zero quaternion");
  return {rotation.normalized(), translation};
}

void ModelBuilder::AddCamera(Camera camera, const FilePlace& place) {
  const std::string what = "camera " + std::to_string(camera.id);
  if (!camera_index_.emplace(camera.id, model_.cameras.size()).second) {
    place.Fail(what + " is defined twice");
  }
  if (camera.width == 0 || camera.height == 0 || camera.width > kMaxImageSide ||
      camera.height > kMaxImageSide) {
    place.Fail(what + ": image size " + std::to_string(camera.width) + " x " +
               std::to_string(camera.height) + " makes no sense");
  }
  const auto finite = [](double p) { return std::isfinite(p); };
  if (!std::all_of(camera.params.begin(), camera.params.end(), finite)) {
    place.Fail(what + ": a parameter is not finite");
  }
  if (camera.IsPanorama()) {
    CheckPanorama(camera, what, place);
  } else {
    const Intrinsics intrinsics = IntrinsicsOf(camera);
    CheckFocal(intrinsics.fx, camera, what, place);
    CheckFocal(intrinsics.fy, camera, what, place);
    num_odd_principal_points_ += PrincipalPointIsOdd(intrinsics, camera.width, camera.height);
  }
  model_.cameras.push_back(std::move(camera));
}

void ModelBuilder::AddImage(ModelImage image, const std::array<double, 4>& quaternion,
                            const FilePlace& place) {
  const std::string what = "image " + std::to_string(image.id);
  if (!image_index_.emplace(image.id, model_.images.size()).second)
    place.Fail(what + " is defined twice");
  const std::string problem = ProblemOfName(image.name);
  if (!problem.empty()) place.Fail(what + ": " + problem);
  if (std::string text = Utf8Name(image.name); text != image.name) {
    image.name_bytes = std::exchange(image.name, std::move(text));
  }
  if (!image_names_.insert(image.name).second) {
    place.Fail(what + ": image name \"" + image.name + "\" occurs twice");
  }
  image.cam_from_world =
      MakePose(quaternion, image.cam_from_world.translation, what + " (" + image.name + ")", place);
  num_odd_quaternions_ += std::abs(QuaternionOf(quaternion).norm() - 1) > kNormTolerance;

  const auto camera = camera_index_.find(image.camera_id);
  if (camera == camera_index_.end()) {
    place.Fail(what + " (" + image.name + ") refers to camera " + std::to_string(image.camera_id) +
               ", which is not among the cameras");
  }
  model_.images.push_back(std::move(image));
}

void ModelBuilder::AddPoint(ModelPoint point) {
  if (!point.position.allFinite() || !point_ids_.insert(point.id).second) {
    ++num_bad_points_;
    return;
  }
  num_bad_track_elements_ += std::erase_if(point.track, [this](const TrackElement& element) {
    return !image_index_.contains(element.image_id);
  });
  for (const TrackElement& element : point.track) {
    const ModelImage& image = model_.images[image_index_.at(element.image_id)];
    num_odd_track_elements_ += !image.Shows(point.id, element.observation);
  }
  model_.points.push_back(std::move(point));
}

SparseModel ModelBuilder::Finish() {
  const auto warn_if = [this](int64_t count, const std::string& text) {
    if (count > 0) Warn(std::to_string(count) + " " + text);
  };
  warn_if(num_odd_quaternions_, "image rotations were not unit quaternions; normalized");
  warn_if(num_odd_principal_points_, "cameras have their principal point outside the image");
  warn_if(num_bad_points_, "3D points left out: not finite or defined twice");
  warn_if(num_bad_track_elements_, "elements of point tracks left out: no such image");
  warn_if(num_odd_track_elements_,
          "elements of point tracks do not agree with the 2D points of their images");
  return std::move(model_);
}

}  // namespace limn::colmap_ext
