// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include <nlohmann/json_fwd.hpp>

#include "limn/evaluation/hss.h"

namespace limn {

// What a report has of the scores (report_writers.h): a table, a header line and a row, an object.

void PrintHss(const HssScores& scores, std::ostream& out);

void WriteHssCsv(const HssScores& scores, std::ostream& out);

nlohmann::ordered_json HssAsJson(const HssScores& scores);

}  // namespace limn
