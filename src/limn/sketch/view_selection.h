// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "limn/model/scene_hints.h"
#include "limn/model/view.h"
#include "limn/util/option_fields.h"
#include "limn/util/option_help.h"
#include "limn/util/parallel.h"

namespace limn {

struct ViewSelectionOptions {
  // More views raise recall and time.
  int max_second_views = 10;
  // More views raise precision and time.
  int max_confirmation_views = 24;
  // The other views of such a place only confirm.
  int enough_primary_views = 9;
  // Below the smaller one depth is unreliable, above the larger one the views no longer show the
  // same edges.
  double min_pair_angle_deg = 3.0;
  double max_pair_angle_deg = 45.0;

  template <typename Self, typename Visit>
  static void VisitFields(Self& self, const Visit& visit) {
    visit("max_second_views", self.max_second_views, Between(1, 1e6),
          "views that a view is paired with");
    visit("max_confirmation_views", self.max_confirmation_views, Between(1, 32),
          "views that confirm its curves");
    visit("enough_primary_views", self.enough_primary_views, Between(1, 1e6),
          "a place seen by more views is sketched from about this many");
    visit("min_pair_angle_deg", self.min_pair_angle_deg, Above(0, 180),
          "smallest triangulation angle of a pair, deg");
    visit("max_pair_angle_deg", self.max_pair_angle_deg, Above(0, 180),
          "largest triangulation angle of a pair, deg");
  }
  // Throws OptionError.
  void Check() const;
};

// The views with which one view is matched, and its depth range.
struct ViewPlan {
  // Depths (z in the camera) in which curves are sought; empty range (min > max) when no other view
  // overlaps.
  double min_depth = 1;
  double max_depth = 0;
  // Whether the view is sketched. Otherwise it only confirms others.
  bool is_primary = true;
  std::vector<ViewId> second_views;        // best first
  std::vector<ViewId> confirmation_views;  // most useful and diverse first
};

// Message if there are fewer than 3 views, or if the cameras have fewer than 3 distinct centers
// (views of one panorama share theirs); else empty.
std::string WhyNothingIsTriangulated(const std::vector<View>& views);

// Other places than its own from which the views of a scene can confirm what one of them shows, at
// least 1, at most `enough`.
int CountOtherPlaces(const std::vector<View>& views, int enough);

// Throws InputError if nothing can be triangulated, as SelectViews does. Call it before extracting
// edges.
void CheckViews(const std::vector<View>& views);

// Chooses depth range, second views and confirmation views of every view
// (algorithm/sketch.md#view-selection): samples places on a grid of pixels and depths, keeps the
// depths that enough other views see under usable angles, scores views by how much of that they
// see, and picks them greedily with spread in angle and epipolar direction. The depths tried are
// those at the scale of the view's neighborhood (view_neighbors.h; a small scene is one
// neighborhood) and those of the sparse model's points where there are enough; points widen the
// depth range, too. Where more than enough_primary_views views see the same places, about that many
// of them are primary, evenly spread over the order of the views; in scenes whose neighbors are
// thinned, at least one in eight. At most max_second_views + max_confirmation_views per view, so
// the stages after it are linear in the number of views. Time per view: some 500 projections for
// each of at most NeighborFinder::kMaxNeighbors others.
std::vector<ViewPlan> SelectViews(const std::vector<View>& views, const SceneHints& hints,
                                  const ViewSelectionOptions& options, const RunContext& context);

// The plans of some views that join a scene whose other views are sketched already; those of the
// others are empty, and not primary. A view is primary unless enough views that are sketched see
// what it sees. Time as SelectViews, per view asked for.
std::vector<ViewPlan> PlanAddedViews(const std::vector<View>& views, const SceneHints& hints,
                                     const std::vector<ViewId>& added,
                                     const std::vector<uint8_t>& is_sketched,
                                     const ViewSelectionOptions& options,
                                     const RunContext& context);

// The views of a plan, ascending.
std::vector<ViewId> PartnersIn(const ViewPlan& plan);

// These views and those in the plans of the primary ones among them, ascending.
std::vector<ViewId> WithPartners(const std::vector<ViewId>& views,
                                 const std::vector<ViewPlan>& plans);

}  // namespace limn
