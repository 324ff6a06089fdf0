#include "limn/belief/belief_options.h"

#include "limn/util/errors.h"

namespace limn {

void BeliefOptions::Check() const {
  LIMN_CHECK_OPTION(min_evidence, >= 0);
  LIMN_CHECK_OPTION(joined_end_evidence, >= 0);
  LIMN_CHECK_OPTION(min_contradicting_views, >= 1);
  LIMN_CHECK_OPTION(min_own_share, >= 0);
  LIMN_CHECK_OPTION(min_own_share, <= 1);
}

}  // namespace limn
