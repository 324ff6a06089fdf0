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

// Throws IoError if no file can be written there: the name is too long, the path is a folder, a
// device, a pipe or a link to one, or its parent is not a folder. Called by WriteFileAtomically,
// and before long work by callers that know their output paths.
void CheckTakesFile(const std::string& path);

constexpr std::string_view kTemporarySuffix = ".limn-tmp";

}  // namespace limn
