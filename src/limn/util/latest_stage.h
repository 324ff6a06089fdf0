#pragma once

#include <string>

namespace limn {

// The stage of the loop (ParallelFor) that began last, to tell where memory was short. From any
// thread.
std::string LatestStage();
void SetLatestStage(const char* stage);

}  // namespace limn
