// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/commands/commands.h"

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <string>

#include "colmap_ext/commands/automatic_drawer.h"
#include "colmap_ext/verbs/align.h"
#include "colmap_ext/verbs/draw_sketch.h"
#include "colmap_ext/verbs/edit.h"
#include "colmap_ext/verbs/evaluate.h"
#include "colmap_ext/verbs/export_drawing.h"
#include "colmap_ext/verbs/extract_edges.h"
#include "colmap_ext/verbs/extract_truth.h"
#include "colmap_ext/verbs/find_faces.h"
#include "colmap_ext/verbs/fuse.h"
#include "colmap_ext/verbs/import_model.h"
#include "colmap_ext/verbs/link.h"
#include "colmap_ext/verbs/refine.h"
#include "colmap_ext/verbs/refine_cameras.h"
#include "colmap_ext/verbs/regularize.h"
#include "colmap_ext/verbs/renew_page.h"
#include "colmap_ext/verbs/sketch.h"
#include "colmap_ext/verbs/view.h"

namespace limn::colmap_ext {
namespace {

int RunOnProject(const Command& command, int argc, const char* const* argv,
                 const ConsoleMaker& make_console, Verb* verb) {
  RunOptions options;
  const auto parser = ParseRunOptions(command.name, command.heading, verb->Groups(), argc, argv,
                                      &options, [&](OptionParser* more) {
                                        verb->AddOptions(more);
                                        verb->AddFileOptions(more);
                                      });
  if (!parser) return 0;
  const auto console = make_console(options.num_threads, PrintingAt(options.log_level));
  SayRetired(*parser, console.get());
  verb->Prepare(&options, console.get());
  options.layout.starts_from = verb->StartsFrom(options);
  const Project project(options, console.get());
  verb->Run(project, options, console.get());
  if (verb->WritesDrawing()) RenewPage(project, options.layout.workspace_path, console.get());
  return 0;
}

// A verb on a project.
template <typename OneVerb>
int OnProject(const Command& command, int argc, const char* const* argv,
              const ConsoleMaker& make_console) {
  OneVerb verb;
  return RunOnProject(command, argc, argv, make_console, &verb);
}

template <typename OneVerb>
std::unique_ptr<DrawingVerb> Make() {
  return std::make_unique<OneVerb>();
}

// A verb on a drawing.
template <typename OneVerb>
constexpr Command OnDrawing(const char* name, const char* function, const char* summary,
                            const char* heading) {
  return {name, summary, heading, OnProject<OneVerb>, function, Make<OneVerb>};
}

// A verb on files, without a project.
template <typename Options, void (*kVerb)(const Options&, Console*)>
int OnFiles(const Command& command, int argc, const char* const* argv,
            const ConsoleMaker& make_console) {
  Options options;
  OptionParser parser(command.name, command.heading);
  options.AddOptions(&parser);
  if (parser.Parse(argc, argv) == OptionParser::Outcome::kHelp) {
    parser.WriteHelp(std::cout);
    return 0;
  }
  options.Check();
  int num_threads = -1;
  if constexpr (requires { options.num_threads; }) num_threads = options.num_threads;
  const auto console = make_console(num_threads, Printing::kStages);
  kVerb(options, console.get());
  return 0;
}

constexpr Command kCommands[] = {
    {.name = "automatic_drawer",
     .summary = "the main job: the 3D drawing of a COLMAP project",
     .heading = "make the 3D drawing of a COLMAP project",
     .run = RunAutomaticDrawer,
     .has_ranks = true},
    {"camera_refiner", "refine the cameras of a COLMAP model by the curves",
     "refine the cameras of a COLMAP model by the curves in its images",
     OnProject<RefineCamerasVerb>},
    {"edge_extractor", "find the edgels of all images",
     "find the edgels of all images, into the cache", OnProject<ExtractEdgesVerb>},
    {"curve_linker", "link them to curve fragments",
     "find the curve fragments of all images, into the cache", OnProject<LinkVerb>},
    {"curve_sketcher", "reconstruct a sketch: unconnected 3D curves",
     "reconstruct 3D curves: the curve sketch", OnProject<SketchVerb>},
    {"curve_drawer", "make the drawing from a stored sketch",
     "make the 3D drawing from the sketch that curve_sketcher has stored",
     OnProject<DrawSketchVerb>},
    OnDrawing<RefineVerb>("drawing_refiner", "refine", "fit a stored drawing to all images",
                          "fit the drawing that curve_drawer has stored to all images"),
    OnDrawing<RegularizeVerb>(
        "drawing_regularizer", "regularize", "make a stored drawing regular: right angles, planes",
        "make a stored drawing regular: parallel, at right angles, in planes"),
    OnDrawing<FindFacesVerb>("drawing_surfacer", "find_faces",
                             "find the faces between the curves of a drawing",
                             "find the faces that the curves of a stored drawing bound"),
    OnDrawing<EditVerb>("drawing_editor", "edit", "apply edits made by hand to a stored drawing",
                        "apply edits made by hand to a stored drawing, and fit what they touch"),
    OnDrawing<AlignVerb>("drawing_aligner", "align", "find up, axes and scale of a stored drawing",
                         "find up, horizontal axes and scale of a stored drawing"),
    OnDrawing<FuseVerb>("drawing_fuser", "fuse",
                        "compare a drawing with dense results and combine the two",
                        "compare a stored drawing with dense results and combine the two"),
    {"drawing_exporter", "write a drawing for CAD, Blender or as a graph",
     "write a drawing in the format of another program", OnFiles<ExporterOptions, RunExporter>},
    {"drawing_viewer", "make a page that shows a drawing in a browser",
     "make a page that shows a stored drawing in a browser", OnProject<ViewVerb>},
    {"model_importer", "make a COLMAP model from cameras in another format",
     "make a COLMAP model from cameras in another format", OnFiles<ImporterOptions, RunImporter>},
    {"drawing_evaluator", "compare curves with ground truth",
     "compare curves, points or faces with ground truth", OnFiles<EvaluatorOptions, RunEvaluator>},
    {"truth_extractor", "ground truth from a surface or a dense cloud",
     "ground truth from a surface or a dense cloud: what the images show of it",
     OnProject<ExtractTruthVerb>},
};

}  // namespace

std::span<const Command> Commands() { return kCommands; }

const Command* FindCommand(std::string_view name) {
  const auto found = std::ranges::find(kCommands, name, &Command::name);
  return found == std::end(kCommands) ? nullptr : found;
}

std::unique_ptr<DrawingVerb> MakeDrawingVerb(std::string_view function) {
  for (const Command& command : kCommands) {
    if (command.function && function == command.function) return command.make_verb();
  }
  throw std::out_of_range("no verb " + std::string(function));
}

}  // namespace limn::colmap_ext
