// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "colmap_ext/import/imported_scene.h"

namespace limn::colmap_ext {

// Adds the measurements in a tracks.csv of OpenSfM to the points of a scene. After a first line
// OPENSFM_TRACKS_VERSION_v..., which the oldest files lack, a line has, between tabs: image, track,
// feature, x, y and more. Positions are from the center of the image, relative to its longer side.
// Images and tracks that are not in the maps, which give indices into the scene, are skipped.
// Throws IoError with the line: missing words, numbers that are not finite.
void AddOpensfmTracks(const std::string& path, const std::map<std::string, int>& image_of_name,
                      const std::map<std::string, size_t>& point_of_track, ImportedScene* scene);

}  // namespace limn::colmap_ext
