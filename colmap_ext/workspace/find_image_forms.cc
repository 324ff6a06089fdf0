// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/find_image_forms.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "limn/util/name_list.h"

namespace limn::colmap_ext {
namespace {

// Files of one size that tell the range of all of them.
constexpr size_t kMaxScanned = 12;

bool FitsCamera(ImageSize size, const Camera& camera) {
  return IsResized(size, static_cast<double>(camera.width), static_cast<double>(camera.height));
}

std::string WholeNumber(double value) { return std::to_string(std::lround(value)); }

enum class Evidence : uint8_t { kNone, kAsStored, kTurned };

Evidence EvidenceOf(ImageSize stored, int orientation, const Camera& camera) {
  if (!SwapsSides(orientation)) return Evidence::kNone;
  const bool fits = FitsCamera(stored, camera);
  const bool fits_turned = FitsCamera(Turned(stored, orientation), camera);
  if (fits == fits_turned) return Evidence::kNone;
  return fits ? Evidence::kAsStored : Evidence::kTurned;
}

void SetOrientations(const SparseModel& model, const std::vector<int>& images,
                     const std::vector<ImageTraits>& traits, std::vector<ViewFile>* files,
                     std::vector<std::string>* notes) {
  std::vector<Evidence> evidence;
  for (size_t i = 0; i < files->size(); ++i) {
    const Camera& camera = model.CameraOf(model.images[images[i]]);
    evidence.push_back(EvidenceOf((*files)[i].stored_size, traits[i].orientation, camera));
  }
  if (!std::ranges::count(evidence, Evidence::kTurned)) return;
  const bool all = !std::ranges::count(evidence, Evidence::kAsStored);
  std::vector<std::string> names;
  for (size_t i = 0; i < files->size(); ++i) {
    ViewFile& file = (*files)[i];
    const Camera& camera = model.CameraOf(model.images[images[i]]);
    const ImageSize turned = Turned(file.stored_size, traits[i].orientation);
    const bool is_turned = evidence[i] == Evidence::kTurned ||
                           (all && traits[i].orientation != 1 && FitsCamera(turned, camera));
    if (!is_turned || camera.IsPanorama()) continue;
    file.form.orientation = traits[i].orientation;
    file.stored_size = turned;
    names.push_back(file.image_name);
  }
  if (names.empty()) return;
  notes->push_back(std::to_string(names.size()) +
                   " images are turned as their EXIF orientation says, since the cameras are those "
                   "of upright pictures: " +
                   ListNames(names));
}

// Which files must be decoded to know what is in them.
std::vector<size_t> FilesToScan(const std::vector<ViewFile>& files,
                                const std::vector<ImageTraits>& traits) {
  std::map<std::pair<int, int>, std::vector<size_t>> deep;
  std::vector<char> is_scanned(files.size(), 0);
  for (size_t i = 0; i < files.size(); ++i) {
    if (files[i].is_damaged) continue;
    is_scanned[i] = traits[i].has_alpha;
    const ImageSize size = files[i].stored_size;
    if (traits[i].is_deep) deep[{size.width, size.height}].push_back(i);
  }
  for (const auto& [size, alike] : deep) {
    const size_t count = std::min(kMaxScanned, alike.size());
    for (size_t k = 0; k < count; ++k) is_scanned[alike[k * alike.size() / count]] = 1;
  }
  std::vector<size_t> to_scan;
  for (size_t i = 0; i < files.size(); ++i) {
    if (is_scanned[i]) to_scan.push_back(i);
  }
  return to_scan;
}

void SetRanges(const std::vector<ImageTraits>& traits, const std::vector<PixelScan>& scans,
               std::vector<ViewFile>* files, std::vector<std::string>* notes) {
  std::map<std::pair<int, int>, std::vector<size_t>> deep;
  for (size_t i = 0; i < files->size(); ++i) {
    const ImageSize size = (*files)[i].stored_size;
    if (traits[i].is_deep) deep[{size.width, size.height}].push_back(i);
  }
  for (const auto& [size, alike] : deep) {
    std::optional<LevelRange> values;
    for (const size_t i : alike) {
      if (!scans[i].values) continue;
      if (!values) values = scans[i].values;
      values->low = std::min(values->low, scans[i].values->low);
      values->high = std::max(values->high, scans[i].values->high);
    }
    const auto range = values ? RangeToShow(*values) : std::nullopt;
    if (!range) continue;
    for (const size_t i : alike) (*files)[i].form.range = range;
    notes->push_back(std::to_string(alike.size()) + " images of 16 bits use values from " +
                     WholeNumber(values->low) + " to " + WholeNumber(values->high) +
                     " of 65535 only: " + WholeNumber(range->low) + " is taken as black and " +
                     WholeNumber(range->high) + " as white");
  }
}

void SetAlpha(const std::vector<PixelScan>& scans, std::vector<ViewFile>* files,
              std::vector<std::string>* notes) {
  std::vector<std::string> names;
  for (size_t i = 0; i < files->size(); ++i) {
    if (!scans[i].has_mask) continue;
    (*files)[i].form.has_mask = true;
    names.push_back((*files)[i].image_name);
  }
  if (names.empty()) return;
  notes->push_back(std::to_string(names.size()) +
                   " images have an alpha channel, which is their mask: what is less than half "
                   "opaque is not used: " +
                   ListNames(names));
}

}  // namespace

void SetForms(const SparseModel& model, const std::vector<int>& images, const PhotoStore& photos,
              const RunContext& context, std::vector<ViewFile>* files,
              std::vector<std::string>* notes) {
  std::vector<ImageTraits> traits(files->size());
  ParallelFor(context, "kinds of images", files->size(),
              [&](size_t i) { traits[i] = photos.Traits((*files)[i].image_path); });
  SetOrientations(model, images, traits, files, notes);
  const std::vector<size_t> to_scan = FilesToScan(*files, traits);
  std::vector<PixelScan> scans(files->size());
  ParallelFor(context, "values of images", to_scan.size(),
              [&](size_t k) { scans[to_scan[k]] = photos.Scan((*files)[to_scan[k]].image_path); });
  SetRanges(traits, scans, files, notes);
  SetAlpha(scans, files, notes);
}

}  // namespace limn::colmap_ext
