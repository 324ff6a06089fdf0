#include "colmap_ext/dense_files/merged_cloud.h"

#include <fstream>
#include <system_error>

#include "limn/files/atomic_file.h"
#include "limn/files/whole_file.h"
#include "limn/formats/ply_output.h"
#include "limn/formats/ply_points_reader.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCloudName = "fused-with-curves.ply";

void PutPoint(const Eigen::Vector3d& position, const Eigen::Vector3d& normal,
              const std::array<uint8_t, 3>& color, std::ostream& out) {
  for (const double value : position) PutLittleEndian(out, static_cast<float>(value));
  for (const double value : normal) PutLittleEndian(out, static_cast<float>(value));
  for (const uint8_t value : color) PutLittleEndian(out, value);
}

void WriteCloud(const fs::path& path, const fs::path& fused,
                const std::vector<CloudPoint>& curve_points) {
  const PlyPointsInfo info = ReadPlyPointsInfo(fused.string());
  if (!info.has_normals) throw IoError(fused.string(), "has no normals, which meshers need");
  WriteFileAtomically(path.string(), [&](std::ostream& out) {
    out << "ply\nformat binary_little_endian 1.0\nelement vertex "
        << info.count + curve_points.size()
        << "\nproperty float x\nproperty float y\nproperty float z\n"
           "property float nx\nproperty float ny\nproperty float nz\n"
           "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
    // Odd points, too: .vis numbers all.
    const auto put = [&](const PlyPoint& point) {
      PutPoint(point.position, point.normal, point.color, out);
    };
    ReadPlyPoints(fused.string(), put, put);
    for (const CloudPoint& point : curve_points) {
      PutPoint(point.position, point.normal, point.color, out);
    }
  });
}

void WriteVisibility(const fs::path& path, const fs::path& fused_visibility,
                     const std::vector<CloudPoint>& curve_points, const std::vector<View>& views) {
  std::ifstream in = OpenFile(fused_visibility.string());
  uint64_t count = 0;
  in.read(reinterpret_cast<char*>(&count), sizeof(count));
  if (!in) throw IoError(fused_visibility.string(), "cannot be read");
  WriteFileAtomically(path.string(), [&](std::ostream& out) {
    PutLittleEndian<uint64_t>(out, count + curve_points.size());
    if (count > 0) out << in.rdbuf();
    for (const CloudPoint& point : curve_points) {
      PutLittleEndian(out, static_cast<uint32_t>(point.views.size()));
      for (const ViewId view : point.views) {
        PutLittleEndian(out, static_cast<uint32_t>(views[view].model_index));
      }
    }
  });
}

// `link` comes to stand for `target`. A folder that is in the way is not ours and stays.
void LinkOrCopy(const fs::path& target, const fs::path& link) {
  std::error_code error;
  if (fs::equivalent(target, link, error)) return;
  if (fs::is_directory(fs::symlink_status(link, error))) {
    throw IoError(link.string(), "is a folder, not the link that is to be made: remove it");
  }
  fs::remove(link, error);
  const fs::path relative = fs::relative(target, link.parent_path(), error);
  fs::create_symlink(error ? fs::absolute(target) : relative, link, error);
  if (error) fs::copy(target, link, fs::copy_options::recursive, error);
  if (error) throw IoError(link.string(), "cannot be made: " + error.message());
}

}  // namespace

std::vector<CloudPoint> PointsForMeshing(const std::vector<CurvePoint>& points) {
  std::vector<CloudPoint> result;
  for (const CurvePoint& point : points) {
    for (const Eigen::Vector3d& normal : point.normals) {
      if (normal.norm() > 0) result.push_back({point.position, normal, point.color, point.views});
    }
  }
  return result;
}

void WriteMeshingFolder(const fs::path& folder, const fs::path& fused, const fs::path& model_dir,
                        const std::vector<CloudPoint>& curve_points,
                        const std::vector<View>& views) {
  const fs::path cloud = folder / kCloudName;
  const fs::path visibility = folder / (std::string(kCloudName) + ".vis");
  const fs::path fused_visibility = fused.string() + ".vis";
  WriteCloud(cloud, fused, curve_points);
  LinkOrCopy(cloud, folder / "fused.ply");
  LinkOrCopy(model_dir, folder / "sparse");
  std::error_code ignored;
  if (!fs::exists(fused_visibility, ignored)) {
    // Those of an earlier run would be of another cloud.
    fs::remove(visibility, ignored);
    fs::remove(folder / "fused.ply.vis", ignored);
    return;
  }
  WriteVisibility(visibility, fused_visibility, curve_points, views);
  LinkOrCopy(visibility, folder / "fused.ply.vis");
}

}  // namespace limn::colmap_ext
