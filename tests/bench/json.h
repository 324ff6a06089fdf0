// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

namespace limn::bench {

// Members keep the order in which they were added.
using Json = nlohmann::ordered_json;

}  // namespace limn::bench
