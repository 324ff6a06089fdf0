// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/python/stages.h"

#include <iostream>
#include <span>
#include <sstream>
#include <utility>

#include <nlohmann/json.hpp>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/host/plugin.h"
#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/verbs/draw.h"
#include "colmap_ext/verbs/draw_sketch.h"
#include "colmap_ext/verbs/drawing_input.h"
#include "colmap_ext/verbs/evaluate.h"
#include "colmap_ext/verbs/export_drawing.h"
#include "colmap_ext/verbs/extract_edges.h"
#include "colmap_ext/verbs/image_places.h"
#include "colmap_ext/verbs/sketch.h"
#include "colmap_ext/verbs/trust.h"
#include "colmap_ext/workspace/refined_folder.h"
#include "limn/evaluation/report_writers.h"
#include "limn/formats/json_drawing_writer.h"
#include "limn/formats/write_drawing.h"
#include "limn/util/errors.h"
#include "limn/util/printable.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// Of an option that the results of earlier stages depend on; empty if there is none.
std::string ChangedOption(const RunOptions& before, const RunOptions& now,
                          std::span<const char* const> groups) {
  if (before.layout != now.layout) return "the paths";
  if (before.view != now.view) return "the images and their size";
  if (before.edges_path != now.edges_path) return "edges_path";
  if (OptionsAsText(before.edge_maps) != OptionsAsText(now.edge_maps)) return "EdgeMaps";
  const Json old_options = Json::parse(Provenance(before));
  const Json new_options = Json::parse(Provenance(now));
  for (const char* group : groups) {
    if (old_options.at(group) != new_options.at(group)) return group;
  }
  return "";
}

constexpr const char* kOptionsOfCurves[] = {"EdgeDetection", "Linking"};
constexpr const char* kOptionsOfSketch[] = {"EdgeDetection", "Linking",       "mode",
                                            "Sketch",        "ViewSelection", "box"};

// The options of a stage: those that its input was made with, and its own. `groups` are the
// stage's, `fixed` those that its input depends on, besides the scene's. `add_more` as in
// ParseRunOptions.
MadeWith AddOptions(const MadeWith& made, const std::string& stage, const OptionGroups& groups,
                    const OptionTexts& own, std::span<const char* const> fixed,
                    const std::function<void(OptionParser*)>& add_more = {}) {
  RefuseOptions(stage, own, {"output_path"});
  // Those of other stages are unknown to it.
  ParseTexts(stage, groups, Merged({{"workspace_path", "."}}, own), add_more);
  MadeWith added;
  added.given = Merged(made.given, own);
  added.options = ParseTexts(stage, OptionsOfAllStages(), added.given, add_more);
  const std::string changed = ChangedOption(made.options, added.options, fixed);
  if (changed.empty()) return added;
  throw OptionError(stage + ": its input was made with another value of " + changed +
                    ": give it to the function that made that");
}

// In place of the path of a drawing.
constexpr const char* kDrawingInMemory = "drawing.json";

// The work on a scene in memory: nothing is kept.
class MemoryJob {
 public:
  MemoryJob(const Scene& scene, const RunOptions& options, Console* console)
      : job_{scene, options, console, &no_cache_} {}
  ~MemoryJob() { job_.scene.images().release(); }
  MemoryJob(const MemoryJob&) = delete;
  MemoryJob& operator=(const MemoryJob&) = delete;

  operator const Job&() const { return job_; }

 private:
  ResultCache no_cache_{""};
  Job job_;
};

DrawingInScene ToScene(const SceneDrawing& drawing) {
  return {Moved(drawing.graph, -drawing.scene->scene.origin()), drawing.metadata, drawing.views,
          drawing.curves};
}

std::shared_ptr<SceneDrawing> FromScene(DrawingInScene made, std::shared_ptr<const OpenScene> scene,
                                        MadeWith with, const Console& console) {
  auto drawing = std::make_shared<SceneDrawing>();
  drawing->graph = Moved(std::move(made.graph), scene->scene.origin());
  drawing->metadata = std::move(made.metadata);
  drawing->made = std::move(with);
  drawing->made.log = console.log();
  drawing->scene = std::move(scene);
  drawing->views = std::move(made.views);
  drawing->curves = std::move(made.curves);
  return drawing;
}

