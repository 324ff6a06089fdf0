// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/evaluation_options.h"

#include "limn/util/errors.h"

namespace limn {

void EvaluationOptions::Check() const {
  LIMN_CHECK_OPTION(taus.size(), > 0);
  for (const double tau : taus) {
    CheckOption(tau >= 1e-15 && tau <= 1e15, "taus", tau, ">= 1e-15 and <= 1e15");
  }
  LIMN_CHECK_RANGE(dont_care_taus, >= 0, <= 1e4);
  LIMN_CHECK_RANGE(junction_taus, > 0, <= 1e4);
  LIMN_CHECK_RANGE(chain_taus, >= 0, <= 1e4);
  LIMN_CHECK_RANGE(cover_taus, >= 0, <= 1e4);
  if (region && region->isEmpty()) throw OptionError("region: its minimum exceeds its maximum");
}

}  // namespace limn
