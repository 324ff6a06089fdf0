// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace limn {

// The probability with these log-odds.
inline double Logistic(double log_odds) { return 1 / (1 + std::exp(-log_odds)); }

}  // namespace limn