// Those that make sense in memory, on top of what the drawing was made with.
OptionGroups GroupsInMemory(const Verb& verb) {
  OptionGroups groups = verb.Groups();
  groups.linking = groups.overwrites = false;
  return groups;
}

void RefuseFileOptions(const std::string& function, Verb* verb, const OptionTexts& options) {
  OptionParser of_files(function, "");
  verb->AddFileOptions(&of_files);
  for (const auto& [name, text] : options) {
    if (of_files.Knows(name)) RefuseOptions(function, options, {name.c_str()});
  }
}

// Keeps the log of a command.
class CommandConsole : public LibraryConsole {
 public:
  CommandConsole(int num_threads, RunMonitor* monitor, RunLog* kept)
      : LibraryConsole(num_threads, monitor), kept_(kept) {}
  ~CommandConsole() override { *kept_ = log(); }

 private:
  RunLog* kept_;
};

// The scene with the refined cameras that a stored drawing fits, if it does.
std::shared_ptr<const OpenScene> SceneOfDrawing(const fs::path& drawing,
                                                std::shared_ptr<const OpenScene> scene,
                                                RunMonitor* monitor) {
  WorkspaceLayout layout = scene->scene.layout();
  const bool is_in_memory = layout.model_dir.empty();
  if (is_in_memory || !TakeRefinedCameras(drawing, &layout)) return scene;
  LibraryConsole console(scene->made.options.num_threads, monitor);
  return std::make_shared<OpenScene>(layout, scene->made, &console);
}

// Those of the options of automatic_drawer that OpenWorkspace takes.
OptionTexts OptionsOfScene(const OptionTexts& options) {
  const CommandLine line("open", {{"workspace_path", "."}});
  RunOptions ignored;
  const auto parser =
      ParseRunOptions("open", "", OptionsOfAllStages(), line.argc(), line.argv(), &ignored);
  OptionTexts of_scene;
  for (const auto& [name, text] : options) {
    if (parser->Knows(name)) of_scene[name] = text;
  }
  of_scene.erase("output_path");
  return of_scene;
}

}  // namespace

OptionGroups OptionsOfAllStages() {
  return {.linking = true,
          .sketch = true,
          .drawing = true,
          .refinement = true,
          .surfaces = true,
          .dense = true,
          .tiles = true,
          .output_cameras = true};
}

OpenScene::OpenScene(SparseModel model, const std::filesystem::path& image_dir,
                     const PhotoStore& photos, MadeWith with, Console* console)
    : scene(std::move(model), image_dir, photos, with.options, console), made(std::move(with)) {
  made.log = console->log();
}

OpenScene::OpenScene(const WorkspaceLayout& layout, MadeWith with, Console* console)
    : scene(layout, with.options, console), made(std::move(with)) {
  made.log = console->log();
}

std::shared_ptr<OpenScene> OpenWorkspace(const OptionTexts& options, RunMonitor* monitor) {
  RefuseOptions("open", options, {"output_path"});
  const RunOptions run = ParseTexts("open", OptionsOfAllStages(), options);
  LibraryConsole console(run.num_threads, monitor);
  return std::make_shared<OpenScene>(ResolveLayout(run.layout), MadeWith{options, run, {}},
                                     &console);
}

std::shared_ptr<SceneEdges> ExtractSceneEdges(std::shared_ptr<const OpenScene> scene,
                                              const OptionTexts& options, RunMonitor* monitor) {
  auto edges = std::make_shared<SceneEdges>();
  edges->made = AddOptions(scene->made, "extract_edges", {}, options, {});
  const RunOptions& run = edges->made.options;
  LibraryConsole console(run.num_threads, monitor);
  edges->edge_maps = FindEdgeMaps(MemoryJob(scene->scene, run, &console));
  for (EdgeMap& map : edges->edge_maps) ApplyLens(nullptr, &map);  // they stay in stored pixels
  edges->scene = std::move(scene);
  edges->made.log = console.log();
  return edges;
}

