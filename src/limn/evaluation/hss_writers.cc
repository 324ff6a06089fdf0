// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/hss_writers.h"

#include <ostream>

#include <nlohmann/json.hpp>

#include "limn/evaluation/report_cells.h"

namespace limn {

void PrintHss(const HssScores& scores, std::ostream& out) {
  constexpr int kWidth = 11;
  constexpr int kDigits = 4;
  PrintRow({"corners", "P %", "R %", "F1 %", "edges IoU %", "HSS %"}, kWidth, out);
  PrintRow({std::to_string(scores.num_corners), Percent(scores.corner_precision),
            Percent(scores.corner_recall), Percent(scores.corner_f1), Percent(scores.edge_iou),
            Percent(scores.hss)},
           kWidth, out);
  out << "corners right " << scores.num_right_corners << " of " << scores.num_corners << ", true "
      << scores.num_true_corners << "; edges " << scores.num_edges << ", true "
      << scores.num_true_edges << "; volume " << Cell(scores.edges.first, kDigits) << " m3, true "
      << Cell(scores.edges.second, kDigits) << ", common " << Cell(scores.edges.common, kDigits)
      << " (denser lines changed the IoU by " << Cell(100 * scores.edges.share_change, 1)
      << " %)\n";
}

nlohmann::ordered_json HssAsJson(const HssScores& scores) {
  return {{"corner_f1", scores.corner_f1},
          {"edge_iou", scores.edge_iou},
          {"hss", scores.hss},
          {"corner_precision", scores.corner_precision},
          {"corner_recall", scores.corner_recall},
          {"num_corners", scores.num_corners},
          {"num_true_corners", scores.num_true_corners},
          {"num_right_corners", scores.num_right_corners},
          {"num_edges", scores.num_edges},
          {"num_true_edges", scores.num_true_edges},
          {"edge_volume", scores.edges.first},
          {"true_edge_volume", scores.edges.second},
          {"common_edge_volume", scores.edges.common},
          {"edge_iou_change", scores.edges.share_change}};
}

void WriteHssCsv(const HssScores& scores, std::ostream& out) {
  const nlohmann::ordered_json json = HssAsJson(scores);
  std::string names, values;
  for (const auto& [name, value] : json.items()) {
    names += (names.empty() ? "" : ",") + name;
    values += (values.empty() ? "" : ",") + value.dump();
  }
  out << names << '\n' << values << '\n';
}

}  // namespace limn
