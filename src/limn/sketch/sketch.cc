#include "limn/sketch/sketch.h"

namespace limn {

SketchResult BuildSketch(SketchMode mode, const SketchInput& input, const SketchOptions& options,
                         const RunContext& context, const ViewSketchStore* store) {
  switch (mode) {
    case SketchMode::kOriginal:
      return BuildOriginalSketch(input, options, context);
    case SketchMode::kEnhanced:
      return BuildEnhancedSketch(input, options, context, store);
    case SketchMode::kSweep:
      return BuildSweptSketch(input, options, context, store);
  }
  return {};
}

}  // namespace limn
