#pragma once

#include <functional>
#include <string>
#include <vector>

#include "limn/edges/edge_detection.h"
#include "limn/linking/linking.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/image.h"
#include "limn/model/view.h"
#include "limn/model/view_subset.h"
#include "limn/pipeline/result_cache.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn {

// The source of the photographs. Both functions must be thread-safe.
struct ImageSource {
  std::function<Image(ViewId)> read;
  // A key that differs if the pixels that `read` returns differ, for cached results.
  std::function<std::string(ViewId)> identity;
};

struct ExtractionInput {
  const std::vector<View>& views;
  const ImageSource& images;
  // Edge maps and fragments of earlier runs, where new ones are stored. Never null.
  ResultCache* cache;
  // The requested views; the others get empty results.
  ViewSubset only = std::nullopt;
};

struct EdgeMapsResult {
  std::vector<EdgeMap> edge_maps;  // in stored pixels, before ApplyLens
  StageSummary summary;
};

struct CurvesResult {
  std::vector<ImageCurves> curves;  // in the virtual pinhole images, per view
  StageSummary summary;
};

// Edge maps of the views, stored in the cache. At most one image per thread is in memory.
EdgeMapsResult ExtractEdgeMaps(const ExtractionInput& input, const EdgeDetectionOptions& edges,
                               const RunContext& context);

// Edges and fragments of the views, mapped by their lenses. Edgels keep the detector's ids; a
// fragment is split at edgels that the lens cannot map. The cache stores the fragments. At most one
// image per thread is in memory.
CurvesResult ExtractCurves(const ExtractionInput& input, const EdgeDetectionOptions& edges,
                           const LinkingOptions& linking, const RunContext& context);

// Removes unusable edgels from fragments and link graph: fragments are cut there, runs of fewer
// than two edgels dropped, a closed fragment becomes open.
void RemoveUnusableEdgels(const std::vector<bool>& usable, ImageCurves* curves);

}  // namespace limn
