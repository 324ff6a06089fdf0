#pragma once

namespace limn {

struct DenseOptions {
  // A sample of the drawing lies on the dense surface when their depths differ by no more than
  // this, and behind it when it is farther away: footprints (depth over focal length). Depths are
  // several times less certain than what lies across the line of sight.
  double depth_tolerance_px = 5;
  // The neighborhood of the surface is looked at this far to either side of a curve, px, where
  // dense depths are no longer fattened or rounded.
  double side_offset_px = 4;
  // Dense points nearer than this to a sample are points of the same place, footprints.
  double near_px = 2;
  // Distance of the samples along a link, footprints.
  double sample_spacing_px = 1;
  // A link is behind the surface when more than this share of what its supporting views can say of
  // its samples says so, and they can say it of at least min_judged_share of them.
  double max_occluded_share = 0.5;
  double min_judged_share = 0.3;
  // But never where so many of its supporting views, in the mean over its samples, see it: they are
  // enough to believe in it. (Others support it by what stands before it.)
  double enough_visible_views = 3;

  void Check() const;
};

}  // namespace limn
