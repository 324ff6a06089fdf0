// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace limn {

// The stage of the loop (ParallelFor) that began last, to report where memory ran out. Callable
// from any thread.
std::string LatestStage();
void SetLatestStage(const char* stage);

// The message that memory ran out: in which stage, and which options to lower; `before_options` is
// "--" on a command line.
std::string OutOfMemoryText(const std::string& before_options);

}  // namespace limn
