// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "colmap_ext/host/job.h"
#include "colmap_ext/verbs/verb.h"

namespace limn::colmap_ext {

// curve_sketcher: unconnected curves in space.
class SketchVerb : public Verb {
 public:
  OptionGroups Groups() const override {
    return {.linking = true, .sketch = true, .overwrites = true};
  }
  void Run(const Project& project, const RunOptions& options, Console* console) override;
};

// The sketch of image curves, relative to the scene's origin; prints a summary. Precondition:
// CheckSceneViews.
CurveSketch MakeSketch(const Job& job, const std::vector<ImageCurves>& curves);

}  // namespace limn::colmap_ext
