// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace limn {

// Vertices of image curves are about a pixel apart in each view that sees an edge. A third of them
// say as much (algorithm/drawing.md#what-was-measured): the swept sketch has no more samples, and
// of other sketches the drawing takes no more.
constexpr int kVerticesPerSample = 3;

}  // namespace limn
