#pragma once

#include "limn/surfaces/surface_options.h"
#include "limn/util/option_help.h"

namespace limn {

// The group Surfaces.
template <typename Visit>
void VisitFields(SurfaceOptions& o, Visit&& visit) {
  visit("min_length_px", o.min_length_px, "shorter links bound no face, px");
  visit("plane_tolerance_px", o.plane_tolerance_px,
        "the links of a face are within this of its plane, px");
  visit("max_bridge_px", o.max_bridge_px,
        "longest gap between links that is bridged where a face needs it, px");
  visit("max_extension_px", o.max_extension_px,
        "longest straight extension of a link to another, px");
  visit("max_extension_share", o.max_extension_share, "the same as a share of the link's length");
  visit("min_width_px", o.min_width_px, "narrower faces are left out, px");
  visit("min_shown_share", o.min_shown_share,
        "share of the border around a place that a view must show to see the place");
  visit("min_views", o.min_views, "views that must see a place of a face");
  visit("min_seen_share", o.min_seen_share, "share of the places of a face that must be seen");
  visit("prior_evidence", o.prior_evidence,
        "evidence of occlusion that every face begins with, natural logarithm");
}

}  // namespace limn
