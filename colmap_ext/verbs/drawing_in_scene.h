// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "colmap_ext/host/scene.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// A drawing in memory with what goes with it. Positions are relative to the origin of its scene;
// only the alignment in the metadata is of the model's coordinates.
struct DrawingInScene {
  DrawingGraph graph;
  DrawingMetadata metadata;
  // Those of the scene, with the cameras that the drawing fits.
  std::vector<View> views;
  // Per view; null if they are not in memory.
  std::shared_ptr<const std::vector<ImageCurves>> curves;
  // Whether sigmas have the share of cameras (AddShareOfCameras), or hold if these are right.
  bool has_share_of_cameras = false;
  // Of the file that it was read from (FingerprintOf); empty if it was made in memory.
  std::string fingerprint = {};
};

// The names of the scene's views.
std::vector<std::string> ViewNames(const Scene& scene);

// Of the scene's views, and the provenance of a result made from them.
DrawingMetadata Metadata(const Scene& scene, const std::string& provenance);

// ReadDrawing for the scene's views, in the coordinates of the file. Throws IoError if it is
// missing, damaged or of other views.
DrawingFile ReadDrawingOf(const Scene& scene, const std::string& path);

// The same, in the scene.
DrawingInScene ReadDrawingInScene(const Scene& scene, const std::string& path);

}  // namespace limn::colmap_ext
