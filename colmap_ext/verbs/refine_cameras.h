// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/verbs/verb.h"

namespace limn::colmap_ext {

// camera_refiner: a model with refined cameras, without the drawing that refined them.
class RefineCamerasVerb : public Verb {
 public:
  OptionGroups Groups() const override {
    return {.linking = true,
            .sketch = true,
            .drawing = true,
            .refinement = true,
            .tiles = true,
            .overwrites = true};
  }
  void Run(const Project& project, const RunOptions& options, Console* console) override;
};

}  // namespace limn::colmap_ext
