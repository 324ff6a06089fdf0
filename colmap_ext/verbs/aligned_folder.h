// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "limn/files/output_path.h"

namespace limn::colmap_ext {

// The folder aligned/ beside a drawing: the whole project in world coordinates. What is in it
// follows from the project, so all of it is replaced at once.

constexpr const char* kAlignedFolder = "aligned";

// Call it before the work. Throws IoError unless the folder is missing, empty, or one that limn
// made and `overwrite` allows to replace: with nothing else in it, so that nothing of the user's is
// lost.
void CheckAlignedFolder(const OutputPath& folder, bool overwrite);

// Makes the folder: `fill` writes into one with a temporary name, which then gets its name in one
// step, in the place of an old one, and is removed if anything fails. Throws IoError, and what
// `fill` throws.
void WriteAlignedFolder(const OutputPath& folder, bool overwrite,
                        const std::function<void(const OutputPath&)>& fill);

}  // namespace limn::colmap_ext
