// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "colmap_ext/host/job.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/verbs/draw_options.h"
#include "colmap_ext/verbs/drawing_in_scene.h"
#include "limn/model/drawing_graph.h"
#include "limn/pipeline/pipeline.h"

namespace limn::colmap_ext {

// What is drawn of a scene. One that is drawn in tiles has no curves, sketch and fates.
struct DrawnScene {
  DrawingInScene drawing;
  CurveSketch sketch;
  // As the cameras of the sketch see them.
  std::shared_ptr<const std::vector<ImageCurves>> curves_of_sketch;
  EdgelFates sketch_fates;
  SampleFates sample_fates;
  // See PipelineResult.
  ViewSubset new_views;
  std::function<void()> keep;
  // The sketch is of them, if there are any, instead of those of the scene, and the drawing fits
  // them, too, unless it fits the given ones.
  std::optional<RefinedCameras> cameras;
  bool fits_given = false;
};

// Draws a scene, alone or together with the other ranks. Nothing for a shard, which is only kept,
// and for ranks other than 0. Precondition: CheckSceneViews. Throws what the stages throw.
std::optional<DrawnScene> DrawInMemory(const Job& job, const DrawerOptions& options);

// What automatic_drawer does with a project: draws its scene and writes all results but
// project.ini. Returns the drawing, relative to the project's origin; nothing where DrawInMemory
// returns nothing. Nothing is written before the input has been checked.
std::optional<DrawingGraph> DrawProject(const Project& project, const DrawerOptions& options,
                                        Console* console);

}  // namespace limn::colmap_ext
