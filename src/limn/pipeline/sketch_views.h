#pragma once

#include <string>

#include "limn/pipeline/result_cache.h"
#include "limn/sketch/sketch.h"

namespace limn {

// To be raised whenever the sketch of the same input changes, so that kept ones are made again.
constexpr int kSketchVersion = 3;

// BuildSketch by way of the cache (never null), which keeps the sketch of every view: a run that
// was stopped goes on where it was, and after a change of images or cameras only the views that it
// touches are sketched again. Results are the same bytes as without. The original sketch is not
// kept. `part` is empty, or the name of the part of the scene that these views are: parts keep
// sketches of the same view.
SketchResult SketchViews(SketchMode mode, const SketchInput& input, const SketchOptions& options,
                         ResultCache* cache, const RunContext& context,
                         const std::string& part = "");

}  // namespace limn
