// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>

#include "limn/evaluation/evaluate_curves.h"

namespace limn {

// Tables for the screen: one row per tau, then the counts of the reconstruction; a table of faces
// and a line about cameras where these were compared. Absent shares are "-". If wireframes were
// compared, only the table of these.
void PrintReport(const EvaluationReport& report, std::ostream& out);

// One header line and one row per tau of the curves, or of the faces if no curves were compared, or
// one row of wireframes; absent shares are empty cells.
void WriteReportCsv(const EvaluationReport& report, std::ostream& out);

// An object with `rows`, the counts, `cameras` and `faces`; what is absent is null. Of wireframes
// it has `unit` and `hss` alone.
void WriteReportJson(const EvaluationReport& report, std::ostream& out);

}  // namespace limn
