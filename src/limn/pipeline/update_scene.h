// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "limn/pipeline/drawing_stages.h"
#include "limn/pipeline/pipeline_input.h"

namespace limn {

// Brings a drawing up to date with views that were added, removed or changed since it was made
// (algorithm/tiles.md#updates). Unchanged links and views keep their results; only what the changes
// touch is redone, so the result differs slightly from a drawing made from scratch.

// Throws OptionError for options that make every part of a drawing depend on all views.
void CheckUpdatable(const PipelineOptions& options);
bool IsUpdatable(const PipelineOptions& options);

// Returns the function that stores in the cache what an update needs to know about a finished
// drawing (PipelineResult::keep). `plans` are those of the sketch.
std::function<void()> RecordWriter(const PipelineInput& input,
                                   const std::vector<ImageCurves>& curves,
                                   const std::vector<ViewPlan>& plans, const DrawingGraph& graph,
                                   const PipelineOptions& options, const RunContext& context);

// Brings the drawing stored last up to date. Nothing if none was made with these options, if too
// much has changed, or if the sketch of a view is missing; `why_not` is then the reason. The result
// has no fates.
std::optional<PipelineResult> UpdateScene(const PipelineInput& input,
                                          std::vector<ImageCurves>* curves,
                                          const PipelineOptions& options, const RunContext& context,
                                          const StageObserver& on_stage_end, std::string* why_not);

}  // namespace limn
