// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "limn/files/whole_file.h"

namespace limn {

// How many bytes at the start of a text are a byte order mark of UTF-8, as Windows' editors write
// it: 3 or 0. Throws IoError that names the encoding if the text is UTF-16 or UTF-32, with a mark
// or without. Twelve bytes of the start are enough.
size_t MarkLength(const std::string& path, std::string_view start);

// A text file as ReadWholeFile returns it, without byte order mark. Throws IoError, also for UTF-16
// and UTF-32.
std::string ReadTextFile(const std::string& path, uint64_t max_bytes = kMaxBytes);

}  // namespace limn
