// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/python/memory_model.h"

#include "colmap_ext/host/run_needs.h"
#include "colmap_ext/import/calibration.h"
#include "colmap_ext/model/mounted_images.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

// There are no files: what is wrong is wrong with the input.
template <typename Work>
auto AsInputErrors(const Work& work) {
  try {
    return work();
  } catch (const IoError& error) {
    throw InputError(error.what());
  }
}

const std::string& Place() {
  static const std::string place = "reconstruction";
  return place;
}

// The run options ask for a workspace; it is not read.
MadeWith MadeInMemory(const OptionTexts& options) {
  RefuseOptions("Scene", options,
                {"workspace_path", "input_path", "image_path", "output_path", "model_index"});
  MadeWith made;
  made.given = Merged({{"workspace_path", "."}}, options);
  made.options = ParseTexts("Scene", OptionsOfAllStages(), made.given);
  return made;
}

}  // namespace

MemoryModel::MemoryModel(const OptionTexts& options) : made_(MadeInMemory(options)) {}

void MemoryModel::AddCamera(uint32_t id, const std::string& model, uint64_t width, uint64_t height,
                            std::vector<double> params) {
  const CameraModel* known = FindCameraModel(model);
  const std::string what = "reconstruction: camera " + std::to_string(id);
  if (!known) {
    throw InputError(what + ": unknown camera model '" + model +
                     "', supported: " + SupportedCameraModels());
  }
  if (params.size() != static_cast<size_t>(known->num_params)) {
    throw InputError(what + ": " + model + " has " + std::to_string(known->num_params) +
                     " parameters, not " + std::to_string(params.size()));
  }
  AsInputErrors([&] {
    builder_.AddCamera({id, known->id, width, height, std::move(params)}, {Place(), "camera", id});
  });
}

void MemoryModel::AddImage(ModelImage image, const std::array<double, 4>& rotation) {
  const FilePlace place = {Place(), "image", image.id};
  AsInputErrors([&] { builder_.AddImage(std::move(image), rotation, place); });
}

void MemoryModel::AddImage(ModelImage image, const Eigen::Matrix3d& rotation) {
  const FilePlace place = {Place(), "image", image.id};
  const Eigen::Quaterniond q = AsInputErrors([&] { return RotationFromMatrix(rotation, place); });
  AddImage(std::move(image), std::array<double, 4>{q.w(), q.x(), q.y(), q.z()});
}

Rigid3d MemoryModel::Pose(std::span<const double> rotation, const Eigen::Vector3d& translation,
                          const std::string& what, uint32_t id) {
  const FilePlace place = {Place(), what.c_str(), id};
  return AsInputErrors([&]() -> Rigid3d {
    if (rotation.size() == 4) {
      return MakePose({rotation[0], rotation[1], rotation[2], rotation[3]}, translation, what,
                      place);
    }
    if (rotation.size() != 9) place.Fail("the rotation must be 3 x 3 or have 4 numbers");
    using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    const Eigen::Quaterniond q = RotationFromMatrix(Eigen::Map<const Rows>(rotation.data()), place);
    return MakePose({q.w(), q.x(), q.y(), q.z()}, translation, what, place);
  });
}

void MemoryModel::AddView(const std::string& name, const Eigen::Matrix3d& calibration,
                          const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation,
                          ImageSize size) {
  ImportedImage image;
  image.name = name;
  image.path = "arrays";
  image.unit = "image";
  image.number = views_.images.size();
  const FilePlace place = {image.path, image.unit, image.number};
  AsInputErrors([&] {
    image.camera = CameraFromCalibration(calibration, size, place);
    image.cam_from_world = {RotationFromMatrix(rotation, place), translation};
  });
  views_.images.push_back(std::move(image));
}

void MemoryModel::CheckRoomFor(const std::string& name, ImageSize size, uint64_t num_bytes) const {
  AsInputErrors([&] { CheckDecodable("image " + name, size, made_.options.view.max_image_size); });
  const std::optional<double> available = AvailableMemory();
  if (!available || static_cast<double>(num_bytes) <= *available) return;
  throw InputError("image " + name + ": its copy takes " + std::to_string(num_bytes >> 20) +
                   " MB, more memory than there is: give the images as files, or smaller");
}

void MemoryModel::AddPhoto(const std::string& name, PhotoPixels pixels) {
  if (photos_.emplace(name, std::move(pixels)).second) return;
  throw InputError("images: there are two of the name \"" + name + "\"");
}

SparseModel MemoryModel::TakeModel(PixelCenters pixel_centers) {
  return AsInputErrors([&] {
    if (views_.images.empty()) {
      SparseModel model = builder_.Finish();
      model.rigs = std::move(rigs_);
      model.frames = std::move(frames_);
      if (!model.rigs.empty()) ApplyRigs(&model);
      return model;
    }
    return ToSparseModel(std::move(views_), {.pixel_centers = pixel_centers});
  });
}

std::shared_ptr<OpenScene> OpenMemory(SparseModel model, const std::filesystem::path& image_dir,
                                      const PhotoStore& photos, MadeWith made,
                                      RunMonitor* monitor) {
  LibraryConsole console(made.options.num_threads, monitor);
  return std::make_shared<OpenScene>(std::move(model), image_dir, photos, std::move(made),
                                     &console);
}

}  // namespace limn::colmap_ext
