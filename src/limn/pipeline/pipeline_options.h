// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "limn/belief/belief_options.h"
#include "limn/dense/dense_options.h"
#include "limn/drawing/drawing_options.h"
#include "limn/edges/edge_detection.h"
#include "limn/edges/ridge_detection.h"
#include "limn/linking/linking.h"
#include "limn/paper/paper_options.h"
#include "limn/pipeline/build_sketch.h"
#include "limn/primitives/primitive_options.h"
#include "limn/refinement/refinement_options.h"
#include "limn/regularity/regularity_options.h"
#include "limn/surfaces/surface_options.h"
#include "limn/tiles/tile_options.h"
#include "limn/util/errors.h"

namespace limn {

// How samples of the sketch become links: traced on their consensus (ours), or exactly as in the
// paper, without re-triangulation, completion, refinement or belief (ECCV 2016).
enum class DrawingMethod { kTraced, kPaper };

// Whether cameras are refined with the drawing: if it looks necessary, never, always.
enum class CameraRefinement { kAuto, kOff, kOn };

// Which cameras the drawing fits if they were refined.
enum class OutputCameras { kRefined, kGiven };

// The options of all stages from photographs to the drawing.
struct PipelineOptions {
  EdgeDetectionOptions edges;
  LinkingOptions linking;
  SketchMode mode = SketchMode::kSweep;
  SketchOptions sketch;
  DrawingMethod method = DrawingMethod::kTraced;
  CameraRefinement refine_cameras = CameraRefinement::kAuto;
  OutputCameras output_cameras = OutputCameras::kRefined;
  DrawingOptions drawing;
  PaperOptions paper;
  RefinementOptions refinement;
  BeliefOptions belief;
  PrimitiveOptions primitives;
  // Make the drawing regular, by these options.
  bool regularize = false;
  RegularityOptions regularity;
  // For faces, which are found in finished drawings.
  SurfaceOptions surfaces;
  TileOptions tiles;

  bool IsPaper() const { return method == DrawingMethod::kPaper; }
  // Throws OptionError with group and option.
  void Check() const;
};

// visit(group name, options struct) for every group of the pipeline, const or not. Their options
// are listed by their structs: see util/option_fields.h.
template <typename Options, typename Visit>
void VisitGroups(Options& options, const Visit& visit) {
  visit("EdgeDetection", options.edges);
  visit("Linking", options.linking);
  visit("ViewSelection", options.sketch.view_selection);
  visit("Sketch", options.sketch);
  visit("Drawing", options.drawing);
  visit("Paper", options.paper);
  visit("DrawingRefinement", options.refinement);
  visit("Belief", options.belief);
  visit("Primitives", options.primitives);
  visit("Regularity", options.regularity);
  visit("Surfaces", options.surfaces);
  visit("Tiles", options.tiles);
}

// Checks the options of one group. Throws OptionError with group and option.
template <typename Options>
void CheckGroup(const std::string& group, const Options& options) {
  try {
    options.Check();
  } catch (const OptionError& error) {
    throw OptionError(group + "." + error.what());
  }
}

enum class Quality { kLow, kMedium, kHigh };

// The options of a quality level. Options given explicitly override them.
struct QualityPreset {
  PipelineOptions options;
  // Longer side of the images, of a quarter turn of panoramas, pixels; -1 = as stored.
  int max_image_size = -1;
  // Pixels of a view per pixel of a sharp photograph, at most.
  double max_scale = 1;
};

// medium: the defaults of all structs, images of at most 2,048 px. low: images of at most 1,000 px,
// fewer views to pair and confirm with; for a first look. high: images as stored, sharp ones as if
// enlarged up to twice, for what they resolve between their pixels, more views to sketch, pair and
// confirm with; about twice the time of medium, and more for sharp images and where medium shrinks
// them.
QualityPreset PresetOf(Quality quality);

// Sets options of other stages to the defaults of the method: for the paper's method, those of the
// paper and of its authors' program. Options given explicitly override them.
void SetMethodDefaults(DrawingMethod method, PipelineOptions* options);

const char* DrawingMethodName(DrawingMethod method);

// All options as the text of a JSON object {"mode": name, "regularize": bool, group: {name:
// value}}, for provenance. Paper is a group of method paper only.
std::string OptionsAsJson(const PipelineOptions& options);

// The same of one group: {name: value}.
std::string OptionsAsJson(const DenseOptions& options);

// One group as "name=value" lines: two structs have the same text if and only if the options that
// users can set are equal. Do not set other fields where results are cached.
std::string OptionsAsText(const EdgeDetectionOptions& options);
std::string OptionsAsText(const RidgeOptions& options);
std::string OptionsAsText(const LinkingOptions& options);
std::string OptionsAsText(const ViewSelectionOptions& options);
// Without the view selection, which is a group of its own.
std::string OptionsAsText(const SketchOptions& options);

}  // namespace limn
