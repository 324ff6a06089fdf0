#include "limn/primitives/primitive_options.h"

#include "limn/util/errors.h"

namespace limn {

void PrimitiveOptions::Check() const {
  LIMN_CHECK_RANGE(max_residual_px, > 0, <= 1000);
  LIMN_CHECK_RANGE(noise_px, >= 1e-6, <= 1000);
  LIMN_CHECK_RANGE(correlation_px, >= 1e-3, <= 1e5);
  LIMN_CHECK_RANGE(end_zone_px, >= 0, <= 1e4);
}

}  // namespace limn
