#include "limn/regularity/regularity_options.h"

#include "limn/util/errors.h"

namespace limn {

void RegularityOptions::Check() const {
  LIMN_CHECK_RANGE(max_shift_px, >= 0, <= 1000);
  LIMN_CHECK_RANGE(max_growth_px, >= 0, <= 1000);
  LIMN_CHECK_RANGE(min_length_px, >= 0, <= 1e5);
}

}  // namespace limn
