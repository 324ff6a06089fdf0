#pragma once

#include <string>

namespace limn {

// The bytes of a file; gzip files are decompressed. Throws IoError.
std::string ReadWholeFile(const std::string& path);

// Lower-case extension with its dot, ignoring a final ".gz".
std::string FileExtension(const std::string& path);

}  // namespace limn
