// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/verbs/drawing_verb.h"

namespace limn::colmap_ext {

// drawing_regularizer: the drawing with exact right angles, parallel lines, planes and so on.
class RegularizeVerb : public DrawingVerb {
 public:
  OptionGroups Groups() const override { return {.regularities = true, .overwrites = true}; }
  void Prepare(RunOptions* options, Console* console) override;
  DrawingInScene Apply(const Job& job, const DrawingInScene& given) override;

 protected:
  ProvenanceKeys ProvenanceRow() const override {
    return {.taken = {"regularize", "Regularity", "Primitives"}, .dropped = {}};
  }
};

}  // namespace limn::colmap_ext
