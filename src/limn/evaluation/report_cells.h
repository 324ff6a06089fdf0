// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace limn {

// Cells of the tables of a report; "-" is what is absent.
std::string Cell(const std::optional<double>& value, int digits);
std::string Cell(const std::optional<int>& count);
// With one decimal.
std::string Percent(const std::optional<double>& share);

void PrintRow(const std::vector<std::string>& cells, int width, std::ostream& out);

}  // namespace limn
