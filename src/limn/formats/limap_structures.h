// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limn/files/output_path.h"
#include "limn/model/curve_set.h"

namespace limn {

// What LIMAP 2.0 keeps beside a COLMAP model, in the folder structures/. Ids of images and 3D
// points are those of the model; pixels are COLMAP's (the center of the top-left pixel is (0.5,
// 0.5)), of images without distortion; lengths are those of the model.

// "This segment or group has no counterpart in space."
constexpr uint64_t kNoLimapId = ~uint64_t{0};

// A segment of an image.
struct LimapSegment {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
  double score = -1;  // -1 = unknown
  uint64_t line = kNoLimapId;
};

// A point or a line of a group.
template <typename Id>
struct LimapMember {
  Id id = 0;
  double weight = 1;
};

// A point lies on a line.
template <typename PointId, typename LineId>
struct LimapIncidence {
  PointId point = 0;
  LineId line = 0;
  double weight = 1;
};

// An image with its points and segments, which are referred to by index.
struct LimapImage {
  struct Group {
    int32_t type = 0;
    std::vector<LimapMember<uint32_t>> points;
    std::vector<LimapMember<uint32_t>> segments;
    uint64_t group = kNoLimapId;
  };

  uint32_t id = 0;
  uint32_t num_points = 0;  // of this image in the model
  std::vector<LimapSegment> segments;
  std::vector<Group> groups;
  std::vector<LimapIncidence<uint32_t, uint32_t>> wireframe;
};

// A segment or group of an image that shows a line or group in space.
struct LimapTrackElement {
  uint32_t image_id = 0;
  uint32_t index = 0;
};

struct LimapLine {
  uint64_t id = 0;
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  Eigen::Vector3d end = Eigen::Vector3d::Zero();
  std::vector<LimapTrackElement> track;
  double uncertainty = -1;  // across the line; -1 = unknown
};

// A vanishing point, plane or primitive.
struct LimapGroup {
  uint64_t id = 0;
  int32_t type = 0;
  std::vector<LimapMember<uint64_t>> points;
  std::vector<LimapMember<uint64_t>> lines;
  std::vector<LimapTrackElement> track;
  std::vector<double> params;
};

using LimapWireframe = std::vector<LimapIncidence<uint64_t, uint64_t>>;

struct LimapStructures {
  std::vector<LimapImage> images;  // structures2d
  std::vector<LimapLine> lines;    // lines3D
  std::vector<LimapGroup> groups;  // groups3D
  LimapWireframe wireframe;        // wireframe3D
};

// The file of lines (lines3D.bin or .txt) in <folder>/structures, else in the folder itself. Empty:
// none.
std::filesystem::path FindLimapLines(const std::filesystem::path& folder);

// Reads the four binary files or, where lines3D.bin is missing, lines3D.txt and wireframe3D.txt
// alone. Throws IoError with byte or line: missing, truncated or trailing data, numbers that are
// not finite, ids given twice, a wireframe or (binary) tracks with lines or segments that do not
// exist.
LimapStructures ReadLimapStructures(const std::filesystem::path& folder);

// One polyline per line; lines of no length are left out.
// lines3D.bin or .txt of LIMAP 2.0, by the extension:
CurveSet ReadLimapLines(const std::string& path);
// alltracks.txt of LIMAP 1:
CurveSet ReadLimapTracks(const std::string& path);

// Writes the four binary files into a folder, which is made if it is missing. The same structures
// give the same bytes. Throws IoError.
void WriteLimapStructures(const LimapStructures& structures, const OutputPath& folder);

}  // namespace limn
