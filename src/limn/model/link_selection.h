#pragma once

#include <array>
#include <string>

#include "limn/model/drawing_graph.h"

namespace limn {

// Which links of a drawing to use. By default all except tentative links and the outlines of smooth
// bodies, which are not curves in space.
struct LinkSelection {
  std::array<bool, kNumLinkKinds> kinds;  // by LinkKind
  bool tentative = false;
  // Rods by their outlines, of any kind, which are what images show, instead of their center lines.
  bool rods_as_outlines = false;

  LinkSelection();
  // The default, but rods by their outlines.
  static LinkSelection AsSeen();
  bool Has(const DrawingLink& link) const;
};

// The names of kinds separated by commas, or "all" or "default". Throws OptionError for the option
// `kinds`.
std::array<bool, kNumLinkKinds> KindsFromNames(const std::string& names);

// The drawing without the other links. Nodes where two links are left stay.
DrawingGraph Selected(DrawingGraph graph, const LinkSelection& selection);

}  // namespace limn
