// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numeric>
#include <optional>
#include <vector>

#include "limn/model/view.h"

namespace limn {

// Some of the views of a scene, ascending; all of them if not set.
using ViewSubset = std::optional<std::vector<ViewId>>;

inline std::vector<ViewId> IdsOf(const ViewSubset& subset, size_t num_views) {
  if (subset) return *subset;
  std::vector<ViewId> all(num_views);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace limn
