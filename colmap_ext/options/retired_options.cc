// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/options/retired_options.h"

#include <algorithm>

#include "limn/util/parse_number.h"

namespace limn {
namespace {

constexpr RetiredOption kRetired[] = {
    {"EdgeDetection.fine_sigma_px", "1"},
    {"EdgeDetection.fine_noise_factor", "8"},
    {"EdgeDetection.fine_min_strength", "1"},
    {"EdgeDetection.min_run_px", "7"},
    {"EdgeDetection.strong_ratio", "1.75"},
    {"EdgeDetection.isoluminant_noise_factor", "3.5"},
    {"EdgeDetection.isoluminant_min_strength", "1.5"},
    {"EdgeDetection.isoluminant_distance_px", "3"},
    {"Linking.neighbor_radius_px", "3.5"},
    {"Linking.position_tolerance_px", "0.4"},
    {"Linking.max_position_tolerance_px", "0.8"},
    {"Linking.angle_tolerance_deg", "15"},
    {"Linking.max_curvature", "0.2"},
    {"Linking.min_curvelet_px", "3"},
    {"Linking.max_bridge_angle_deg", "25"},
    {"Linking.corner_arm_px", "5"},
    {"Linking.corner_angle_deg", "35"},
    {"Linking.junction_distance_px", "3.5"},
    {"Linking.junction_stem_px", "15"},
    {"Linking.junction_angle_deg", "30"},
    {"Linking.tangent_arm_px", "4"},
    {"ViewSelection.min_confirmation_angle_deg", "2"},
    {"ViewSelection.max_confirmation_angle_deg", "70"},
    {"ViewSelection.min_points_for_depth", "50"},
    {"ViewSelection.points_depth_widening", "2"},
    {"Sketch.min_overlap_px", "5"},
    {"Sketch.sample_spacing_px", "2"},
    {"Sketch.support_window_px", "4"},
    {"Sketch.min_window_support", "0.7"},
    {"Sketch.min_epipolar_angle_deg", "3"},
    {"Sketch.max_epipolar_angle_deg", "15"},
    {"Sketch.min_tangency_weight", "0.1"},
    {"Sketch.first_to_second_ratio", "1.5"},
    {"Sketch.depth_gate_px", "1.5"},
    {"Sketch.max_unsupported_gap_px", "2.5"},
    {"Sketch.max_interpolated_gap_px", "30"},
    {"Sketch.min_piece_length_px", "8"},
    {"Sketch.max_sweep_views", "16"},
    {"Sketch.sweep_spacing_px", "3"},
    {"Sketch.original_min_fragment_length_px", "20"},
    {"Sketch.original_min_epipolar_angle_deg", "10"},
    {"Sketch.original_min_inliers_view", "15"},
    {"Drawing.max_support_distance_px", "1"},
    {"Drawing.max_support_angle_deg", "15"},
    {"Drawing.robust_residual_px", "0.6"},
    {"Drawing.bending_sigma_px", "0.03"},
    {"Drawing.supporting_views_share", "0.25"},
    {"Drawing.min_linked_length_px", "4"},
    {"Drawing.overlap_regularity_px", "9"},
    {"Drawing.max_link_angle_deg", "25"},
    {"Drawing.averaging_tolerance_px", "0.05"},
    {"Drawing.min_seed_views", "2"},
    {"Drawing.min_traced_views", "1"},
    {"Drawing.max_tracing_gap_px", "6"},
    {"Drawing.primary_views_share", "0.1"},
    {"Drawing.min_primary_views", "2.5"},
    {"Drawing.max_primary_views", "4"},
    {"Drawing.own_views_share", "0.12"},
    {"Drawing.min_own_views", "2"},
    {"Drawing.max_own_views", "6"},
    {"Drawing.max_continuation_gap_px", "6"},
    {"Drawing.max_junction_miss_px", "4"},
    {"Drawing.min_junction_views", "3"},
    {"Drawing.min_junction_angle_deg", "25"},
    {"Drawing.covered_share", "0.8"},
    {"DrawingRefinement.control_spacing_px", "3"},
    {"DrawingRefinement.max_angle_deg", "15"},
    {"DrawingRefinement.refine_poses", "0"},
    {"DrawingRefinement.support_window_px", "6"},
    {"DrawingRefinement.min_window_support", "0.5"},
    {"DrawingRefinement.min_views", "3"},
    {"DrawingRefinement.robust_residual_px", "0.5"},
    {"DrawingRefinement.correlation_px", "4"},
    {"Belief.joined_end_evidence", "5"},
    {"Belief.min_contradicting_views", "2"},
    {"Belief.min_own_share", "0.2"},
    {"Primitives.noise_px", "0.3"},
    {"Primitives.correlation_px", "12"},
    {"Primitives.end_zone_px", "4"},
    {"Regularity.min_length_px", "20"},
    {"Surfaces.max_extension_share", "1"},
    {"Surfaces.prior_evidence", "2"},
    {"DenseFusion.side_offset_px", "4"},
    {"DenseFusion.sample_spacing_px", "1"},
    {"DenseFusion.max_occluded_share", "0.5"},
    {"DenseFusion.min_judged_share", "0.3"},
    {"DenseFusion.enough_visible_views", "3"},
};

constexpr const char* kFormerNames[] = {
    "Drawing.strong_link_views",    "Drawing.dense_link_views",  "Drawing.min_strong_links",
    "Drawing.max_averaging_rounds", "Drawing.merge_distance_px", "Drawing.min_branch_length_px",
    "Drawing.junction_distance_px",
};
// By the same index.
constexpr const char* kNewNames[] = {
    "Paper.strong_link_views",    "Paper.dense_link_views",  "Paper.min_strong_links",
    "Paper.max_averaging_rounds", "Paper.merge_distance_px", "Paper.min_branch_length_px",
    "Paper.junction_distance_px",
};

}  // namespace

std::span<const RetiredOption> RetiredOptions() { return kRetired; }

std::span<const char* const> FormerNames() { return kFormerNames; }

std::optional<std::string> FixedValue(std::string_view name) {
  const auto found = std::ranges::find(kRetired, name, &RetiredOption::name);
  if (found == std::end(kRetired)) return std::nullopt;
  return found->value;
}

std::optional<std::string> NewName(std::string_view name) {
  const auto found = std::ranges::find(kFormerNames, name);
  if (found == std::end(kFormerNames)) return std::nullopt;
  return kNewNames[found - std::begin(kFormerNames)];
}

bool IsRetiredWord(std::string_view name, std::string_view word) {
  return name == "Drawing.method" && word == "merged";
}

bool AreSameValue(const std::string& a, const std::string& b) {
  if (a == "false" || a == "true") return AreSameValue(a == "true" ? "1" : "0", b);
  if (a == b) return true;
  const std::optional<double> number = ParseNumber<double>(a);
  return number && number == ParseNumber<double>(b);
}

}  // namespace limn
