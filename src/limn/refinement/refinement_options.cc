#include "limn/refinement/refinement_options.h"

#include "limn/util/errors.h"

namespace limn {

void RefinementOptions::Check() const {
  LIMN_CHECK_RANGE(num_rounds, >= 0, <= 100);
  LIMN_CHECK_RANGE(control_spacing_px, >= 1, <= 1000);
  LIMN_CHECK_RANGE(max_distance_px, > 0, <= 100);
  LIMN_CHECK_RANGE(max_angle_deg, > 0, <= 90);
  LIMN_CHECK_RANGE(support_window_px, >= 0, <= 1000);
  LIMN_CHECK_RANGE(min_window_support, >= 0, <= 1);
  LIMN_CHECK_RANGE(min_views, >= 2, <= 1e6);
  LIMN_CHECK_RANGE(robust_residual_px, >= 1e-6, <= 1000);
  LIMN_CHECK_RANGE(correlation_px, >= 1e-3, <= 1e5);
  LIMN_CHECK_RANGE(bending_sigma, >= 1e-6, <= 1e4);
  CheckOption(!refine_poses || num_rounds > 0, "refine_poses", 1, "0 when num_rounds is 0");
}

}  // namespace limn
