// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "limn/editing/edit_outcome.h"
#include "limn/editing/edits.h"

namespace limn::colmap_ext {

// What became of edits, one outcome each: a line that counts them, then a line per edit with its
// index, a warning where it was not applied, or only in part. Of many with one outcome a line lists
// the first.
std::vector<std::string> LinesOfEdits(const std::vector<Edit>& edits,
                                      const std::vector<EditOutcome>& outcomes);

}  // namespace limn::colmap_ext
