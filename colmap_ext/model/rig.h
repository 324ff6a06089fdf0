#pragma once

#include <cstdint>
#include <istream>
#include <map>
#include <string>
#include <vector>

#include "colmap_ext/model/model.h"

namespace limn::colmap_ext {

// Rigs and frames (COLMAP 3.12 and later): cameras mounted together, and the instants at which they
// were triggered. cam_from_world = cam_from_rig * rig_from_world. Sensors other than cameras are
// skipped.

// A sensor of a rig; the reference sensor is the origin of the rig.
struct RigCamera {
  bool has_pose = false;
  Rigid3d cam_from_rig;
};

struct Rig {
  uint32_t id = 0;
  std::map<uint32_t, RigCamera> cameras;  // by camera_id
};

struct Frame {
  uint32_t id = 0;
  uint32_t rig_id = 0;
  Rigid3d rig_from_world;
  std::vector<uint64_t> image_ids;
};

// Layouts: COLMAP's documentation, "Output format". All throw IoError with byte or line.
std::vector<Rig> ReadRigsBinary(std::istream& in, const std::string& path);
std::vector<Rig> ReadRigsText(std::istream& in, const std::string& path);
std::vector<Frame> ReadFramesBinary(std::istream& in, const std::string& path);
std::vector<Frame> ReadFramesText(std::istream& in, const std::string& path);

// Replaces the poses of the images file by the composed ones, as COLMAP does. The two differ if a
// tool edited only the images file: a warning counts the images whose pose changed by more than
// 1e-6 (rad, or relative to the distances). Images in no frame, of an unknown rig or of a camera
// without a pose in its rig keep their pose, which is counted in a warning, as are images in two
// frames (the first wins).
void ApplyRigs(const std::vector<Rig>& rigs, const std::vector<Frame>& frames, SparseModel* model);

}  // namespace limn::colmap_ext
