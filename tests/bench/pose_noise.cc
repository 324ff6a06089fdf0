// SPDX-License-Identifier: BSD-3-Clause
// Writes a workspace of a data set whose cameras are wrong, fewer or of another size, and how what
// is drawn there is judged: scripts/bench/pose_ladder.py and benchmark.py draw it.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "bench/bench_main.h"
#include "bench/data_sets.h"
#include "bench/measure.h"
#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/verbs/evaluate.h"
#include "colmap_ext/workspace/model_folder.h"
#include "colmap_ext/workspace/to_views.h"
#include "colmap_ext/workspace/view_set.h"
#include "limn/files/atomic_file.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "limn/util/median.h"
#include "support/random_numbers.h"

namespace limn::bench {
namespace {

namespace fs = std::filesystem;
using colmap_ext::SparseModel;
using colmap_ext::WorkspaceLayout;

struct NoiseOptions {
  std::string set;
  std::string data_path = LIMN_DATA_DIR;
  std::string output_path;
  std::string given_model;
  double error_px = 0;
  double turned_deg = 0;
  int num_views = -1;
  double scale = 1;
  int seed = 1;

  void Check() const {
    if (set.empty()) throw OptionError("--set must be given");
    if (output_path.empty()) throw OptionError("--output_path must be given");
    LIMN_CHECK_RANGE(error_px, >= 0, <= 1000);
    LIMN_CHECK_RANGE(turned_deg, >= 0, <= 180);
    LIMN_CHECK_RANGE_OR(num_views, -1, >= 2, <= 1e6);
    LIMN_CHECK_RANGE(scale, >= 0.01, <= 100);
    LIMN_CHECK_RANGE(seed, >= 0, <= 1e9);
  }
};

// Points of the truth or else of the model.
std::vector<Eigen::Vector3d> PointsOfScene(const DataSet& set, const SparseModel& model) {
  const Truth truth = ReadTruth(set);
  std::vector<Eigen::Vector3d> points = truth.curves.points;
  for (const Polyline3d& line : truth.curves.polylines) {
    points.insert(points.end(), line.begin(), line.end());
  }
  if (!points.empty()) return points;
  for (const auto& point : model.points) points.push_back(point.position);
  if (points.empty()) throw IoError(set.workspace_path, "has neither a truth nor points");
  return points;
}

// The median over all views of the depths of what is in the image.
double DepthOfScene(const std::vector<View>& views, const std::vector<Eigen::Vector3d>& points) {
  std::vector<double> depths;
  for (const View& view : views) {
    for (const Eigen::Vector3d& point : points) {
      if (view.Project(point)) depths.push_back((view.cam_from_world * point).z());
    }
  }
  return Median(std::move(depths));
}

// Errors of all cameras, independent: a standard deviation of `error_px` in the image about the x
// and y axes of the camera, half of it about its optical axis; and along each axis for the center,
// at the depth of the scene.
void DisturbCameras(double error_px, double depth, std::mt19937* random, SparseModel* model) {
  testing::NormalDistribution<double> gauss(0, error_px);
  const auto draw = [&] { return testing::RandomVector(gauss, *random); };
  for (auto& image : model->images) {
    const double focal = IntrinsicsOf(model->CameraOf(image)).fx;
    const Eigen::Vector3d turn = draw().cwiseProduct(Eigen::Vector3d(1, 1, 0.5)) / focal;
    Rigid3d motion;
    motion.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized());
    motion.translation = draw() * depth / focal;
    image.cam_from_world = motion * image.cam_from_world;
  }
}

// One camera in a hundred, at least one, turned by this angle about its center.
void TurnCameras(double angle_deg, std::mt19937* random, SparseModel* model) {
  testing::NormalDistribution<double> gauss(0, 1);
  std::vector<size_t> order(model->images.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), *random);
  order.resize(std::max<size_t>(1, order.size() / 100));
  for (const size_t i : order) {
    const Eigen::Vector3d axis = testing::RandomVector(gauss, *random);
    Rigid3d turn;
    turn.rotation = Eigen::AngleAxisd(angle_deg * kDeg, axis.normalized());
    model->images[i].cam_from_world = turn * model->images[i].cam_from_world;
  }
}

// Images would name points that are not there, or are elsewhere in them.
void RemovePoints(SparseModel* model) {
  model->points.clear();
  for (auto& image : model->images) image.observations.clear();
}

// So many images, evenly spread in their order.
void KeepViews(size_t num_views, SparseModel* model) {
  auto& images = model->images;
  if (num_views >= images.size()) return;
  for (size_t i = 0; i < num_views; ++i) images[i] = images[i * images.size() / num_views];
  images.resize(num_views);
  RemovePoints(model);
}

