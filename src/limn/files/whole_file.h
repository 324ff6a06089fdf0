// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <fstream>
#include <string>

namespace limn {

// Throws IoError if the path exists but is not a regular file: a folder, or a pipe or device, which
// might block forever. A missing file is reported when it is opened.
void CheckIsFile(const std::string& path);

// A stream of the bytes of a regular file. Throws IoError.
std::ifstream OpenFile(const std::string& path);

// Largest number of bytes read from a file.
constexpr uint64_t kMaxListBytes = uint64_t{1} << 26;  // lists of names and options
constexpr uint64_t kMaxJsonBytes = uint64_t{1} << 30;
constexpr uint64_t kMaxBytes = uint64_t{1} << 32;
constexpr uint64_t kMaxMeshBytes = uint64_t{1} << 34;  // and results of stages
constexpr uint64_t kMaxDrawingBytes = kMaxMeshBytes;   // a large scene in tiles has gigabytes

// The bytes of a file; gzip files are decompressed. Throws IoError, also for more than `max_bytes`,
// for gzip files of more than 64 MB and 100 times their size (bombs), and if memory is short.
std::string ReadWholeFile(const std::string& path, uint64_t max_bytes = kMaxBytes);

// Lower-case extension with its dot, ignoring a final ".gz".
std::string FileExtension(const std::string& path);

}  // namespace limn
