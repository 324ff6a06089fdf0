// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "limn/files/output_path.h"
#include "limn/model/curve_fragment.h"

namespace limn {

// Stores the edgels and fragments of one image (see stage_file.h for the container and `identity`).
void WriteImageCurves(const OutputPath& path, const ImageCurves& curves,
                      const std::string& identity);

// Nothing if the file is stale: made from other input or by another version of Limn. An empty
// `identity` accepts any. Everything read is checked (ids in range, numbers finite); throws
// IoError.
std::optional<ImageCurves> ReadImageCurves(const std::string& path, const std::string& identity);

}  // namespace limn
