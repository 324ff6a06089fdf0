// Disturbs the cameras of the sample scene, draws it with them, with and without refine_poses, and
// tells how far cameras and drawings are from the truth.
#include <cstdio>
#include <iostream>

#include "bench/data_sets.h"
#include "bench/measure.h"
#include "colmap_ext/commands/project.h"
#include "colmap_ext/options/option_parser.h"
#include "limn/drawing/drawing.h"
#include "limn/geometry/polyline.h"
#include "limn/refinement/refinement.h"
#include "limn/sketch/sketch.h"
#include "support/camera_errors.h"

namespace limn::bench {
namespace {

struct StudyOptions {
  std::string output_path;
  double error_px = 1;
  int seed = 1;
  bool use_points = true;
};

struct Study {
  DataSet set;
  Truth truth;
  Scene scene;  // with the true cameras
  std::vector<Eigen::Vector3d> truth_points;
};

Study Load(const StudyOptions& options, colmap_ext::Console* console) {
  Study study;
  study.set = SelectDataSets(KnownDataSets("", LIMN_SAMPLE_DIR), "sample-day")[0];
  study.truth = ReadTruth(study.set);
  colmap_ext::RunOptions run;
  run.layout.workspace_path = study.set.workspace_path;
  run.layout.output_path = options.output_path;
  const colmap_ext::Project project(run, console);
  study.scene = {project.views(), ExtractProjectCurves(project, run, console).curves, {}};
  if (options.use_points) study.scene.hints = project.view_set().hints;
  for (const Polyline3d& polyline : study.truth.curves.polylines) {
    const Polyline3d samples = ResampleUniform(polyline, 0.05);
    study.truth_points.insert(study.truth_points.end(), samples.begin(), samples.end());
  }
  return study;
}

void PrintCameras(const std::string& name, const Study& study, const std::vector<View>& views) {
  const auto errors = testing::MeasureCameras(views, study.scene.views, study.truth_points);
  std::printf("| %s | %.3f | %.3f | %.4f | %.2f | %+.3f |\n", name.c_str(), errors.raw_px,
              errors.aligned_px, errors.rotation_deg, 1000 * errors.center,
              100 * (views[0].camera.fx / study.scene.views[0].camera.fx - 1));
}

// After the same alignment as the cameras.
void PrintDrawing(const std::string& name, const Study& study, const std::vector<View>& views,
                  const DrawingGraph& graph, const RunContext& context) {
  const Eigen::Affine3d truth_from_world =
      testing::WorldFromTruth(views, study.scene.views).inverse();
  CurveSet set = ToCurveSet(graph);
  for (Polyline3d& polyline : set.polylines) {
    for (Eigen::Vector3d& point : polyline) point = truth_from_world * point;
  }
  for (CurveNode& node : set.nodes) {
    node.position_in_world = truth_from_world * node.position_in_world;
  }
  const Json report =
      MeasureAgainstTruth(study.set, study.truth, study.scene.views, set, false, context);
  std::printf("| %s |", name.c_str());
  for (const Json& row : report["all"]["rows"]) {
    std::printf(" %.3f / %.3f / %.3f |", row["precision"].get<double>(),
                row["recall"].get<double>(), row["f"].get<double>());
  }
  std::printf(" %.3f |\n", report["all"]["rows"][0]["median_accuracy"].get<double>());
  std::fflush(stdout);
}

DrawingGraph Draw(const Study& study, const std::vector<View>& views, const RunContext& context) {
  const auto& curves = study.scene.curves;
  const CurveSketch sketch =
      BuildSketch(PipelineOptions().mode, {views, curves, study.scene.hints, std::nullopt}, {},
                  context)
          .sketch;
  return BuildDrawing({views, curves, sketch, std::nullopt}, {}, context).graph;
}

RefinementResult Refine(const Study& study, const std::vector<View>& views,
                        const DrawingGraph& graph, bool refine_poses, const RunContext& context) {
  RefinementOptions options;
  options.refine_poses = refine_poses;
  return RefineDrawing({views, study.scene.curves, graph, &study.scene.hints.points}, options,
                       context);
}

void Run(const StudyOptions& options) {
  colmap_ext::Console console(-1);
  const RunContext& context = console.context();
  const Study study = Load(options, &console);
  const std::vector<View>& truth = study.scene.views;
  const std::vector<View> disturbed = testing::PerturbCameras(
      truth, study.truth_points, options.error_px, static_cast<unsigned>(options.seed));
  const DrawingGraph drawn = Draw(study, disturbed, context);
  const DrawingGraph left = Refine(study, disturbed, drawn, false, context).graph;
  const RefinementResult refined = Refine(study, disturbed, drawn, true, context);
  const std::vector<View>& views = refined.cameras->views;
  const DrawingGraph again = Draw(study, views, context);
  const RefinementResult twice = Refine(study, views, again, true, context);
  const DrawingGraph best = Refine(study, truth, Draw(study, truth, context), false, context).graph;

  std::printf(
      "\n| cameras | px as they are | px aligned | rotation deg | centre mm | focal %% |\n");
  std::printf("|---|---|---|---|---|---|\n");
  PrintCameras("disturbed", study, disturbed);
  PrintCameras("refined", study, views);
  PrintCameras("drawn again and refined", study, twice.cameras->views);
  std::printf("\n| drawing | P/R/F at 1 | at 2 | at 4 footprints | median distance |\n");
  std::printf("|---|---|---|---|---|\n");
  PrintDrawing("disturbed cameras", study, disturbed, left, context);
  PrintDrawing("refined cameras", study, views, refined.graph, context);
  PrintDrawing("drawn again and refined", study, twice.cameras->views, twice.graph, context);
  PrintDrawing("true cameras", study, truth, best, context);
}

}  // namespace
}  // namespace limn::bench

int main(int argc, char** argv) {
  limn::bench::StudyOptions options;
  limn::OptionParser parser("pose_study", "refine disturbed cameras of the sample");
  parser.AddOption("output_path", &options.output_path, "folder for the cache of image curves");
  parser.AddOption("error_px", &options.error_px, "mean displacement of the disturbed cameras, px");
  parser.AddOption("seed", &options.seed, "of the disturbance");
  parser.AddOption("use_points", &options.use_points, "use the points of the sparse model too");
  try {
    using Outcome = limn::OptionParser::Outcome;
    if (parser.Parse(argc, argv, std::cout) == Outcome::kHelp) return 0;
    limn::bench::Run(options);
  } catch (const std::exception& error) {
    std::cerr << "ERROR: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
