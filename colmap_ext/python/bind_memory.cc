// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "colmap_ext/python/bindings.h"
#include "colmap_ext/python/memory_model.h"
#include "colmap_ext/python/run_free.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {

namespace py = pybind11;

namespace {

// Converts, and copies if it must.
template <typename Number>
using Values = py::array_t<Number, py::array::c_style | py::array::forcecast>;

Eigen::Vector3d ToVector(const Values<double>& array, const char* what) {
  if (array.size() != 3) throw InputError(std::string(what) + ": must have 3 numbers");
  return {array.data()[0], array.data()[1], array.data()[2]};
}

Eigen::Matrix3d ToMatrix(const Values<double>& array, const char* what) {
  if (array.ndim() != 2 || array.size() != 9)
    throw InputError(std::string(what) + ": must be 3 x 3");
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(array.data());
}

std::vector<Observation> Observations(const Values<double>& positions,
                                      const Values<uint64_t>& point_ids) {
  const auto count = static_cast<size_t>(point_ids.size());
  if (static_cast<size_t>(positions.size()) != 2 * count) {
    throw InputError("points2D: must be as many positions as ids of points");
  }
  std::vector<Observation> observations(count);
  for (size_t i = 0; i < count; ++i) {
    observations[i].position = {positions.data()[2 * i], positions.data()[2 * i + 1]};
    observations[i].point3D_id = point_ids.data()[i];
  }
  return observations;
}

void AddImage(MemoryModel* model, uint32_t id, uint32_t camera_id, std::string name,
              const Values<double>& rotation, const Values<double>& translation,
              const Values<double>& positions, const Values<uint64_t>& point_ids) {
  ModelImage image;
  image.id = id;
  image.camera_id = camera_id;
  image.name = std::move(name);
  image.cam_from_world.translation = ToVector(translation, "translation");
  image.observations = Observations(positions, point_ids);
  if (rotation.size() == 4) {
    std::array<double, 4> quaternion;
    std::copy_n(rotation.data(), 4, quaternion.begin());
    model->AddImage(std::move(image), quaternion);
  } else {
    model->AddImage(std::move(image), ToMatrix(rotation, "rotation"));
  }
}

void AddPoint(MemoryModel* model, uint64_t id, const Values<double>& position,
              const std::array<uint8_t, 3>& color, double error,
              const std::vector<std::pair<uint32_t, uint32_t>>& track) {
  ModelPoint point;
  point.id = id;
  point.position = ToVector(position, "points3D");
  point.color = color;
  point.error = error;
  for (const auto& [image_id, observation] : track) point.track.push_back({image_id, observation});
  model->AddPoint(std::move(point));
}

Rigid3d ToPose(const Values<double>& rotation, const Values<double>& translation,
               const std::string& what, uint32_t id) {
  return MemoryModel::Pose({rotation.data(), static_cast<size_t>(rotation.size())},
                           ToVector(translation, "translation"), what, id);
}

// Type and id of a sensor.
using SensorPair = std::pair<int32_t, uint32_t>;
// The id of a camera, and its pose in a rig.
using CameraOfRig = std::tuple<uint32_t, Values<double>, Values<double>>;
// The ids of an image and of its camera.
using ImageOfFrame = std::pair<uint32_t, uint32_t>;

void AddRig(MemoryModel* model, uint32_t id, const SensorPair& reference,
            const std::vector<CameraOfRig>& cameras) {
  Rig rig;
  rig.id = id;
  rig.sensors.push_back({{reference.first, reference.second}, true, {}});
  for (const auto& [camera_id, rotation, translation] : cameras) {
    rig.sensors.push_back(
        {{kCameraSensor, camera_id}, true, ToPose(rotation, translation, "rig", id)});
  }
  model->AddRig(std::move(rig));
}

void AddFrame(MemoryModel* model, uint32_t id, uint32_t rig_id, const Values<double>& rotation,
              const Values<double>& translation, const std::vector<ImageOfFrame>& images) {
  Frame frame = {id, rig_id, ToPose(rotation, translation, "frame", id), {}};
  for (const auto& [image_id, camera_id] : images) {
    frame.data.push_back({{kCameraSensor, camera_id}, image_id});
  }
  model->AddFrame(std::move(frame));
}

template <typename Number>
std::vector<Number> CopyValues(const py::array& array) {
  const Values<Number> values(array);
  return {values.data(), values.data() + values.size()};
}

// Before anything looks at the values or copies them.
void CheckPhoto(const MemoryModel& model, const std::string& name, const py::array& array) {
  const auto fail = [&](const std::string& why) { throw InputError("image " + name + ": " + why); };
  if (array.ndim() != 2 && !(array.ndim() == 3 && (array.shape(2) == 1 || array.shape(2) == 3))) {
    fail("must be an array of H x W or H x W x 3");
  }
  if (array.size() == 0 || std::max(array.shape(0), array.shape(1)) > 1'000'000) {
    fail("the size makes no sense");
  }
  const ImageSize size = {static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0))};
  model.CheckRoomFor(name, size, static_cast<uint64_t>(array.nbytes()));
}

