// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/dense_files/dense_cloud.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <memory>
#include <optional>

#include "colmap_ext/dense_files/patch_file.h"
#include "colmap_ext/model/record_reading.h"
#include "colmap_ext/workspace/pmvs_model.h"
#include "limn/files/whole_file.h"
#include "limn/formats/ply_points_reader.h"
#include "limn/util/byte_stream.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

// Per image of the model its view, or -1.
std::vector<ViewId> ViewsByModelIndex(const std::vector<View>& views, size_t num_images) {
  std::vector<ViewId> by_index(num_images, -1);
  for (size_t v = 0; v < views.size(); ++v) {
    const auto index = static_cast<size_t>(views[v].model_index);
    if (index < num_images) by_index[index] = static_cast<ViewId>(v);
  }
  return by_index;
}

// Reads the lists of a .vis file in order.
class VisibilityReader {
 public:
  VisibilityReader(const std::string& path, uint64_t num_points, std::vector<ViewId> views)
      : in_(OpenFile(path)), reader_(path, in_), views_(std::move(views)) {
    const uint64_t count = ReadCount(reader_, "number of points", sizeof(uint32_t));
    if (count != num_points) {
      reader_.At(0).Fail(std::to_string(count) + " points, but the cloud has " +
                         std::to_string(num_points));
    }
  }

  std::vector<ViewId> Next() {
    const auto count = reader_.Get<uint32_t>("number of images");
    std::vector<ViewId> seen_by;
    for (uint32_t k = 0; k < count; ++k) {
      const FilePlace place = reader_.Here();
      const auto image = reader_.Get<uint32_t>("image number");
      if (image >= views_.size()) {
        place.Fail("image " + std::to_string(image) + ", but the model has " +
                   std::to_string(views_.size()));
      }
      if (views_[image] >= 0) seen_by.push_back(views_[image]);
    }
    std::sort(seen_by.begin(), seen_by.end());
    return seen_by;
  }

  // Call it after the last point.
  void CheckEnd() const { reader_.ExpectEnd(); }

 private:
  std::ifstream in_;
  ByteReader reader_;
  std::vector<ViewId> views_;
};

Eigen::Vector3d UnitOrZero(const Eigen::Vector3d& vector) {
  const double norm = vector.norm();
  return norm > 0 ? Eigen::Vector3d(vector / norm) : Eigen::Vector3d::Zero();
}

// No model has such coordinates; their squares would be.
constexpr double kFarthest = 1e15;

using Colors = std::vector<std::array<uint8_t, 3>>;
constexpr std::array<uint8_t, 3> kGray = {128, 128, 128};

// PMVS writes the same points with colors to a .ply file. Empty if there is none.
Colors ColorsBeside(std::filesystem::path patches, uint64_t num_patches) {
  const std::string path = patches.replace_extension(".ply").string();
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return {};
  const PlyPointsInfo info = ReadPlyPointsInfo(path);
  if (info.count != num_patches || !info.has_colors) return {};
  Colors colors;
  const auto take = [&](const PlyPoint& point) { colors.push_back(point.color); };
  ReadPlyPoints(path, take, take);
  return colors;
}

void CheckImages(const Patch& patch, size_t num_images, const FilePlace& place) {
  for (const std::vector<int>* images : {&patch.images, &patch.more_images}) {
    for (const int image : *images) {
      if (static_cast<size_t>(image) < num_images) continue;
      place.Fail("image " + std::to_string(image) + ", but there are only " +
                 std::to_string(num_images));
    }
  }
}

}  // namespace

