#pragma once

#include <string>

#include "limn/pipeline/result_cache.h"
#include "limn/sketch/sketch.h"

namespace limn {

// To be incremented when the sketch of the same input changes, so that stored ones are made again.
constexpr int kSketchVersion = 3;

// BuildSketch with the cache (never null), which stores the sketch of every view: a stopped run
// resumes, and after a change of images or cameras only the affected views are sketched again. The
// results are the same bytes as without. The original sketch is not stored. `part` is empty, or the
// name of the part of the scene that these views form: several parts may store sketches of the same
// view.
SketchResult SketchViews(SketchMode mode, const SketchInput& input, const SketchOptions& options,
                         ResultCache* cache, const RunContext& context,
                         const std::string& part = "");

}  // namespace limn
