#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace limn {

// Writes a file atomically: the bytes go to a temporary file in the same folder, with a unique name
// that ends with kTemporarySuffix, which is then renamed. Creates missing folders; an old file
// leaves its permissions to the new one. Throws IoError; then, and if `write` throws, the temporary
// file is removed and the old file untouched.
void WriteFileAtomically(const std::string& path, const std::function<void(std::ostream&)>& write);

void WriteFileAtomically(const std::string& path, std::string_view bytes);

// Throws IoError if no file can be written there because its name is too long or because of what
// is there: a folder, a device, a pipe, or a link to one, or no folder above it. Called by
// WriteFileAtomically, and before the work by those who know what they will write.
void CheckTakesFile(const std::string& path);

constexpr std::string_view kTemporarySuffix = ".limn-tmp";

}  // namespace limn
