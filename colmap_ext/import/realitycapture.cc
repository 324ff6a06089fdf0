// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/realitycapture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "colmap_ext/import/brown_lens.h"
#include "colmap_ext/import/stated_size.h"
#include "colmap_ext/workspace/camera_files.h"
#include "limn/files/text_file.h"
#include "limn/util/angles.h"
#include "limn/util/parse_number.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

constexpr double kFilmWidthMm = 36;
constexpr std::array kNeeded = {"name", "x", "y", "alt", "heading", "pitch", "roll", "f"};

std::string_view Trimmed(std::string_view word) {
  constexpr std::string_view kSpace = " \t\r";
  const size_t begin = word.find_first_not_of(kSpace);
  if (begin == word.npos) return {};
  return word.substr(begin, word.find_last_not_of(kSpace) + 1 - begin);
}

std::vector<std::string_view> Words(std::string_view line) {
  std::vector<std::string_view> words;
  while (true) {
    const size_t end = line.find(',');
    words.push_back(Trimmed(line.substr(0, end)));
    if (end == line.npos) return words;
    line.remove_prefix(end + 1);
  }
}

using Columns = std::map<std::string, size_t, std::less<>>;

Columns ReadColumns(std::string_view line, const FilePlace& place) {
  Columns columns;
  if (line.starts_with('#')) line.remove_prefix(1);
  const std::vector<std::string_view> words = Words(line);
  for (size_t i = 0; i < words.size(); ++i) columns.emplace(std::string(words[i]), i);
  for (const char* needed : kNeeded) {
    if (columns.contains(needed)) continue;
    place.Fail("no column \"" + std::string(needed) +
               "\": export Internal/External camera parameters (Alignment > Export > "
               "Registration)");
  }
  return columns;
}

class Row {
 public:
  Row(std::string_view line, const Columns& columns, const FilePlace& place)
      : words_(Words(line)), columns_(columns), place_(place) {}

  // Zero if there is no such column.
  double Number(std::string_view column) const {
    const auto found = columns_.find(column);
    if (found == columns_.end()) return 0;
    const auto value = ParseNumber<double>(Word(found->second));
    if (!value || !std::isfinite(*value)) {
      place_.Fail("\"" + std::string(column) + "\" is not a finite number");
    }
    return *value;
  }
  std::string Name() const { return std::string(Word(columns_.find("name")->second)); }

 private:
  std::string_view Word(size_t column) const {
    if (column >= words_.size() || words_[column].empty()) {
      place_.Fail("there are " + std::to_string(columns_.size()) + " columns, but " +
                  std::to_string(words_.size()) + " words in this line, or some are empty");
    }
    return words_[column];
  }

  std::vector<std::string_view> words_;
  const Columns& columns_;
  const FilePlace& place_;
};

void SetRowLens(const Row& row, const FilePlace& place, Camera* camera) {
  const auto width = static_cast<double>(camera->width);
  const auto height = static_cast<double>(camera->height);
  const double longer_side = std::max(width, height);
  const double focal = longer_side * row.Number("f") / kFilmWidthMm;
  camera->params = {focal, focal, 0.5 * width + longer_side * row.Number("px"),
                    0.5 * height + longer_side * row.Number("py")};
  SetBrownLens({{row.Number("k1"), row.Number("k2"), row.Number("k3"), row.Number("k4")},
                row.Number("t1"),
                row.Number("t2")},
               place, camera);
}

Rigid3d PoseOfRow(const Row& row) {
  const auto turn = [&](const char* column, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(row.Number(column) * kDeg, axis);
  };
  const Eigen::Quaterniond world_from_upright(turn("heading", -Eigen::Vector3d::UnitZ()) *
                                              turn("pitch", Eigen::Vector3d::UnitX()) *
                                              turn("roll", Eigen::Vector3d::UnitY()));
  // From x right, y up, z backwards to y down, z forward.
  const Eigen::Quaterniond half_turn(0, 1, 0, 0);
  return Inverse(Rigid3d{world_from_upright * half_turn,
                         {row.Number("x"), row.Number("y"), row.Number("alt")}});
}

std::optional<ImportedImage> ReadRow(const Row& row, const FilePlace& place, ImageFolder* images) {
  const auto found = images->Find(row.Name(), fs::path(place.path).parent_path(), place);
  if (!found) return std::nullopt;
  ImportedImage image;
  image.path = place.path;
  image.number = place.number;
  image.name = found->name;
  SetSizeOfFile(*found, &image);
  SetRowLens(row, place, &image.camera);
  image.cam_from_world = PoseOfRow(row);
  return image;
}

}  // namespace

bool HoldsRealityCapture(const fs::path& path) {
  return HoldsCameraFile(path, kRealityCaptureType);
}

ImportedScene ReadRealityCapture(const ImportInput& input) {
  const std::string path = TheCameraFile(input.path, kRealityCaptureType).string();
  const std::string text = ReadTextFile(path, kMaxListBytes);
  ImportedScene scene;
  scene.notes = {"Read " + path};
  std::optional<Columns> columns;
  std::string_view rest = text;
  for (uint64_t number = 1; !rest.empty(); ++number) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (Trimmed(line).empty() || line.starts_with("#cameras")) continue;
    const FilePlace place{path, "line", number};
    if (!columns) {
      columns = ReadColumns(line, place);
    } else if (auto image = ReadRow(Row(line, *columns, place), place, input.images)) {
      scene.images.push_back(std::move(*image));
    }
  }
  if (!columns) FilePlace{path, "line", 1}.Fail("no line with the names of the columns");
  return scene;
}

}  // namespace limn::colmap_ext
