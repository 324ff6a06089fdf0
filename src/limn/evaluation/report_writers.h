#pragma once

#include <iosfwd>
#include <string>

#include "limn/evaluation/evaluate_curves.h"

namespace limn {

// A table for the screen: one row per tau, then the counts of the reconstruction. Absent shares are
// "-".
void PrintReport(const EvaluationReport& report, std::ostream& out);

// One header line and one row per tau; absent shares are empty cells.
void WriteReportCsv(const EvaluationReport& report, std::ostream& out);

// An object with `rows` and the counts; absent shares are null.
void WriteReportJson(const EvaluationReport& report, std::ostream& out);

}  // namespace limn
