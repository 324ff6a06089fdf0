// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "bench/json.h"

namespace limn::bench {

// Cells of Markdown tables. A number that is null is "-".
using Cells = std::vector<std::string>;

std::string Fixed(const Json& number, int digits, double factor = 1);
// Of a share, with one decimal.
std::string Percent(const Json& share);
// As short as %g makes it.
std::string Short(const Json& number);
// "P / R / F" in percent of an object with precision, recall and f.
std::string Shares(const Json& row);

void PrintRow(const Cells& cells, std::ostream& out);
void PrintHead(const Cells& cells, std::ostream& out);

}  // namespace limn::bench
