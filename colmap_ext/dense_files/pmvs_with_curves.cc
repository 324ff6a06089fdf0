#include "colmap_ext/dense_files/pmvs_with_curves.h"

#include <algorithm>
#include <string>

#include "colmap_ext/dense_files/patch_file.h"
#include "limn/files/atomic_file.h"
#include "limn/util/number_text.h"

namespace limn::colmap_ext {
namespace {

std::vector<Patch> CurvePatches(const std::vector<CurvePoint>& points,
                                const std::vector<View>& views, const std::vector<int>& numbers) {
  std::vector<Patch> patches;
  for (const CurvePoint& point : points) {
    Patch patch;
    patch.position = point.position;
    patch.normal = point.Outward(views);
    patch.photometric_score = 1;
    for (const ViewId view : point.views) {
      if (numbers[view] >= 0) patch.images.push_back(numbers[view]);
    }
    if (!patch.images.empty()) patches.push_back(std::move(patch));
  }
  return patches;
}

void PutLine(const Eigen::Vector3d& position, const Eigen::Vector3d& normal,
             const std::array<uint8_t, 3>& color, std::ostream& out) {
  for (const Eigen::Vector3d& vector : {position, normal}) {
    for (const double value : vector) out << NumberText(value) << ' ';
  }
  out << static_cast<int>(color[0]) << ' ' << static_cast<int>(color[1]) << ' '
      << static_cast<int>(color[2]) << '\n';
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
    out << "ply\nformat ascii 1.0\nelement vertex " << cloud.num_points + points.size()
        << "\nproperty float x\nproperty float y\nproperty float z\n"
           "property float nx\nproperty float ny\nproperty float nz\n"
           "property uchar diffuse_red\nproperty uchar diffuse_green\n"
           "property uchar diffuse_blue\nend_header\n";
    cloud.points(
        [&](const DensePoint& point) { PutLine(point.position, point.normal, point.color, out); });
    for (const CurvePoint& point : points) {
      PutLine(point.position, point.Outward(views), point.color, out);
    }
  });
}

}  // namespace limn::colmap_ext
