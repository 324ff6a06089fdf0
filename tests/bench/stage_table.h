// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "bench/json.h"

namespace limn::bench {

// A report of stages (stage_costs.h) as one Markdown table: medians of the runs and, of several,
// the smallest and the largest; precision, recall and F in percent in the first box.
void WriteStageTable(const Json& report, std::ostream& out);

}  // namespace limn::bench
