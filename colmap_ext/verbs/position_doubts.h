// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "colmap_ext/workspace/view_set.h"
#include "limn/alignment/align_drawing.h"
#include "limn/util/name_list.h"

namespace limn::colmap_ext {

// The images whose positions were left out of the fit, with their distances, m; the farthest first.
// Precondition: there is a fit.
std::vector<NamedNumber> FarPositions(const AlignmentResult& result, const ViewSet& set);

// What the positions of cameras contradict, and the images it concerns; empty if nothing.
// `lengths` are those of the alignment.
std::string PositionDoubtText(const AlignmentResult& result,
                              const std::vector<KnownLength>& lengths, const ViewSet& set);

}  // namespace limn::colmap_ext
