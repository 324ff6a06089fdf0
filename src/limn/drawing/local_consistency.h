#pragma once

#include <vector>

#include "limn/drawing/drawing_options.h"
#include "limn/drawing/samples.h"
#include "limn/util/parallel.h"

namespace limn {

// A sample and the sample of another curve that it shares most edgels with.
struct SampleLink {
  int other = -1;  // sample id
  int votes = 0;   // views in which both are supported by the same edgel (phi)
};

// The multiview local consistency network (ECCV 2016, section 4; MLN in the paper): samples of
// curves from different primary views are linked when image edgels support both.
struct LocalConsistency {
  // Links of sample s: links[begin[s] .. begin[s + 1]), one per other curve, ascending by curve;
  // only dense ones, that is with at least dense_link_views votes.
  std::vector<size_t> begin = {0};
  std::vector<SampleLink> links;
};

// Links whose directions differ by more than max_link_angle_deg, or that in as many views as agree
// are supported by edgels lying side by side (two bars close to each other), are left out. Every
// edgel is visited by all samples it supports: O(sum over edgels of their number squared).
LocalConsistency BuildLocalConsistency(const SampleSet& samples,
                                       const std::vector<ImageCurves>& curves,
                                       const DrawingOptions& options, const RunContext& context);

}  // namespace limn
