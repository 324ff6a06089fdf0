// What wrong cameras cost: draws the sample scene with all cameras disturbed more and more, and
// with one camera in a hundred, at least one, turned by 5 degrees about its center.
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <random>

#include "bench/bench_main.h"
#include "bench/markdown.h"
#include "bench/sample_study.h"
#include "colmap_ext/host/terminal_console.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "support/camera_errors.h"

namespace limn::bench {
namespace {

constexpr double kWrongShare = 0.01;
constexpr double kWrongDeg = 5;

struct NoiseOptions {
  std::string output_path;
  std::vector<double> errors_px = {0, 0.5, 1, 2};
  int seed = 1;
};

// Every hundredth view, one at least, chosen and turned at random.
std::vector<View> WithWrongViews(std::vector<View> views, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss(0, 1);
  std::vector<size_t> order(views.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), random);
  const auto count =
      std::max<size_t>(1, static_cast<size_t>(kWrongShare * static_cast<double>(views.size())));
  for (size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d axis =
        Eigen::Vector3d(gauss(random), gauss(random), gauss(random)).normalized();
    Rigid3d turn;
    turn.rotation = Eigen::AngleAxisd(kWrongDeg * kDeg, axis);
    views[order[i]].cam_from_world = turn * views[order[i]].cam_from_world;
  }
  return views;
}

void MeasureViews(const std::string& name, const SampleStudy& study, const std::vector<View>& views,
                  const RunContext& context) {
  const DrawingGraph refined = Refine(study, views, Draw(study, views, context), context);
  const Json report = MeasureAligned(study, views, refined, context);
  Cells cells = {name, std::to_string(refined.links.size())};
  for (const Json& row : report["all"]["rows"]) cells.push_back(Shares(row));
  PrintRow(cells, std::cout);
  std::cout.flush();
}

void Run(const NoiseOptions& options) {
  if (options.output_path.empty()) throw OptionError("--output_path must be given");
  colmap_ext::TerminalConsole console(-1);
  RunContext context = console.context();
  context.progress = {};  // nothing between the rows of the table
  const SampleStudy study = LoadSampleStudy(options.output_path, true, &console);
  const auto seed = static_cast<unsigned>(options.seed);
  std::cout << '\n';
  PrintHead({"cameras", "links", "P/R/F at 1", "at 2", "at 4 footprints"}, std::cout);
  for (const double error_px : options.errors_px) {
    const std::vector<View> views =
        error_px > 0
            ? testing::PerturbCameras(study.scene.views, study.truth_points, error_px, seed)
            : study.scene.views;
    MeasureViews(Short(error_px) + " px off", study, views, context);
  }
  MeasureViews("one turned by " + Short(kWrongDeg) + " degrees", study,
               WithWrongViews(study.scene.views, seed), context);
}

}  // namespace
}  // namespace limn::bench

int main(int argc, char** argv) {
  limn::bench::NoiseOptions options;
  limn::OptionParser parser("pose_noise", "accuracy of the sample's drawing with wrong cameras");
  parser.AddOption("output_path", &options.output_path, "folder for the cache of image curves");
  parser.AddOption("errors_px", &options.errors_px, "mean displacements of the cameras, px");
  parser.AddOption("seed", &options.seed, "of the disturbances");
  return limn::bench::BenchMain(argc, argv, &parser, [&] { limn::bench::Run(options); });
}
