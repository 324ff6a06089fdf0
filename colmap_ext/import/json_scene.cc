// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/json_scene.h"

#include <nlohmann/json.hpp>

#include "colmap_ext/import/import_input.h"
#include "limn/files/json_text.h"
#include "limn/files/whole_file.h"

namespace limn::colmap_ext {

ImportedScene ReadJsonScene(const std::filesystem::path& input, const std::string& input_type,
                            size_t max_values, const SceneOfJson& scene_of) {
  const std::string path = TheCameraFile(input, input_type).string();
  try {
    const auto json = ParseJson(path, ReadWholeFile(path, kMaxJsonBytes), max_values);
    return scene_of(JsonValue(json), path);
  } catch (const std::exception&) {
    RethrowJsonError(path);
  }
}

}  // namespace limn::colmap_ext
