// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "colmap_ext/options/option_parser.h"

namespace limn::colmap_ext {

// Which part of a drawing a sheet shows, in units of the exported file: pictures along a face, and
// sections.
struct PlanOptions {
  // Depth shown in front of and behind the face of --view face:<id>; -1: unlimited.
  double depth_before = -1;
  double depth_behind = -1;
  // The height of a horizontal section in the aligned world, a number; empty: none.
  std::string section;
  // Also draw what is below the section.
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
