#include "colmap_ext/python/stages.h"

#include <iostream>
#include <span>
#include <sstream>
#include <utility>

#include <nlohmann/json.hpp>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/verbs/align.h"
#include "colmap_ext/verbs/draw_options.h"
#include "colmap_ext/verbs/draw_scene.h"
#include "colmap_ext/verbs/drawing_input.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "colmap_ext/verbs/edit.h"
#include "colmap_ext/verbs/evaluate.h"
#include "colmap_ext/verbs/export_drawing.h"
#include "colmap_ext/verbs/fuse.h"
#include "colmap_ext/verbs/trust.h"
#include "limn/evaluation/report_writers.h"
#include "limn/formats/write_drawing.h"
#include "limn/pipeline/refit_edited.h"
#include "limn/pipeline/sketch_views.h"
#include "limn/surfaces/find_faces.h"
#include "limn/util/errors.h"

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

StageObserver ReportTo(Console* console) {
  return [console](const StageSummary& summary) { console->Report(summary); };
}

// With what goes with all drawings of a scene.
std::shared_ptr<SceneDrawing> MakeDrawing(std::shared_ptr<const OpenScene> scene, MadeWith made,
                                          const DrawingGraph& graph,
                                          const std::optional<RefinedCameras>& cameras,
                                          const std::string& provenance) {
  CheckGraph(graph);
  auto drawing = std::make_shared<SceneDrawing>();
  drawing->graph = Moved(graph, scene->scene.origin());
  drawing->metadata = Metadata(scene->scene, provenance);
  drawing->made = std::move(made);
  drawing->views = cameras ? cameras->views : scene->scene.views();
  drawing->scene = std::move(scene);
  return drawing;
}

// Relative to the scene's origin.
DrawingGraph GraphInScene(const SceneDrawing& drawing) {
  return Moved(drawing.graph, -drawing.scene->scene.origin());
}

void RequireScene(const SceneDrawing& drawing, const char* function) {
  if (drawing.scene) return;
  throw InputError(std::string(function) +
                   ": the drawing was read without its workspace: read_drawing(path, scene)");
}

std::shared_ptr<const std::vector<ImageCurves>> CurvesOf(std::shared_ptr<const OpenScene> scene,
                                                         const RunOptions& options,
                                                         Console* console) {
  ResultCache no_cache("");
  const Scene& read = scene->scene;
  CurvesResult result =
      ExtractCurves({read.views(), read.images(), &no_cache}, options.pipeline.edges,
                    options.pipeline.linking, console->context());
  console->Report(result.summary);
  return std::make_shared<const std::vector<ImageCurves>>(std::move(result.curves));
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
          .tiles = true};
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
  ResultCache no_cache("");
  EdgeMapsResult result = ExtractEdgeMaps({scene->scene.views(), scene->scene.images(), &no_cache},
                                          run.pipeline.edges, console.context());
  console.Report(result.summary);
  edges->edge_maps = std::move(result.edge_maps);
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
  curves->curves = CurvesOf(scene, curves->made.options, &console);
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
  ResultCache no_cache("");
  SketchResult result =
      SketchViews(run.pipeline.mode,
                  {{scene.views(), *curves->curves, scene.view_set().hints, SceneBox(scene, run)}},
                  run.pipeline.sketch, &no_cache, console.context());
  console.Report(result.summary);
  sketch->sketch = std::make_shared<const CurveSketch>(std::move(result.sketch));
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
  const RunOptions run = made.options;
  LibraryConsole console(run.num_threads, monitor);
  const SceneCurves& curves = *sketch->curves;
  const Scene& scene = curves.scene->scene;
  const DrawingResult result = limn::DrawSketch(
      {{scene.views(), *curves.curves, scene.view_set().hints, SceneBox(scene, run)},
       *sketch->sketch},
      run.pipeline, console.context());
  console.Report(result.summary);
  auto drawing = MakeDrawing(curves.scene, std::move(made), result.graph, std::nullopt,
                             DrawingProvenance(run, Provenance(sketch->made.options)));
  drawing->curves = curves.curves;
  drawing->made.log = console.log();
  return drawing;
}

