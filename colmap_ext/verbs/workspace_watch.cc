// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/workspace_watch.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kStep{100};
constexpr std::chrono::seconds kBetweenLooks{1};
// A writer counts as done this long after the last change.
constexpr std::chrono::seconds kQuiet{2};

bool IsCancelled(const RunContext& context) { return context.cancelled && *context.cancelled; }

// Returns false if the run is cancelled.
bool Rest(const RunContext& context, Clock::duration duration) {
  const Clock::time_point end = Clock::now() + duration;
  while (!IsCancelled(context) && Clock::now() < end) std::this_thread::sleep_for(kStep);
  return !IsCancelled(context);
}

// Whether a file is one of a model: results may be in the same folder.
bool IsOfModel(const fs::path& file) {
  constexpr std::string_view kStems[] = {"cameras", "images", "points3D", "rigs", "frames"};
  const std::string extension = file.extension().string();
  const bool is_colmap = (extension == ".bin" || extension == ".txt") &&
                         std::ranges::find(kStems, file.stem().string()) != std::end(kStems);
  return is_colmap || file.filename().string().starts_with("bundle.rd.out");
}

// The files of a folder for which `select`; none if it cannot be read.
template <typename Select>
std::vector<fs::path> FilesIn(const fs::path& folder, const Select& select) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator file(folder, error), end; !error && file != end;
       file.increment(error)) {
    if (select(file->path())) files.push_back(file->path());
  }
  return files;
}

// Size and time; zero if the file is missing.
std::pair<uintmax_t, fs::file_time_type> StampOf(const fs::path& path) {
  std::error_code no_size, no_time;
  const uintmax_t size = fs::file_size(path, no_size);
  const fs::file_time_type time = fs::last_write_time(path, no_time);
  if (no_size || no_time) return {};
  return {size, time};
}

}  // namespace

WorkspaceWatch::WorkspaceWatch(fs::path model_dir) : model_dir_(std::move(model_dir)) { Look(); }

void WorkspaceWatch::Look() { seen_ = Now(); }

void WorkspaceWatch::WatchImages(const Project& project, const fs::path& mask_dir) {
  for (const fs::path& image : images_) seen_.erase(image);
  images_.clear();
  for (size_t v = 0; v < project.views().size(); ++v) {
    const ViewFile& file = project.view_set().files[v];
    images_.insert(file.image_path);
    if (!file.mask_path.empty()) {
      images_.insert(file.mask_path);
    } else if (!mask_dir.empty()) {
      images_.insert(mask_dir / (file.image_name + ".png"));
    }
  }
  for (const fs::path& image : images_) seen_[image] = StampOf(image);
}

WorkspaceWatch::Stamps WorkspaceWatch::Now() const {
  Stamps now;
  for (const fs::path& file : FilesIn(model_dir_, IsOfModel)) now[file] = StampOf(file);
  // The cameras of a PMVS folder.
  const auto is_text = [](const fs::path& file) { return file.extension() == ".txt"; };
  for (const fs::path& file : FilesIn(model_dir_ / "txt", is_text)) now[file] = StampOf(file);
  for (const fs::path& image : images_) now[image] = StampOf(image);
  return now;
}

bool WorkspaceWatch::WaitForChange(const RunContext& context) const {
  while (!HasChanged()) {
    if (!Rest(context, kBetweenLooks)) return false;
  }
  for (Stamps last = Now();;) {
    if (!Rest(context, kQuiet)) return false;
    Stamps now = Now();
    if (now == last) return true;
    last = std::move(now);
  }
}

}  // namespace limn::colmap_ext
