// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limn/files/output_path.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/model/curve3d.h"

namespace limn {

struct StoredCurveSketch {
  CurveSketch sketch;
  // Names of the views that the sketch's view ids index, the options it was made with, and the
  // refined cameras, if it fits some.
  DrawingMetadata metadata;
};

// Stores a curve sketch with its per-sample support (see stage_file.h for the container and
// `identity`).
void WriteCurveSketch(const OutputPath& path, const CurveSketch& sketch,
                      const DrawingMetadata& metadata, const std::string& identity);

// Nothing if the file is stale: made from other input or by another version of Limn. An empty
// `identity` accepts any. `curves` are the image curves of all views. Everything read is checked
// (anchors and ids in range, sizes agree, numbers finite except unknown sigmas); throws IoError.
std::optional<StoredCurveSketch> ReadCurveSketch(const std::string& path,
                                                 const std::vector<ImageCurves>& curves,
                                                 const std::string& identity);

// DrawingMetadata::refined_cameras, from the beginning of the file. Empty if it has none, or cannot
// be read.
std::string RefinedCamerasOfSketch(const std::string& path);

}  // namespace limn
