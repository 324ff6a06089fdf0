#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "limn/edges/edge_detection.h"
#include "limn/linking/linking.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/image.h"
#include "limn/model/view.h"
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
  // Folder of edge maps and fragments of earlier runs, <cache_dir>/edges/<view name>.bin and
  // <cache_dir>/fragments/<view name>.bin. Empty = no cache.
  std::string cache_dir;
};

// How many images were found in the cache, and how many were there with other options or pixels (or
// damaged) and were computed again.
struct CacheUse {
  int64_t reused = 0;
  int64_t outdated = 0;
};

struct EdgeMapsResult {
  std::vector<EdgeMap> edge_maps;  // in stored pixels, before ApplyLens
  StageSummary summary;
  CacheUse cache;
};

struct CurvesResult {
  std::vector<ImageCurves> curves;  // in the virtual pinhole images, per view
  StageSummary summary;
  CacheUse cache;
};

// The edge maps of all views, which the cache keeps. At most one image per thread is in memory.
EdgeMapsResult ExtractEdgeMaps(const ExtractionInput& input, const EdgeDetectionOptions& edges,
                               const RunContext& context);

// Edges, fragments and lens of all views. Edgels keep the ids that the detector gave them; where
// the lens cannot map an edgel its fragment is split. The cache keeps the fragments. At most one
// image per thread is in memory.
CurvesResult ExtractCurves(const ExtractionInput& input, const EdgeDetectionOptions& edges,
                           const LinkingOptions& linking, const RunContext& context);

// A text that differs whenever cameras, poses or the ids and places of edgels and fragments differ:
// what a sketch made from these curves is valid for. Linear in the number of edgels.
std::string CurvesKey(const std::vector<View>& views, const std::vector<ImageCurves>& curves);

// Remove from fragments and link graph the edgels that are not usable: fragments are cut there,
// runs of fewer than two edgels vanish, a closed fragment that is cut becomes open.
void RemoveUnusableEdgels(const std::vector<bool>& usable, ImageCurves* curves);

}  // namespace limn
