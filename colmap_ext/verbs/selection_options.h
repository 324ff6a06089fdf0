// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "colmap_ext/host/console.h"
#include "colmap_ext/options/option_parser.h"
#include "limn/model/link_selection.h"

namespace limn::colmap_ext {

// --detail, to decide what `subject` has.
void AddDetailOption(const std::string& subject, Detail* detail, OptionParser* parser);

// Says so if coarse detail is asked of a drawing that does not tell how long its curves are.
void WarnOfUnknownCurves(const DrawingGraph& graph, Detail detail, Console* console);

// The options by which a command selects links of a drawing.
struct SelectionOptions {
  std::string kinds = "default";
  Detail detail = Detail::kNormal;
  bool tentative = false;
  bool rods_as_outlines = false;

  void AddOptions(OptionParser* parser);
  // Throws OptionError.
  LinkSelection Selection() const;
};

}  // namespace limn::colmap_ext
