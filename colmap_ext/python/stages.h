// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "colmap_ext/host/library_console.h"
#include "colmap_ext/host/scene.h"
#include "colmap_ext/python/option_texts.h"
#include "limn/alignment/drawing_span.h"
#include "limn/evaluation/evaluate_curves.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/model/curve3d.h"
#include "limn/pipeline/pipeline.h"

namespace limn::colmap_ext {

// The stages on a scene in memory. Only ExportDrawing, SaveDrawing, EvaluateAsJson with options
// that name its outputs, RunCommand and DrawInFolder write files. Options of a command that do not
// apply to a stage, such as output_path, are refused (OptionError). A result keeps what it was made
// from, and the options; a later stage adds its own, and may not change those of the stages before
// it (OptionError).

// What a stage was made with.
struct MadeWith {
  OptionTexts given;
  RunOptions options;  // `given`, parsed
  RunLog log;          // of this stage
};

struct OpenScene {
  OpenScene(const WorkspaceLayout& layout, MadeWith with, Console* console);
  OpenScene(SparseModel model, const std::filesystem::path& image_dir, const PhotoStore& photos,
            MadeWith with, Console* console);

  Scene scene;
  MadeWith made;
};

// Edges of the photographs.
struct SceneEdges {
  std::shared_ptr<const OpenScene> scene;
  MadeWith made;
  std::vector<EdgeMap> edge_maps;  // per view, in stored pixels
};

// Curves of the photographs.
struct SceneCurves {
  std::shared_ptr<const OpenScene> scene;
  MadeWith made;
  std::shared_ptr<const std::vector<ImageCurves>> curves;  // per view
};

// Unconnected curves in space.
struct SceneSketch {
  std::shared_ptr<const SceneCurves> curves;
  MadeWith made;
  std::shared_ptr<const CurveSketch> sketch;    // relative to the scene's origin
  std::shared_ptr<const CurveSketch> in_model;  // in the model's coordinates
};

struct SceneDrawing {
  DrawingGraph graph;  // in the model's coordinates
  DrawingMetadata metadata;
  MadeWith made;
  // Null for a drawing that was read without its workspace.
  std::shared_ptr<const OpenScene> scene;
  // The views that the drawing fits, relative to the scene's origin; empty without a scene.
  std::vector<View> views;
  // Null if they are not in memory.
  std::shared_ptr<const std::vector<ImageCurves>> curves;
};

// The option groups of all stages together.
OptionGroups OptionsOfAllStages();

// Throws OptionError, IoError, InputError, as all that follow; and Cancelled.
std::shared_ptr<OpenScene> OpenWorkspace(const OptionTexts& options, RunMonitor* monitor);

std::shared_ptr<SceneEdges> ExtractSceneEdges(std::shared_ptr<const OpenScene> scene,
                                              const OptionTexts& options, RunMonitor* monitor);

std::shared_ptr<SceneCurves> LinkScene(std::shared_ptr<const OpenScene> scene,
                                       const OptionTexts& options, RunMonitor* monitor);

std::shared_ptr<SceneSketch> SketchScene(std::shared_ptr<const SceneCurves> curves,
                                         const OptionTexts& options, RunMonitor* monitor);

// The drawing of a sketch before its refinement, as of curve_drawer.
std::shared_ptr<SceneDrawing> DrawSketch(std::shared_ptr<const SceneSketch> sketch,
                                         const OptionTexts& options, RunMonitor* monitor);

// All stages, as of automatic_drawer.
std::shared_ptr<SceneDrawing> DrawOpenScene(std::shared_ptr<const OpenScene> scene,
                                            const OptionTexts& options, RunMonitor* monitor);

// What a verb of the table of commands makes of a drawing with a scene, by its name in Python.
// Throws also std::out_of_range if there is none of this name.
std::shared_ptr<SceneDrawing> ApplyVerb(const std::string& function,
                                        std::shared_ptr<const SceneDrawing> drawing,
                                        const OptionTexts& options, RunMonitor* monitor);

// A drawing.json; with its scene, if that is not null, or that with the refined cameras that it
// fits.
std::shared_ptr<SceneDrawing> ReadSceneDrawing(const std::filesystem::path& path,
                                               std::shared_ptr<const OpenScene> scene,
                                               RunMonitor* monitor);

// The report as JSON, as of drawing_evaluator: of a drawing, or of the file that the options name
// if it is null.
std::string EvaluateAsJson(std::shared_ptr<const SceneDrawing> drawing, const OptionTexts& options,
                           RunMonitor* monitor);

// Writes a file, as drawing_exporter does: of a drawing, or of the one that the options name if it
// is null.
void ExportDrawing(std::shared_ptr<const SceneDrawing> drawing, const OptionTexts& options,
                   RunMonitor* monitor);

struct SceneLength {
  MeasuredLength measured;
  std::string unit;  // "m", or "none" if the scale is unknown
};

// A length of a drawing (ParseSpan), in the world if it is aligned. Pixels need the scene. Throws
// OptionError for other texts.
SceneLength MeasureLength(const SceneDrawing& drawing, const std::string& text);

// Writes a drawing in the format of the extension: all of it as .json, without tentative links and
// contours in the others, as automatic_drawer does.
void SaveDrawing(const SceneDrawing& drawing, const std::string& path);

// The text of its drawing.json.
std::string DrawingAsJson(const SceneDrawing& drawing);

// A drawing without a scene, of such a text.
std::shared_ptr<SceneDrawing> DrawingFromJson(const std::string& text);

// The options that open the scene of a folder again. Throws InputError for one in memory.
OptionTexts OptionsOfFolder(const OpenScene& scene);

// Runs a command of the command line, which writes what it writes there, but prints nothing.
// Throws OptionError if there is no such command.
RunLog RunCommand(const std::string& command, const OptionTexts& options, RunMonitor* monitor);

// camera_refiner, and the workspace with the refined model.
std::shared_ptr<OpenScene> RefineCamerasInFolder(const OptionTexts& options, RunMonitor* monitor);

// automatic_drawer, and its drawing read again, with its scene.
std::shared_ptr<SceneDrawing> DrawInFolder(const OptionTexts& options, RunMonitor* monitor);

}  // namespace limn::colmap_ext
