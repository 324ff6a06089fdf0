#pragma once

#include <string>
#include <string_view>

namespace limn {

// A gzip file; the same bytes give the same file.
std::string Gzip(std::string_view bytes);

// Base64 (RFC 4648) in one line.
std::string Base64(std::string_view bytes);

}  // namespace limn
