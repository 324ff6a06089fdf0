#pragma once

#include <cmath>

namespace limn {

inline constexpr double kDeg = M_PI / 180;

}  // namespace limn
