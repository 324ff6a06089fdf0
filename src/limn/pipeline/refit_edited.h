#pragma once

#include <functional>
#include <vector>

#include "limn/editing/apply_edits.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/curves_scene.h"
#include "limn/model/image.h"
#include "limn/model/view.h"
#include "limn/pipeline/pipeline_options.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn {

// The images that an edited drawing is fitted to.
struct RefitScene {
  const std::vector<View>& views;
  const std::vector<ImageCurves>& curves;   // per view
  std::function<Image(ViewId)> read_image;  // for the kinds of edges; may be empty
};

// Refits the links that edits have touched to the images, and describes them again: supporting
// views, sigmas, primitives, and kinds unless set by hand (RefitLinks, RefitPrimitives,
// ClassifyKinds). The cameras, all other links and the nodes that these end at stay. Dimensions
// follow the links (SnapDimensions). Warns, in the outcomes of the edits, about gaps that they
// closed where the images show no edge. Throws OptionError and Cancelled.
StageSummary RefitEdited(const RefitScene& scene, const PipelineOptions& options,
                         const RunContext& context, EditedDrawing* edited);

}  // namespace limn
