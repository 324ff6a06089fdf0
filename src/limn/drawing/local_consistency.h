#pragma once

#include <vector>

#include "limn/drawing/drawing_options.h"
#include "limn/drawing/samples.h"
#include "limn/util/parallel.h"

namespace limn {

// The sample of another curve with which a sample shares most edgels.
struct SampleLink {
  int other = -1;  // sample id
  int votes = 0;   // views in which both are supported by the same edgel (phi)
};

// The multiview local consistency network (ECCV 2016, section 3; MLN in the paper; ALGORITHM.md 8).
// Samples of curves from different primary views are linked if edgels support both.
struct LocalConsistency {
  // Links of sample s: links[begin[s] .. begin[s + 1]), at most one per other curve, ascending by
  // curve, each with at least dense_link_views votes.
  std::vector<size_t> begin = {0};
  std::vector<SampleLink> links;
};

// Leaves out links between samples whose directions differ by more than max_link_angle_deg, or that
// are supported by edgels side by side (two parallel bars) in as many views as agree. Time: sum
// over edgels of the square of the number of samples they support.
LocalConsistency BuildLocalConsistency(const SampleSet& samples,
                                       const std::vector<ImageCurves>& curves,
                                       const DrawingOptions& options, const RunContext& context);

}  // namespace limn
