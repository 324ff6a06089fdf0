#pragma once

#include <string_view>

namespace limn {

// The page before and behind its payload. The build makes them from page/ (page/build.mjs); both
// are empty if it was told not to (CMake option LIMN_WITH_VIEWER).
extern const std::string_view kPageHead;
extern const std::string_view kPageTail;

}  // namespace limn
