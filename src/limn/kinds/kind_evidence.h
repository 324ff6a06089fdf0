// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "limn/kinds/link_profiles.h"

namespace limn {

// What the images show about the kind of a link (algorithm/kinds.md#evidence). Colors are
// logarithms of linear intensities. "Change" is that from the darker to the brighter side.
struct KindEvidence {
  int num_profiles = 0;
  int num_views = 0;  // with profiles
  // Median width of the step over that of sharp edges at this depth in the same view.
  double blur_ratio = 1;
  // Largest deviation of a channel's change from the mean of the three, of medians.
  double chroma_change = 0;
  // How much the views differ in the change, in the darker side and in the brighter side: median
  // over the views of the largest deviation of a channel from its median. 0 for one view.
  double change_spread = 0;
  double darker_spread = 0;
  double brighter_spread = 0;
  // That of the side that differs less, once all views are exposed and balanced alike.
  double steadier_spread_exposed = 0;
  // How much the change differs between neighboring places on the link: the median, of medians over
  // the views. Infinite with profiles at fewer than four places.
  double unevenness = std::numeric_limits<double>::infinity();
  // Share of its length behind other links, as a light of the scene sees it (SharesBehind).
  double share_behind = 0;
};

// Per link, from the profiles of every view. Linear time, apart from the medians.
std::vector<KindEvidence> GatherEvidence(
    size_t num_links, const std::vector<std::vector<LinkProfile>>& profiles_of_view);

}  // namespace limn
