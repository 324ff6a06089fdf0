#pragma once

#include "limn/pipeline/pipeline_options.h"

namespace limn {

// visit(group name, options struct) for every group of the pipeline, const or not. Their options
// are listed by their structs: see util/option_fields.h.
template <typename Options, typename Visit>
void VisitGroups(Options& options, const Visit& visit) {
  visit("EdgeDetection", options.edges);
  visit("Linking", options.linking);
  visit("ViewSelection", options.sketch.view_selection);
  visit("Sketch", options.sketch);
  visit("Drawing", options.drawing);
  visit("Paper", options.paper);
  visit("DrawingRefinement", options.refinement);
  visit("Belief", options.belief);
  visit("Primitives", options.primitives);
  visit("Regularity", options.regularity);
  visit("Surfaces", options.surfaces);
  visit("Tiles", options.tiles);
}

}  // namespace limn
