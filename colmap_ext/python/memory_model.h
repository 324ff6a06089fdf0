// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "colmap_ext/import/imported_scene.h"
#include "colmap_ext/model/model_builder.h"
#include "colmap_ext/python/stages.h"
#include "colmap_ext/workspace/image_reader.h"

namespace limn::colmap_ext {

// Collects cameras, images and photographs in memory, for OpenMemory. All functions throw
// InputError, with the same messages as the file readers.
class MemoryModel {
 public:
  // `options` as of OpenMemory. Throws OptionError.
  explicit MemoryModel(const OptionTexts& options);

  // Records as in COLMAP's files: all cameras, then all images, then all points.
  void AddCamera(uint32_t id, const std::string& model, uint64_t width, uint64_t height,
                 std::vector<double> params);
  // `rotation`: w, x, y, z.
  void AddImage(ModelImage image, const std::array<double, 4>& rotation);
  // `rotation`: a matrix.
  void AddImage(ModelImage image, const Eigen::Matrix3d& rotation);
  void AddPoint(ModelPoint point) { builder_.AddPoint(std::move(point)); }
  // Rigs and frames, in any order: poses of their images become those that they compose, as in
  // files. Poses are those of MemoryModel::Pose.
  void AddRig(Rig rig) { rigs_.push_back(std::move(rig)); }
  void AddFrame(Frame frame) { frames_.push_back(std::move(frame)); }

  // Checked and normalized. `rotation`: w, x, y, z, or the nine numbers of a matrix, row by row;
  // `what` is named in errors.
  static Rigid3d Pose(std::span<const double> rotation, const Eigen::Vector3d& translation,
                      const std::string& what, uint32_t id);

  // Instead of records: a pinhole camera x_px = K (R X + t) with its image.
  void AddView(const std::string& name, const Eigen::Matrix3d& calibration,
               const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation, ImageSize size);

  // To be called before a photograph is copied. Throws InputError for one that would be refused as
  // a file (CheckDecodable), or that takes more memory than there is.
  void CheckRoomFor(const std::string& name, ImageSize size, uint64_t num_bytes) const;
  void AddPhoto(const std::string& name, PhotoPixels pixels);

  // From the views if any were added, else from the records. Call it once.
  SparseModel TakeModel(PixelCenters pixel_centers);
  PhotoStore TakePhotos() { return PhotoStore(std::move(photos_)); }
  const MadeWith& made() const { return made_; }

 private:
  MadeWith made_;
  ModelBuilder builder_;
  std::vector<Rig> rigs_;
  std::vector<Frame> frames_;
  ImportedScene views_;
  std::map<std::string, PhotoPixels> photos_;
};

// The scene of a model; photographs that are not in memory are in the folder.
std::shared_ptr<OpenScene> OpenMemory(SparseModel model, const std::filesystem::path& image_dir,
                                      const PhotoStore& photos, MadeWith made, RunMonitor* monitor);

}  // namespace limn::colmap_ext