// `white` is the level of white of floating-point numbers.
PhotoPixels ToPixels(const MemoryModel& model, const std::string& name, const py::array& array,
                     double white) {
  CheckPhoto(model, name, array);
  const auto fail = [&](const std::string& why) { throw InputError("image " + name + ": " + why); };
  PhotoPixels pixels;
  pixels.size = {static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0))};
  pixels.channels = array.ndim() == 3 ? static_cast<int>(array.shape(2)) : 1;
  if (py::isinstance<py::array_t<uint8_t>>(array)) {
    pixels.values = CopyValues<uint8_t>(array);
  } else if (py::isinstance<py::array_t<uint16_t>>(array)) {
    pixels.values = CopyValues<uint16_t>(array);
  } else if (array.dtype().kind() == 'f') {
    std::vector<float> values = CopyValues<float>(array);
    const auto scale = static_cast<float>(1 / white);
    for (float& value : values) value *= scale;
    const bool in_range = std::all_of(values.begin(), values.end(),
                                      [](float value) { return value >= 0 && value <= 1; });
    if (!in_range) {
      fail("floating-point values must be 0 to 1, or, of all images of the scene, 0 to 255");
    }
    pixels.values = std::move(values);
  } else {
    fail("values must be uint8, uint16 or floating-point");
  }
  return pixels;
}

std::shared_ptr<OpenScene> Open(MemoryModel* model, const std::filesystem::path& image_path,
                                bool half_pixels, const py::object& progress) {
  const auto centers = half_pixels ? PixelCenters::kHalf : PixelCenters::kInteger;
  auto taken = std::make_shared<SparseModel>(model->TakeModel(centers));
  return RunFree(progress, [taken, image_path, photos = model->TakePhotos(),
                            made = model->made()](RunMonitor* monitor) {
    return OpenMemory(std::move(*taken), image_path, photos, made, monitor);
  });
}

}  // namespace

void BindMemory(py::module_* module) {
  py::class_<MemoryModel>(*module, "MemoryModel", "Cameras and images, for a Scene.")
      .def("add_camera", &MemoryModel::AddCamera, py::arg("id"), py::arg("model"), py::arg("width"),
           py::arg("height"), py::arg("params"))
      .def("add_image", AddImage, py::arg("id"), py::arg("camera_id"), py::arg("name"),
           py::arg("rotation"), py::arg("translation"), py::arg("positions"), py::arg("point_ids"),
           "rotation: 3 x 3, or a quaternion w, x, y, z; positions: N x 2 in COLMAP's pixels.")
      .def("add_point", AddPoint, py::arg("id"), py::arg("position"), py::arg("color"),
           py::arg("error"), py::arg("track"))
      .def("add_rig", AddRig, py::arg("id"), py::arg("reference"), py::arg("cameras"),
           "reference: type and id of its sensor; cameras: id, rotation and translation of others.")
      .def("add_frame", AddFrame, py::arg("id"), py::arg("rig_id"), py::arg("rotation"),
           py::arg("translation"), py::arg("images"),
           "images: their ids and those of their cameras.")
      .def(
          "add_view",
          [](MemoryModel* model, const std::string& name, const Values<double>& K,
             const Values<double>& R, const Values<double>& t, int width, int height) {
            model->AddView(name, ToMatrix(K, "K"), ToMatrix(R, "R"), ToVector(t, "t"),
                           {width, height});
          },
          py::arg("name"), py::arg("K"), py::arg("R"), py::arg("t"), py::arg("width"),
          py::arg("height"))
      .def("check_photo", CheckPhoto, py::arg("name"), py::arg("image"))
      .def(
          "add_photo",
          [](MemoryModel* model, const std::string& name, const py::array& image, double white) {
            model->AddPhoto(name, ToPixels(*model, name, image, white));
          },
          py::arg("name"), py::arg("image"), py::arg("white"))
      .def("open", Open, py::arg("image_path"), py::arg("half_pixels"), py::arg("progress"));
  module->def(
      "memory_model", [](const OptionTexts& options) { return MemoryModel(options); },
      py::arg("options"), "An empty one, for a scene with these options.");
}

}  // namespace limn::colmap_ext
