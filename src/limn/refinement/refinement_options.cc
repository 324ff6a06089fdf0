#include "limn/refinement/refinement_options.h"

#include "limn/util/errors.h"

namespace limn {

void RefinementOptions::Check() const {
  LIMN_CHECK_OPTION(num_rounds, >= 0);
  LIMN_CHECK_OPTION(num_rounds, <= 100);
  LIMN_CHECK_OPTION(control_spacing_px, >= 1);
  LIMN_CHECK_OPTION(max_distance_px, > 0);
  LIMN_CHECK_OPTION(max_angle_deg, > 0);
  LIMN_CHECK_OPTION(max_angle_deg, <= 90);
  LIMN_CHECK_OPTION(support_window_px, >= 0);
  LIMN_CHECK_OPTION(min_window_support, >= 0);
  LIMN_CHECK_OPTION(min_window_support, <= 1);
  LIMN_CHECK_OPTION(min_views, >= 2);
  LIMN_CHECK_OPTION(robust_residual_px, > 0);
  LIMN_CHECK_OPTION(correlation_px, > 0);
  LIMN_CHECK_OPTION(bending_sigma, > 0);
  CheckOption(!refine_poses || num_rounds > 0, "refine_poses", 1, "0 when num_rounds is 0");
}

}  // namespace limn
