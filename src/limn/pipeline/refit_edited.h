// SPDX-License-Identifier: BSD-3-Clause
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

// Refits the links that edits have touched to the images, and describes them again: supporting
// views, sigmas, primitives, and kinds unless set by hand (RefitLinks, RefitPrimitives,
// ClassifyKinds, MarkTexture). The cameras, all other links and the nodes that these end at stay.
// Dimensions follow the links (SnapDimensions). Warns, in the outcomes of the edits, about gaps
// that they closed where the images show no edge. `read_image`, which may be empty, is for the
// kinds. Throws OptionError and Cancelled.
StageSummary RefitEdited(const CurvesScene& scene, const std::function<Image(ViewId)>& read_image,
                         const PipelineOptions& options, const RunContext& context,
                         EditedDrawing* edited);

}  // namespace limn