std::shared_ptr<SceneDrawing> DrawOpenScene(std::shared_ptr<const OpenScene> scene,
                                            const OptionTexts& options, RunMonitor* monitor) {
  MadeWith made = AddOptions(
      scene->made, "draw",
      {.linking = true, .sketch = true, .drawing = true, .refinement = true, .tiles = true},
      options, {});
  DrawerOptions drawer;
  drawer.run = made.options;
  const RunOptions& run = drawer.run;
  LibraryConsole console(run.num_threads, monitor);
  const Scene& read = scene->scene;
  CheckSceneViews(read);
  ResultCache no_cache("");
  const PipelineInput input{read.views(), read.view_set().hints, read.images(), SceneBox(read, run),
                            &no_cache};
  const std::vector<Tile> tiles = PlanSceneTiles(input, drawer, &console);
  PipelineResult result = *DrawSceneOrTiles(input, tiles, run.pipeline, &console);
  auto drawing = MakeDrawing(scene, std::move(made), result.graph, result.cameras, Provenance(run));
  SayTrust(MeasureTrust(read.view_set(), drawing->views, result.curves, result.graph),
           !run.box.empty(), &console);
  if (!IsInTiles(tiles, input.views)) {
    drawing->curves = std::make_shared<const std::vector<ImageCurves>>(std::move(result.curves));
  }
  drawing->made.log = console.log();
  return drawing;
}

std::shared_ptr<SceneDrawing> RefineSceneDrawing(std::shared_ptr<const SceneDrawing> drawing,
                                                 const OptionTexts& options, RunMonitor* monitor) {
  RequireScene(*drawing, "refine");
  MadeWith made =
      AddOptions(drawing->made, "refine", {.refinement = true}, options, kOptionsOfSketch);
  const RunOptions run = made.options;
  LibraryConsole console(run.num_threads, monitor);
  const Scene& scene = drawing->scene->scene;
  const auto curves = drawing->curves ? drawing->curves : CurvesOf(drawing->scene, run, &console);
  JudgedDrawing judged =
      RefineAndJudge({{drawing->views, *curves, scene.view_set().hints}, GraphInScene(*drawing)},
                     run.pipeline, console.context(), ReportTo(&console));
  const std::vector<View>& views = judged.cameras ? judged.cameras->views : drawing->views;
  const DrawingGraph graph = DescribeLinks(std::move(judged.graph), views, scene.images().read,
                                           run.pipeline, console.context(), ReportTo(&console));
  scene.images().release();
  const std::string provenance = RefinementProvenance(run, drawing->metadata.options_json);
  auto refined = MakeDrawing(drawing->scene, std::move(made), graph, judged.cameras, provenance);
  SayTrust(MeasureTrust(scene.view_set(), refined->views, *curves, graph), HasBox(provenance),
           &console);
  SayDroppedFaces(drawing->graph, graph, &console);
  refined->metadata.alignment = drawing->metadata.alignment;
  refined->curves = curves;
  refined->made.log = console.log();
  return refined;
}

std::shared_ptr<SceneDrawing> RegularizeSceneDrawing(std::shared_ptr<const SceneDrawing> drawing,
                                                     const OptionTexts& options,
                                                     RunMonitor* monitor) {
  RequireScene(*drawing, "regularize");
  auto regular = std::make_shared<SceneDrawing>(*drawing);
  regular->made =
      AddOptions(drawing->made, "regularize", {.regularities = true}, options, kOptionsOfSketch);
  const RunOptions& run = regular->made.options;
  LibraryConsole console(run.num_threads, monitor);
  const RegularityResult result =
      Regularize(GraphInScene(*drawing), drawing->views, run.pipeline.regularity,
                 run.pipeline.primitives, console.context());
  console.Report(result.summary);
  CheckGraph(result.graph);
  SayRegularities(result.graph, result.moves, &console);
  SayDroppedFaces(drawing->graph, result.graph, &console);
  regular->graph = Moved(result.graph, drawing->scene->scene.origin());
  regular->metadata.options_json = RegularityProvenance(run, drawing->metadata.options_json);
  regular->made.log = console.log();
  return regular;
}

