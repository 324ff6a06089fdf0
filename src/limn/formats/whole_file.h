#pragma once

#include <cstdint>
#include <string>

namespace limn {

// Throws IoError if there is something else than a regular file: a folder, or a pipe or device,
// which may never end or never begin. Whether there is anything at all is told when it is opened.
void CheckIsFile(const std::string& path);

// The bytes of a file; gzip files are decompressed. Throws IoError, also for more bytes than
// `max_size` and the size on disk (gzip bombs), and if memory is short.
std::string ReadWholeFile(const std::string& path, uint64_t max_size = uint64_t{1} << 30);

// Lower-case extension with its dot, ignoring a final ".gz".
std::string FileExtension(const std::string& path);

}  // namespace limn
