#pragma once

#include <cstdint>
#include <string>

#include "limn/util/byte_stream.h"

namespace limn::colmap_ext {

// The counts and names of COLMAP's binary files. All throw IoError with the byte.

// A u64 count of records of at least `min_record_bytes` each: fails if they cannot fit into what is
// left of the file, so that it is safe to reserve.
uint64_t ReadCount(ByteReader& reader, const char* what, uint64_t min_record_bytes);

// The same of a u32 count.
uint32_t ReadCount32(ByteReader& reader, const char* what, uint64_t min_record_bytes);

// Up to a NUL, which is consumed; at most 4096 bytes.
std::string ReadName(ByteReader& reader, const char* what);

}  // namespace limn::colmap_ext
