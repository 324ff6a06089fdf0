// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/refinement_options.h"

namespace limn {

void RefinementOptions::Check() const { CheckFields(*this); }

}  // namespace limn