std::shared_ptr<SceneDrawing> FindSceneFaces(std::shared_ptr<const SceneDrawing> drawing,
                                             const OptionTexts& options, RunMonitor* monitor) {
  RequireScene(*drawing, "find_faces");
  auto faced = std::make_shared<SceneDrawing>(*drawing);
  faced->made =
      AddOptions(drawing->made, "find_faces", {.surfaces = true}, options, kOptionsOfSketch);
  const RunOptions& run = faced->made.options;
  LibraryConsole console(run.num_threads, monitor);
  const Scene& scene = drawing->scene->scene;
  if (!faced->curves) faced->curves = CurvesOf(drawing->scene, run, &console);
  const SurfaceResult result = FindFaces({drawing->views, *faced->curves, scene.view_set().hints},
                                         run.pipeline.refinement.Gate(), GraphInScene(*drawing),
                                         run.pipeline.surfaces, console.context());
  console.Report(result.summary);
  SayLinksBehind(result.links_behind, &console);
  CheckGraph(result.graph);
  faced->graph = Moved(result.graph, scene.origin());
  faced->metadata.options_json = SurfaceProvenance(run, drawing->metadata.options_json);
  faced->made.log = console.log();
  return faced;
}

std::shared_ptr<SceneDrawing> EditSceneDrawing(std::shared_ptr<const SceneDrawing> drawing,
                                               const OptionTexts& options, RunMonitor* monitor) {
  RequireScene(*drawing, "edit");
  RefuseOptions("edit", options, {"drawing_path"});
  std::string edits_path;
  const MadeWith added =
      AddOptions(drawing->made, "edit", {.refit = true}, options, kOptionsOfSketch,
                 [&](OptionParser* more) { more->AddOption("edits", &edits_path, "edits.json"); });
  const RunOptions& run = added.options;
  CheckEditorOptions(run);
  const EditsFile file = ReadEdits(edits_path);
  LibraryConsole console(run.num_threads, monitor);
  const Scene& scene = drawing->scene->scene;
  EditedDrawing result =
      ApplyEdits(GraphInScene(*drawing), drawing->views, Moved(file.edits, -scene.origin()),
                 run.pipeline.drawing.topology);
  // Options of the edits are of no use to later stages.
  auto edited = std::make_shared<SceneDrawing>(*drawing);
  if (HasTouched(result)) {
    if (!edited->curves) edited->curves = CurvesOf(drawing->scene, run, &console);
    console.Report(RefitEdited({drawing->views, *edited->curves}, scene.images().read, run.pipeline,
                               console.context(), &result));
    scene.images().release();
  }
  SayEdits(file.edits, result, &console);
  CheckGraph(result.graph);
  edited->graph = Moved(result.graph, scene.origin());
  edited->metadata.options_json = EditProvenance(file, drawing->metadata.options_json);
  edited->made.log = console.log();
  return edited;
}

std::shared_ptr<SceneDrawing> FuseSceneDrawing(std::shared_ptr<const SceneDrawing> drawing,
                                               const OptionTexts& options, RunMonitor* monitor) {
  RequireScene(*drawing, "fuse");
  if (drawing->scene->scene.layout().model_dir.empty()) {
    throw InputError("fuse: dense results belong to a project, not to a scene in memory");
  }
  // What names the drawing, and of the files that drawing_fuser writes.
  RefuseOptions("fuse", options, {"drawing_path", "sparse_spacing_px"});
  FuserOptions fuser;
  const MadeWith added =
      AddOptions(drawing->made, "fuse", {.dense = true}, options, kOptionsOfSketch,
                 [&](OptionParser* more) { fuser.AddOptions(more); });
  fuser.Check();
  const RunOptions& run = added.options;
  LibraryConsole console(run.num_threads, monitor);
  const Scene& scene = drawing->scene->scene;
  const DenseInput dense = OpenDenseInput(scene, fuser, run.layout.workspace_path, &console);
  const FusionResult result =
      FuseDrawing({scene.views(), GraphInScene(*drawing), dense.depths,
                   dense.cloud ? std::optional(dense.points) : std::nullopt},
                  run.dense, console.context());
  console.Report(result.summary);
  // Options of the fusion are of no use to later stages.
  auto fused = std::make_shared<SceneDrawing>(*drawing);
  fused->graph =
      Moved(fuser.remove_occluded ? WithoutOccluded(result.graph) : result.graph, scene.origin());
  fused->metadata.options_json = FusionProvenance(run, fuser, drawing->metadata.options_json);
  fused->made.log = console.log();
  return fused;
}

