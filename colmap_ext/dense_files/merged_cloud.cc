// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/dense_files/merged_cloud.h"

#include <fstream>
#include <system_error>

#include "limn/files/atomic_file.h"
#include "limn/files/output_link.h"
#include "limn/files/whole_file.h"
#include "limn/files/writable_folder.h"
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

void WriteCloud(const OutputPath& path, const fs::path& fused,
                const std::vector<CloudPoint>& curve_points) {
  const PlyPointsInfo info = ReadPlyPointsInfo(fused.string());
  if (!info.has_normals) throw IoError(fused.string(), "has no normals, which meshers need");
  WriteFileAtomically(path, [&](std::ostream& out) {
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

void WriteVisibility(const OutputPath& path, const fs::path& fused_visibility,
                     const std::vector<CloudPoint>& curve_points, const std::vector<View>& views) {
  std::ifstream in = OpenFile(fused_visibility.string());
  uint64_t count = 0;
  in.read(reinterpret_cast<char*>(&count), sizeof(count));
  if (!in) throw IoError(fused_visibility.string(), "cannot be read");
  WriteFileAtomically(path, [&](std::ostream& out) {
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

// Of a file, or of the files of a folder.
void Copy(const fs::path& from, const OutputPath& to) {
  if (!fs::is_directory(from)) {
    const auto copy = [&](std::ostream& out) { out << OpenFile(from.string()).rdbuf(); };
    return fs::file_size(from) > 0 ? WriteFileAtomically(to, copy) : WriteFileAtomically(to, "");
  }
  for (const auto& entry : fs::directory_iterator(from)) {
    if (entry.is_regular_file()) Copy(entry.path(), to / entry.path().filename());
  }
}

// `link` comes to stand for `target`.
void LinkOrCopy(const fs::path& target, const OutputPath& link) {
  std::error_code ignored;
  if (fs::equivalent(target, link.string(), ignored)) return;
  if (!MakeLink(target, link)) Copy(target, link);
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

void WriteMeshingFolder(const OutputPath& folder, const fs::path& fused, const fs::path& model_dir,
                        const std::vector<CloudPoint>& curve_points,
                        const std::vector<View>& views) {
  const OutputPath cloud = folder / kCloudName;
  const OutputPath visibility = cloud + ".vis";
  const fs::path fused_visibility = fused.string() + ".vis";
  WriteCloud(cloud, fused, curve_points);
  LinkOrCopy(cloud.string(), folder / "fused.ply");
  LinkOrCopy(model_dir, folder / "sparse");
  std::error_code ignored;
  if (!fs::exists(fused_visibility, ignored)) {
    // Those of an earlier run would be of another cloud.
    RemoveFile(visibility);
    RemoveFile(folder / "fused.ply.vis");
    return;
  }
  WriteVisibility(visibility, fused_visibility, curve_points, views);
  LinkOrCopy(visibility.string(), folder / "fused.ply.vis");
}

}  // namespace limn::colmap_ext
