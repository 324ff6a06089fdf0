// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace limn {

// Calls visit(begin, end) for every maximal run [begin, end) of indices below `count` for which
// is_in holds.
template <typename IsIn, typename Visit>
void ForEachRun(int count, const IsIn& is_in, const Visit& visit) {
  for (int begin = 0, k = 0; k <= count; ++k) {
    if (k < count && is_in(k)) continue;
    if (k > begin) visit(begin, k);
    begin = k + 1;
  }
}

}  // namespace limn
