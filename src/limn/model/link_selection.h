// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "limn/model/drawing_graph.h"

namespace limn {

// How much of a drawing to show.
enum class Detail {
  kCoarse,  // curves of at least 80 px, no texture
  kNormal,  // no texture
  kAll,
};
constexpr int kNumDetails = 3;

// "coarse", "normal", "all".
const char* DetailName(Detail detail);
// Throws OptionError for the option `detail`.
Detail DetailFromName(const std::string& name);

// Which links of a drawing to use. By default all except tentative links, texture and the outlines
// of smooth bodies, which are not curves in space.
struct LinkSelection {
  std::array<bool, kNumLinkKinds> kinds;  // by LinkKind
  bool tentative = false;
  // Rods by their outlines, of any kind, which are what images show, instead of their center lines.
  bool rods_as_outlines = false;
  // Of the curve that a link is a part of; unknown lengths pass.
  double min_curve_px = 0;

  LinkSelection();
  // The default, but rods by their outlines.
  static LinkSelection AsSeen();
  // kAll adds texture, kCoarse leaves it out, kNormal changes nothing.
  void Set(Detail detail);
  bool Has(const DrawingLink& link) const;
};

// The names of kinds separated by commas, or "all" or "default". Throws OptionError for the option
// `kinds`.
std::array<bool, kNumLinkKinds> KindsFromNames(const std::string& names);

// The drawing without the other links, with the numbers that links and nodes had. Nodes where two
// links are left stay.
DrawingGraph Selected(DrawingGraph graph, const LinkSelection& selection);

}  // namespace limn
