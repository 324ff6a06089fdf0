// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "limn/cameras/camera_mounts.h"
#include "limn/cameras/row_motion.h"
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

// Of a drawing that fits the cameras of the input although they were refined.
struct FitToGiven {
  std::vector<ImageCurves> curves;  // as these cameras see them
  // Median distance of the curves from their edgels in the images of these cameras, px: of the
  // drawing that fits the refined cameras, and of this one.
  double refined_px = 0;
  double given_px = 0;
};

struct PipelineResult {
  // Sketch and curves are of them, if there are any, instead of those of the input; the drawing
  // fits them, too, unless it fits the given ones.
  std::optional<RefinedCameras> cameras;
  std::vector<ImageCurves> curves;
  CurveSketch sketch;
  EdgelFates sketch_fates;
  DrawingGraph graph;
  SampleFates sample_fates;
  // Of a drawing that was brought up to date, the views that are new or changed.
  ViewSubset new_views = std::nullopt;
  RowMotion rows = {};  // CameraRefiner::Rows; of no view if nothing was measured
  std::optional<FitToGiven> fit_to_given = std::nullopt;
  // Stores the drawing for updates. Call it once all results are written, so that an interrupted
  // run does not count as done.
  std::function<void()> keep = [] {};
};

}  // namespace limn
