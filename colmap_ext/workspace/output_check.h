// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "limn/files/output_path.h"

namespace limn::colmap_ext {

// Throws IoError unless files can be created in this folder, or the folder itself can, without
// following a link below the folder that the user named. Writes nothing; to be called before a long
// run.
void CheckWritable(const OutputPath& folder);

// Whether this is a file that limn writes, by what it begins with. Not for binary files of models.
bool IsFileOfLimn(const std::string& path);

// Also to be called before the work, for every file that will be written. Throws IoError if the
// path is not a regular file (see CheckTakesFile) or, unless `overwrite`, a file that limn did not
// write.
void CheckResultFile(const OutputPath& path, bool overwrite);

// Help text of the option `overwrite` of commands whose output files are named by the user.
constexpr const char* kOverwriteHelp = "replace an output that is an input, a drawing or not ours";

// The same for a file that the user names. Unless `overwrite`, it must not be one of the inputs, a
// file of a model or a drawing.json either: these may be the only ones.
void CheckNamedOutput(const OutputPath& path, const std::vector<std::string>& inputs,
                      bool overwrite);

}  // namespace limn::colmap_ext
