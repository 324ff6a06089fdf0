// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/drawing_in_scene.h"

#include <utility>

#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/verbs/drawing_input.h"
#include "limn/alignment/camera_hints.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {

std::vector<std::string> ViewNames(const Scene& scene) {
  std::vector<std::string> names;
  for (const View& view : scene.views()) names.push_back(view.name);
  return names;
}

DrawingMetadata Metadata(const Scene& scene, const std::string& provenance) {
  DrawingMetadata metadata;
  metadata.view_names = ViewNames(scene);
  metadata.options_json = provenance;
  if (!scene.views().empty()) metadata.main_view_direction = MainViewDirection(scene.views());
  return metadata;
}

DrawingFile ReadDrawingOf(const Scene& scene, const std::string& path) {
  const std::vector<std::string> view_names = ViewNames(scene);
  DrawingFile drawing = ReadDrawing(path, view_names);
  if (drawing.metadata.view_names == view_names) return drawing;
  throw IoError(path, "is a drawing of other images than those of the model");
}

DrawingInScene ReadDrawingInScene(const Scene& scene, const std::string& path) {
  DrawingFile file = ReadDrawingOf(scene, path);
  DrawingInScene drawing = {Moved(std::move(file.graph), -scene.origin()), std::move(file.metadata),
                            scene.views(), nullptr};
  drawing.fingerprint = FingerprintOf(path);
  return drawing;
}

}  // namespace limn::colmap_ext
