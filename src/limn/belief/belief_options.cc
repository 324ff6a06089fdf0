#include "limn/belief/belief_options.h"

#include "limn/util/errors.h"

namespace limn {

void BeliefOptions::Check() const {
  LIMN_CHECK_RANGE(min_evidence, >= 0, <= 1e6);
  LIMN_CHECK_RANGE(joined_end_evidence, >= 0, <= 1e6);
  LIMN_CHECK_RANGE(min_contradicting_views, >= 1, <= 1e6);
  LIMN_CHECK_RANGE(min_own_share, >= 0, <= 1);
}

}  // namespace limn
