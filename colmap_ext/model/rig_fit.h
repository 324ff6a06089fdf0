// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>

#include "colmap_ext/model/model.h"

namespace limn::colmap_ext {

// The opposite of ApplyRigs, for images (indices) whose poses were changed one by one: fits the
// poses of frames, and of the sensors in their rigs, by least squares, first of angles, then of
// camera centers. Afterwards the poses of all mounted images are the composed ones. Reference
// sensors, and whatever none of these images determines, stay. Time: a few sparse linear
// least-squares problems.
void FitRigs(const std::set<size_t>& images, SparseModel* model);

}  // namespace limn::colmap_ext
