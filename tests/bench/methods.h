// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/data_sets.h"
#include "bench/measures/supported_curve.h"
#include "bench/stopwatch.h"
#include "colmap_ext/host/console.h"
#include "colmap_ext/verbs/draw_options.h"
#include "limn/cache/result_cache.h"
#include "limn/model/curve3d.h"
#include "limn/model/curve_set.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn::bench {

// What a method made of a scene.
struct Reconstruction {
  CurveSet set;
  std::vector<SupportedCurve> curves;
  std::optional<DrawingGraph> graph;  // of a drawing, rods by their outlines
  // The same drawing with rods by their center lines.
  std::optional<DrawingGraph> with_rods;
  Times times;  // of what makes both sketch and drawing
};

// A way from photographs to 3D curves, and the threshold that is swept for its curve of precision
// and recall.
struct Method {
  std::string name;
  // Of automatic_drawer.
  std::vector<std::string> arguments;
  // Whether the sketch or the drawing is the result.
  bool draws = false;
  std::string threshold_name;
  // The options that are set to the threshold.
  std::vector<std::string> threshold_options;
  std::vector<int> thresholds;
};

// One line per method; those that share their runs follow each other and have the same thresholds.
const std::vector<Method>& Methods();

// The arguments of automatic_drawer for a data set. `max_image_size`: px, -1 = as stored, 0 = as by
// default.
std::vector<std::string> SceneArguments(const DataSet& set, const std::string& output_path,
                                        int max_image_size);

// The options of a command line of automatic_drawer, without its name. Throws OptionError.
colmap_ext::DrawerOptions DrawerOptionsOf(const std::vector<std::string>& arguments);

// Does what automatic_drawer does but write its results. Keeps the
// last run, since a sketch and a drawing may be of the same.
class Workbench {
 public:
  // `arguments`: of automatic_drawer, which photographs of which project are drawn: those of
  // `views`, which must outlive it. `cache_path`: where image curves are kept, without which times
  // are those of the command; "" = nowhere.
  Workbench(std::vector<std::string> arguments, const std::vector<View>& views,
            const std::string& cache_path, colmap_ext::Console* console)
      : scene_arguments_(std::move(arguments)),
        views_(views),
        cache_(cache_path),
        console_(console) {}

  // Throws what automatic_drawer throws, and InputError if other photographs are drawn, in tiles or
  // with cameras that are not those of the model.
  Reconstruction Run(const Method& method, std::optional<int> threshold);

 private:
  void Draw(const std::vector<std::string>& arguments);

  std::vector<std::string> scene_arguments_;
  const std::vector<View>& views_;
  ResultCache cache_;
  colmap_ext::Console* console_;
  // The last run.
  std::vector<std::string> arguments_;
  CurveSketch sketch_;
  DrawingGraph drawing_;
  Times times_;
};

}  // namespace limn::bench
