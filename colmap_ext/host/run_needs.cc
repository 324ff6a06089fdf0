// SPDX-License-Identifier: BSD-3-Clause
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

// Measured (algorithm/cache.md#what-a-run-needs). Edges are lines: what a view needs grows with its
// side, the square root of its pixels.
constexpr double kProgramBytes = 100e6;
constexpr double kBytesPerSidePx = 20e3;
constexpr double kCacheBytesPerSidePx = 1.6e3;
// While edges are found, of what views need in the end, and per pixel of the largest one and
// thread.
constexpr double kShareWithEdges = 0.35;
constexpr double kPlaneBytesPerPixel = 40;

double NumPixels(const View& view) {
  return static_cast<double>(view.camera.width) * view.camera.height;
}

// Sum over the first views.
double SumOfSides(const std::vector<double>& pixels, size_t count) {
  double sum = 0;
  for (size_t v = 0; v < count; ++v) sum += std::sqrt(pixels[v]);
  return sum;
}

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
  const size_t max_views = tiles.max_views > 0 ? tiles.max_views : pixels.size();
  const double of_views = kBytesPerSidePx * SumOfSides(pixels, std::min(max_views, pixels.size()));
  const double of_planes = pixels.empty() ? 0 : num_threads * kPlaneBytesPerPixel * pixels.front();
  return {kProgramBytes + std::max(of_views, kShareWithEdges * of_views + of_planes),
          kCacheBytesPerSidePx * SumOfSides(pixels, pixels.size())};
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
