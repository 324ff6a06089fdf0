// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/measures/supported_curve.h"
#include "bench/scene.h"
#include "bench/stopwatch.h"
#include "limn/model/curve_set.h"
#include "limn/model/drawing_graph.h"
#include "limn/pipeline/pipeline_options.h"
#include "limn/sketch/sketch.h"
#include "limn/util/parallel.h"

namespace limn::bench {

// What a method made of a scene.
struct Reconstruction {
  CurveSet set;
  std::vector<SupportedCurve> curves;
  std::optional<DrawingGraph> graph;  // of a drawing, rods by their outlines
  // The same drawing with rods by their center lines.
  std::optional<DrawingGraph> with_rods;
  Times times;  // from image curves on
};

// A way from image curves to 3D curves, and the threshold that is swept for its curve of precision
// and recall.
struct Method {
  std::string name;
  // As automatic_drawer takes them.
  std::vector<std::string> arguments;
  // Whether the sketch or the drawing is the result.
  bool draws = false;
  std::string threshold_name;
  // The options that are set to the threshold.
  std::vector<std::string> threshold_options;
  std::vector<int> thresholds;
};

// One line per method.
const std::vector<Method>& Methods();

// The options of a method, with its threshold unless absent. Throws OptionError for a method with
// options of edges or linking, since all methods begin with the same image curves.
PipelineOptions OptionsOf(const Method& method, std::optional<int> threshold);

// Runs methods on one scene; keeps the last sketch, since several methods begin with the same one.
class Workbench {
 public:
  // Both must outlive it.
  Workbench(const Scene& scene, const RunContext& context) : scene_(scene), context_(context) {}

  // The times include those of the sketch, whether it was made now or before.
  Reconstruction Run(const Method& method, std::optional<int> threshold);

 private:
  void MakeSketch(const PipelineOptions& options);

  const Scene& scene_;
  const RunContext& context_;
  std::string options_text_;  // of the last sketch
  CurveSketch sketch_;
  Times sketch_times_;
};

}  // namespace limn::bench
