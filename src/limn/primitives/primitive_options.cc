#include "limn/primitives/primitive_options.h"

#include "limn/util/errors.h"

namespace limn {

void PrimitiveOptions::Check() const {
  LIMN_CHECK_OPTION(max_residual_px, > 0);
  LIMN_CHECK_OPTION(noise_px, > 0);
  LIMN_CHECK_OPTION(correlation_px, > 0);
  LIMN_CHECK_OPTION(end_zone_px, >= 0);
}

}  // namespace limn
