#include "limn/drawing/drawing_options.h"

#include "limn/util/errors.h"

namespace limn {

void DrawingOptions::Check() const {
  if (method != "traced" && method != "paper") {
    throw OptionError("method: " + method + ": traced or paper expected");
  }
  LIMN_CHECK_OPTION(max_support_distance_px, > 0);
  LIMN_CHECK_OPTION(max_support_angle_deg, > 0);
  LIMN_CHECK_OPTION(max_support_angle_deg, <= 90);
  LIMN_CHECK_OPTION(robust_residual_px, > 0);
  LIMN_CHECK_OPTION(bending_sigma_px, > 0);
  LIMN_CHECK_OPTION(supporting_views_share, >= 0);
  LIMN_CHECK_OPTION(supporting_views_share, <= 1);
  LIMN_CHECK_OPTION(min_supporting_views, >= 2);
  LIMN_CHECK_OPTION(max_supporting_views, >= min_supporting_views);
  LIMN_CHECK_OPTION(dense_link_views, >= 1);
  LIMN_CHECK_OPTION(strong_link_views, >= dense_link_views);
  LIMN_CHECK_OPTION(min_linked_length_px, >= 0);
  LIMN_CHECK_OPTION(overlap_regularity_px, >= 0);
  LIMN_CHECK_OPTION(max_link_angle_deg, > 0);
  LIMN_CHECK_OPTION(averaging_tolerance_px, > 0);
  LIMN_CHECK_OPTION(max_averaging_rounds, >= 0);
  LIMN_CHECK_OPTION(max_averaging_rounds, <= 1000);
  LIMN_CHECK_OPTION(merge_distance_px, > 0);
  LIMN_CHECK_OPTION(min_branch_length_px, >= 0);
  LIMN_CHECK_OPTION(junction_distance_px, >= 0);
  topology.Check();
}

}  // namespace limn
