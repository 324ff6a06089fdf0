#pragma once

#include <vector>

#include "limn/drawing/draft.h"

namespace limn {

struct CleanupCounts {
  int64_t forks_cut = 0;  // ends freed that left a node alongside another link
  int64_t dissolved_nodes = 0;
  int64_t samples_pruned = 0;   // in links that were too short, hanging by one end or by none
  int64_t samples_covered = 0;  // in links that ran along another
};

// Tidy the draft until nothing changes: forks are cut (forks.h), nodes in which two links meet
// alone and go on smoothly dissolve, short links that hang by one end or by none and links that run
// along others are removed.
CleanupCounts CleanUp(const DrawingOptions& options, Draft* draft);

// The graph of a draft: free ends and loops get nodes, node positions are the mean of the incident
// ends, members, supporting views, residuals and smooth continuations are filled in. Passes
// Validate().
DrawingGraph AssembleGraph(const SampleSet& samples, const std::vector<View>& views,
                           const std::vector<ImageCurves>& curves, const DrawingOptions& options,
                           const Draft& draft);

}  // namespace limn