std::shared_ptr<SceneCurves> LinkScene(std::shared_ptr<const OpenScene> scene,
                                       const OptionTexts& options, RunMonitor* monitor) {
  auto curves = std::make_shared<SceneCurves>();
  curves->made = AddOptions(scene->made, "link", {.linking = true}, options, {});
  LibraryConsole console(curves->made.options.num_threads, monitor);
  curves->curves = SharedImageCurves(MemoryJob(scene->scene, curves->made.options, &console));
  curves->scene = std::move(scene);
  curves->made.log = console.log();
  return curves;
}

std::shared_ptr<SceneSketch> SketchScene(std::shared_ptr<const SceneCurves> curves,
                                         const OptionTexts& options, RunMonitor* monitor) {
  auto sketch = std::make_shared<SceneSketch>();
  sketch->made = AddOptions(curves->made, "sketch", {.sketch = true}, options, kOptionsOfCurves);
  const RunOptions& run = sketch->made.options;
  LibraryConsole console(run.num_threads, monitor);
  const Scene& scene = curves->scene->scene;
  CheckSceneViews(scene);
  sketch->sketch = std::make_shared<const CurveSketch>(
      MakeSketch(MemoryJob(scene, run, &console), *curves->curves));
  sketch->in_model =
      scene.origin().isZero()
          ? sketch->sketch
          : std::make_shared<const CurveSketch>(Moved(*sketch->sketch, scene.origin()));
  sketch->curves = std::move(curves);
  sketch->made.log = console.log();
  return sketch;
}

std::shared_ptr<SceneDrawing> DrawSketch(std::shared_ptr<const SceneSketch> sketch,
                                         const OptionTexts& options, RunMonitor* monitor) {
  MadeWith made = AddOptions(sketch->made, "draw", {.drawing = true}, options, kOptionsOfSketch);
  LibraryConsole console(made.options.num_threads, monitor);
  const SceneCurves& curves = *sketch->curves;
  DrawingInScene drawing = DrawSketchInScene(
      MemoryJob(curves.scene->scene, made.options, &console), curves.curves, *sketch->sketch,
      ProvenanceOfDrawing(made.options, Provenance(sketch->made.options)));
  return FromScene(std::move(drawing), curves.scene, std::move(made), console);
}

std::shared_ptr<SceneDrawing> DrawOpenScene(std::shared_ptr<const OpenScene> scene,
                                            const OptionTexts& options, RunMonitor* monitor) {
  MadeWith made = AddOptions(scene->made, "draw",
                             {.linking = true,
                              .sketch = true,
                              .drawing = true,
                              .refinement = true,
                              .tiles = true,
                              .output_cameras = true},
                             options, {});
  DrawerOptions drawer;
  // The scene keeps its cameras.
  PipelineOptions& pipeline = made.options.pipeline;
  if (pipeline.refine_cameras == CameraRefinement::kAuto &&
      pipeline.output_cameras == OutputCameras::kRefined) {
    pipeline.refine_cameras = CameraRefinement::kOff;
  }
  drawer.run = made.options;
  LibraryConsole console(made.options.num_threads, monitor);
  CheckSceneViews(scene->scene);
  auto drawn = DrawInMemory(MemoryJob(scene->scene, made.options, &console), drawer);
  DrawingInScene& drawing = drawn->drawing;
  ReportTrust(scene->scene.view_set(), drawing, &console);
  return FromScene(std::move(drawing), scene, std::move(made), console);
}

