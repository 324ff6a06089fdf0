// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "colmap_ext/model/camera_model.h"
#include "colmap_ext/model/rig.h"
#include "limn/geometry/rigid3.h"

namespace limn::colmap_ext {

// A sparse model as COLMAP stores it: COLMAP's ids, pixels (corner of the image at (0, 0)) and file
// order. to_views.h turns it into what the rest of Limn works on.

// "This 2D point has no 3D point."
constexpr uint64_t kNoPoint3D = ~uint64_t{0};

struct Observation {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  uint64_t point3D_id = kNoPoint3D;
};

// A registered image.
struct ModelImage {
  uint32_t id = 0;
  // The quaternion is normalized on reading.
  Rigid3d cam_from_world;
  uint32_t camera_id = 0;
  // Relative to the image folder, '/' between folders; UTF-8 (Utf8Name of the name as stored).
  std::string name;
  std::vector<Observation> observations;
  // The file in the image folder if it differs from the name (PMVS folders); else empty.
  std::string file = "";
  // The name as stored if that is not UTF-8, as names in a code page of Windows; else empty.
  std::string name_bytes = "";

  const std::string& StoredName() const { return name_bytes.empty() ? name : name_bytes; }
  // Whether this observation exists and belongs to this 3D point.
  bool Shows(uint64_t point3D_id, uint32_t observation) const {
    return observation < observations.size() && observations[observation].point3D_id == point3D_id;
  }
};

struct TrackElement {
  uint32_t image_id = 0;
  uint32_t observation = 0;  // index into ModelImage::observations
};

struct ModelPoint {
  uint64_t id = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  std::array<uint8_t, 3> color = {};
  double error = -1;  // mean reprojection error, pixels; -1 = not computed
  std::vector<TrackElement> track;
};

// The form of a model's files.
enum class ModelFlavor { kBinary, kText };

struct SparseModel {
  std::filesystem::path folder;
  // That of the files it was read from.
  ModelFlavor flavor = ModelFlavor::kText;
  std::vector<Camera> cameras;
  // In file order, to which .vis files, consistency graphs and PMVS numbers refer.
  std::vector<ModelImage> images;
  std::vector<ModelPoint> points;
  // If the model has both: poses of images were composed from them. (COLMAP 3.12 and later write a
  // rig for every single camera, too.)
  std::vector<Rig> rigs;
  std::vector<Frame> frames;
  // Problems that did not prevent reading, for the user.
  std::vector<std::string> warnings;

  // Precondition: the camera exists, as it does for every image of a model that was read.
  const Camera& CameraOf(const ModelImage& image) const;
};

// An id above those of all points.
uint64_t NextPointId(const SparseModel& model);

}  // namespace limn::colmap_ext
