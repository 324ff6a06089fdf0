#pragma once

#include <string>
#include <vector>

#include "bench/data_sets.h"
#include "bench/measure.h"
#include "bench/scene.h"
#include "colmap_ext/host/console.h"
#include "limn/refinement/refinement.h"

namespace limn::bench {

// The sample scene by day, to be drawn with other cameras than the true ones.
struct SampleStudy {
  DataSet set;
  Truth truth;
  Scene scene;  // with the true cameras
  // On the true curves, 5 cm apart.
  std::vector<Eigen::Vector3d> truth_points;
};

// The image curves are cached below `output_path`. Without `use_points` the scene has no hints.
// Throws IoError.
SampleStudy LoadSampleStudy(const std::string& output_path, bool use_points,
                            colmap_ext::Console* console);

// With default options, not refined.
DrawingGraph Draw(const SampleStudy& study, const std::vector<View>& views,
                  const RunContext& context);

DrawingGraph Refine(const SampleStudy& study, const std::vector<View>& views,
                    const DrawingGraph& graph, const RunContext& context);

// What MeasureAgainstTruth says of a drawing that was made with these views, after the similarity
// that best aligns their centers with the true ones.
Json MeasureAligned(const SampleStudy& study, const std::vector<View>& views,
                    const DrawingGraph& graph, const RunContext& context);

}  // namespace limn::bench
