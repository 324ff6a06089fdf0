// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/drawing/samples.h"
#include "limn/paper/paper_options.h"
#include "limn/util/parallel.h"

namespace limn {

// A sample, and the sample of another curve with which it shares the most edgels.
struct SampleLink {
  int sample = -1;
  int other = -1;
  int votes = 0;  // views in which both are supported by the same edgel (phi)
  // Samples of the other curve to which this one is strongly linked.
  int num_strong = 0;
};

// The multiview local consistency network (ECCV 2016, section 3; MLN in the paper;
// algorithm/paper.md#local-consistency-network). Samples of curves from different primary views are
// linked if edgels support both. Per curve the links of its samples, ascending by sample and other;
// a sample has at most one to each curve. Each has at least dense_link_views votes.
using LocalConsistency = std::vector<std::vector<SampleLink>>;

// Edgels of `num_views` views support the samples. Time: sum over edgels of the square of the
// number of samples they support.
LocalConsistency BuildLocalConsistency(const SampleSet& samples, size_t num_views,
                                       const PaperOptions& options, const RunContext& context);

}  // namespace limn
