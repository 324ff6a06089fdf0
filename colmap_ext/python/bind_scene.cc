// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <stdexcept>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/python/arrays.h"
#include "colmap_ext/python/bindings.h"
#include "colmap_ext/python/run_free.h"
#include "colmap_ext/workspace/to_views.h"
#include "limn/util/printable.h"

namespace limn::colmap_ext {

namespace py = pybind11;

namespace {

py::dict ToDict(const StageSummary::Counts& counts) {
  py::dict dict;
  for (const auto& [name, count] : counts) dict[py::str(name)] = count;
  return dict;
}

std::vector<std::string> NamesOf(const OpenScene& scene) {
  std::vector<std::string> names;
  for (const View& view : scene.scene.views()) names.push_back(view.name);
  return names;
}

// H x W or H x W x 3, gray levels 0 to 255.
py::array_t<float> ImageOf(std::shared_ptr<const OpenScene> scene, const std::string& name) {
  const ViewId view = ViewNamed(scene->scene.views(), name);
  const Image image = RunFree(py::none(), [scene = std::move(scene), view](RunMonitor*) {
    Image photo = ReadViewImage(scene->scene.view_set(), view);
    return photo.scale.isOnes() ? std::move(photo) : AtViewSize(photo);
  });
  const auto height = static_cast<py::ssize_t>(image.height);
  std::vector<py::ssize_t> shape = {height, image.width};
  if (image.channels == 3) shape.push_back(3);
  py::array_t<float> array(shape);
  std::copy(image.data.begin(), image.data.end(), array.mutable_data());
  return array;
}

using CameraNumbers = std::array<double, 4>;

// Focal lengths and principal point; the rotation as x, y, z, w.
py::tuple PickledCamera(const SceneCamera& c) {
  const auto& [rotation, translation] = c.cam_from_world;
  const CameraNumbers pinhole = {c.camera.fx, c.camera.fy, c.camera.cx, c.camera.cy};
  const CameraNumbers turn = {rotation.x(), rotation.y(), rotation.z(), rotation.w()};
  const std::array<double, 3> shift = {translation.x(), translation.y(), translation.z()};
  return CallOf(PickleFunction("camera"), py::make_tuple(c.name, c.camera.width, c.camera.height,
                                                         pinhole, turn, shift, c.has_lens));
}

SceneCamera ToCamera(const std::string& name, int width, int height, const CameraNumbers& pinhole,
                     const CameraNumbers& turn, const std::array<double, 3>& shift, bool has_lens) {
  SceneCamera c;
  c.name = name;
  c.camera.fx = pinhole[0];
  c.camera.fy = pinhole[1];
  c.camera.cx = pinhole[2];
  c.camera.cy = pinhole[3];
  c.camera.width = width;
  c.camera.height = height;
  c.cam_from_world.rotation = Eigen::Quaterniond(turn[3], turn[0], turn[1], turn[2]);
  c.cam_from_world.translation = Eigen::Vector3d(shift[0], shift[1], shift[2]);
  c.has_lens = has_lens;
  return c;
}

// The folder is opened again.
py::tuple PickledScene(const OpenScene& scene) {
  py::dict options;
  for (const auto& [name, text] : OptionsOfFolder(scene)) options[py::str(name)] = py::bytes(text);
  return CallOf(PickleFunction("scene"), py::make_tuple(options));
}

}  // namespace

std::vector<SceneCamera> CamerasOf(const std::vector<View>& views) {
  std::vector<SceneCamera> cameras;
  for (const View& view : views) {
    cameras.push_back({view.name, view.camera, view.cam_from_world, view.lens != nullptr});
  }
  return cameras;
}

py::tuple CallOf(const py::object& function, const py::tuple& arguments) {
  return py::make_tuple(function, arguments);
}

py::object PickleFunction(const char* name) {
  return py::module_::import("limn._pickles").attr(name);
}

py::list WarningsOf(const RunLog& log) {
  py::list warnings;
  for (const std::string& warning : log.warnings) warnings.append(LineOf(warning));
  return warnings;
}

py::list StagesOf(const RunLog& log) {
  py::list stages;
  for (const RunLog::Stage& stage : log.stages) {
    py::dict one;
    one["stage"] = stage.summary.stage;
    one["seconds"] = stage.seconds;
    one["in"] = ToDict(stage.summary.in);
    one["kept"] = ToDict(stage.summary.kept);
    one["dropped"] = ToDict(stage.summary.dropped);
    stages.append(one);
  }
  return stages;
}

py::str LineOf(const std::string& text) {
  return py::reinterpret_steal<py::str>(PyUnicode_DecodeFSDefault(Printable(text).c_str()));
}

size_t IndexOf(py::ssize_t i, size_t n) {
  const auto size = static_cast<py::ssize_t>(n);
  if (i < -size || i >= size) throw py::index_error("there are " + std::to_string(n));
  return static_cast<size_t>(i < 0 ? i + size : i);
}

py::iterator IterateSequence(const py::object& sequence) {
  return py::reinterpret_steal<py::iterator>(PySeqIter_New(sequence.ptr()));
}

ViewId ViewNamed(const std::vector<View>& views, const std::string& name) {
  const auto found =
      std::find_if(views.begin(), views.end(), [&](const View& view) { return view.name == name; });
  if (found == views.end()) throw py::key_error(name);
  return static_cast<ViewId>(found - views.begin());
}

void BindScene(py::module_* module) {
  py::class_<SceneCamera>(
      *module, "Camera",
      "A pinhole camera with a pose: x_px = K (R X + t). The center of the top-left "
      "pixel is (0, 0). Of a camera with a lens, the virtual pinhole camera that its "
      "image is mapped to.")
      .def_property_readonly(
          "name", [](const SceneCamera& c) { return c.name; }, "Name of the image.")
      .def_property_readonly(
          "width", [](const SceneCamera& c) { return c.camera.width; },
          "Width of the image as used, px.")
      .def_property_readonly(
          "height", [](const SceneCamera& c) { return c.camera.height; },
          "Height of the image as used, px.")
      .def_property_readonly(
          "K", [](const SceneCamera& c) { return CopyOf(c.camera.Calibration()); },
          "3 x 3 calibration, px.")
      .def_property_readonly(
          "R",
          [](const SceneCamera& c) { return CopyOf(c.cam_from_world.rotation.toRotationMatrix()); },
          "3 x 3 rotation from the model to the camera.")
      .def_property_readonly(
          "t", [](const SceneCamera& c) { return CopyOf(c.cam_from_world.translation); },
          "3 translation from the model to the camera, in the model's unit.")
      .def_property_readonly(
          "center",
          [](const SceneCamera& c) { return CopyOf(Inverse(c.cam_from_world).translation); },
          "3 position of the camera, in the model's unit.")
      .def_property_readonly(
          "has_lens", [](const SceneCamera& c) { return c.has_lens; },
          "Whether the photograph has distortion.")
      .def("__reduce__", PickledCamera)
      .def("__repr__", [](const SceneCamera& c) { return "<limn.Camera of '" + c.name + "'>"; });

  module->def("make_camera", ToCamera, py::arg("name"), py::arg("width"), py::arg("height"),
              py::arg("pinhole"), py::arg("turn"), py::arg("shift"), py::arg("has_lens"));

  py::class_<OpenScene, std::shared_ptr<OpenScene>>(
      *module, "Scene",
      "Photographs and cameras: what a drawing is made from; its length is the number of images. "
      "From limn.open(), Scene.from_arrays() or Scene.from_reconstruction().")
      .def_property_readonly("names", NamesOf, "Names of the images, sorted.")
      .def_property_readonly(
          "cameras",
          [](const OpenScene& scene) {
            return CamerasOf(Moved(scene.scene.views(), scene.scene.origin()));
          },
          "A camera per image, in the order of the names.")
      .def_property_readonly(
          "warnings", [](const OpenScene& scene) { return WarningsOf(scene.made.log); },
          "Warnings from reading the scene, as lines of text.")
      .def_property_readonly(
          "num_points",
          [](const OpenScene& scene) { return scene.scene.view_set().hints.points.size(); },
          "Number of 3D points of the sparse model that images see.")
      .def("image", ImageOf, py::arg("name"),
           "The photograph as used: H x W or H x W x 3 (RGB), a copy, gray levels 0 to 255. Raises "
           "KeyError for other names, and limn.IoError if the file cannot be read.")
      .def("__reduce__", PickledScene)
      .def("__len__", [](const OpenScene& scene) { return scene.scene.views().size(); })
      .def("__repr__", [](const OpenScene& scene) {
        return "<limn.Scene of " + std::to_string(scene.scene.views().size()) + " images>";
      });
}

}  // namespace limn::colmap_ext
