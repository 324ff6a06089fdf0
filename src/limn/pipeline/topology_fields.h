#pragma once

#include "limn/topology/topology_options.h"
#include "limn/util/option_help.h"

namespace limn {

// Part of the group Drawing for users.
template <typename Visit>
void VisitFields(TopologyOptions& o, Visit&& visit) {
  visit("min_seed_views", o.min_seed_views,
        "curves are traced from where samples of this many primary views agree");
  visit("min_traced_views", o.min_traced_views, "and as long as samples of this many do");
  visit("max_tracing_gap_px", o.max_tracing_gap_px, "longest gap in a traced curve, px");
  visit("primary_views_share", o.primary_views_share,
        "mean number of primary views that must agree with a link, as a share of its views");
  visit("min_primary_views", o.min_primary_views, "lower limit of that number");
  visit("max_primary_views", o.max_primary_views, "upper limit of that number");
  visit("own_views_share", o.own_views_share,
        "else views with edgels of its own, beyond chance, as a share of its views");
  visit("min_own_views", o.min_own_views, "lower limit of that number");
  visit("max_own_views", o.max_own_views, "upper limit of that number");
  visit("min_link_length_px", o.min_link_length_px, "shorter loose links are dropped, px");
  visit("max_continuation_gap_px", o.max_continuation_gap_px,
        "longest gap when a curve is extended in the images, px");
  visit("max_junction_gap_px", o.max_junction_gap_px, "longest gap between ends that meet, px");
  visit("max_junction_miss_px", o.max_junction_miss_px,
        "largest sideways distance from their lines, px");
  visit("min_junction_views", o.min_junction_views, "views that must show the meeting");
  visit("min_junction_angle_deg", o.min_junction_angle_deg,
        "links that leave a node at a smaller angle form no junction, deg");
  visit("max_continuation_angle_deg", o.max_continuation_angle_deg,
        "two ends that turn by less continue each other, deg");
  visit("covered_share", o.covered_share, "a link is dropped if others run along this share of it");
  visit("max_short_edge_px", o.max_short_edge_px,
        "longest edge inferred from its two ends alone, px");
}

}  // namespace limn
