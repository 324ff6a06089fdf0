// Disturbs the cameras of the sample scene, draws it with them, with and without refine_poses, and
// tells how far cameras and drawings are from the truth.
#include <cstdio>

#include "bench/bench_main.h"
#include "bench/sample_study.h"
#include "colmap_ext/host/terminal_console.h"
#include "support/camera_errors.h"

namespace limn::bench {
namespace {

struct StudyOptions {
  std::string output_path;
  double error_px = 1;
  int seed = 1;
  bool use_points = true;
};

void PrintCameras(const std::string& name, const SampleStudy& study,
                  const std::vector<View>& views) {
  const auto errors = testing::MeasureCameras(views, study.scene.views, study.truth_points);
  std::printf("| %s | %.3f | %.3f | %.4f | %.2f | %+.3f |\n", name.c_str(), errors.raw_px,
              errors.aligned_px, errors.rotation_deg, 1000 * errors.center,
              100 * (views[0].camera.fx / study.scene.views[0].camera.fx - 1));
}

// After the same alignment as the cameras.
void PrintDrawing(const std::string& name, const SampleStudy& study, const std::vector<View>& views,
                  const DrawingGraph& graph, const RunContext& context) {
  const Json report = MeasureAligned(study, views, graph, context);
  std::printf("| %s |", name.c_str());
  for (const Json& row : report["all"]["rows"]) {
    std::printf(" %.3f / %.3f / %.3f |", row["precision"].get<double>(),
                row["recall"].get<double>(), row["f"].get<double>());
  }
  std::printf(" %.3f |\n", report["all"]["rows"][0]["median_accuracy"].get<double>());
  std::fflush(stdout);
}

void Run(const StudyOptions& options) {
  colmap_ext::TerminalConsole console(-1);
  const RunContext& context = console.context();
  const SampleStudy study = LoadSampleStudy(options.output_path, options.use_points, &console);
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
      "\n| cameras | px as they are | px aligned | rotation deg | center mm | focal %% |\n");
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
  return limn::bench::BenchMain(argc, argv, &parser, [&] { limn::bench::Run(options); });
}
