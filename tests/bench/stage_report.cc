// SPDX-License-Identifier: BSD-3-Clause
// Measures every stage of the main job on the known data sets (data_sets.h), from photographs,
// with default options but for the cameras, which are taken as they are given: wall and processor
// time, peak memory, and how near what it made is to the truth. Only image curves are written to a
// cache. Writes report.json (keys: stage_costs.h) and report.md. The files are read once before, so
// that times do not tell of the disk.
#include <string>

#include "bench/bench_main.h"
#include "bench/data_sets.h"
#include "bench/measure.h"
#include "bench/methods.h"
#include "bench/run_stages.h"
#include "bench/stage_costs.h"
#include "bench/stage_table.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/host/terminal_console.h"
#include "colmap_ext/temp_dir.h"
#include "limn/files/atomic_file.h"
#include "limn/util/errors.h"

namespace limn::bench {
namespace {

struct Options {
  std::string data_path = LIMN_DATA_DIR;
  std::string sample_path = LIMN_SAMPLE_DIR;
  std::string output_path;
  std::string sets;
  std::string commit;
  int repeat = 1;
  bool accuracy = true;
  int max_image_size = 0;
  int num_threads = -1;
};

void AddOptions(Options* options, OptionParser* parser) {
  parser->AddOption("data_path", &options->data_path, "folder of the data sets");
  parser->AddOption("sample_path", &options->sample_path, "folder of the sample scene");
  parser->AddOption("output_path", &options->output_path, "folder of report.json and report.md");
  parser->AddOption("sets", &options->sets, "data sets with commas between; empty = all present");
  parser->AddOption("commit", &options->commit, "what is measured, for the report");
  parser->AddOption("repeat", &options->repeat, "runs of every stage");
  parser->AddOption("accuracy", &options->accuracy, "compare with the truth");
  parser->AddOption("max_image_size", &options->max_image_size,
                    "shrink images to this longer side, px, -1 = off, 0 = as by default");
  parser->AddOption("num_threads", &options->num_threads, "-1 = all cores");
}

void Check(const Options& options) {
  if (options.output_path.empty()) throw OptionError("--output_path must be given");
  CheckOption(options.repeat >= 1, "repeat", options.repeat, ">= 1");
}

void ReadImagesOnce(const colmap_ext::Project& project) {
  for (size_t v = 0; v < project.views().size(); ++v) {
    project.images().identity(static_cast<ViewId>(v));
  }
}

// The views in pixels of the images, in which distances are measured.
std::vector<View> ViewsOfImages(colmap_ext::RunOptions run, colmap_ext::Console* console) {
  run.view.max_scale = 1;
  return colmap_ext::Project(run, console).views();
}

Scene ExtractScene(const colmap_ext::Project& project, const PipelineOptions& options,
                   const RunContext& context, Json* set) {
  const TempDir folder;
  ResultCache cache(folder.path().string());
  const StageMeter meter;
  CurvesResult curves = ExtractCurves({project.views(), project.images(), &cache}, options.edges,
                                      options.linking, context);
  AddCost(meter.Finish(curves.summary.stage), set);
  return {project.views(), std::move(curves.curves), project.view_set().hints};
}

Json MeasureStages(const DataSet& data, const Options& options, colmap_ext::Console* console) {
  const TempDir unused;
  const auto run =
      DrawerOptionsOf(SceneArguments(data, unused.path().string(), options.max_image_size)).run;
  const std::vector<View> views = ViewsOfImages(run, console);
  const colmap_ext::Project project(run, console);
  const Truth truth = options.accuracy ? ReadTruth(data) : Truth();
  Json set = NewStageSet(data.name, project.views().size(),
                         data.in_footprints ? "footprint" : "world", data.taus);
  ReadImagesOnce(project);
  StageListener listener;
  listener.on_stage_end = [&](const StageCost& cost) {
    AddCost(cost, &set);
    console->Say(data.name + ", " + cost.stage + ": " + std::to_string(cost.times.seconds) + " s");
  };
  for (int i = 0; i < options.repeat; ++i) {
    // Every run makes the same.
    listener.on_made = [&](const std::string& stage, const CurveSet& made) {
      if (i > 0 || !truth.IsKnown()) return;
      AddTruth(stage,
               MeasureAgainstTruth(data, truth, views, made, /*find_duplicates=*/false,
                                   console->context()),
               &set);
    };
    const Scene scene = ExtractScene(project, run.pipeline, console->context(), &set);
    RunStages(scene, project.images().read, run.pipeline, console->context(), listener);
  }
  AddTotal(&set);
  return set;
}

void WriteReport(const Options& options, const Json& report) {
  WriteFileAtomically(options.output_path + "/report.json",
                      [&](std::ostream& out) { out << report.dump(1) << '\n'; });
  WriteFileAtomically(options.output_path + "/report.md",
                      [&](std::ostream& out) { WriteStageTable(report, out); });
}

void Run(const Options& options) {
  Check(options);
  const auto sets =
      SelectDataSets(KnownDataSets(options.data_path, options.sample_path), options.sets);
  colmap_ext::TerminalConsole console(options.num_threads);
  Json report = NewStageReport(options.commit, options.num_threads);
  for (const DataSet& set : sets) {
    report["sets"].push_back(MeasureStages(set, options, &console));
    WriteReport(options, report);  // what is known can be read
  }
}

}  // namespace
}  // namespace limn::bench

int main(int argc, char** argv) {
  limn::bench::Options options;
  limn::OptionParser parser("stage_report",
                            "time, memory and accuracy of every stage on data sets");
  limn::bench::AddOptions(&options, &parser);
  return limn::bench::BenchMain(argc, argv, &parser, [&] { limn::bench::Run(options); });
}
