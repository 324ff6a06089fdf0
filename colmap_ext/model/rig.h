#pragma once

#include <cstdint>
#include <istream>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "limn/geometry/rigid3.h"

namespace limn::colmap_ext {

struct SparseModel;

// Rigs and frames (COLMAP 3.12 and later): sensors mounted together, and the instants at which they
// were triggered. cam_from_world = cam_from_rig * rig_from_world.

struct SensorId {
  int32_t type = 0;
  uint32_t id = 0;  // of a camera: its camera_id

  bool operator==(const SensorId&) const = default;
};
constexpr int32_t kCameraSensor = 0;

struct RigSensor {
  SensorId sensor;
  bool has_pose = false;
  Rigid3d sensor_from_rig;
};

struct Rig {
  uint32_t id = 0;
  std::vector<RigSensor> sensors;  // the first, the reference sensor, is the origin of the rig

  int NumCameras() const;
};

// An image, or what another sensor has measured.
struct FrameData {
  SensorId sensor;
  uint64_t id = 0;
};

struct Frame {
  uint32_t id = 0;
  uint32_t rig_id = 0;
  Rigid3d rig_from_world;
  std::vector<FrameData> data;
};

// Layouts: COLMAP's documentation, "Output format". Readers throw IoError with byte or line.
std::vector<Rig> ReadRigsBinary(std::istream& in, const std::string& path);
std::vector<Rig> ReadRigsText(std::istream& in, const std::string& path);
std::vector<Frame> ReadFramesBinary(std::istream& in, const std::string& path);
std::vector<Frame> ReadFramesText(std::istream& in, const std::string& path);
void WriteRigsBinary(const SparseModel& model, std::ostream& out);
void WriteRigsText(const SparseModel& model, std::ostream& out);
void WriteFramesBinary(const SparseModel& model, std::ostream& out);
void WriteFramesText(const SparseModel& model, std::ostream& out);

// An image with a pose by rigs and frames.
struct MountedImage {
  size_t image = 0;   // index into the model's images
  size_t frame = 0;   // into its frames
  size_t rig = 0;     // into its rigs
  size_t sensor = 0;  // into the rig's sensors
};

// All but images in no frame, of an unknown rig or of a camera without a pose in its rig. The first
// frame of an image counts.
std::vector<MountedImage> MountedImages(const SparseModel& model);

// Those of these images (indices) that are mounted in a rig on which these images show several
// cameras, so that their poses depend on each other.
std::set<size_t> ImagesOfSharedRigs(const std::set<size_t>& images, const SparseModel& model);

// The pose that rigs and frames give to an image.
Rigid3d ComposedPose(const SparseModel& model, const MountedImage& mounted);

// Replaces the poses of the images file by the composed ones, as COLMAP does. The two differ if a
// tool edited only the images file: a warning counts the images whose pose changed by more than
// 1e-6 (rad, or relative to the distances). Images that are not mounted keep their pose, which is
// counted in a warning, as are images in two frames.
void ApplyRigs(SparseModel* model);

// The opposite, for images (indices) whose poses were changed one by one: fits the poses of frames,
// and of the sensors in their rigs, by least squares, first of angles, then of camera centers.
// Afterwards the poses of all mounted images are the composed ones. Reference sensors, and whatever
// none of these images determines, stay. Time: a few sparse linear least-squares problems.
void FitRigs(const std::set<size_t>& images, SparseModel* model);

}  // namespace limn::colmap_ext
