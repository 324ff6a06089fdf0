// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/verbs/drawing_verb.h"

namespace limn::colmap_ext {

// drawing_surfacer: the drawing with the faces that its links bound.
class FindFacesVerb : public DrawingVerb {
 public:
  OptionGroups Groups() const override {
    return {.linking = true, .surfaces = true, .overwrites = true};
  }
  DrawingInScene Apply(const Job& job, const DrawingInScene& given) override;

 protected:
  ProvenanceKeys ProvenanceRow() const override { return {.taken = {"Surfaces"}, .dropped = {}}; }
};

}  // namespace limn::colmap_ext
