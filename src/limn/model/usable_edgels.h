// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/curve_fragment.h"

namespace limn {

// Removes unusable edgels from fragments: these are cut there, runs of fewer than two edgels
// dropped, a closed fragment becomes open.
void RemoveUnusableEdgels(const std::vector<bool>& usable, ImageCurves* curves);

}  // namespace limn
