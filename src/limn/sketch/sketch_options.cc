#include "limn/sketch/sketch_options.h"

#include "limn/util/errors.h"

namespace limn {

void SketchOptions::Check() const {
  view_selection.Check();
  LIMN_CHECK_OPTION(min_fragment_length_px, >= 3);
  LIMN_CHECK_OPTION(min_overlap_px, >= 2);
  LIMN_CHECK_OPTION(sample_spacing_px, > 0);
  LIMN_CHECK_OPTION(max_sweep_views, >= 2);
  LIMN_CHECK_OPTION(sweep_spacing_px, > 0);
  LIMN_CHECK_OPTION(max_support_distance_px, > 0);
  LIMN_CHECK_OPTION(max_support_angle_deg, > 0);
  LIMN_CHECK_OPTION(max_support_angle_deg, <= 90);
  LIMN_CHECK_OPTION(support_window_px, >= 0);
  LIMN_CHECK_OPTION(min_window_support, > 0);
  LIMN_CHECK_OPTION(min_window_support, <= 1);
  LIMN_CHECK_OPTION(min_supporting_views, >= 1);
  LIMN_CHECK_OPTION(min_epipolar_angle_deg, >= 0);
  LIMN_CHECK_OPTION(max_epipolar_angle_deg, > min_epipolar_angle_deg);
  LIMN_CHECK_OPTION(min_tangency_weight, >= 0);
  LIMN_CHECK_OPTION(min_tangency_weight, <= 1);
  LIMN_CHECK_OPTION(depth_gate_px, > 0);
  LIMN_CHECK_OPTION(max_unsupported_gap_px, >= 0);
  LIMN_CHECK_OPTION(max_interpolated_gap_px, >= 0);
  LIMN_CHECK_OPTION(min_piece_length_px, > 0);
  LIMN_CHECK_OPTION(original_min_fragment_length_px, >= 3);
  LIMN_CHECK_OPTION(original_min_epipolar_angle_deg, >= 0);
  LIMN_CHECK_OPTION(original_min_inliers_view, >= 1);
  LIMN_CHECK_OPTION(original_min_inliers_total, >= 0);
  LIMN_CHECK_OPTION(original_first_to_second_ratio, >= 1);
}

}  // namespace limn
