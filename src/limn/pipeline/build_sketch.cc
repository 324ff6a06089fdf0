#include "limn/pipeline/build_sketch.h"

#include "limn/paper/enhanced_sketch.h"
#include "limn/paper/original_sketch.h"

namespace limn {

const char* SketchModeName(SketchMode mode) {
  switch (mode) {
    case SketchMode::kOriginal:
      return "original";
    case SketchMode::kEnhanced:
      return "enhanced";
    case SketchMode::kSweep:
      return "sweep";
  }
  return "";
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
