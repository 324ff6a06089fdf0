#pragma once

namespace limn {

struct DenseOptions {
  // A sample of the drawing lies on the dense surface if their depths differ by at most this, in
  // footprints, and behind it if it is farther away. Depths are several times less accurate than
  // positions across the line of sight.
  double depth_tolerance_px = 5;
  // Distance to either side of a curve at which the surface is examined, px: there dense depths are
  // no longer fattened or rounded.
  double side_offset_px = 4;
  // Dense points within this distance of a sample are at the same place, footprints.
  double near_px = 2;
  // Spacing of the samples along a link, footprints.
  double sample_spacing_px = 1;
  // A link is behind the surface if more than this share of its supporting views' judgments of its
  // samples say so, and if they can judge at least min_judged_share of the samples.
  double max_occluded_share = 0.5;
  double min_judged_share = 0.3;
  // Except if, averaged over its samples, this many of its supporting views see it. (Others may
  // support it by edges of what stands in front of it.)
  double enough_visible_views = 3;

  void Check() const;
};

}  // namespace limn
