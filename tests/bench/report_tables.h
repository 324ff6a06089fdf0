// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "bench/json.h"

namespace limn::bench {

// The report as Markdown: for every data set tables of the methods with their default options and
// of other programs' stored results in every box, what the sweep gave in the first box, EMAP's
// figures. Absent figures are "-". `report` is {"sets": [...]} with what MeasureSet gives.
void WriteTables(const Json& report, std::ostream& out);

}  // namespace limn::bench
