// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "limn/formats/svg/sheet.h"

namespace limn {

// Size of the legend's text, pixels of the sheet.
constexpr double kLegendTextPx = 3 * 96 / 25.4;

// Writes <g id="legend"> for the lower margin of a sheet with a legend: on the left the scale and a
// bar of a round length (at most a third of the paper), on the right the directions of x, y and z
// as projected arrows of 8 mm; one along the viewing direction is a dot. Styled by the picture's
// style sheet.
void WriteLegend(const SvgSheet& sheet, std::ostream& out);

}  // namespace limn
