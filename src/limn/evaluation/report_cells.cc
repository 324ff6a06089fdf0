// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/report_cells.h"

#include <iomanip>
#include <ostream>
#include <sstream>

namespace limn {

std::string Cell(const std::optional<double>& value, int digits) {
  if (!value) return "-";
  std::ostringstream text;
  text << std::setprecision(digits) << *value;
  return text.str();
}

std::string Cell(const std::optional<int>& count) { return count ? std::to_string(*count) : "-"; }

std::string Percent(const std::optional<double>& share) {
  if (!share) return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << 100 * *share;
  return text.str();
}

void PrintRow(const std::vector<std::string>& cells, int width, std::ostream& out) {
  for (const std::string& cell : cells) out << std::setw(width) << cell << ' ';
  out << '\n';
}

}  // namespace limn
