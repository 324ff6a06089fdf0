// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/draw.h"

#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "colmap_ext/host/provenance.h"
#include "colmap_ext/host/ranks.h"
#include "colmap_ext/host/run_needs.h"
#include "colmap_ext/verbs/align.h"
#include "colmap_ext/verbs/draw_shards.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "colmap_ext/verbs/refined_cameras.h"
#include "colmap_ext/verbs/renew_page.h"
#include "colmap_ext/verbs/run_report.h"
#include "colmap_ext/verbs/trust.h"
#include "limn/pipeline/tiled_scene.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

// By all ranks together; only rank 0 gets a result.
std::optional<PipelineResult> DrawByRanks(const PipelineInput& input, const Job& job) {
  const PipelineOptions& options = job.options.pipeline;
  RankTeam team;
  RunContext context = job.context();
  context.team = &team;
  if (Rank() != 0) {
    DrawUnrefined(input, options, context, job.reporter());
    return std::nullopt;
  }
  PipelineResult result = DrawScene(input, options, context, job.reporter());
  job.console->Say("For the drawing the processes sent each other " +
                   std::to_string(team.bytes_exchanged() >> 20) + " MB");
  return result;
}

// PlanTiles. Throws OptionError if there are several tiles and an option needs the whole scene at
// once.
std::vector<Tile> PlanSceneTiles(const PipelineInput& input, const DrawerOptions& options,
                                 Console* console) {
  std::vector<Tile> tiles =
      PlanTiles(input.views, input.hints, input.box, options.run.pipeline.tiles);
  if (!IsInTiles(tiles, input.views)) return tiles;
  const std::string in_tiles = "the scene is drawn in " + std::to_string(tiles.size()) + " tiles";
  if (options.account) throw OptionError("account = 1: " + in_tiles + ", which keep no account");
  console->Say("Views are many: " + in_tiles + ", and there will be no file of its sketch");
  return tiles;
}

std::optional<PipelineResult> DrawSceneOrTiles(const PipelineInput& input,
                                               const std::vector<Tile>& tiles, const Job& job) {
  const PipelineOptions& options = job.options.pipeline;
  const bool leads = Rank() == 0;
  if (NumRanks() > 1) {
    if (leads) TellOtherRanks(RankOrder::kWork);
    FillCacheByRanks(input, tiles, options, job.console);
  }
  if (IsInTiles(tiles, input.views)) {
    if (!leads) return std::nullopt;
    PipelineResult result;
    result.graph = DrawProjectTiles(input, tiles, options, job.console);
    return result;
  }
  if (NumRanks() > 1) return DrawByRanks(input, job);
  return DrawScene(input, options, job.context(), job.reporter());
}

DrawnScene ToDrawnScene(PipelineResult result, const Job& job, bool is_in_tiles) {
  DrawnScene drawn;
  DrawingInScene& drawing = drawn.drawing;
  drawing.graph = std::move(result.graph);
  drawing.metadata = Metadata(job.scene, Provenance(job.options));
  if (!is_in_tiles) {
    drawn.curves_of_sketch =
        std::make_shared<const std::vector<ImageCurves>>(std::move(result.curves));
    drawing.curves = drawn.curves_of_sketch;
  }
  drawn.sketch = std::move(result.sketch);
  drawn.sketch_fates = std::move(result.sketch_fates);
  drawn.sample_fates = std::move(result.sample_fates);
  drawn.new_views = std::move(result.new_views);
  drawn.keep = std::move(result.keep);
  drawing.views = result.cameras ? result.cameras->views : job.views();
  drawn.cameras = std::move(result.cameras);
  drawing.has_share_of_cameras =
      drawn.cameras && drawn.cameras->uncertainty && !result.fit_to_given;
  if (result.fit_to_given) {
    drawn.fits_given = true;
    drawing.views = job.views();
    drawing.curves =
        std::make_shared<const std::vector<ImageCurves>>(std::move(result.fit_to_given->curves));
  }
  return drawn;
}

