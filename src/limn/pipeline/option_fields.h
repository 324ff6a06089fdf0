#pragma once

#include "limn/dense/dense_options.h"
#include "limn/pipeline/pipeline_options.h"
#include "limn/pipeline/surface_fields.h"
#include "limn/pipeline/topology_fields.h"
#include "limn/util/option_help.h"

namespace limn {

// The fields of every options struct, in order: visit(name, field, help). `field` is a reference to
// a double, int, bool or std::string, `help` an OptionHelp or its text. The only list of options:
// command line, ini files, cache keys and provenance are made from it. Nested structs are groups of
// their own: see VisitGroups.

template <typename Visit>
void VisitFields(EdgeDetectionOptions& o, Visit&& visit) {
  visit("channel", o.channel, "channel of positions and directions: green, luminance or color");
  visit("sigma_px", o.sigma_px, "scale of the Gaussian derivatives, px");
  visit("fine_sigma_px", o.fine_sigma_px, "finer scale for strong edges, px, 0 = none");
  visit("fine_noise_factor", o.fine_noise_factor, "noise_factor at the finer scale");
  visit("fine_min_strength", o.fine_min_strength, "min_strength at the finer scale");
  visit("noise_factor", o.noise_factor, "weakest edge in multiples of the image's gradient noise");
  visit("min_strength", o.min_strength, BasicOption("weakest edge, gray levels per px"));
  visit("min_run_px", o.min_run_px, "shortest run of edgels that keeps weak ones, px");
  visit("strong_ratio", o.strong_ratio, "edgels above this multiple of the threshold need no run");
  visit("find_isoluminant", o.find_isoluminant, "also find edges in red or blue only");
  visit("isoluminant_noise_factor", o.isoluminant_noise_factor, "noise_factor in red and blue");
  visit("isoluminant_min_strength", o.isoluminant_min_strength, "min_strength in red and blue");
  visit("isoluminant_distance_px", o.isoluminant_distance_px,
        "red and blue edgels within this of a similar main one are dropped, px");
  visit("texture_density", o.texture_density,
        "short edgels per px^2 from which texture is not linked, 0 = all are linked");
  visit("margin_px", o.margin_px, "unused border of the image, px");
}

template <typename Visit>
void VisitFields(RidgeOptions& o, Visit&& visit) {
  visit("min_probability", o.min_probability,
        "edges_path: weakest edge in maps, share of their full range");
  visit("sigma_px", o.sigma_px, "edges_path: scale at which maps are smoothed, px");
}

template <typename Visit>
void VisitFields(LinkingOptions& o, Visit&& visit) {
  visit("neighbor_radius_px", o.neighbor_radius_px, "neighborhood of a curvelet, px");
  visit("position_tolerance_px", o.position_tolerance_px, "curvelets: tolerance across, px");
  visit("max_position_tolerance_px", o.max_position_tolerance_px,
        "largest tolerance, for uncertain edgels, px");
  visit("angle_tolerance_deg", o.angle_tolerance_deg, "curvelets: tolerance on directions, deg");
  visit("max_curvature", o.max_curvature, "largest curvature of a curvelet, 1/px");
  visit("min_curvelet_px", o.min_curvelet_px, "shortest curvelet that links, px");
  visit("forks", o.forks, "how forks are decided: best (links) or hypotheses (fragments)");
  visit("max_bridge_px", o.max_bridge_px, "longest gap over which fragments are joined, px");
  visit("max_bridge_angle_deg", o.max_bridge_angle_deg, "largest turn at such a gap, deg");
  visit("corner_arm_px", o.corner_arm_px, "length of the arms that show a corner, px");
  visit("corner_angle_deg", o.corner_angle_deg, "fragments break at larger turns, deg");
  visit("junction_distance_px", o.junction_distance_px,
        "an end this near to another fragment breaks it, px");
  visit("junction_stem_px", o.junction_stem_px, "shortest fragment that breaks another, px");
  visit("junction_angle_deg", o.junction_angle_deg, "smallest angle between the two, deg");
  visit("min_length_px", o.min_length_px, "shorter fragments are dropped, px");
  visit("tangent_arm_px", o.tangent_arm_px,
        "directions are fitted to this length on either side, px");
}

template <typename Visit>
void VisitFields(ViewSelectionOptions& o, Visit&& visit) {
  visit("max_second_views", o.max_second_views, "views that a view is paired with");
  visit("max_confirmation_views", o.max_confirmation_views, "views that confirm its curves");
  visit("enough_primary_views", o.enough_primary_views,
        "a place seen by more views is sketched from about this many");
  visit("min_pair_angle_deg", o.min_pair_angle_deg, "smallest triangulation angle of a pair, deg");
  visit("max_pair_angle_deg", o.max_pair_angle_deg, "largest triangulation angle of a pair, deg");
  visit("min_confirmation_angle_deg", o.min_confirmation_angle_deg,
        "smallest angle of a confirmation view, deg");
  visit("max_confirmation_angle_deg", o.max_confirmation_angle_deg,
        "largest angle of a confirmation view, deg");
  visit("min_points_for_depth", o.min_points_for_depth,
        "3D points of a view needed to use them for its depth range");
  visit("points_depth_widening", o.points_depth_widening,
        "factor by which the points' depth range is widened");
}

template <typename Visit>
void VisitFields(SketchOptions& o, Visit&& visit) {
  visit("min_fragment_length_px", o.min_fragment_length_px,
        "shorter fragments are not matched, px");
  visit("min_overlap_px", o.min_overlap_px, "shortest stretch that two fragments share, px");
  visit("sample_spacing_px", o.sample_spacing_px, "spacing of samples with depths, px");
  visit("max_support_distance_px", o.max_support_distance_px,
        "largest distance of a supporting edgel across the edge, px");
  visit("max_support_angle_deg", o.max_support_angle_deg, "and within this angle, deg");
  visit("support_window_px", o.support_window_px, "half length of the window of local support, px");
  visit("min_window_support", o.min_window_support, "share of the window that must be supported");
  visit("min_supporting_views", o.min_supporting_views,
        "confirmation views that must support a sample");
  visit("min_epipolar_angle_deg", o.min_epipolar_angle_deg,
        "below this angle to the epipolar line a view has the least weight, deg");
  visit("max_epipolar_angle_deg", o.max_epipolar_angle_deg,
        "above this angle it has full weight, deg");
  visit("min_tangency_weight", o.min_tangency_weight, "the least weight");
  visit("averaging", o.averaging, "enhanced mode: robust, or paper: the paper's section 2");
  visit("first_to_second_ratio", o.first_to_second_ratio,
        "original mode, averaging paper: support of the best match over that of the next");
  visit("depth_gate_px", o.depth_gate_px, "reconstructions of an edgel within this agree, px");
  visit("max_unsupported_gap_px", o.max_unsupported_gap_px, "longest unsupported gap, px");
  visit("max_interpolated_gap_px", o.max_interpolated_gap_px,
        "longest epipolar-tangent stretch to interpolate, px");
  visit("min_piece_length_px", o.min_piece_length_px, "shorter curves are dropped, px");
  visit("max_sweep_views", o.max_sweep_views, "sweep mode: views used to find depths");
  visit("sweep_spacing_px", o.sweep_spacing_px, "sweep mode: spacing of the samples, px");
  visit("original_min_fragment_length_px", o.original_min_fragment_length_px,
        "original mode: shorter fragments are not matched, px");
  visit("original_min_epipolar_angle_deg", o.original_min_epipolar_angle_deg,
        "original mode: curves are cut where nearer to epipolar lines, deg");
  visit("original_min_inliers_view", o.original_min_inliers_view,
        "original mode: inlier edgels that make a view count");
  visit("original_min_inliers_total", o.original_min_inliers_total,
        "original mode: inliers over all confirmation views, of 5 or more, that a curve needs");
  visit("original_exhaustive_pairs", o.original_exhaustive_pairs,
        "original mode: match all pairs of views, not the selected ones");
}

template <typename Visit>
void VisitFields(DrawingOptions& o, Visit&& visit) {
  visit("max_support_distance_px", o.max_support_distance_px,
        "largest distance of a supporting edgel across the edge, px");
  visit("max_support_angle_deg", o.max_support_angle_deg, "and within this angle, deg");
  visit("robust_residual_px", o.robust_residual_px, "larger residuals count linearly, px");
  visit("bending_sigma_px", o.bending_sigma_px,
        "allowed change of direction between samples; smaller is smoother, px");
  visit("supporting_views_share", o.supporting_views_share,
        "share of the views containing a sample that must support it");
  visit("min_supporting_views", o.min_supporting_views,
        BasicOption("curves supported by fewer views are not drawn"));
  visit("max_supporting_views", o.max_supporting_views, "upper limit of that number");
  visit("min_piece_length_px", o.min_piece_length_px,
        "shorter pieces are dropped after re-triangulation, px");
  VisitFields(o.topology, visit);
}

template <typename Visit>
void VisitFields(PaperOptions& o, Visit&& visit) {
  visit("max_support_distance_px", o.max_support_distance_px,
        "largest distance of a supporting edgel across the edge, px");
  visit("max_support_angle_deg", o.max_support_angle_deg, "and within this angle, deg");
  visit("strong_link_views", o.strong_link_views, "views with shared edgels for a strong link");
  visit("dense_link_views", o.dense_link_views, "the same for a dense link");
  visit("min_strong_links", o.min_strong_links, "strong links that link two curves");
  visit("overlap_regularity_px", o.overlap_regularity_px,
        "shorter gaps in an overlap are filled, shorter overlaps removed, px");
  visit("max_link_angle_deg", o.max_link_angle_deg, "largest angle of merged curves, deg");
  visit("averaging_tolerance_px", o.averaging_tolerance_px,
        "averaging stops when samples move less, px");
  visit("max_averaging_rounds", o.max_averaging_rounds, "or after this many rounds");
  visit("merge_distance_px", o.merge_distance_px, "samples within this of a link belong to it, px");
  visit("min_branch_length_px", o.min_branch_length_px, "shorter stubs are not branches, px");
  visit("junction_distance_px", o.junction_distance_px, "ends within this meet in a node, px");
}

template <typename Visit>
void VisitFields(RefinementOptions& o, Visit&& visit) {
  visit("num_rounds", o.num_rounds, "rounds of matching and fitting, 0 = no refinement");
  visit("control_spacing_px", o.control_spacing_px, "spacing of control points, px");
  visit("max_distance_px", o.max_distance_px,
        "largest distance of an edgel that pulls at a link, px");
  visit("max_angle_deg", o.max_angle_deg, "and within this angle, deg");
  visit("support_window_px", o.support_window_px,
        "half length of the window that decides whether a view shows it, px");
  visit("min_window_support", o.min_window_support, "share of the window that edgels must cover");
  visit("min_views", o.min_views, "views that must show a sample for its edgels to count");
  visit("robust_residual_px", o.robust_residual_px, "much larger residuals hardly count, px");
  visit("correlation_px", o.correlation_px, "correlation length of edgel errors in an image, px");
  visit("bending_sigma", o.bending_sigma,
        "standard deviation of the change of direction over 1 px, rad");
  visit("refine_poses", o.refine_poses, BasicOption("refine camera poses and focal lengths too"));
}

template <typename Visit>
void VisitFields(BeliefOptions& o, Visit&& visit) {
  visit("judge", o.judge, "mark links that the images do not support as tentative");
  visit("min_evidence", o.min_evidence,
        "evidence against chance that a link without neighbors needs, natural logarithm");
  visit("joined_end_evidence", o.joined_end_evidence,
        "by how much each end that meets another link lowers that");
  visit("min_contradicting_views", o.min_contradicting_views,
        "views that see others through a link before it is doubted");
  visit("min_own_share", o.min_own_share,
        "share of its edgels that no better link explains, of a link with a free end");
}

template <typename Visit>
void VisitFields(PrimitiveOptions& o, Visit&& visit) {
  visit("max_residual_px", o.max_residual_px,
        "largest distance of a primitive from its link, RMS over the views, px");
  visit("noise_px", o.noise_px, "standard deviation of drawn curves, px");
  visit("correlation_px", o.correlation_px, "correlation length of their errors, px");
  visit("end_zone_px", o.end_zone_px, "samples within this of a node have little weight, px");
}

template <typename Visit>
void VisitFields(RegularityOptions& o, Visit&& visit) {
  visit("max_shift_px", o.max_shift_px,
        "ends of a link move by at most this to follow a regularity, px");
  visit("max_growth_px", o.max_growth_px,
        "a link's residual grows by at most this, RMS over the views, px");
  visit("min_length_px", o.min_length_px, "shorter links follow none, px");
}

template <typename Visit>
void VisitFields(TileOptions& o, Visit&& visit) {
  visit("max_views", o.max_views,
        "larger scenes are drawn in tiles of at most this many views, 0 = never");
  visit("reach_px", o.reach_px, "margin by which tiles overlap, px");
}

template <typename Visit>
void VisitFields(DenseOptions& o, Visit&& visit) {
  visit("depth_tolerance_px", o.depth_tolerance_px,
        BasicOption("a curve this near in depth is on the surface, footprints"));
  visit("side_offset_px", o.side_offset_px,
        "distance from a curve at which the surface is examined, px");
  visit("near_px", o.near_px, "dense points within this are at the same place, footprints");
  visit("sample_spacing_px", o.sample_spacing_px,
        "distance of the samples along a link, footprints");
  visit("max_occluded_share", o.max_occluded_share,
        "a link is behind the surface if a larger share of judgments says so");
  visit("min_judged_share", o.min_judged_share,
        "share of samples that supporting views must be able to judge");
  visit("enough_visible_views", o.enough_visible_views,
        "a link seen by this many supporting views is never behind the surface");
}

// visit(group name, options struct) for every group of the pipeline.
template <typename Visit>
void VisitGroups(PipelineOptions& options, Visit&& visit) {
  visit("EdgeDetection", options.edges);
  visit("Linking", options.linking);
  visit("ViewSelection", options.sketch.view_selection);
  visit("Sketch", options.sketch);
  visit("Drawing", options.drawing);
  visit("Paper", options.paper);
  visit("DrawingRefinement", options.refinement);
  visit("Belief", options.belief);
  visit("Primitives", options.primitives);
  visit("Regularity", options.regularity);
  visit("Surfaces", options.surfaces);
  visit("Tiles", options.tiles);
}

}  // namespace limn
