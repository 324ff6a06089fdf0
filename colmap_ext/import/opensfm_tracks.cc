// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/opensfm_tracks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "limn/files/text_file.h"
#include "limn/util/errors.h"
#include "limn/util/parse_number.h"

namespace limn::colmap_ext {
namespace {

// Between tabs: image, track, feature, x, y.
std::array<std::string_view, 5> FirstWords(std::string_view line, const FilePlace& place) {
  std::array<std::string_view, 5> words;
  for (size_t i = 0; i < words.size(); ++i) {
    const size_t end = line.find('\t');
    words[i] = line.substr(0, end);
    if (words[i].empty() || (end == line.npos && i + 1 < words.size())) {
      place.Fail("image, track, feature, x and y expected, with tabs between them");
    }
    line.remove_prefix(std::min(words[i].size() + 1, line.size()));
  }
  return words;
}

double Coordinate(std::string_view word, const FilePlace& place) {
  const auto value = ParseNumber<double>(word);
  if (!value || !std::isfinite(*value)) place.Fail("x and y are no finite numbers");
  return *value;
}

void AddMeasurement(const Eigen::Vector2d& relative, uint32_t image_index, ModelPoint* point,
                    ImportedImage* image) {
  const Eigen::Vector2d size(static_cast<double>(image->camera.width),
                             static_cast<double>(image->camera.height));
  point->track.push_back({image_index + 1, static_cast<uint32_t>(image->observations.size())});
  image->observations.push_back({0.5 * size + size.maxCoeff() * relative, point->id});
}

}  // namespace

void AddOpensfmTracks(const std::string& path, const std::map<std::string, int>& image_of_name,
                      const std::map<std::string, size_t>& point_of_track, ImportedScene* scene) {
  const std::string text = ReadTextFile(path);
  std::string_view rest = text;
  for (uint64_t number = 1; !rest.empty(); ++number) {
    std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty() || line.starts_with("OPENSFM_TRACKS_VERSION")) continue;
    const FilePlace place{path, "line", number};
    const auto [image, track, feature, x, y] = FirstWords(line, place);
    const auto of_image = image_of_name.find(std::string(image));
    const auto of_track = point_of_track.find(std::string(track));
    if (of_image == image_of_name.end() || of_track == point_of_track.end()) continue;
    AddMeasurement({Coordinate(x, place), Coordinate(y, place)},
                   static_cast<uint32_t>(of_image->second), &scene->points[of_track->second],
                   &scene->images[of_image->second]);
  }
}

}  // namespace limn::colmap_ext
