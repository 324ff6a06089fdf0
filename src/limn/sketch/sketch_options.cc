#include "limn/sketch/sketch_options.h"

#include "limn/util/errors.h"

namespace limn {

void SketchOptions::Check() const {
  view_selection.Check();
  LIMN_CHECK_RANGE(min_fragment_length_px, >= 3, <= 1e5);
  LIMN_CHECK_RANGE(min_overlap_px, >= 2, <= 1e5);
  LIMN_CHECK_RANGE(sample_spacing_px, >= 0.1, <= 1000);
  LIMN_CHECK_RANGE(max_sweep_views, >= 2, <= 1e6);
  LIMN_CHECK_RANGE(sweep_spacing_px, >= 0.1, <= 1000);
  LIMN_CHECK_RANGE(max_support_distance_px, > 0, <= 100);
  LIMN_CHECK_RANGE(max_support_angle_deg, > 0, <= 90);
  LIMN_CHECK_RANGE(support_window_px, >= 0, <= 1000);
  LIMN_CHECK_RANGE(min_window_support, > 0, <= 1);
  LIMN_CHECK_RANGE(min_supporting_views, >= 1, <= 1e6);
  LIMN_CHECK_RANGE(min_epipolar_angle_deg, >= 0, <= 90);
  LIMN_CHECK_RANGE(max_epipolar_angle_deg, >= 0, <= 90);
  LIMN_CHECK_OPTION(max_epipolar_angle_deg, > min_epipolar_angle_deg);
  LIMN_CHECK_RANGE(min_tangency_weight, >= 0, <= 1);
  if (averaging != "robust" && !AveragesAsPaper()) {
    throw OptionError("averaging: " + averaging + ": robust or paper expected");
  }
  LIMN_CHECK_RANGE(first_to_second_ratio, >= 1, <= 1e6);
  LIMN_CHECK_RANGE(depth_gate_px, > 0, <= 100);
  LIMN_CHECK_RANGE(max_unsupported_gap_px, >= 0, <= 1e4);
  LIMN_CHECK_RANGE(max_interpolated_gap_px, >= 0, <= 1e4);
  LIMN_CHECK_RANGE(min_piece_length_px, > 0, <= 1e5);
  LIMN_CHECK_RANGE(original_min_fragment_length_px, >= 3, <= 1e5);
  LIMN_CHECK_RANGE(original_min_epipolar_angle_deg, >= 0, <= 90);
  LIMN_CHECK_RANGE(original_min_inliers_view, >= 1, <= 1e9);
  LIMN_CHECK_RANGE(original_min_inliers_total, >= 0, <= 1e9);
}

}  // namespace limn
