// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "colmap_ext/host/run_options.h"
#include "colmap_ext/verbs/align.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "colmap_ext/verbs/truth_input.h"

namespace limn::colmap_ext {

// The options of automatic_drawer.
struct DrawerOptions {
  RunOptions run;
  // Report what became of every edgel.
  bool account = false;
  // Draw again whenever the workspace changes, until interrupted.
  bool watch = false;
  // Write drawing.html with a report, judged by this truth if there is one.
  bool page = true;
  ResultOptions results;
  TruthInput truth;
  AlignOptions align;

  // Throws OptionError.
  void Check() const;
  // Sets what follows from other options.
  void SetDerived();
};

// Like ParseRunOptions.
std::optional<OptionParser> ParseDrawerOptions(const char* heading, int argc,
                                               const char* const* argv, DrawerOptions* options);

}  // namespace limn::colmap_ext
