// SPDX-License-Identifier: BSD-3-Clause
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "colmap_ext/python/bindings.h"
#include "colmap_ext/python/run_free.h"

namespace limn::colmap_ext {

namespace py = pybind11;

namespace {

using OptionalDrawing = std::optional<std::shared_ptr<SceneDrawing>>;

// Binds a stage as name(input, options, progress).
template <typename Input, typename Output>
void BindStage(py::module_* module, const char* name,
               std::shared_ptr<Output> (*stage)(std::shared_ptr<const Input>, const OptionTexts&,
                                                RunMonitor*)) {
  module->def(
      name,
      [stage](const std::shared_ptr<Input>& input, const OptionTexts& options,
              const py::object& progress) {
        return RunFree(progress, [stage, input, options](RunMonitor* monitor) {
          return stage(input, options, monitor);
        });
      },
      py::arg("input").none(false), py::arg("options"), py::arg("progress"));
}

}  // namespace

void BindStages(py::module_* module) {
  module->def(
      "open",
      [](const OptionTexts& options, const py::object& progress) {
        return RunFree(progress,
                       [options](RunMonitor* monitor) { return OpenWorkspace(options, monitor); });
      },
      py::arg("options"), py::arg("progress"));
  module->def(
      "draw_in_folder",
      [](const OptionTexts& options, const py::object& progress) {
        return RunFree(progress,
                       [options](RunMonitor* monitor) { return DrawInFolder(options, monitor); });
      },
      py::arg("options"), py::arg("progress"));
  module->def(
      "refine_cameras_in_folder",
      [](const OptionTexts& options, const py::object& progress) {
        return RunFree(progress, [options](RunMonitor* monitor) {
          return RefineCamerasInFolder(options, monitor);
        });
      },
      py::arg("options"), py::arg("progress"));
  BindStage(module, "extract_edges", ExtractSceneEdges);
  BindStage(module, "link", LinkScene);
  BindStage(module, "sketch", SketchScene);
  BindStage(module, "draw_sketch", DrawSketch);
  BindStage(module, "draw_scene", DrawOpenScene);
  module->def(
      "apply",
      [](const std::string& function, const std::shared_ptr<SceneDrawing>& drawing,
         const OptionTexts& options, const py::object& progress) {
        return RunFree(progress, [function, drawing, options](RunMonitor* monitor) {
          return ApplyVerb(function, drawing, options, monitor);
        });
      },
      py::arg("function"), py::arg("drawing").none(false), py::arg("options"), py::arg("progress"));
  module->def(
      "read_drawing",
      [](const std::filesystem::path& path,
         const std::optional<std::shared_ptr<OpenScene>>& scene) {
        return RunFree(py::none(), [path, scene = scene.value_or(nullptr)](RunMonitor* monitor) {
          return ReadSceneDrawing(path, scene, monitor);
        });
      },
      py::arg("path"), py::arg("scene"));
  module->def(
      "evaluate",
      [](const OptionalDrawing& drawing, const OptionTexts& options, const py::object& progress) {
        return RunFree(progress,
                       [drawing = drawing.value_or(nullptr), options](RunMonitor* monitor) {
                         return EvaluateAsJson(drawing, options, monitor);
                       });
      },
      py::arg("drawing"), py::arg("options"), py::arg("progress"));
  module->def(
      "export_drawing",
      [](const OptionalDrawing& drawing, const OptionTexts& options, const py::object& progress) {
        RunWithoutLock(progress,
                       [drawing = drawing.value_or(nullptr), options](RunMonitor* monitor) {
                         ExportDrawing(drawing, options, monitor);
                       });
      },
      py::arg("drawing"), py::arg("options"), py::arg("progress"));
  module->def(
      "measure",
      [](const std::shared_ptr<SceneDrawing>& drawing, const std::string& text) {
        return RunFree(py::none(), [drawing, text](RunMonitor*) {
          const SceneLength length = MeasureLength(*drawing, text);
          return std::make_tuple(length.measured.length, length.measured.sigma, length.unit);
        });
      },
      py::arg("drawing").none(false), py::arg("text"));
  module->def(
      "run",
      [](const std::string& command, const OptionTexts& options, const py::object& progress) {
        RunWithoutLock(progress, [command, options](RunMonitor* monitor) {
          RunCommand(command, options, monitor);
        });
      },
      py::arg("command"), py::arg("options"), py::arg("progress"));
}

}  // namespace limn::colmap_ext
