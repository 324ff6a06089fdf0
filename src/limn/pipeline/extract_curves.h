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

// Where the photographs of the views come from. Both functions are called from several threads.
struct ImageSource {
  std::function<Image(ViewId)> read;
  // A text that differs whenever the pixels that `read` returns differ: cached results are found by
  // it.
  std::function<std::string(ViewId)> identity;
};

struct ExtractionInput {
  const std::vector<View>& views;
  const ImageSource& images;
  // Edge maps and fragments of earlier runs; what is made is kept there. Never null.
  ResultCache* cache;
  // Views that are asked for; the others get none.
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

// The edge maps of the views, which the cache keeps. At most one image per thread is in memory.
EdgeMapsResult ExtractEdgeMaps(const ExtractionInput& input, const EdgeDetectionOptions& edges,
                               const RunContext& context);

// Edges, fragments and lens of the views. Edgels keep the ids that the detector gave them; where
// the lens cannot map an edgel its fragment is split. The cache keeps the fragments. At most one
// image per thread is in memory.
CurvesResult ExtractCurves(const ExtractionInput& input, const EdgeDetectionOptions& edges,
                           const LinkingOptions& linking, const RunContext& context);

// Remove from fragments and link graph the edgels that are not usable: fragments are cut there,
// runs of fewer than two edgels vanish, a closed fragment that is cut becomes open.
void RemoveUnusableEdgels(const std::vector<bool>& usable, ImageCurves* curves);

}  // namespace limn
