#pragma once

namespace limn {

struct RegularityOptions {
  // The ends of a link move by at most this in the images, px, for one regularity to hold.
  double max_shift_px = 0.5;
  // The residual of a link (root mean square over its supporting views) grows by at most this, px;
  // links whose residuals would grow more are released.
  double max_growth_px = 0.1;
  // Shorter links follow no regularity, px.
  double min_length_px = 20;

  // Throws OptionError.
  void Check() const;
};

}  // namespace limn