DenseCloud OpenPlyCloud(const std::filesystem::path& path, const std::vector<View>& views,
                        size_t num_model_images) {
  const PlyPointsInfo info = ReadPlyPointsInfo(path.string());
  const std::string visibility = path.string() + ".vis";
  std::error_code ignored;
  const bool has_visibility = std::filesystem::exists(visibility, ignored);
  const std::vector<ViewId> by_index = ViewsByModelIndex(views, num_model_images);
  if (has_visibility) VisibilityReader(visibility, info.count, by_index);  // throws
  const auto num_odd = std::make_shared<uint64_t>(0);
  DenseCloud cloud = {info.count, info.has_normals, has_visibility, {}, num_odd};
  cloud.points = [=](const DensePointVisitor& visit) {
    *num_odd = 0;
    std::unique_ptr<VisibilityReader> seen_by;
    if (has_visibility) {
      seen_by = std::make_unique<VisibilityReader>(visibility, info.count, by_index);
    }
    DensePoint point;
    point.views_known = has_visibility;
    const auto leave_out = [&](const PlyPoint&) {
      if (seen_by) seen_by->Next();
      ++*num_odd;
    };
    const auto take = [&](const PlyPoint& from) {
      if (from.position.cwiseAbs().maxCoeff() > kFarthest) {
        leave_out(from);
        return;
      }
      point.position = from.position;
      point.normal = UnitOrZero(from.normal);
      point.color = from.color;
      point.quality = from.quality;
      if (seen_by) point.views = seen_by->Next();
      visit(point);
    };
    ReadPlyPoints(path.string(), take, leave_out);
    if (seen_by) seen_by->CheckEnd();
  };
  return cloud;
}

DenseCloud OpenPatchCloud(const std::filesystem::path& path, const std::vector<View>& views,
                          size_t num_model_images) {
  const std::vector<int> numbers = PmvsNumbers(path, views);
  std::map<int, ViewId> view_of;
  for (size_t v = 0; v < views.size(); ++v) {
    if (numbers[v] >= 0) view_of[numbers[v]] = static_cast<ViewId>(v);
  }
  if (view_of.empty()) {
    throw IoError(path.string(), "bundle.rd.out.list.txt beside it names none of the images");
  }
  DenseCloud cloud;
  cloud.has_normals = cloud.has_visibility = true;
  const size_t num_named = ReadPmvsImageNames(path.parent_path().parent_path()).size();
  const size_t num_images = num_named > 0 ? num_named : num_model_images;
  ReadPatchFile(path.string(), [&](const Patch& patch) {
    CheckImages(patch, num_images, {path.string(), "patch", cloud.num_points});
    ++cloud.num_points;
  });
  const auto colors = std::make_shared<Colors>(ColorsBeside(path, cloud.num_points));
  cloud.points = [=](const DensePointVisitor& visit) {
    DensePoint point;
    point.views_known = true;
    point.color = kGray;
    uint64_t index = 0;
    ReadPatchFile(path.string(), [&](const Patch& patch) {
      point.position = patch.position;
      point.normal = UnitOrZero(patch.normal);
      point.quality = patch.photometric_score;
      if (index < colors->size()) point.color = (*colors)[index];
      ++index;
      point.views.clear();
      for (const int image : patch.images) {
        const auto view = view_of.find(image);
        if (view != view_of.end()) point.views.push_back(view->second);
      }
      std::sort(point.views.begin(), point.views.end());
      visit(point);
    });
  };
  return cloud;
}

DenseCloud OpenClouds(const std::vector<std::filesystem::path>& paths,
                      const std::vector<View>& views, size_t num_model_images) {
  std::vector<DensePointStream> parts;
  std::vector<std::shared_ptr<const uint64_t>> odd_of_parts;
  DenseCloud all = {0, true, true, {}};
  for (const std::filesystem::path& path : paths) {
    DenseCloud cloud = path.extension() == ".patch" ? OpenPatchCloud(path, views, num_model_images)
                                                    : OpenPlyCloud(path, views, num_model_images);
    all.num_points += cloud.num_points;
    all.has_normals &= cloud.has_normals;
    all.has_visibility &= cloud.has_visibility;
    parts.push_back(std::move(cloud.points));
    odd_of_parts.push_back(cloud.num_odd);
  }
  if (all.num_points == 0) throw IoError(paths.front().string(), "no points");
  const auto num_odd = std::make_shared<uint64_t>(0);
  all.num_odd = num_odd;
  all.points = [parts = std::move(parts), odd_of_parts = std::move(odd_of_parts),
                num_odd](const DensePointVisitor& visit) {
    *num_odd = 0;
    for (size_t i = 0; i < parts.size(); ++i) {
      parts[i](visit);
      if (odd_of_parts[i]) *num_odd += *odd_of_parts[i];
    }
  };
  return all;
}

std::string DenseCloud::NoteOnOdd() const {
  if (!num_odd || *num_odd == 0) return "";
  return std::to_string(*num_odd) + " of " + std::to_string(num_points) +
         " points of the cloud are left out: a coordinate, normal or color is no number, or out of "
         "all range";
}

}  // namespace limn::colmap_ext
