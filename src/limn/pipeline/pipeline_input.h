#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "limn/cameras/camera_mounts.h"
#include "limn/model/curve3d.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/edgel_fate.h"
#include "limn/model/scene_hints.h"
#include "limn/model/view_subset.h"
#include "limn/pipeline/extract_curves.h"
#include "limn/pipeline/refine_cameras.h"

namespace limn {

// The input of a drawing.
struct PipelineInput {
  const std::vector<View>& views;
  const SceneHints& hints;
  const ImageSource& images;
  // Only what lies in this box is reconstructed.
  std::optional<Eigen::AlignedBox3d> box;
  // Image curves and sketches of earlier runs, where new ones are stored. Never null.
  ResultCache* cache;
  // Which views move together if the cameras are refined; null = they stay as they are, whatever
  // the options say.
  const CameraMounts* mounts = nullptr;
  // Instead bring the drawing stored last up to date, if possible (update_scene.h).
  bool update = false;
};

struct PipelineResult {
  // The drawing fits them, if there are any, instead of those of the input.
  std::optional<RefinedCameras> cameras;
  std::vector<ImageCurves> curves;
  CurveSketch sketch;
  EdgelFates sketch_fates;
  DrawingGraph graph;
  SampleFates sample_fates;
  // Of a drawing that was brought up to date, the views that are new or changed.
  ViewSubset new_views = std::nullopt;
  // Stores the drawing for updates. Call it once all results are written, so that an interrupted
  // run does not count as done.
  std::function<void()> keep = [] {};
};

}  // namespace limn