void SayNeeds(const Project& project, const RunOptions& run, Console* console) {
  const int num_threads =
      run.num_threads > 0 ? run.num_threads : static_cast<int>(std::thread::hardware_concurrency());
  const RunNeeds needs = EstimateNeeds(project.views(), run.pipeline.tiles, num_threads);
  for (const std::string& line : LinesOf(needs, AvailableMemory())) console->Say(line);
}

}  // namespace

std::optional<DrawnScene> DrawInMemory(const Job& job, const DrawerOptions& options) {
  const RunOptions& run = options.run;
  const ViewSet& set = job.scene.view_set();
  const CameraRefinement how = CameraRefinementOf(job);
  const PipelineInput input{
      set.views,          set.hints,
      job.scene.images(), SceneBox(job.scene, run),
      job.cache,          how == CameraRefinement::kOff ? nullptr : &set.mounts,
      run.update};
  const std::vector<Tile> tiles = PlanSceneTiles(input, options, job.console);
  if (!run.shard.empty()) {
    DoShard(input, tiles, run, job.console);
    return std::nullopt;
  }
  auto result = DrawSceneOrTiles(input, tiles, job);
  if (!result) return std::nullopt;
  CheckGraph(result->graph);
  if (result->cameras) ToImagePixels(set, &*result->cameras);
  ToImagePixels(set, &result->rows);
  if (result->fit_to_given) ToImagePixels(set, &*result->fit_to_given);
  if (how != CameraRefinement::kOff && !result->new_views)
    SayCameras(result->cameras, set, how, job.console);
  SayRows(result->rows, job.console);
  if (result->fit_to_given) SayFitToGiven(*result->fit_to_given, job.console);
  return ToDrawnScene(std::move(*result), job, IsInTiles(tiles, input.views));
}

std::optional<DrawingGraph> DrawProject(const Project& project, const DrawerOptions& options,
                                        Console* console) {
  const RunOptions& run = options.run;
  CheckRunOutputs(project, run);
  CheckSceneViews(project);
  SayNeeds(project, run, console);
  const std::string replaced_cameras = CamerasOfResults(project, SketchFileName(run.pipeline.mode));
  const SceneAligner aligner(project, run.layout, options.align, console);
  auto drawn = DrawInMemory(JobOf(project, run, console), options);
  if (!drawn) return std::nullopt;
  DrawingInScene& drawing = drawn->drawing;
  const auto& curves = drawn->curves_of_sketch;
  if (drawn->cameras && !drawn->fits_given) WarnOfDense(project, *drawn->cameras, console);
  const std::string cameras = WriteRefinedModel(project, drawn->cameras, console);
  drawing.metadata.refined_cameras = cameras;
  if (curves) {
    WriteSketchResults(project, SketchFileName(run.pipeline.mode),
                       drawn->cameras ? drawn->cameras->views : drawing.views, *curves,
                       drawn->sketch, drawing.metadata, console->context());
  }
  if (drawn->fits_given) drawing.metadata.refined_cameras.clear();
  drawing.metadata.alignment = aligner.Align(drawing.views, drawing.graph, console);
  WriteDrawingResults(project, drawing, options.results, console, drawn->new_views);
  if (options.account) {
    WriteAccount(project,
                 {{drawing.views, *curves},
                  drawn->sketch_fates,
                  drawn->sketch,
                  drawn->sample_fates,
                  drawing.graph},
                 console);
  }
  const Trust trust = ReportTrust(project.view_set(), drawing, console);
  if (options.page) {
    WritePageWithReport(project, drawing, options, trust, console);
  } else {
    WarnOfOldPage(project, "--page 0", console);
  }
  drawn->keep();
  RemoveOtherCameras(project, replaced_cameras, cameras, console);
  console->SayTotalTime();
  console->RepeatWarnings();
  return std::move(drawing.graph);
}

}  // namespace limn::colmap_ext
