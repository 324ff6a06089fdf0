#include "colmap_ext/verbs/selection_options.h"

namespace limn::colmap_ext {

void SelectionOptions::AddOptions(OptionParser* parser) {
  parser->AddOption("kinds", &kinds,
                    BasicOption("kinds of links to use, separated by commas: edge, paint, shadow, "
                                "contour (outlines of smooth bodies), unknown; or all; default = "
                                "all but contour"));
  parser->AddOption("tentative", &tentative, BasicOption("use tentative links, too"));
}

LinkSelection SelectionOptions::Selection() const {
  LinkSelection selection;
  selection.kinds = KindsFromNames(kinds);
  selection.tentative = tentative;
  return selection;
}

}  // namespace limn::colmap_ext
