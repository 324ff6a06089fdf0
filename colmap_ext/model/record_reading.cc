// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/record_reading.h"

#include <algorithm>
#include <cctype>
#include <cstring>

namespace limn::colmap_ext {
namespace {

constexpr size_t kMaxNameBytes = 4096;

// A count that is really text (an LFS pointer, an HTML page, a text model under a wrong name).
bool LooksLikeText(uint64_t count) {
  char bytes[sizeof(count)];
  std::memcpy(bytes, &count, sizeof(count));
  return std::all_of(std::begin(bytes), std::end(bytes), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return std::isprint(byte) || std::isspace(byte);
  });
}

}  // namespace

uint64_t ReadCount(ByteReader& reader, const char* what, uint64_t min_record_bytes) {
  const FilePlace place = reader.Here();
  const auto count = reader.Get<uint64_t>(what);
  if (count > reader.Remaining() / min_record_bytes) {
    if (place.number == 0 && LooksLikeText(count)) place.Fail("text, not a binary COLMAP file");
    place.Fail(std::string(what) + " = " + std::to_string(count) + " does not fit the remaining " +
               std::to_string(reader.Remaining()) + " bytes: truncated, or not a COLMAP file");
  }
  return count;
}

uint32_t ReadCount32(ByteReader& reader, const char* what, uint64_t min_record_bytes) {
  const FilePlace place = reader.Here();
  const auto count = reader.Get<uint32_t>(what);
  if (count > reader.Remaining() / min_record_bytes) {
    place.Fail(std::string(what) + " = " + std::to_string(count) + " does not fit the file");
  }
  return count;
}

std::string ReadName(ByteReader& reader, const char* what) {
  const FilePlace start = reader.Here();
  std::string name;
  for (char c = reader.Get<char>(what); c != '\0'; c = reader.Get<char>(what)) {
    if (name.size() == kMaxNameBytes) {
      start.Fail(std::string(what) + " is longer than " + std::to_string(kMaxNameBytes) + " bytes");
    }
    name += c;
  }
  return name;
}

}  // namespace limn::colmap_ext
