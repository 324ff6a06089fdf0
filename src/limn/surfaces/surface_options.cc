#include "limn/surfaces/surface_options.h"

#include "limn/util/errors.h"

namespace limn {

void SurfaceOptions::Check() const {
  LIMN_CHECK_RANGE(min_length_px, >= 1, <= 1e4);
  LIMN_CHECK_RANGE(plane_tolerance_px, > 0, <= 100);
  LIMN_CHECK_RANGE(max_bridge_px, >= 0, <= 1e3);
  LIMN_CHECK_RANGE(max_extension_px, >= 0, <= 1e4);
  LIMN_CHECK_RANGE(max_extension_share, >= 0, <= 100);
  LIMN_CHECK_RANGE(min_width_px, >= 0, <= 1e4);
  LIMN_CHECK_RANGE(min_shown_share, > 0, <= 1);
  LIMN_CHECK_RANGE(min_views, >= 1, <= 1e4);
  LIMN_CHECK_RANGE(min_seen_share, >= 0, <= 1);
  LIMN_CHECK_RANGE(prior_evidence, >= -100, <= 100);
}

}  // namespace limn
