#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace limn {

// Write a file such that there is either the old one or the whole new one, never a part: the bytes
// go to "<path>.tmp" beside it, which is then renamed. Missing folders are made. Throws IoError;
// then, and when `write` throws, the temporary file is gone and the old file untouched.
void WriteFileAtomically(const std::string& path, const std::function<void(std::ostream&)>& write);

void WriteFileAtomically(const std::string& path, std::string_view bytes);

}  // namespace limn