std::shared_ptr<SceneDrawing> AlignSceneDrawing(std::shared_ptr<const SceneDrawing> drawing,
                                                const OptionTexts& options, RunMonitor* monitor) {
  RequireScene(*drawing, "align");
  AlignOptions align;
  OptionParser parser("align", "");
  align.AddOptions(/*of_drawing=*/true, &parser);
  const CommandLine line("align", options);
  parser.Parse(line.argc(), line.argv(), std::cout);
  align.Check();
  LibraryConsole console(drawing->made.options.num_threads, monitor);
  const Scene& scene = drawing->scene->scene;
  // What the options of a scene in memory name is no project.
  const bool is_project = !scene.layout().model_dir.empty();
  const SceneAligner aligner(scene, is_project ? drawing->made.options.layout : LayoutOptions(),
                             align, &console);
  auto aligned = std::make_shared<SceneDrawing>(*drawing);
  aligned->metadata.alignment = aligner.Align(drawing->views, GraphInScene(*drawing), &console);
  aligned->made.log = console.log();
  return aligned;
}

std::shared_ptr<SceneDrawing> ReadSceneDrawing(const fs::path& path,
                                               std::shared_ptr<const OpenScene> scene) {
  auto drawing = std::make_shared<SceneDrawing>();
  DrawingFile file =
      scene ? ReadDrawingOf(scene->scene, path.string()) : ReadDrawing(path.string());
  drawing->graph = std::move(file.graph);
  drawing->metadata = std::move(file.metadata);
  if (!scene) return drawing;
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
  parser.Parse(line.argc(), line.argv(), std::cout);
  if (drawing) evaluator.input_path = kDrawingInMemory;
  if (drawing && drawing->scene) {
    evaluator.views = Moved(drawing->views, drawing->scene->scene.origin());
  }
  evaluator.Check();
  const LibraryConsole console(evaluator.num_threads, monitor);
  const EvaluationReport report =
      drawing ? EvaluateDrawing(drawing->graph, evaluator, console.context())
              : EvaluateFile(evaluator, console.context());
  ThrowIfCancelled(console.context());
  WriteReportFiles(report, evaluator);
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
  parser.Parse(line.argc(), line.argv(), std::cout);
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

void SaveDrawing(const SceneDrawing& drawing, const std::string& path) {
  const bool is_whole = DrawingFormatOf(path, {}) == "json";
  WriteDrawing(path, is_whole ? drawing.graph : Selected(drawing.graph, {}), drawing.metadata);
}

RunLog RunCommand(const std::string& command, const OptionTexts& options, RunMonitor* monitor) {
  const Command* found = FindCommand(command);
  if (!found) throw OptionError("unknown command '" + command + "'");
  const CommandLine line(command, options);
  RunLog log;
  found->run(line.argc(), line.argv(), [monitor, &log](int num_threads, bool) {
    return std::make_unique<CommandConsole>(num_threads, monitor, &log);
  });
  return log;
}

std::shared_ptr<SceneDrawing> DrawInFolder(const OptionTexts& options, RunMonitor* monitor) {
  for (const char* name : {"project_path", "shard"}) {
    if (options.contains(name)) {
      throw OptionError(std::string(name) + ": not with output_path, but with run()");
    }
  }
  const OptionTexts of_scene = OptionsOfScene(options);
  const bool moves_cameras =
      ParseTexts("draw", OptionsOfAllStages(), of_scene).pipeline.refinement.refine_poses;
  RunLog log = RunCommand("automatic_drawer", options, monitor);
  const fs::path folder = options.at("output_path");
  auto drawing = ReadSceneDrawing(folder / "drawing.json",
                                  moves_cameras ? nullptr : OpenWorkspace(of_scene, monitor));
  drawing->made.log = std::move(log);
  return drawing;
}

}  // namespace limn::colmap_ext
