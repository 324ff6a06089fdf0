// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/sketch/confirmation.h"

namespace limn {

// A hypothesis that some view supports.
struct SupportedHypothesis {
  CurveHypothesis hypothesis;
  HypothesisSupport support;
};

// Which of the hypotheses of a fragment with one second view counts at each of the fragment's
// `num_vertices` vertices, as an index: the one whose tangency weights, summed over its length, are
// more than `ratio` (at least 1) times those of every other there; -1 if there is none. Time:
// samples of the hypotheses.
std::vector<int> FindVertexWinners(const std::vector<SupportedHypothesis>& rivals,
                                   size_t num_vertices, double ratio);

}  // namespace limn
