// SPDX-License-Identifier: BSD-3-Clause
#include "bench/measure_set.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "bench/measure.h"
#include "bench/methods.h"
#include "bench/scene.h"
#include "bench/side_by_side.h"
#include "bench/stopwatch.h"
#include "colmap_ext/host/job.h"
#include "colmap_ext/temp_dir.h"
#include "limn/files/atomic_file.h"
#include "limn/formats/read_curves.h"
#include "limn/formats/write_drawing.h"
#include "limn/pictures/picture.h"

namespace limn::bench {
namespace {

using colmap_ext::Console;

// A data set while it is measured.
struct Measured {
  const DataSet& set;
  Truth truth;
  Scene scene;
  Scene training;
  Scene held_out;
  double seconds = 0;  // of the image curves
};

std::vector<std::string> ArgumentsFor(const DataSet& set, const ReportOptions& options) {
  return SceneArguments(set, options.output_path + "/" + set.name, options.max_image_size);
}

Measured Load(const DataSet& set, const ReportOptions& options, Console* console) {
  colmap_ext::DrawerOptions drawer = DrawerOptionsOf(ArgumentsFor(set, options));
  drawer.run.view.max_scale = 1;  // distances are in pixels of the images
  const colmap_ext::Project project(drawer.run, console);
  Measured measured{set, ReadTruth(set), {}, {}, {}, 0};
  const Stopwatch stopwatch;
  CurvesResult curves = ExtractImageCurves(JobOf(project, drawer.run, console));
  measured.seconds = stopwatch.Elapsed().seconds;
  measured.scene = {project.views(), std::move(curves.curves), {}};
  measured.training = PartOf(measured.scene, false);
  measured.held_out = PartOf(measured.scene, true);
  return measured;
}

// `threshold` is null for the default options.
Json MeasureRun(const Measured& measured, const Method& method, const Json& threshold,
                const Reconstruction& result, Console* console) {
  Json run;
  run["method"] = method.name;
  run["arguments"] = method.arguments;
  run["threshold_name"] = method.threshold_name;
  run["threshold"] = threshold;
  run["seconds"] = result.times.seconds;
  run["cpu_seconds"] = result.times.cpu_seconds;
  run["shape"] = MeasureShape(result.set, measured.scene.views);
  // A sketch has every curve once per pair of views: they would take long to count.
  const bool find_duplicates = threshold.is_null() && result.graph.has_value();
  run["truth"] = MeasureAgainstTruth(measured.set, measured.truth, measured.scene.views, result.set,
                                     find_duplicates, console->context());
  console->Say(measured.set.name + ", " + method.name + ", threshold " +
               (threshold.is_null() ? "default" : threshold.dump()) + ": " +
               std::to_string(result.set.polylines.size()) + " curves");
  return run;
}

// File names hold no spaces.
std::string ResultPath(const ReportOptions& options, const DataSet& set, std::string name) {
  std::replace(name.begin(), name.end(), ' ', '-');
  return options.output_path + "/" + set.name + "/" + name;
}

void WriteResults(const ReportOptions& options, const Measured& measured, const Method& method,
                  const DrawingGraph& graph) {
  DrawingMetadata metadata;
  for (const View& view : measured.scene.views) metadata.view_names.push_back(view.name);
  WriteDrawing(ResultPath(options, measured.set, method.name + ".json"), graph, metadata);
  const std::string& cloud_path = measured.set.cloud_path;
  if (cloud_path.empty() || !std::filesystem::exists(cloud_path)) return;
  const View& view = measured.scene.views[measured.scene.views.size() / 2];
  WritePng(ResultPath(options, measured.set, method.name + "-beside-pmvs.png"),
           DrawSideBySide(graph, ReadCurves(cloud_path).points, view));
}

// For the photographs that are not held out.
std::vector<std::string> TrainingArguments(const Measured& measured, const ReportOptions& options) {
  const std::string list = ResultPath(options, measured.set, "training-images.txt");
  WriteFileAtomically(list, [&](std::ostream& out) {
    for (const View& view : measured.training.views) out << view.name << '\n';
  });
  std::vector<std::string> arguments = ArgumentsFor(measured.set, options);
  arguments.insert(arguments.end(), {"--image_list_path", list});
  return arguments;
}

void MeasureDefaults(const ReportOptions& options, const Measured& measured,
                     const std::string& cache_path, Console* console,
                     const std::function<void(Json)>& add_run) {
  Workbench workbench(ArgumentsFor(measured.set, options), measured.scene.views, "", console);
  Workbench training_bench(TrainingArguments(measured, options), measured.training.views,
                           cache_path, console);
  for (const Method& method : Methods()) {
    const Reconstruction result = workbench.Run(method, std::nullopt);
    Json run = MeasureRun(measured, method, nullptr, result, console);
    run["emap"] = MeasureByEmap(measured.truth, result.set);
    run["held_out"] =
        MeasureHeldOutViews(measured.training, measured.held_out,
                            training_bench.Run(method, std::nullopt).curves, console->context());
    run["sigmas"] = run["rods"] = nullptr;
    if (result.graph) {
      run["sigmas"] = MeasureSigmas(measured.truth, measured.scene.views, *result.graph);
      run["rods"] = MeasureRods(measured.set, measured.truth, measured.scene.views,
                                *result.with_rods, console->context());
      WriteResults(options, measured, method, *result.graph);
    }
    add_run(std::move(run));
  }
}

// Threshold by threshold, all methods that share their runs.
void MeasureSweep(const ReportOptions& options, const Measured& measured,
                  const std::string& cache_path, Console* console,
                  const std::function<void(Json)>& add_run) {
  Workbench workbench(ArgumentsFor(measured.set, options), measured.scene.views, cache_path,
                      console);
  const std::vector<Method>& methods = Methods();
  for (auto begin = methods.begin(); begin != methods.end();) {
    const auto end = std::find_if(begin, methods.end(), [&](const Method& method) {
      return method.arguments != begin->arguments;
    });
    for (const int threshold : begin->thresholds) {
      for (auto method = begin; method != end; ++method) {
        add_run(
            MeasureRun(measured, *method, threshold, workbench.Run(*method, threshold), console));
      }
    }
    begin = end;
  }
}

void MeasurePeers(const Measured& measured, Console* console, Json* json) {
  (*json)["peers"] = Json::array();
  (*json)["missing_peers"] = Json::array();
  for (const PeerResult& peer : measured.set.peers) {
    if (!std::filesystem::exists(peer.path)) {
      (*json)["missing_peers"].push_back(peer.path);
      console->Say(measured.set.name + ", " + peer.program + ": left out, there is no " +
                   peer.path);
      continue;
    }
    const CurveSet curves = ReadCurves(peer.path);
    const std::vector<View>& views = measured.scene.views;
    (*json)["peers"].push_back(
        {{"method", peer.program},
         {"shape", MeasureShape(curves, views)},
         {"truth", MeasureAgainstTruth(measured.set, measured.truth, views, curves,
                                       /*find_duplicates=*/true, console->context())}});
  }
}

}  // namespace

void MeasureSet(const DataSet& set, const ReportOptions& options, Console* console,
                const std::function<void(const Json&)>& on_run) {
  const Measured measured = Load(set, options, console);
  Json json;
  json["name"] = set.name;
  json["plot"] = set.plot;
  json["unit"] = set.in_footprints ? "footprint" : "world";
  json["taus"] = set.taus;
  json["boxes"] = Json::array();
  for (const NamedBox& box : measured.truth.boxes) json["boxes"].push_back(box.name);
  json["num_views"] = measured.scene.views.size();
  json["num_held_out"] = measured.held_out.views.size();
  json["seconds"] = measured.seconds;
  json["ceiling"] = MeasureCeiling(set, measured.truth, measured.scene, console->context());
  MeasurePeers(measured, console, &json);
  json["runs"] = Json::array();
  const auto add_run = [&](Json run) {
    json["runs"].push_back(std::move(run));
    on_run(json);
  };
  const TempDir cache;
  const std::string cache_path = cache.path().string();
  MeasureDefaults(options, measured, cache_path, console, add_run);
  // Without truth there is nothing to plot.
  if (!options.quick && measured.truth.IsKnown()) {
    MeasureSweep(options, measured, cache_path, console, add_run);
  }
}

}  // namespace limn::bench
