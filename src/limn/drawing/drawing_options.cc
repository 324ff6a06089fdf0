#include "limn/drawing/drawing_options.h"

#include "limn/util/errors.h"

namespace limn {

void DrawingOptions::Check() const {
  if (method != "traced" && method != "merged" && !IsPaper()) {
    throw OptionError("method: " + method + ": traced, merged or paper expected");
  }
  LIMN_CHECK_RANGE(max_support_distance_px, > 0, <= 100);
  LIMN_CHECK_RANGE(max_support_angle_deg, > 0, <= 90);
  LIMN_CHECK_RANGE(robust_residual_px, >= 1e-6, <= 1000);
  LIMN_CHECK_RANGE(bending_sigma_px, >= 1e-6, <= 1e4);
  LIMN_CHECK_RANGE(supporting_views_share, >= 0, <= 1);
  LIMN_CHECK_RANGE(min_supporting_views, >= 2, <= 1e6);
  LIMN_CHECK_RANGE(max_supporting_views, >= 2, <= 1e6);
  LIMN_CHECK_OPTION(max_supporting_views, >= min_supporting_views);
  LIMN_CHECK_RANGE(dense_link_views, >= 1, <= 1e6);
  LIMN_CHECK_RANGE(strong_link_views, >= 1, <= 1e6);
  LIMN_CHECK_OPTION(strong_link_views, >= dense_link_views);
  LIMN_CHECK_RANGE(min_strong_links, >= 1, <= 1e9);
  LIMN_CHECK_RANGE(min_linked_length_px, >= 0, <= 1e5);
  LIMN_CHECK_RANGE(overlap_regularity_px, >= 0, <= 1e5);
  LIMN_CHECK_RANGE(max_link_angle_deg, > 0, <= 180);
  LIMN_CHECK_RANGE(averaging_tolerance_px, >= 1e-12, <= 1000);
  LIMN_CHECK_RANGE(max_averaging_rounds, >= 0, <= 1000);
  LIMN_CHECK_RANGE(merge_distance_px, > 0, <= 100);
  LIMN_CHECK_RANGE(min_branch_length_px, >= 0, <= 1e5);
  LIMN_CHECK_RANGE(junction_distance_px, >= 0, <= 1000);
  topology.Check();
}

}  // namespace limn
