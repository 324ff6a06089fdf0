#include "limn/dense/dense_options.h"

#include "limn/util/errors.h"

namespace limn {

void DenseOptions::Check() const {
  LIMN_CHECK_RANGE(depth_tolerance_px, > 0, <= 1e4);
  LIMN_CHECK_RANGE(side_offset_px, > 0, <= 1e4);
  LIMN_CHECK_RANGE(near_px, > 0, <= 1000);
  LIMN_CHECK_RANGE(sample_spacing_px, >= 0.1, <= 1e4);
  LIMN_CHECK_RANGE(max_occluded_share, >= 0, <= 1);
  LIMN_CHECK_RANGE(enough_visible_views, >= 0, <= 1e6);
  LIMN_CHECK_RANGE(min_judged_share, >= 0, <= 1);
}

}  // namespace limn
