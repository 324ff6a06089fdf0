#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "colmap_ext/model/camera_model.h"
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
  // Relative to the image folder, '/' between folders.
  std::string name;
  std::vector<Observation> observations;
  // The file in the image folder where that is not the name (PMVS folders); else empty.
  std::string file = "";

  // Whether this observation exists and is of this 3D point.
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

struct SparseModel {
  std::filesystem::path folder;
  std::vector<Camera> cameras;
  // In file order, which .vis files, consistency graphs and PMVS numbering refer to.
  std::vector<ModelImage> images;
  std::vector<ModelPoint> points;
  // Some rig has several cameras: their poses were composed. (COLMAP 3.12 and later write a rig for
  // every single camera, too.)
  bool has_rigs = false;
  // Oddities that did not stop the reading, in words.
  std::vector<std::string> warnings;

  // Precondition: the camera exists (always true for the images of a model that was read).
  const Camera& CameraOf(const ModelImage& image) const;
};

// Whether the folder holds cameras and images, in binary or in text.
bool HoldsColmapModel(const std::filesystem::path& folder);

// Of a folder that is no model: which file is missing beside the others, "images.bin is missing
// beside cameras.bin". Empty if the folder has neither cameras nor images, or is a model.
std::string MissingColmapFile(const std::filesystem::path& folder);

// Number of registered images, without reading them. Throws IoError.
uint64_t CountColmapImages(const std::filesystem::path& folder);

// Read a model: binary when cameras.bin and images.bin exist, else text; a flavor with points3D
// comes before one without. A missing points3D file is a warning, poses alone are enough. Poses
// composed from rigs and frames, where both exist, replace those of the images file, as in COLMAP.
//
// Throws IoError naming file, byte or line, and reason: missing, truncated or trailing data, counts
// that do not fit the file, unknown camera model, wrong number of parameters, focal length or size
// that is no positive number, EQUIRECTANGULAR, duplicate ids or names, unknown camera_id, zero or
// non-finite poses, image names that are empty or lead out of the image folder.
SparseModel ReadColmapModel(const std::filesystem::path& folder);

}  // namespace limn::colmap_ext
