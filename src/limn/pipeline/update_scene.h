#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "limn/pipeline/pipeline.h"

namespace limn {

// Bringing a drawing up to date with views that came, went or changed since it was made
// (algorithm/tiles.md#updates). Links, and views that are as they were, keep what was made of them;
// only what the changes touch is made again, so the result differs a little from a drawing made
// from nothing.

// Throws OptionError for options whose drawings depend everywhere on all views.
void CheckUpdatable(const PipelineOptions& options);
bool IsUpdatable(const PipelineOptions& options);

// Returns what keeps in the cache what an update needs to know of a finished drawing
// (PipelineResult::keep). `plans` are those of the sketch.
std::function<void()> KeeperOf(const PipelineInput& input, const std::vector<ImageCurves>& curves,
                               const std::vector<ViewPlan>& plans, const DrawingGraph& graph,
                               const PipelineOptions& options, const RunContext& context);

// Brings the drawing that was kept last up to date. Nothing if there is none
// that was made with these options, if too much has changed, or if the sketch of a view is lost;
// `why_not` is then the reason. The result has no fates.
std::optional<PipelineResult> UpdateScene(const PipelineInput& input,
                                          std::vector<ImageCurves>* curves,
                                          const PipelineOptions& options, const RunContext& context,
                                          const StageObserver& on_stage_end, std::string* why_not);

}  // namespace limn
