// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "limn/cache/result_cache.h"
#include "limn/edges/edge_detection.h"
#include "limn/linking/linking.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/given_edges.h"
#include "limn/model/image.h"
#include "limn/model/view.h"
#include "limn/model/view_subset.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn {

// The source of the photographs. All functions must be thread-safe.
struct ImageSource {
  std::function<Image(ViewId)> read;
  // A key that differs if what the other functions return differs, for cached results.
  std::function<std::string(ViewId)> identity;
  // Edges to use instead of detecting them in the photograph; none = detect them.
  std::function<GivenEdges(ViewId)> given_edges = nullptr;
  // Called after a loop over views: frees what the other functions keep of an image to read more
  // of it. None = they keep nothing.
  std::function<void()> release = nullptr;
};

// Called with the fragments of a view, in stored pixels, before ApplyLens. Must be thread-safe.
using FragmentsObserver = std::function<void(ViewId, const ImageCurves&)>;

struct ExtractionInput {
  const std::vector<View>& views;
  const ImageSource& images;
  // Edge maps and fragments of earlier runs, where new ones are stored. Never null.
  ResultCache* cache;
  // The requested views; the others get empty results.
  ViewSubset only = std::nullopt;
  FragmentsObserver on_fragments = nullptr;
};

struct EdgeMapsResult {
  std::vector<EdgeMap> edge_maps;  // in stored pixels, before ApplyLens
  StageSummary summary;
};

struct CurvesResult {
  std::vector<ImageCurves> curves;  // in the virtual pinhole images, per view
  StageSummary summary;
};

// Edge maps of the views, detected or given, stored in the cache. At most one image per thread is
// in memory.
EdgeMapsResult ExtractEdgeMaps(const ExtractionInput& input, const EdgeDetectionOptions& edges,
                               const RunContext& context);

// Edges and fragments of the views, found or given, mapped by their lenses. Edgels keep their ids;
// a fragment is split at edgels that the lens cannot map. The cache stores the fragments. At most
// one image per thread is in memory.
CurvesResult ExtractCurves(const ExtractionInput& input, const EdgeDetectionOptions& edges,
                           const LinkingOptions& linking, const RunContext& context);

}  // namespace limn
