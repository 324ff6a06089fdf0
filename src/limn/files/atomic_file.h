// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <iosfwd>
#include <string_view>

#include "limn/files/output_path.h"

namespace limn {

// Writes a file atomically: the bytes go to a temporary file in the same folder, with a unique name
// that ends with kTemporarySuffix, which is then renamed. Creates missing folders, follows no link
// below the folder that the user named; an old file leaves its permissions to the new one. Throws
// IoError; then, and if `write` throws, the temporary file is removed and the old file untouched.
void WriteFileAtomically(const OutputPath& path, const std::function<void(std::ostream&)>& write);

void WriteFileAtomically(const OutputPath& path, std::string_view bytes);

// Throws IoError if no file can be written there: the name is too long, the path is a link, a
// folder, a device or a pipe, or what is above it is a link (below the folder that the user named)
// or not a folder. Called by WriteFileAtomically, and before long work by callers that know their
// output paths.
void CheckTakesFile(const OutputPath& path);

}  // namespace limn
