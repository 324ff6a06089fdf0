// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "limn/util/byte_stream.h"

namespace limn::colmap_ext {

// Readers of counts and names in COLMAP's binary files. All throw IoError with the byte.

// A u64 count of records of at least `min_record_bytes` each: fails if they cannot fit in the rest
// of the file, so that reserving is safe.
uint64_t ReadCount(ByteReader& reader, const char* what, uint64_t min_record_bytes);

// The same for a u32 count.
uint32_t ReadCount32(ByteReader& reader, const char* what, uint64_t min_record_bytes);

// Reads up to a NUL, which is consumed; at most 4096 bytes.
std::string ReadName(ByteReader& reader, const char* what);

}  // namespace limn::colmap_ext
