// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/selection_options.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace limn::colmap_ext {

void AddDetailOption(const std::string& subject, Detail* detail, OptionParser* parser) {
  std::vector<std::pair<std::string, Detail>> words;
  for (const Detail value : {Detail::kCoarse, Detail::kNormal, Detail::kAll}) {
    words.push_back({DetailName(value), value});
  }
  parser->AddOption("detail", detail, words,
                    BasicOption("what " + subject +
                                ": coarse = only curves of at least 80 px, all = texture (grain, "
                                "leaves, small print), too"));
}

void WarnOfUnknownCurves(const DrawingGraph& graph, Detail detail, Console* console) {
  if (detail != Detail::kCoarse) return;
  const auto is_known = [](const DrawingLink& link) { return link.curve_px > 0; };
  if (graph.links.empty() || std::ranges::any_of(graph.links, is_known)) return;
  console->Say(
      "WARNING: detail = coarse leaves out no short curves: the drawing, of curve_drawer or of an "
      "earlier version of limn, does not tell their lengths in px (drawing_refiner adds them)");
}

void SelectionOptions::AddOptions(OptionParser* parser) {
  parser->AddOption("kinds", &kinds,
                    BasicOption("kinds of links to use, separated by commas: edge, paint, shadow, "
                                "contour (outlines of smooth bodies), rod, texture, unknown; or "
                                "all; default = all but contour and texture"));
  AddDetailOption("to use", &detail, parser);
  parser->AddOption("tentative", &tentative, "use tentative links, too");
  parser->AddOption("rods_as_outlines", &rods_as_outlines,
                    "use the outlines of rods instead of their center lines");
}

LinkSelection SelectionOptions::Selection() const {
  LinkSelection selection;
  selection.kinds = KindsFromNames(kinds);
  selection.tentative = tentative;
  selection.rods_as_outlines = rods_as_outlines;
  selection.Set(detail);
  return selection;
}

}  // namespace limn::colmap_ext
