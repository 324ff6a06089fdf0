// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/build_sketch.h"

#include "limn/paper/enhanced_sketch.h"
#include "limn/paper/original_sketch.h"
#include "limn/util/name_table.h"

namespace limn {

const char* SketchModeName(SketchMode mode) {
  constexpr NameTable<SketchMode, 3> kNames = {{"original", "enhanced", "sweep"}};
  return kNames.Of(mode);
}

SketchResult BuildSketch(SketchMode mode, const SketchInput& input, const SketchOptions& options,
                         const RunContext& context, const ViewSketchStore* store) {
  switch (mode) {
    case SketchMode::kOriginal:
      return BuildOriginalSketch(input, options, context);
    case SketchMode::kEnhanced:
      return BuildEnhancedSketch(input, options, context, store);
    case SketchMode::kSweep:
      return BuildSweptSketch(input, WithSupportRule(options), context, store);
  }
  return {};
}

}  // namespace limn
