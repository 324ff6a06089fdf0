// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace limn::colmap_ext {

// COLMAP's camera models, 3.8 to 4.2. Ids and names have never changed their meaning between
// releases.
enum class CameraModelId : int32_t {
  kSimplePinhole = 0,
  kPinhole = 1,
  kSimpleRadial = 2,
  kRadial = 3,
  kOpencv = 4,
  kOpencvFisheye = 5,
  kFullOpencv = 6,
  kFov = 7,
  kSimpleRadialFisheye = 8,
  kRadialFisheye = 9,
  kThinPrismFisheye = 10,
  kRadTanThinPrismFisheye = 11,
  kSimpleDivision = 12,
  kDivision = 13,
  kSimpleFisheye = 14,
  kFisheye = 15,
  kEucm = 16,
  kEquirectangular = 17,
};

// An entry of the table of models. Parameters are ordered as focal lengths (1 or 2; 0 for
// EQUIRECTANGULAR), cx, cy, then the extra (distortion) parameters.
struct CameraModel {
  CameraModelId id;
  const char* name;
  int num_params;
  int num_focals;
};

// Null if there is no such model.
const CameraModel* FindCameraModel(int32_t id);
const CameraModel* FindCameraModel(std::string_view name);

// All model names, comma-separated, for messages.
std::string SupportedCameraModels();

// A camera as stored in cameras.bin or cameras.txt. Lengths in pixels; COLMAP's convention: the
// top-left corner of the image is (0, 0).
struct Camera {
  uint32_t id = 0;
  CameraModelId model = CameraModelId::kPinhole;
  uint64_t width = 0;
  uint64_t height = 0;
  std::vector<double> params;

  // Panoramas have no intrinsics (model/panorama.h).
  bool IsPanorama() const { return model == CameraModelId::kEquirectangular; }
};

// Parameters of any model but EQUIRECTANGULAR in a common form; a single focal length is stored
// twice.
struct Intrinsics {
  CameraModelId model = CameraModelId::kPinhole;
  double fx = 1;
  double fy = 1;
  double cx = 0;
  double cy = 0;
  std::vector<double> extra;
};

// Precondition: the model is not EQUIRECTANGULAR and has the right number of parameters.
Intrinsics IntrinsicsOf(const Camera& camera);

// The same camera for an image resized by these factors: focal lengths and principal point scale
// per axis, extra parameters stay.
Intrinsics Rescaled(Intrinsics intrinsics, double scale_x, double scale_y);

// Whether the stored image is a pinhole image: a pinhole model, or a model without its own fisheye
// mapping whose distortion parameters are all at most 1e-8 (image_undistorter keeps such cameras).
// Fisheye models never are.
bool IsPinhole(const Intrinsics& intrinsics);

}  // namespace limn::colmap_ext
