// SPDX-License-Identifier: BSD-3-Clause
#include "bench/methods.h"

#include <utility>

#include "colmap_ext/host/run_options.h"
#include "limn/drawing/drawing.h"
#include "limn/model/link_selection.h"
#include "limn/pipeline/pipeline.h"
#include "limn/primitives/fit_primitives.h"
#include "limn/util/errors.h"

namespace limn::bench {
namespace {

// A drawing with all its links.
DrawingGraph Draw(const Scene& scene, const CurveSketch& sketch, const PipelineOptions& options,
                  const RunContext& context) {
  const StageObserver unheard = [](const StageSummary&) {};
  const DrawingGraph drawing =
      BuildDrawing({{scene.views, scene.curves}, sketch}, options.drawing, context).graph;
  DrawingGraph judged =
      RefineAndJudge({{scene.views, scene.curves}, drawing}, options, context, unheard);
  // Kinds, which need the photographs, do not change the curves.
  return DescribeLinks(std::move(judged), scene.views, nullptr, options, context, unheard);
}

}  // namespace

const std::vector<Method>& Methods() {
  static const std::string paper_ini = LIMN_SCRIPTS_DIR "/paper.ini";
  static const std::vector<std::string> paper = {"--project_path", paper_ini};
  static const std::vector<std::string> inliers = {"Sketch.original_min_inliers_total"};
  static const std::vector<int> inlier_totals = {25, 50, 125, 250, 500};
  // The same number of views whatever the number that contains a sample, as in the paper.
  static const std::vector<std::string> supporting_views = {"Sketch.min_supporting_views",
                                                            "Drawing.min_supporting_views",
                                                            "Drawing.max_supporting_views"};
  static const std::vector<int> views = {3, 4, 6, 8, 12};
  static const std::vector<Method> methods = {
      {"original sketch", {"--mode", "original"}, false, "inliers", inliers, inlier_totals},
      {"enhanced sketch", paper, false, "views", supporting_views, views},
      {"paper drawing", paper, true, "views", supporting_views, views},
      {"swept sketch", {}, false, "views", supporting_views, views},
      {"default drawing", {}, true, "views", supporting_views, views},
  };
  return methods;
}

PipelineOptions OptionsOf(const Method& method, std::optional<int> threshold) {
  // The scene is there already; a command line must name a project.
  std::vector<std::string> arguments = {"automatic_drawer", "--workspace_path=."};
  arguments.insert(arguments.end(), method.arguments.begin(), method.arguments.end());
  for (const std::string& option : method.threshold_options) {
    if (threshold) arguments.push_back("--" + option + "=" + std::to_string(*threshold));
  }
  std::vector<const char*> words;
  for (const std::string& argument : arguments) words.push_back(argument.c_str());
  colmap_ext::OptionGroups groups;
  groups.linking = groups.sketch = groups.drawing = groups.refinement = true;
  colmap_ext::RunOptions options;
  ParseRunOptions(method.name, "", groups, static_cast<int>(words.size()), words.data(), &options);
  PipelineOptions of_curves;
  of_curves.edges = options.pipeline.edges;
  of_curves.linking = options.pipeline.linking;
  if (OptionsAsJson(of_curves) != OptionsAsJson(PipelineOptions())) {
    throw OptionError(method.name + ": the image curves are those of the default options");
  }
  return options.pipeline;
}

void Workbench::MakeSketch(const PipelineOptions& options) {
  PipelineOptions of_sketch;
  of_sketch.mode = options.mode;
  of_sketch.sketch = options.sketch;
  const std::string text = OptionsAsJson(of_sketch);
  if (text == options_text_) return;
  const Stopwatch stopwatch;
  sketch_ = BuildSketch(options.mode, {{scene_.views, scene_.curves, scene_.hints}}, options.sketch,
                        context_)
                .sketch;
  sketch_times_ = stopwatch.Elapsed();
  options_text_ = text;
}

Reconstruction Workbench::Run(const Method& method, std::optional<int> threshold) {
  const PipelineOptions options = OptionsOf(method, threshold);
  MakeSketch(options);
  if (!method.draws) {
    return {ToCurveSet(sketch_), ToSupportedCurves(sketch_), std::nullopt, std::nullopt,
            sketch_times_};
  }
  const Stopwatch stopwatch;
  const DrawingGraph drawn = Draw(scene_, sketch_, options, context_);
  const Times times = sketch_times_ + stopwatch.Elapsed();
  // What a user gets by default.
  DrawingGraph graph = Selected(drawn, LinkSelection::AsSeen());
  return {ToCurveSet(graph), ToSupportedCurves(graph), std::move(graph),
          Selected(drawn, LinkSelection()), times};
}

}  // namespace limn::bench
