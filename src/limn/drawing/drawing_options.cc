#include "limn/drawing/drawing_options.h"

#include "limn/util/errors.h"

namespace limn {

void DrawingOptions::Check() const {
  LIMN_CHECK_RANGE(max_support_distance_px, > 0, <= 100);
  LIMN_CHECK_RANGE(max_support_angle_deg, > 0, <= 90);
  LIMN_CHECK_RANGE(robust_residual_px, >= 1e-6, <= 1000);
  LIMN_CHECK_RANGE(bending_sigma_px, >= 1e-6, <= 1e4);
  LIMN_CHECK_RANGE(supporting_views_share, >= 0, <= 1);
  LIMN_CHECK_RANGE(min_supporting_views, >= 2, <= 1e6);
  LIMN_CHECK_RANGE(max_supporting_views, >= 2, <= 1e6);
  LIMN_CHECK_OPTION(max_supporting_views, >= min_supporting_views);
  LIMN_CHECK_RANGE(min_piece_length_px, >= 0, <= 1e5);
  topology.Check();
}

}  // namespace limn
