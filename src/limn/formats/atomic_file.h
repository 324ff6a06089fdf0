#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace limn {

// Write a file such that there is either the old one or the whole new one, never a part: the bytes
// go to a temporary file beside it, with a name of its own that ends with kTemporarySuffix, which
// is then renamed. Missing folders are made. Throws IoError; then, and when `write` throws, the
// temporary file is gone and the old file untouched.
void WriteFileAtomically(const std::string& path, const std::function<void(std::ostream&)>& write);

void WriteFileAtomically(const std::string& path, std::string_view bytes);

constexpr std::string_view kTemporarySuffix = ".limn-tmp";

// Remove the temporary files of all writes that go on in other threads, and let none begin: to be
// called right before the process ends without waiting for them.
void AbandonWrites();

}  // namespace limn
