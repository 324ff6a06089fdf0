// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace limn {

// A gzip file; the same bytes give the same file.
std::string Gzip(std::string_view bytes);

// The bytes of a whole gzip file, not more than `max_bytes`. Throws InputError.
std::string Gunzip(std::string_view packed, size_t max_bytes);

// Base64 (RFC 4648) in one line.
std::string Base64(std::string_view bytes);

// The bytes of such a line. Throws InputError.
std::string Unbase64(std::string_view text);

}  // namespace limn
