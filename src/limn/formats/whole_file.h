#pragma once

#include <string>

namespace limn {

// The bytes of a file; a gzip file comes back unpacked. Throws IoError.
std::string ReadWholeFile(const std::string& path);

// Lower-case extension with its dot, that before ".gz" if there is one.
std::string FileExtension(const std::string& path);

}  // namespace limn
