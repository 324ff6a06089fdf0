#pragma once

#include <cstdint>
#include <string>

namespace limn {

// The bytes of a file; gzip files are decompressed. Throws IoError, also for more bytes than
// `max_size` and the size on disk (gzip bombs, endless devices), and if memory is short.
std::string ReadWholeFile(const std::string& path, uint64_t max_size = uint64_t{1} << 30);

// Lower-case extension with its dot, ignoring a final ".gz".
std::string FileExtension(const std::string& path);

}  // namespace limn
