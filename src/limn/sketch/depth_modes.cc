// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/depth_modes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

// Cost of a jump of 1 px between neighbors, its cap, and the cost of starting or ending a stretch.
constexpr double kJumpCost = 2.0;
constexpr double kMaxJumpCost = 10.0;
constexpr double kBoundaryCost = 2.0;

double JumpCost(const FusedDepth& from, const FusedDepth& to, double step_px) {
  const double predicted =
      from.inverse_depth + 0.5 * step_px * (from.slope_per_px + to.slope_per_px);
  const double jump_px = std::abs(to.inverse_depth - predicted) * to.px_per_inverse_depth;
  return std::min(kJumpCost * jump_px * jump_px, kMaxJumpCost);
}

}  // namespace

std::vector<int> ChooseModes(const FragmentRays& fragment,
                             const std::vector<std::vector<DepthMode>>& modes) {
  const size_t count = modes.size();
  // State 0 is "no depth", state m + 1 is mode m.
  std::vector<std::vector<double>> score(count);
  std::vector<std::vector<int>> previous(count);
  for (size_t i = 0; i < count; ++i) {
    const size_t num_states = modes[i].size() + 1;
    score[i].assign(num_states, 0);
    previous[i].assign(num_states, 0);
    for (size_t s = 0; s < num_states; ++s) {
      const double gain = s == 0 ? 0 : modes[i][s - 1].score;
      if (i == 0) {
        score[i][s] = gain;
        continue;
      }
      double best = -std::numeric_limits<double>::infinity();
      for (size_t p = 0; p < score[i - 1].size(); ++p) {
        double cost = 0;
        if ((p == 0) != (s == 0)) cost = kBoundaryCost;
        if (p > 0 && s > 0) {
          cost = JumpCost(modes[i - 1][p - 1].depth, modes[i][s - 1].depth,
                          fragment.arc_px[i] - fragment.arc_px[i - 1]);
        }
        const double total = score[i - 1][p] - cost;
        if (total > best) {
          best = total;
          previous[i][s] = static_cast<int>(p);
        }
      }
      score[i][s] = best + gain;
    }
  }
  std::vector<int> chosen(count, -1);
  if (count == 0) return chosen;
  int state = static_cast<int>(std::max_element(score.back().begin(), score.back().end()) -
                               score.back().begin());
  for (size_t i = count; i-- > 0;) {
    chosen[i] = state - 1;
    state = previous[i][state];
  }
  return chosen;
}

}  // namespace limn
