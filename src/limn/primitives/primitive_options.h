#pragma once

namespace limn {

struct PrimitiveOptions {
  // A primitive explains a link if its distance, root mean square over the supporting views,
  // nowhere exceeds this, px.
  double max_residual_px = 1;
  // Standard deviation of a drawn curve in the images, px, and correlation length of its errors,
  // px. They weigh a better fit against more parameters.
  double noise_px = 0.3;
  double correlation_px = 12;
  // Within this distance of a node the edges of its links run into one another, px: samples there
  // get little weight, and the node moves, by at most this, to where the shapes of its links meet.
  double end_zone_px = 4;

  // Throws OptionError.
  void Check() const;
};

}  // namespace limn
