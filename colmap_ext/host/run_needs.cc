#include "colmap_ext/host/run_needs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <sstream>
#include <string_view>

namespace limn::colmap_ext {
namespace {

// Measured (algorithm/cache.md#what-a-run-needs).
constexpr double kProgramBytes = 100e6;
// Edgels lie on curves, whose length grows with the side of a view, not with its area.
constexpr double kEdgelsPerSidePx = 80;
// Of an edgel with its indices, and its share of sketch and samples.
constexpr double kBytesPerEdgel = 200;
constexpr double kCacheBytesPerEdgel = 32;
// Of the largest view, per thread: the planes that edges are found in.
constexpr double kBytesPerPixelOfThread = 60;

double NumPixels(const View& view) {
  return static_cast<double>(view.camera.width) * view.camera.height;
}

double NumEdgels(double num_pixels) { return kEdgelsPerSidePx * std::sqrt(num_pixels); }

// The number after a name at the beginning of a line, as in /proc/meminfo.
std::optional<double> NumberAfter(const std::string& path, std::string_view name) {
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(name)) continue;
    double number = 0;
    if (std::istringstream(line.substr(name.size())) >> number) return number;
  }
  return std::nullopt;
}

std::string Megabytes(double bytes) {
  char text[40];
  if (bytes < 1e9) {
    std::snprintf(text, sizeof(text), "%.0f MB", bytes / 1e6);
  } else {
    std::snprintf(text, sizeof(text), "%.1f GB", bytes / 1e9);
  }
  return text;
}

}  // namespace

RunNeeds EstimateNeeds(const std::vector<View>& views, const TileOptions& tiles, int num_threads) {
  std::vector<double> pixels;
  for (const View& view : views) pixels.push_back(NumPixels(view));
  std::ranges::sort(pixels, std::greater());
  const bool is_in_tiles = tiles.max_views > 0 && std::ssize(pixels) > tiles.max_views;
  RunNeeds needs;
  needs.memory_bytes = kProgramBytes;
  for (size_t v = 0; v < pixels.size(); ++v) {
    const bool is_in_memory = !is_in_tiles || v < static_cast<size_t>(tiles.max_views);
    if (is_in_memory) needs.memory_bytes += kBytesPerEdgel * NumEdgels(pixels[v]);
    needs.cache_bytes += kCacheBytesPerEdgel * NumEdgels(pixels[v]);
  }
  if (!pixels.empty()) {
    needs.memory_bytes += num_threads * kBytesPerPixelOfThread * pixels.front();
  }
  return needs;
}

std::optional<double> AvailableMemory() {
  std::optional<double> available = NumberAfter("/proc/meminfo", "MemAvailable:");
  if (available) *available *= 1024;
  // Of the group that the process is in, where it sees nothing above it, as in a container.
  const std::optional<double> limit = NumberAfter("/sys/fs/cgroup/memory.max", "");
  const std::optional<double> used = NumberAfter("/sys/fs/cgroup/memory.current", "");
  if (limit && used) available = std::min(available.value_or(*limit), *limit - *used);
  return available;
}

std::vector<std::string> LinesOf(const RunNeeds& needs, const std::optional<double>& available) {
  std::vector<std::string> lines = {"This takes about " + Megabytes(needs.memory_bytes) +
                                    " of memory and about " + Megabytes(needs.cache_bytes) +
                                    " on disk for the cache"};
  if (available && *available < needs.memory_bytes) {
    lines.push_back("WARNING: " + Megabytes(*available) +
                    " of memory is available, less than this may take: if it is not enough, lower "
                    "--max_image_size, --Tiles.max_views or --num_threads");
  }
  return lines;
}

}  // namespace limn::colmap_ext
