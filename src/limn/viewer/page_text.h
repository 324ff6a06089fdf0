// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace limn {

// The page before and after its payload, made from page/ by the build (page/build.mjs). Empty if
// the CMake option LIMN_WITH_VIEWER is OFF.
extern const std::string_view kPageHead;
extern const std::string_view kPageTail;

}  // namespace limn
