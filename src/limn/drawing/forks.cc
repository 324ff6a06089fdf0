#include "limn/drawing/forks.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace limn {
namespace {

struct Leaving {
  LinkEnd end;
  Eigen::Vector3d direction;  // unit, into the link
  double length_px = 0;
};

// The pair of a node's links that leave it at the smallest angle; -1, -1 if there are none.
std::pair<int, int> SharpestPair(const std::vector<Leaving>& leaving, double min_cosine) {
  std::pair<int, int> best = {-1, -1};
  double largest = min_cosine;
  for (int i = 0; i < static_cast<int>(leaving.size()); ++i) {
    for (int j = i + 1; j < static_cast<int>(leaving.size()); ++j) {
      const double cosine = leaving[i].direction.dot(leaving[j].direction);
      if (cosine <= largest) continue;
      largest = cosine;
      best = {i, j};
    }
  }
  return best;
}

// Cosine of the smallest turn from a third link of the node into link `i` of a pair, -1 if there is
// none.
double SmallestTurn(const std::vector<Leaving>& leaving, int i, int partner) {
  double cosine = -1;
  for (int k = 0; k < static_cast<int>(leaving.size()); ++k) {
    if (k == i || k == partner) continue;
    cosine = std::max(cosine, -leaving[i].direction.dot(leaving[k].direction));
  }
  return cosine;
}

}  // namespace

int64_t CutForks(const DrawingOptions& options, Draft* draft) {
  // Two turns that differ by less than this are alike, as cosines.
  constexpr double kAlike = 0.02;
  const double fork = std::cos(options.min_junction_angle_deg * M_PI / 180);
  int64_t num_freed = 0;
  for (const auto& [node, ends] : CollectEnds(*draft)) {
    std::vector<Leaving> leaving;
    for (const LinkEnd& end : ends) {
      const DraftLink& link = draft->links[end.link];
      leaving.push_back({end, -LineAtEnd(link, end.end).outward, LengthPx(link)});
    }
    while (leaving.size() > 2) {
      const auto [i, j] = SharpestPair(leaving, fork);
      if (i < 0) break;
      const double turn_i = SmallestTurn(leaving, i, j);
      const double turn_j = SmallestTurn(leaving, j, i);
      const bool keep_i = std::abs(turn_i - turn_j) > kAlike
                              ? turn_i > turn_j
                              : leaving[i].length_px >= leaving[j].length_px;
      const int freed = keep_i ? j : i;
      const LinkEnd& end = leaving[freed].end;
      draft->links[end.link].node[end.end] = -1;
      leaving.erase(leaving.begin() + freed);
      ++num_freed;
    }
  }
  return num_freed;
}

}  // namespace limn
