#pragma once

#include <optional>
#include <string>

#include "colmap_ext/options/option_parser.h"

namespace limn::colmap_ext {

// What of a drawing is on a sheet, in units of the exported file: pictures along a face, and
// sections.
struct PlanOptions {
  // How far from the face of --view face:<id> in front of it and behind it; -1: any distance.
  double depth_before = -1;
  double depth_behind = -1;
  // The height of a horizontal section in the aligned world, a number; empty: none.
  std::string section;
  // What is below the section, too.
  bool section_below = true;
  // Gaps between faces that are closed; -1: UsualGap.
  double section_gap = -1;

  void AddOptions(OptionParser* parser);
  // Throws OptionError.
  void Check() const;
  // Throws OptionError.
  std::optional<double> SectionHeight() const;
};

}  // namespace limn::colmap_ext
