// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/verbs/drawing_verb.h"

namespace limn::colmap_ext {

// drawing_refiner: the drawing fitted to all images, its links judged and described by primitives.
class RefineVerb : public DrawingVerb {
 public:
  OptionGroups Groups() const override {
    return {.linking = true, .refinement = true, .overwrites = true};
  }
  DrawingInScene Apply(const Job& job, const DrawingInScene& given) override;
  void Conclude(const Job& job, const DrawingInScene& given, const DrawingInScene& made) override;

 protected:
  ProvenanceKeys ProvenanceRow() const override {
    return {.taken = {"DrawingRefinement", "Belief", "Primitives", "regularize", "Regularity"},
            .dropped = {"Surfaces"}};  // faces end as links move
  }
};

}  // namespace limn::colmap_ext
