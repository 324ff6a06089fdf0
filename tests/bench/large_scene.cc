// SPDX-License-Identifier: BSD-3-Clause
// How time and memory of the stages after the image curves grow with the number of views: on a
// street (street_scene.h) whose image curves are generated, and which is compared with its truth.
// Prints the table of stages and what a view costs; --output_path keeps report.json
// (stage_costs.h).
#include <iostream>
#include <string>

#include "bench/bench_main.h"
#include "bench/markdown.h"
#include "bench/run_stages.h"
#include "bench/stage_table.h"
#include "bench/street_scene.h"
#include "colmap_ext/host/terminal_console.h"
#include "limn/evaluation/evaluate_curves.h"
#include "limn/evaluation/report_writers.h"
#include "limn/files/atomic_file.h"
#include "limn/model/view_subset.h"
#include "limn/pipeline/tiled_scene.h"
#include "support/synthetic_image.h"

namespace limn::bench {
namespace {

struct Options {
  StreetOptions street;
  std::string output_path;
  std::string commit;
  bool accuracy = true;
  int tile_views = 0;
  int num_threads = -1;
};

void AddOptions(Options* options, OptionParser* parser) {
  parser->AddOption("views", &options->street.num_views, "number of views");
  parser->AddOption("edgels", &options->street.num_edgels, "edgels per view, in the mean");
  parser->AddOption("noise_px", &options->street.noise_px, "noise of the edgels, px");
  parser->AddOption("seed", &options->street.seed, "of the scene");
  parser->AddOption("accuracy", &options->accuracy, "compare with the truth");
  parser->AddOption("tile_views", &options->tile_views,
                    "draw in tiles of so many views, whose image curves are made for each; 0 = in "
                    "one piece");
  parser->AddOption("output_path", &options->output_path, "folder of report.json; empty = none");
  parser->AddOption("commit", &options->commit, "what is measured, for the report");
  parser->AddOption("num_threads", &options->num_threads, "-1 = all cores");
}

// In meters: footprints of a thousand views would take longer than the stages.
Json MeasureTruth(const Street& street, const CurveSet& made, const std::vector<double>& taus,
                  const RunContext& context) {
  EvaluationOptions options;
  options.taus = taus;
  options.find_duplicates = false;
  std::ostringstream text;
  WriteReportJson(EvaluateCurves(made, street.truth, options, {}, context), text);
  return {{"all", Json::parse(text.str())}};
}

std::vector<ImageCurves> CurvesOf(const Street& street, const std::vector<ViewId>& ids,
                                  const RunContext& context) {
  std::vector<ImageCurves> curves(ids.size());
  ParallelFor(context, "street", ids.size(),
              [&](size_t i) { curves[i] = street.curves_of(ids[i]); });
  return curves;
}

// Each tile's image curves are made when it is drawn, as those of photographs are read then.
void RunTiles(const Street& street, int tile_views, const RunContext& context,
              const StageListener& listener) {
  PipelineOptions options;
  options.tiles.max_views = tile_views;
  const Scene& scene = street.scene;
  const std::vector<Tile> tiles = PlanTiles(scene.views, scene.hints, std::nullopt, options.tiles);
  for (const Tile& tile : tiles) std::cout << tile.views.size() << " ";
  std::cout << "views in " << tiles.size() << " tiles" << std::endl;
  ResultCache none("");
  const auto curves_of = [&](const SceneSubset& part) {
    return CurvesResult{CurvesOf(street, part.ids, context), {}};
  };
  const auto gray = [&](ViewId view) {
    const PinholeCamera& camera = scene.views[view].camera;
    return testing::ConstantImage(camera.width, camera.height, {128});
  };
  const StageMeter meter;
  const DrawingGraph graph = DrawTiles({scene.views, scene.hints, &none, tiles, curves_of, gray},
                                       options, context, [&](const StageSummary& summary) {
                                         std::cout << summary.stage << ':';
                                         for (const auto& [what, count] : summary.kept)
                                           std::cout << ' ' << count << ' ' << what;
                                         std::cout << std::endl;
                                       });
  listener.on_stage_end(meter.Finish("tiles"));
  listener.on_made("tiles", ToCurveSet(graph));
}

size_t CountEdgels(const Scene& scene) {
  size_t count = 0;
  for (const ImageCurves& curves : scene.curves) count += curves.edge_map.edgels.size();
  return count;
}

void PrintPerView(const Json& set, double num_views, std::ostream& out) {
  out << '\n';
  PrintHead({"stage", "CPU ms per view", "peak MB per view"}, out);
  for (const Json& stage : set["stages"]) {
    PrintRow({stage["stage"], Fixed(stage["cpu_seconds"][0], 1, 1000 / num_views),
              Fixed(stage["peak_mb"][0], 2, 1 / num_views)},
             out);
  }
}

Json MeasureStreet(const Options& options, const colmap_ext::Console& console) {
  const StreetOptions& size = options.street;
  const RunContext& context = console.context();
  const StageMeter meter;
  Street street = MakeStreet(size);
  const std::vector<double> taus = {street.footprint, 2 * street.footprint};
  Json set = NewStageSet(
      "street-" + std::to_string(size.num_views) + "-" + std::to_string(size.num_edgels),
      street.scene.views.size(), "world", taus);
  const StageListener listener = {
      [&](const StageCost& cost) {
        AddCost(cost, &set);
        std::cout << cost.stage << ": " << cost.times.seconds << " s" << std::endl;
      },
      [&](const std::string& stage, const CurveSet& made) {
        std::cout << stage << ": " << made.polylines.size() << " curves" << std::endl;
        if (options.accuracy) AddTruth(stage, MeasureTruth(street, made, taus, context), &set);
      }};
  if (options.tile_views > 0) {
    RunTiles(street, options.tile_views, context, listener);
  } else {
    street.scene.curves = CurvesOf(street, IdsOf(std::nullopt, street.scene.views.size()), context);
    const StageCost made_scene = meter.Finish("scene");
    std::cout << CountEdgels(street.scene) / street.scene.views.size()
              << " edgels per view in the mean; the scene took " << made_scene.times.seconds
              << " s and " << made_scene.peak_mb << " MB\n";
    RunStages(street.scene, {}, {}, context, listener);
  }
  AddTotal(&set);
  return set;
}

void Run(const Options& options) {
  const colmap_ext::TerminalConsole console(options.num_threads);
  Json report = NewStageReport(options.commit, options.num_threads);
  report["sets"].push_back(MeasureStreet(options, console));
  WriteStageTable(report, std::cout);
  PrintPerView(report["sets"][0], options.street.num_views, std::cout);
  if (options.output_path.empty()) return;
  WriteFileAtomically(options.output_path + "/report.json",
                      [&](std::ostream& out) { out << report.dump(1) << '\n'; });
}

}  // namespace
}  // namespace limn::bench

int main(int argc, char** argv) {
  limn::bench::Options options;
  limn::OptionParser parser("large_scene", "time and memory of the stages on a generated street");
  limn::bench::AddOptions(&options, &parser);
  return limn::bench::BenchMain(argc, argv, &parser, [&] { limn::bench::Run(options); });
}
