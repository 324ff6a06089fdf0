// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cerrno>
#include <system_error>

namespace limn {

// Of a call of the system that returns 0, or another number and a reason in errno.
inline std::error_code ErrorOf(int result) {
  return result == 0 ? std::error_code() : std::error_code(errno, std::generic_category());
}

}  // namespace limn