std::shared_ptr<SceneDrawing> ApplyVerb(const std::string& function,
                                        std::shared_ptr<const SceneDrawing> drawing,
                                        const OptionTexts& options, RunMonitor* monitor) {
  if (!drawing->scene) {
    throw InputError(function +
                     ": the drawing was read without its workspace: read_drawing(path, scene)");
  }
  const auto verb = MakeDrawingVerb(function);
  RefuseFileOptions(function, verb.get(), options);
  MadeWith made = AddOptions(drawing->made, function, GroupsInMemory(*verb), options,
                             kOptionsOfSketch, [&](OptionParser* more) { verb->AddOptions(more); });
  LibraryConsole console(made.options.num_threads, monitor);
  verb->Prepare(&made.options, &console);
  const MemoryJob job(drawing->scene->scene, made.options, &console);
  const DrawingInScene given = ToScene(*drawing);
  DrawingInScene result = verb->Apply(job, given);
  result.metadata.options_json = verb->Provenance(made.options, given.metadata.options_json);
  verb->Conclude(job, given, result);
  auto applied = FromScene(std::move(result), drawing->scene,
                           verb->HasOwnOptions() ? drawing->made : std::move(made), console);
  if (verb->KeepsGraph()) applied->graph = drawing->graph;  // not moved there and back
  return applied;
}

std::shared_ptr<SceneDrawing> ReadSceneDrawing(const fs::path& path,
                                               std::shared_ptr<const OpenScene> scene,
                                               RunMonitor* monitor) {
  auto drawing = std::make_shared<SceneDrawing>();
  DrawingFile file =
      scene ? ReadDrawingOf(scene->scene, path.string()) : ReadDrawing(path.string());
  drawing->graph = std::move(file.graph);
  drawing->metadata = std::move(file.metadata);
  if (!scene) return drawing;
  scene = SceneOfDrawing(path, std::move(scene), monitor);
  drawing->made = scene->made;
  drawing->made.log = {};
  drawing->views = scene->scene.views();
  drawing->scene = std::move(scene);
  return drawing;
}

std::string EvaluateAsJson(std::shared_ptr<const SceneDrawing> drawing, const OptionTexts& options,
                           RunMonitor* monitor) {
  if (drawing) RefuseOptions("evaluate", options, {"input_path"});
  if (drawing && drawing->scene) {
    RefuseOptions("evaluate", options, {"workspace_path", "image_path", "model_index"});
  }
  EvaluatorOptions evaluator;
  OptionParser parser("evaluate", "");
  evaluator.AddOptions(&parser);
  const CommandLine line("evaluate", options);
  parser.Parse(line.argc(), line.argv());
  if (drawing) {
    evaluator.input_path = kDrawingInMemory;
    evaluator.alignment = drawing->metadata.alignment;
  }
  if (drawing && drawing->scene) {
    const Scene& scene = drawing->scene->scene;
    evaluator.views = InImagePixels(Moved(drawing->views, scene.origin()));
  }
  evaluator.Check();
  LibraryConsole console(evaluator.num_threads, monitor);
  const EvaluationReport report =
      EvaluateAndWrite(drawing ? &drawing->graph : nullptr, evaluator, &console);
  std::ostringstream json;
  WriteReportJson(report, json);
  return json.str();
}

void ExportDrawing(std::shared_ptr<const SceneDrawing> drawing, const OptionTexts& options,
                   RunMonitor* monitor) {
  if (drawing) RefuseOptions("export", options, {"input_path"});
  ExporterOptions exporter;
  OptionParser parser("export", "");
  exporter.AddOptions(&parser);
  const CommandLine line("export", options);
  parser.Parse(line.argc(), line.argv());
  if (drawing) exporter.input_path = kDrawingInMemory;
  exporter.Check();
  LibraryConsole console(/*num_threads=*/-1, monitor);
  if (drawing) {
    if (exporter.aligned && !drawing->metadata.alignment) {
      throw InputError("export: aligned: the drawing has no alignment: limn.align(drawing)");
    }
    limn::colmap_ext::ExportDrawing({drawing->graph, drawing->metadata}, exporter, &console);
  } else {
    limn::colmap_ext::ExportDrawing(exporter, &console);
  }
}

