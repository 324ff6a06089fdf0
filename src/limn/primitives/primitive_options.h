#pragma once

namespace limn {

struct PrimitiveOptions {
  // A primitive explains a link if it is nowhere farther from it, in the mean over the views that
  // support the link (root of the mean square), px.
  double max_residual_px = 1;
  // Standard deviation of a drawn curve, as the views see it, px, and the length over which its
  // errors are the same, px. They weigh a better fit against more parameters.
  double noise_px = 0.3;
  double correlation_px = 12;
  // Nearer than this to a node the edges of its links run into one another, px: there they count
  // little, and the node moves, by no more than this, to where the shapes of its links meet.
  double end_zone_px = 4;

  // Throws OptionError.
  void Check() const;
};

}  // namespace limn
