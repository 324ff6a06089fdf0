#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace limn {

enum class StageKind : uint32_t {
  kImageCurves = 1,
  kCurveSketch = 2,
  kViewSketch = 3,
  kDrawing = 4
};

// The result of a stage on disk, all numbers little endian:
//   char[8] "limnfile" | u32 format version | u32 kind | u64 n, char[n] identity |
//   u64 size of the payload | u64 m, byte[m] payload (zlib; image curves
//   stored without compression) | u32 crc32 of all bytes before
// `identity` stands for everything the payload depends on (options, input); the caller chooses it.
// The same input gives the same bytes. Throws IoError.
void WriteStageFile(const std::string& path, StageKind kind, std::string_view identity,
                    std::string_view payload);

// The payload, or nothing if the file was made from something else: an identity other than
// `identity` (empty: any will do) or another format version, so that the caller makes it anew.
// Throws IoError if there is no such file, or it is cut, damaged, or of another kind.
std::optional<std::string> ReadStageFile(const std::string& path, StageKind kind,
                                         std::string_view identity);

}  // namespace limn
