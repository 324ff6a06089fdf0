// SPDX-License-Identifier: BSD-3-Clause
#include "bench/methods.h"

#include <algorithm>
#include <utility>

#include "colmap_ext/verbs/draw.h"
#include "limn/model/link_selection.h"
#include "limn/util/errors.h"

namespace limn::bench {
namespace {

// Throws InputError unless numbers of views mean the same.
void CheckViews(const std::vector<View>& expected, const std::vector<View>& views) {
  const bool are_same = std::equal(expected.begin(), expected.end(), views.begin(), views.end(),
                                   [](const View& a, const View& b) { return a.name == b.name; });
  if (!are_same) throw InputError("other images are drawn than are judged");
}

}  // namespace

const std::vector<Method>& Methods() {
  static const std::string paper_ini = LIMN_SCRIPTS_DIR "/paper.ini";
  static const std::vector<std::string> given_cameras = {"--refine_cameras", "0"};
  static const std::vector<std::string> paper = {"--project_path", paper_ini};
  static const std::vector<std::string> original = {"--mode", "original", "--refine_cameras", "0"};
  static const std::vector<std::string> inliers = {"Sketch.original_min_inliers_total"};
  static const std::vector<int> inlier_totals = {25, 50, 125, 250, 500};
  // The same number of views whatever the number that contains a sample, as in the paper.
  static const std::vector<std::string> supporting_views = {"Sketch.min_supporting_views",
                                                            "Drawing.min_supporting_views",
                                                            "Drawing.max_supporting_views"};
  // The paper's drawing takes all curves of its sketch.
  static const std::vector<std::string> views_of_sketch = {"Sketch.min_supporting_views"};
  static const std::vector<int> views = {3, 4, 6, 8, 12};
  static const std::vector<Method> methods = {
      {"original sketch", original, false, "inliers", inliers, inlier_totals},
      {"enhanced sketch", paper, false, "views", views_of_sketch, views},
      {"paper drawing", paper, true, "views", views_of_sketch, views},
      {"swept sketch", given_cameras, false, "views", supporting_views, views},
      {"default drawing", given_cameras, true, "views", supporting_views, views},
  };
  return methods;
}

std::vector<std::string> SceneArguments(const DataSet& set, const std::string& output_path,
                                        int max_image_size) {
  std::vector<std::string> arguments = {"--workspace_path", set.workspace_path, "--output_path",
                                        output_path};
  if (max_image_size != 0)
    arguments.push_back("--max_image_size=" + std::to_string(max_image_size));
  return arguments;
}

colmap_ext::DrawerOptions DrawerOptionsOf(const std::vector<std::string>& arguments) {
  std::vector<const char*> words = {"automatic_drawer"};
  for (const std::string& argument : arguments) words.push_back(argument.c_str());
  colmap_ext::DrawerOptions options;
  ParseDrawerOptions("", static_cast<int>(words.size()), words.data(), &options);
  return options;
}

void Workbench::Draw(const std::vector<std::string>& arguments) {
  arguments_.clear();
  sketch_ = {};
  drawing_ = {};
  const colmap_ext::DrawerOptions options = DrawerOptionsOf(arguments);
  const Stopwatch stopwatch;
  const colmap_ext::Project project(options.run, console_);
  CheckSceneViews(project);
  CheckViews(views_, project.views());
  auto drawn = DrawInMemory({project, options.run, console_, &cache_}, options);
  if (!drawn || !drawn->curves_of_sketch || drawn->cameras) {
    throw InputError("views are too many for one tile, or their cameras were refined");
  }
  times_ = stopwatch.Elapsed();
  sketch_ = std::move(drawn->sketch);
  drawing_ = std::move(drawn->drawing.graph);
  arguments_ = arguments;
}

Reconstruction Workbench::Run(const Method& method, std::optional<int> threshold) {
  std::vector<std::string> arguments = scene_arguments_;
  arguments.insert(arguments.end(), method.arguments.begin(), method.arguments.end());
  for (const std::string& option : method.threshold_options) {
    if (threshold) arguments.push_back("--" + option + "=" + std::to_string(*threshold));
  }
  if (arguments != arguments_) Draw(arguments);
  if (!method.draws) {
    return {ToCurveSet(sketch_), ToSupportedCurves(sketch_), std::nullopt, std::nullopt, times_};
  }
  // What a user gets by default.
  DrawingGraph graph = Selected(drawing_, LinkSelection::AsSeen());
  return {ToCurveSet(graph), ToSupportedCurves(graph), std::move(graph),
          Selected(drawing_, LinkSelection()), times_};
}

}  // namespace limn::bench
