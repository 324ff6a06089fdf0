#include "colmap_ext/verbs/drawing_in_scene.h"

#include <utility>

#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/verbs/drawing_input.h"
#include "limn/alignment/camera_hints.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {

DrawingMetadata Metadata(const Scene& scene, const std::string& provenance) {
  DrawingMetadata metadata;
  for (const View& view : scene.views()) metadata.view_names.push_back(view.name);
  metadata.options_json = provenance;
  if (!scene.views().empty()) metadata.main_view_direction = MainViewDirection(scene.views());
  return metadata;
}

DrawingFile ReadDrawingOf(const Scene& scene, const std::string& path) {
  const std::vector<std::string> view_names = Metadata(scene, "{}").view_names;
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
