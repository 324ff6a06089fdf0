// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/primitives/link_samples.h"

namespace limn {

// New shapes of some links, world units; the ends of several at one node coincide.
using NewShapes = std::vector<std::optional<CurveShape>>;

// Gives links their new shapes, and moves nodes, points and the shapes of other links along; drops
// the faces bounded by links whose points moved. `samples` are per link.
void ApplyShapes(const NewShapes& shapes, const std::vector<LinkSamples>& samples,
                 DrawingGraph* graph);

// How far the ends of links with new shapes move, as their images see it, px; only those that do.
std::vector<double> MovesPx(const DrawingGraph& before, const NewShapes& shapes,
                            const std::vector<LinkSamples>& samples);

}  // namespace limn
