// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "limn/files/output_path.h"

namespace limn {

enum class StageKind : uint32_t {
  kImageCurves = 1,
  kCurveSketch = 2,
  kViewSketch = 3,
  kDrawing = 4,
  kSceneRecord = 5
};

// Writes the result of a stage, all numbers little-endian:
//   char[8] "limnfile" | u32 format version | u32 kind | u64 n, char[n] identity |
//   u64 m, byte[m] payload | u32 crc32 of all bytes before
// What of the payload shrinks is packed already (packed_numbers.h). `identity`, chosen by the
// caller, represents everything that the payload depends on (options, input). The same input gives
// the same bytes. Throws IoError.
void WriteStageFile(const OutputPath& path, StageKind kind, std::string_view identity,
                    std::string_view payload);

// The payload, or nothing if the file is stale: its identity differs from `identity` (empty: any is
// accepted), or its format version. Throws IoError if the file is missing, truncated, damaged, or
// of another kind.
std::optional<std::string> ReadStageFile(const std::string& path, StageKind kind,
                                         std::string_view identity);

// The text that the payload begins with, without reading the rest. Empty if there is no such file
// of this kind and version.
std::string FirstTextOfStageFile(const std::string& path, StageKind kind);

}  // namespace limn
