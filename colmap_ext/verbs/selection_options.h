#pragma once

#include <string>

#include "colmap_ext/options/option_parser.h"
#include "limn/model/link_selection.h"

namespace limn::colmap_ext {

// The options by which a command selects links of a drawing.
struct SelectionOptions {
  std::string kinds = "default";
  bool tentative = false;
  bool rods_as_outlines = false;

  void AddOptions(OptionParser* parser);
  // Throws OptionError.
  LinkSelection Selection() const;
};

}  // namespace limn::colmap_ext
