// SPDX-License-Identifier: BSD-3-Clause
#include "bench/markdown.h"

#include <cstdio>
#include <ostream>

namespace limn::bench {

std::string Fixed(const Json& number, int digits, double factor) {
  if (number.is_null()) return "-";
  char text[40];
  std::snprintf(text, sizeof(text), "%.*f", digits, factor * number.get<double>());
  return text;
}

std::string Percent(const Json& share) { return Fixed(share, 1, 100); }

std::string Short(const Json& number) {
  char text[40];
  std::snprintf(text, sizeof(text), "%g", number.get<double>());
  return text;
}

std::string Shares(const Json& row) {
  return Percent(row["precision"]) + " / " + Percent(row["recall"]) + " / " + Percent(row["f"]);
}

void PrintRow(const Cells& cells, std::ostream& out) {
  out << '|';
  for (const std::string& cell : cells) out << ' ' << cell << " |";
  out << '\n';
}

void PrintHead(const Cells& cells, std::ostream& out) {
  PrintRow(cells, out);
  PrintRow(Cells(cells.size(), "---"), out);
}

}  // namespace limn::bench