SceneLength MeasureLength(const SceneDrawing& drawing, const std::string& text) {
  auto span = ParseSpan(text);
  if (!span) {
    throw OptionError("measure: " + Printable(text) +
                      ": must be like \"link 12\", \"from 3 to 7\" or \"a.jpg 120,340 to b.jpg "
                      "500,220\"");
  }
  if (!span->pixels.empty()) {
    if (!drawing.scene) {
      throw InputError("measure: pixels need the scene: limn.read_drawing(path, workspace)");
    }
    const Scene& scene = drawing.scene->scene;
    const std::vector<View> stored =
        InStoredImages(scene.view_set(), Moved(drawing.views, scene.origin()));
    span->places = PlacesOf(span->pixels, scene.view_set(), stored, drawing.graph);
  }
  const Alignment alignment = drawing.metadata.alignment.value_or(Alignment());
  return {InWorld(MeasureSpan(drawing.graph, *span), alignment), alignment.Unit()};
}

void SaveDrawing(const SceneDrawing& drawing, const std::string& path) {
  const std::string name = DrawingFormatOf(path, {});
  DrawingFormatOptions format;
  if (name == "step") format.write_step = LoadStepWriter();
  WriteDrawing(path, name == "json" ? drawing.graph : Selected(drawing.graph, {}), drawing.metadata,
               format);
}

std::string DrawingAsJson(const SceneDrawing& drawing) {
  std::ostringstream text;
  WriteDrawingJson(drawing.graph, drawing.metadata, text);
  return text.str();
}

std::shared_ptr<SceneDrawing> DrawingFromJson(const std::string& text) {
  auto drawing = std::make_shared<SceneDrawing>();
  DrawingFile file = ParseDrawingJson("pickled drawing", text);
  drawing->graph = std::move(file.graph);
  drawing->metadata = std::move(file.metadata);
  return drawing;
}

OptionTexts OptionsOfFolder(const OpenScene& scene) {
  const WorkspaceLayout& layout = scene.scene.layout();
  if (layout.model_dir.empty()) {
    throw InputError("a Scene in memory cannot be pickled: pickle the arrays it was made from");
  }
  return Merged(scene.made.given, {{"image_path", layout.image_dir.string()},
                                   {"input_path", layout.model_dir.string()}});
}

RunLog RunCommand(const std::string& command, const OptionTexts& options, RunMonitor* monitor) {
  const Command* found = FindCommand(command);
  if (!found) throw OptionError("unknown command '" + command + "'");
  const CommandLine line(command, options);
  RunLog log;
  found->Run(line.argc(), line.argv(), [monitor, &log](int num_threads, Printing) {
    return std::make_unique<CommandConsole>(num_threads, monitor, &log);
  });
  return log;
}

std::shared_ptr<OpenScene> RefineCamerasInFolder(const OptionTexts& options, RunMonitor* monitor) {
  RunCommand("camera_refiner", options, monitor);
  OptionTexts of_scene = OptionsOfScene(options);
  const CommandLine line("open", of_scene);
  RunOptions given;
  ParseRunOptions("open", "", OptionsOfAllStages(), line.argc(), line.argv(), &given);
  of_scene["image_path"] = ResolveLayout(given.layout).image_dir.string();
  of_scene["input_path"] = (fs::path(options.at("output_path")) / kRefinedFolder).string();
  return OpenWorkspace(of_scene, monitor);
}

std::shared_ptr<SceneDrawing> DrawInFolder(const OptionTexts& options, RunMonitor* monitor) {
  for (const char* name : {"project_path", "shard"}) {
    if (options.contains(name)) {
      throw OptionError(std::string(name) + ": not with output_path, but with run()");
    }
  }
  const OptionTexts of_scene = OptionsOfScene(options);
  RunLog log = RunCommand("automatic_drawer", options, monitor);
  const fs::path folder = options.at("output_path");
  auto drawing =
      ReadSceneDrawing(folder / "drawing.json", OpenWorkspace(of_scene, monitor), monitor);
  drawing->made.log = std::move(log);
  return drawing;
}

}  // namespace limn::colmap_ext
