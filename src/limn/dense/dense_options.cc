#include "limn/dense/dense_options.h"

#include "limn/util/errors.h"

namespace limn {

void DenseOptions::Check() const {
  LIMN_CHECK_OPTION(depth_tolerance_px, > 0);
  LIMN_CHECK_OPTION(side_offset_px, > 0);
  LIMN_CHECK_OPTION(near_px, > 0);
  LIMN_CHECK_OPTION(sample_spacing_px, > 0);
  LIMN_CHECK_OPTION(max_occluded_share, >= 0);
  LIMN_CHECK_OPTION(max_occluded_share, <= 1);
  LIMN_CHECK_OPTION(enough_visible_views, >= 0);
  LIMN_CHECK_OPTION(min_judged_share, >= 0);
  LIMN_CHECK_OPTION(min_judged_share, <= 1);
}

}  // namespace limn
