#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "colmap_ext/model/model.h"
#include "colmap_ext/model/tracked_points.h"

namespace limn::colmap_ext {

// Where a format has the centers of pixels.
enum class PixelCenters {
  kInteger,  // the center of the top-left pixel is (0, 0): half a pixel is added for COLMAP
  kHalf,     // it is (0.5, 0.5), as in COLMAP
};

// A camera as a reader found it.
struct ImportedImage {
  std::string name;  // relative to the image folder
  // Without an id. Its principal point is in the pixels of the format, origin at the top left.
  Camera camera;
  Rigid3d cam_from_world;
  // In the same pixels.
  std::vector<Observation> observations;
  // Where it was found, for messages.
  std::string path;
  const char* unit = "line";
  uint64_t number = 1;
};

// What a file of another program holds, in COLMAP's axes (x right, y down, z forward).
struct ImportedScene {
  std::vector<ImportedImage> images;
  // Tracks refer to images by index + 1.
  std::vector<ModelPoint> points;
  // What the user should know: which file was read, how images were matched, what was left out.
  std::vector<std::string> notes;
};

// Give a scene its points. Precondition: they are of its images.
void SetPoints(TrackedPoints tracked, ImportedScene* scene);

struct SparseModelOptions {
  PixelCenters pixel_centers = PixelCenters::kHalf;
  // Images of one size share a camera, that of the first of them, if this moves no pixel by more
  // (pinhole part), pixels; and if their distortions agree to 1e-10.
  double share_cameras_px = 1e-7;
};

// The model of a scene; image ids count from 1. Throws IoError with the place of the
// image for what ReadModel would refuse, too: names that occur twice, focal lengths that are not
// positive, anything not finite.
SparseModel ToSparseModel(ImportedScene scene, const SparseModelOptions& options);

}  // namespace limn::colmap_ext
