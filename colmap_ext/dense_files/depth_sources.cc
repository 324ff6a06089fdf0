// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/dense_files/depth_sources.h"

#include <cmath>
#include <memory>
#include <system_error>
#include <utility>

#include "colmap_ext/dense_files/depth_map.h"
#include "limn/dense/point_splat.h"
#include "limn/util/errors.h"
#include "limn/visibility/render_depth.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// Of all depth images that are made of a cloud at a time, at most; 16 bytes each.
constexpr size_t kMaxCellsAtATime = 50'000'000;

// The map of a view, or an empty path.
fs::path FindMap(const fs::path& folder, const std::string& image_name) {
  std::error_code ignored;
  for (const char* kind : {".geometric.bin", ".photometric.bin"}) {
    fs::path path = folder / (image_name + kind);
    if (fs::exists(path, ignored)) return path;
  }
  return {};
}

// One aspect up to a pixel of the smaller of the two.
void CheckShape(const FloatMap& map, const PinholeCamera& camera, const fs::path& path) {
  const double scale_x = static_cast<double>(camera.width) / map.width;
  const double scale_y = static_cast<double>(camera.height) / map.height;
  const double larger = std::max(map.width, map.height);
  if (std::abs(scale_x / scale_y - 1) * larger > 1.5) {
    throw IoError(path.string(), std::to_string(map.width) + " x " + std::to_string(map.height) +
                                     " pixels, which is not the shape of its image, " +
                                     std::to_string(camera.width) + " x " +
                                     std::to_string(camera.height));
  }
}

// COLMAP's dense stage puts the pixel (column, row) of a map where its convention has (column, row)
// too, at the pixel's corner; in ours that is half a pixel of the image up and left.
DepthImage ToDepthImage(const FloatMap& map, const View& view) {
  DepthImage image;
  image.width = map.width;
  image.height = map.height;
  image.cell_px = {static_cast<double>(view.camera.width) / map.width,
                   static_cast<double>(view.camera.height) / map.height};
  image.origin_px = {-0.5, -0.5};
  image.depth = map.data;
  for (float& depth : image.depth) {
    if (!(depth > 0) || !std::isfinite(depth)) depth = 0;
  }
  return image;
}

void AddNormals(const fs::path& path, const View& view, DepthImage* image) {
  const FloatMap map = ReadNormalMap(path);
  if (map.width != image->width || map.height != image->height) {
    throw IoError(path.string(), "not the size of its depth map");
  }
  const Eigen::Matrix3f world_from_cam =
      view.cam_from_world.rotation.conjugate().toRotationMatrix().cast<float>();
  image->normal_in_world.reserve(image->depth.size());
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const Eigen::Vector3f normal(map.At(column, row, 0), map.At(column, row, 1),
                                   map.At(column, row, 2));
      image->normal_in_world.push_back(normal.allFinite() ? Eigen::Vector3f(world_from_cam * normal)
                                                          : Eigen::Vector3f::Zero());
    }
  }
}

// Splats the cloud for as many views at a time as memory allows.
class CloudDepths {
 public:
  CloudDepths(DensePointStream points, const std::vector<View>& views)
      : points_(std::move(points)), views_(views) {}

  std::optional<DepthImage> For(size_t view) {
    if (view < begin_ || view >= end_) Make(view);
    DepthImage& image = images_[view - begin_];
    if (image.width == 0) return std::nullopt;
    return image;
  }

 private:
  void Make(size_t begin) {
    if (num_seen_.empty()) num_seen_ = CountSeenPoints(points_, views_);
    begin_ = end_ = begin;
    size_t num_cells = 0;
    while (end_ < views_.size()) {
      num_cells += NumSplatCells(views_[end_], num_seen_[end_]);
      if (end_ > begin_ && num_cells > kMaxCellsAtATime) break;
      ++end_;
    }
    images_.clear();
    images_ = SplatPoints(points_, views_, num_seen_, begin_, end_);
  }

  DensePointStream points_;
  const std::vector<View>& views_;
  std::vector<size_t> num_seen_;
  std::vector<DepthImage> images_;
  size_t begin_ = 0;
  size_t end_ = 0;
};

}  // namespace

DepthSource DepthMapSource(const fs::path& stereo_dir, const std::vector<View>& views) {
  return [stereo_dir, &views](ViewId id) -> std::optional<DepthImage> {
    const View& view = views[id];
    const fs::path path = FindMap(stereo_dir / "depth_maps", view.name);
    if (path.empty()) return std::nullopt;
    if (view.lens) {
      throw IoError(path.string(),
                    "its image has lens distortion: depth maps are of undistorted "
                    "images");
    }
    const FloatMap map = ReadDepthMap(path);
    CheckShape(map, view.camera, path);
    DepthImage image = ToDepthImage(map, view);
    const fs::path normals = FindMap(stereo_dir / "normal_maps", view.name);
    if (!normals.empty()) AddNormals(normals, view, &image);
    return image;
  };
}

size_t CountDepthMaps(const fs::path& stereo_dir, const std::vector<View>& views) {
  size_t count = 0;
  for (const View& view : views) count += !FindMap(stereo_dir / "depth_maps", view.name).empty();
  return count;
}

DepthSource CloudDepthSource(DensePointStream points, const std::vector<View>& views) {
  const auto depths = std::make_shared<CloudDepths>(std::move(points), views);
  return [depths](ViewId view) { return depths->For(static_cast<size_t>(view)); };
}

DepthSource MeshDepthSource(TriangleMesh mesh, const std::vector<View>& views) {
  return [mesh = std::move(mesh), &views](ViewId view) -> std::optional<DepthImage> {
    return RenderDepth(mesh, views[view], 1);
  };
}

}  // namespace limn::colmap_ext