// Of pictures that were made larger or smaller by this factor.
void ScaleCameras(double scale, SparseModel* model) {
  for (auto& camera : model->cameras) {
    const auto& model_of_camera = *colmap_ext::FindCameraModel(static_cast<int32_t>(camera.model));
    for (int i = 0; i < model_of_camera.num_focals + 2; ++i) camera.params[i] *= scale;
    camera.width = static_cast<uint64_t>(std::lround(scale * camera.width));
    camera.height = static_cast<uint64_t>(std::lround(scale * camera.height));
  }
  RemovePoints(model);
}

// How drawing_evaluator judges what was drawn with these cameras, as a project file for it: within
// the same distances whatever the size of the pictures, whose footprints it takes.
void WriteEvaluatorOptions(const DataSet& set, const WorkspaceLayout& layout, double scale,
                           const std::string& workspace_path) {
  colmap_ext::EvaluatorOptions options;
  options.layout.workspace_path = workspace_path;
  options.true_model_path = layout.model_dir.string();
  options.truth.truth_path = set.truth_path;
  options.truth.truth_edges_path = set.truth_edges_path;
  options.truth.junctions_path = set.junctions_path;
  options.truth.dont_care_path = set.dont_care_path;
  options.truth.evaluation.taus = set.taus;
  if (set.in_footprints) {
    options.truth.unit = colmap_ext::TruthInput::Unit::kFootprint;
    for (double& tau : options.truth.evaluation.taus) tau *= scale;
  }
  if (const auto& region = set.boxes.front().region) {
    for (int axis = 0; axis < 3; ++axis) {
      options.box.insert(options.box.end(), {region->min()[axis], region->max()[axis]});
    }
  }
  OptionParser parser("drawing_evaluator", "");
  options.AddOptions(&parser);
  WriteFileAtomically((fs::path(workspace_path) / "evaluator.ini").string(),
                      [&](std::ostream& out) { parser.WriteIni(out); });
}

void Run(const NoiseOptions& options) {
  options.Check();
  const DataSet set =
      SelectDataSets(KnownDataSets(options.data_path, LIMN_SAMPLE_DIR), options.set).front();
  colmap_ext::LayoutOptions where;
  where.workspace_path = fs::absolute(set.workspace_path).lexically_normal().string();
  const WorkspaceLayout layout = ResolveLayout(where);
  const SparseModel exact = colmap_ext::ReadModel(layout.model_dir);
  SparseModel model = exact;
  if (!options.given_model.empty()) {
    model = colmap_ext::ReadModel(fs::path(where.workspace_path) / options.given_model);
  }
  // Images move one by one.
  model.rigs.clear();
  model.frames.clear();
  std::mt19937 random(static_cast<unsigned>(options.seed));
  if (options.error_px > 0) {
    const colmap_ext::ViewSet views = ToViews(exact, layout.image_dir, {});
    const double depth = DepthOfScene(views.views, PointsOfScene(set, exact));
    DisturbCameras(options.error_px, depth, &random, &model);
  }
  if (options.turned_deg > 0) TurnCameras(options.turned_deg, &random, &model);
  if (options.num_views > 0) KeepViews(options.num_views, &model);
  if (options.scale != 1) ScaleCameras(options.scale, &model);
  const fs::path output = fs::absolute(options.output_path).lexically_normal();
  WriteModelBinary(model, output / "sparse/0");
  if (!fs::is_symlink(output / "images")) {
    fs::create_directory_symlink(layout.image_dir, output / "images");
  }
  WriteEvaluatorOptions(set, layout, options.scale, output.string());
}

}  // namespace
}  // namespace limn::bench

int main(int argc, char** argv) {
  limn::bench::NoiseOptions options;
  limn::OptionParser parser("pose_noise", "a workspace of a data set whose cameras are wrong");
  parser.AddOption("set", &options.set, "data set (tests/bench/data_sets.cc)");
  parser.AddOption("data_path", &options.data_path, "folder of the data sets");
  parser.AddOption("output_path", &options.output_path,
                   "new workspace: wrong cameras in sparse/0, evaluator.ini for drawing_evaluator");
  parser.AddOption(
      "given_model", &options.given_model,
      "model with wrong cameras, such as those of the set: a folder in its workspace, or a "
      "path");
  parser.AddOption("error_px", &options.error_px,
                   "errors of rotations and centers per axis, standard deviation in the image");
  parser.AddOption("turned_deg", &options.turned_deg,
                   "turns one camera in a hundred, at least one, by this angle");
  parser.AddOption("num_views", &options.num_views, "only so many images, evenly spread; -1 = all");
  parser.AddOption("scale", &options.scale, "for images that are so many times as large");
  parser.AddOption("seed", &options.seed, "of the errors");
  return limn::bench::BenchMain(argc, argv, &parser, [&] { limn::bench::Run(options); });
}
