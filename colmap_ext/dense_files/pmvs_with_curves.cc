// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/dense_files/pmvs_with_curves.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "colmap_ext/dense_files/patch_file.h"
#include "limn/files/atomic_file.h"
#include "limn/util/number_text.h"

namespace limn::colmap_ext {
namespace {

// Of patches of curves, of which PMVS has no score.
constexpr double kCurveScore = 1;

std::vector<Patch> CurvePatches(const std::vector<CurvePoint>& points,
                                const std::vector<View>& views, const std::vector<int>& numbers) {
  std::vector<Patch> patches;
  for (const CurvePoint& point : points) {
    Patch patch;
    patch.position = point.position;
    patch.normal = point.Outward(views);
    patch.photometric_score = kCurveScore;
    for (const ViewId view : point.views) {
      if (numbers[view] >= 0) patch.images.push_back(numbers[view]);
    }
    if (!patch.images.empty()) patches.push_back(std::move(patch));
  }
  return patches;
}

// Colors by the names that most programs know, and by PMVS's.
constexpr const char* kVertexProperties =
    "property float x\nproperty float y\nproperty float z\n"
    "property float nx\nproperty float ny\nproperty float nz\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    "property uchar diffuse_red\nproperty uchar diffuse_green\nproperty uchar diffuse_blue\n"
    "property float quality\n";

void PutLine(const DensePoint& point, std::ostream& out) {
  for (const Eigen::Vector3d& vector : {point.position, point.normal}) {
    for (const double value : vector) out << NumberText(value) << ' ';
  }
  for (int i = 0; i < 2; ++i) {
    for (const uint8_t value : point.color) out << static_cast<int>(value) << ' ';
  }
  out << NumberText(point.quality) << '\n';
}

// Without those that are left out.
uint64_t CountPoints(const DenseCloud& cloud) {
  uint64_t count = 0;
  cloud.points([&](const DensePoint&) { ++count; });
  return count;
}

}  // namespace

void WritePmvsWithCurves(const OutputPath& base, const std::vector<std::filesystem::path>& files,
                         const DenseCloud& cloud, const std::vector<CurvePoint>& points,
                         const std::vector<View>& views) {
  const bool has_patches = files.front().extension() == ".patch";
  const std::vector<Patch> of_curves =
      CurvePatches(points, views, PmvsNumbers(files.front(), views));
  WriteFileAtomically(base + ".patch", [&](std::ostream& out) {
    WritePatchHeader((has_patches ? cloud.num_points : 0) + of_curves.size(), out);
    const auto write = [&](const Patch& patch) { WritePatch(patch, out); };
    for (const std::filesystem::path& file : files) {
      if (has_patches) ReadPatchFile(file.string(), write);
    }
    std::for_each(of_curves.begin(), of_curves.end(), write);
  });
  WriteFileAtomically(base + ".ply", [&](std::ostream& out) {
    out << "ply\nformat ascii 1.0\nelement vertex " << CountPoints(cloud) + points.size() << '\n'
        << kVertexProperties << "end_header\n";
    cloud.points([&](const DensePoint& point) { PutLine(point, out); });
    for (const CurvePoint& point : points) {
      DensePoint dense;
      dense.position = point.position;
      dense.normal = point.Outward(views);
      dense.color = point.color;
      dense.quality = kCurveScore;
      PutLine(dense, out);
    }
  });
}

}  // namespace limn::colmap_ext
