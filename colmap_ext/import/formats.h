// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "colmap_ext/import/import_input.h"

namespace limn::colmap_ext {

// An entry of the table of camera formats that can be imported.
struct ImportFormat {
  const char* name;  // value of --input_type
  PixelCenters pixel_centers;
  bool (*recognize)(const std::filesystem::path& path);
  ImportedScene (*read)(const ImportInput& input);
};

const std::vector<ImportFormat>& ImportFormats();

// Null if no format has this name.
const ImportFormat* FindImportFormat(const std::string& name);

// The one format that recognizes the path. Throws IoError if none or several do.
const ImportFormat& RecognizeFormat(const std::filesystem::path& path);

}  // namespace limn::colmap_ext
