#pragma once

#include <optional>
#include <string>

#include "limn/model/curve_fragment.h"

namespace limn {

// The edgels and fragments of one image on disk (see stage_file.h for the container and
// `identity`).
void WriteImageCurves(const std::string& path, const ImageCurves& curves,
                      const std::string& identity);

// Nothing if the file was made from other input or by another version of Limn, and must be made
// again. An empty `identity` accepts any. Everything read is checked (ids in range, numbers
// finite); throws IoError.
std::optional<ImageCurves> ReadImageCurves(const std::string& path, const std::string& identity);

}  // namespace limn
