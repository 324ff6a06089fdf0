// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "colmap_ext/import/imported_scene.h"
#include "limn/files/json_value.h"

namespace limn::colmap_ext {

using SceneOfJson = std::function<ImportedScene(const JsonValue& file, const std::string& path)>;

// The scene of the JSON file of this type at or in `input` (TheCameraFile), of at most
// `max_values`. Throws IoError; InputErrors of `scene_of` become IoErrors that name the file.
ImportedScene ReadJsonScene(const std::filesystem::path& input, const std::string& input_type,
                            size_t max_values, const SceneOfJson& scene_of);

}  // namespace limn::colmap_ext
