// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/vertex_winners.h"

#include <numeric>

namespace limn {
namespace {

// The best two at a vertex.
struct BestTotals {
  int winner = -1;
  double first = 0;
  double second = 0;

  void Add(int rival, double total) {
    if (total > first) {
      winner = rival;
      second = first;
      first = total;
    } else if (total > second) {
      second = total;
    }
  }
};

}  // namespace

std::vector<int> FindVertexWinners(const std::vector<SupportedHypothesis>& rivals,
                                   size_t num_vertices, double ratio) {
  std::vector<BestTotals> best(num_vertices);
  for (size_t r = 0; r < rivals.size(); ++r) {
    const auto& [hypothesis, support] = rivals[r];
    const double total = std::accumulate(support.weighted.begin(), support.weighted.end(), 0.0);
    for (const HypothesisSample& sample : hypothesis.samples) {
      best[sample.vertex].Add(static_cast<int>(r), total);
    }
  }
  std::vector<int> winners;
  for (const BestTotals& totals : best) {
    winners.push_back(totals.first > ratio * totals.second ? totals.winner : -1);
  }
  return winners;
}

}  // namespace limn
