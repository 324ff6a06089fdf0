#pragma once

#include <string>
#include <vector>

#include "colmap_ext/import/import_input.h"

namespace limn::colmap_ext {

// One row of the table of formats that cameras are imported from.
struct ImportFormat {
  const char* name;  // of --input_type
  PixelCenters pixel_centers;
  bool (*recognize)(const std::filesystem::path& path);
  ImportedScene (*read)(const ImportInput& input);
};

const std::vector<ImportFormat>& ImportFormats();

// The format of this name; null if there is none.
const ImportFormat* FindImportFormat(const std::string& name);

// The only format that recognizes the path. Throws IoError if none does, or several.
const ImportFormat& RecognizeFormat(const std::filesystem::path& path);

}  // namespace limn::colmap_ext
