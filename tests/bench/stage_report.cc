// SPDX-License-Identifier: BSD-3-Clause
// Measures every stage of the main job on the known data sets (data_sets.h), from photographs and
// with an empty cache: wall and processor time, peak memory, and how near what it made is to the
// truth. Writes report.json (keys: stage_costs.h) and report.md. The files are read once before, so
// that times do not tell of the disk.
#include <string>

#include "bench/bench_main.h"
#include "bench/data_sets.h"
#include "bench/measure.h"
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
  int max_image_size = -1;
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
                    "shrink images to this longer side, px, -1 = off");
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

Scene ExtractScene(const colmap_ext::Project& project, const PipelineOptions& options,
                   const RunContext& context, Json* set) {
  const TempDir folder;
  ResultCache cache(folder.path().string());
  const StageMeter meter;
  CurvesResult curves = ExtractCurves({project.views(), project.images(), &cache}, options.edges,
                                      options.linking, context);
  AddCost(meter.Finish(curves.summary.stage), nullptr, set);
  return {project.views(), std::move(curves.curves), project.view_set().hints};
}

Json MeasureStages(const DataSet& data, const Options& options, colmap_ext::Console* console) {
  const TempDir unused;
  colmap_ext::RunOptions run;
  run.layout.workspace_path = data.workspace_path;
  run.layout.output_path = unused.path().string();
  run.view.max_image_size = options.max_image_size;
  const colmap_ext::Project project(run, console);
  const Truth truth = options.accuracy ? ReadTruth(data) : Truth();
  Json set = NewStageSet(data.name, project.views().size(),
                         data.in_footprints ? "footprint" : "world", data.taus);
  ReadImagesOnce(project);
  for (int i = 0; i < options.repeat; ++i) {
    const Scene scene = ExtractScene(project, run.pipeline, console->context(), &set);
    RunStages(scene, project.images().read, run.pipeline, console->context(),
              [&](const StageCost& cost, const CurveSet& made) {
                // Every run makes the same.
                const Json shares = i == 0 ? MeasureAgainstTruth(data, truth, scene.views, made,
                                                                 false, console->context())
                                           : Json(nullptr);
                AddCost(cost, shares, &set);
                console->Say(data.name + ", " + cost.stage + ": " +
                             std::to_string(cost.times.seconds) + " s");
              });
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
