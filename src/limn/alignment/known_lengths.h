// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "limn/alignment/drawing_span.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// A length of the drawing that was measured in the world: of a link, or between two places.
struct KnownLength {
  DrawingSpan span;
  double meters = 0;
  std::string text;  // as it was given
};

// From texts such as "link 12 = 2.40 m" and "from 3 to 7 = 8 ft" (see ParseSpan); the units are mm,
// cm, m, in and ft. Throws OptionError for the option `known_length`.
std::vector<KnownLength> ParseKnownLengths(const std::vector<std::string>& texts);

struct LengthFit {
  double scale = 1;             // meters per unit of the drawing
  std::vector<double> lengths;  // in the drawing, in meters by this scale
  // Standard deviation of the scale, relative: the larger one of what the uncertainties of the
  // drawing leave and, for several lengths, of how far they differ; 0: unknown.
  double sigma = 0;
};

// The least-squares scale. The length of a link is that of its primitive, which does not follow the
// noise of its points; for a spline or a link without a primitive it is that of its points. Throws
// OptionError if the drawing has no such link or node, two nodes are at one place, or two lengths
// contradict each other (algorithm/alignment.md#contradictions): names the two that do most.
// Quadratic in the lengths. Preconditions: there are lengths; places of pixels are known.
LengthFit FitLengths(const DrawingGraph& graph, const std::vector<KnownLength>& lengths);

}  // namespace limn
