// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace limn {

// What to do instead of an option that COLMAP's commands have and those of limn do not; empty if it
// is no such option.
std::string AdviceOnColmapOption(std::string_view name);

}  // namespace limn
