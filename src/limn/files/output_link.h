// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "limn/files/output_path.h"

namespace limn {

// Makes a relative link to a file or folder that exists, so that both can be moved together.
// Replaces a file or link; missing folders are made. Returns whether the file system has links.
// Throws IoError, also if a folder is in the way, which is not ours and stays.
bool MakeLink(const std::filesystem::path& target, const OutputPath& link);

}  // namespace limn
