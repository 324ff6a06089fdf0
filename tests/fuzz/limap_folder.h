// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace limn::fuzz {

// Reads structures of LIMAP of which one file has these bytes. The others, where there are binary
// ones, have an image 3 with two segments and a line 7.
int FuzzLimap(const uint8_t* data, size_t size, const std::string& name);

}  // namespace limn::fuzz
