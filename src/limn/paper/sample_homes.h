// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <compare>
#include <limits>
#include <vector>

#include "limn/geometry/spatial_index.h"
#include "limn/model/view.h"
#include "limn/paper/curve_consistency.h"
#include "limn/paper/merging_primitives.h"

namespace limn {

// Finds the vertices that stand for samples (their homes), and the places where curves meet links
// or themselves (algorithm/paper.md#order-and-homes). Holds references.
class SampleHomes {
 public:
  SampleHomes(const SampleSet& samples, const CurveConsistency& network,
              const std::vector<View>& views, const PaperOptions& options,
              const MergingPrimitives& primitives);

  // The existing vertex that stands for a sample; -1 if there is none.
  int Find(int sample) const;

  // Gives the samples of an open curve that have no home one among its earlier samples, where it
  // runs along itself in the same direction. `homes[k]` belongs to its sample k.
  void FindOwn(int curve, std::vector<int>* homes) const;

  // The sample in an open curve's own interior that its first or last sample runs into at an angle;
  // -1 if there is none.
  int FindAhead(int sample) const;

  // Per link that a curve touches where it leaves or rejoins links, one vertex, the home first: the
  // others are less than twice as far from the sample.
  std::vector<int> FindTouched(int sample, int home) const;

 private:
  // A vertex that may stand for a sample. The nearest is the best.
  struct Candidate {
    double squared_distance = std::numeric_limits<double>::infinity();
    int vertex = -1;

    auto operator<=>(const Candidate&) const = default;
  };

  Candidate CandidateFor(int sample, int vertex) const;
  bool IsAlong(int sample, int vertex) const;
  bool Covers(int sample, const Candidate& best) const;
  bool MayMerge(int sample, int vertex) const;
  double ReprojectedDistancePx(int sample, int vertex) const;

  const SampleSet& samples_;
  const CurveConsistency& network_;
  const std::vector<View>& views_;
  const PaperOptions& options_;
  const MergingPrimitives& primitives_;
  SpatialIndex index_;  // of the samples; only some are vertices
};

}  // namespace limn
