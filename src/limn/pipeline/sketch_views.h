// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "limn/cache/result_cache.h"
#include "limn/model/curve3d.h"
#include "limn/pipeline/build_sketch.h"

namespace limn {

// Increment it when the sketch of the same input changes, so that stored ones are remade.
constexpr int kSketchVersion = 7;

// BuildSketch with the cache (never null), which stores the sketch of every view: a stopped run
// resumes, and after a change of images or cameras only the affected views are sketched again. The
// results are the same bytes as without. The original sketch is not stored. `part` is empty, or the
// name of the part of the scene that these views form: several parts may store sketches of the same
// view.
SketchResult SketchViews(SketchMode mode, const SketchInput& input, const SketchOptions& options,
                         ResultCache* cache, const RunContext& context,
                         const std::string& part = "");

// What a stored sketch of a view was made from.
struct SketchIdentity {
  // The view and those in its plan, ascending. The file counts views by this list, so that views
  // that the sketch does not depend on may come and go.
  std::vector<ViewId> views;
  std::string key;

  // Place in the list.
  ViewId PlaceOf(ViewId view) const;
};

// Of the sketch that SketchViews makes of the view with this plan. `view_keys` are the ViewKeys of
// the input.
SketchIdentity IdentityOfSketch(SketchMode mode, const SketchInput& input,
                                const SketchOptions& options, ViewId view, const ViewPlan& plan,
                                const std::vector<std::string>& view_keys);

// Gives the views of curves new ids, `new_ids[old id]`, which must be ascending where they are not
// negative. Edgels of views with a negative one are dropped.
void RenumberViews(const std::vector<ViewId>& new_ids, std::vector<Curve3D>* curves);

// New ids by old ones: the places in this list; -1 for views that are not in it.
std::vector<ViewId> PlacesIn(const std::vector<ViewId>& views, size_t num_views);

}  // namespace limn
