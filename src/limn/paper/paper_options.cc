#include "limn/paper/paper_options.h"

#include "limn/util/errors.h"

namespace limn {

void PaperOptions::Check() const {
  LIMN_CHECK_RANGE(max_support_distance_px, > 0, <= 100);
  LIMN_CHECK_RANGE(max_support_angle_deg, > 0, <= 90);
  LIMN_CHECK_RANGE(dense_link_views, >= 1, <= 1e6);
  LIMN_CHECK_RANGE(strong_link_views, >= 1, <= 1e6);
  LIMN_CHECK_OPTION(strong_link_views, >= dense_link_views);
  LIMN_CHECK_RANGE(min_strong_links, >= 1, <= 1e9);
  LIMN_CHECK_RANGE(overlap_regularity_px, >= 0, <= 1e5);
  LIMN_CHECK_RANGE(averaging_tolerance_px, >= 1e-12, <= 1000);
  LIMN_CHECK_RANGE(max_averaging_rounds, >= 0, <= 1000);
  LIMN_CHECK_RANGE(max_link_angle_deg, > 0, <= 180);
  LIMN_CHECK_RANGE(merge_distance_px, > 0, <= 100);
  LIMN_CHECK_RANGE(min_branch_length_px, >= 0, <= 1e5);
  LIMN_CHECK_RANGE(junction_distance_px, >= 0, <= 1000);
}

}  // namespace limn
