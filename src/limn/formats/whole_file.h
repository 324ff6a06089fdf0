#pragma once

#include <string>

namespace limn {

// Throws IoError if there is something else than a regular file: a folder, or a pipe or device,
// which may never end or never begin. Whether there is anything at all is told when it is opened.
void CheckIsFile(const std::string& path);

// The bytes of a file; gzip files are decompressed. Throws IoError.
std::string ReadWholeFile(const std::string& path);

// Lower-case extension with its dot, ignoring a final ".gz".
std::string FileExtension(const std::string& path);

}  // namespace limn
