// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "limn/model/drawing_graph.h"

namespace limn {

// The line that a straight link follows: its primitive, or, before primitives are fitted, its chord
// if the points are within 1 % of its length from it. Nothing for other links. Linear time.
std::optional<LineSegment> LineOf(const DrawingLink& link);

}  // namespace limn
