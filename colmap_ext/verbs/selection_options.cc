#include "colmap_ext/verbs/selection_options.h"

namespace limn::colmap_ext {

void SelectionOptions::AddOptions(OptionParser* parser) {
  parser->AddOption("kinds", &kinds,
                    BasicOption("kinds of links to use, separated by commas: edge, paint, shadow, "
                                "contour (outlines of smooth bodies), rod, unknown; or all; "
                                "default = all but contour"));
  parser->AddOption("tentative", &tentative, BasicOption("use tentative links, too"));
  parser->AddOption("rods_as_outlines", &rods_as_outlines,
                    "use the outlines of rods instead of their center lines");
}

LinkSelection SelectionOptions::Selection() const {
  LinkSelection selection;
  selection.kinds = KindsFromNames(kinds);
  selection.tentative = tentative;
  selection.rods_as_outlines = rods_as_outlines;
  return selection;
}

}  // namespace limn::colmap_ext
