#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <Eigen/Core>

namespace limn {

// Finds points within a few footprints of a place, where the footprint varies over the scene: one
// hash grid per power of two of the footprint. Points can be added at any time.
class VertexGrid {
 public:
  // Cells are twice `cell_px` footprints wide at the small end of each level.
  explicit VertexGrid(double cell_px) : cell_px_(cell_px) {}

  void Add(int vertex, const Eigen::Vector3d& position, double footprint) {
    const int level = Level(footprint);
    cells_[Key(level, Cell(position, level))].push_back(vertex);
  }

  // Visits every vertex within about cell_px footprints of the position, and some beyond.
  template <typename Visit>
  void ForEachNear(const Eigen::Vector3d& position, double footprint, Visit&& visit) const {
    for (int level = Level(footprint) - 1; level <= Level(footprint) + 1; ++level) {
      const Eigen::Vector3i center = Cell(position, level);
      for (int dx = -1; dx <= 1; ++dx) {
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dz = -1; dz <= 1; ++dz) {
            const auto cell = cells_.find(Key(level, center + Eigen::Vector3i(dx, dy, dz)));
            if (cell == cells_.end()) continue;
            for (const int vertex : cell->second) visit(vertex);
          }
        }
      }
    }
  }

 private:
  static int Level(double footprint) { return static_cast<int>(std::floor(std::log2(footprint))); }

  Eigen::Vector3i Cell(const Eigen::Vector3d& position, int level) const {
    const double size = 2 * cell_px_ * std::ldexp(1.0, level);
    return (position / size).array().floor().cast<int>();
  }

  static uint64_t Key(int level, const Eigen::Vector3i& cell) {
    uint64_t key = static_cast<uint64_t>(level + 1024) * 0xD1B54A32D192ED03ull;
    for (int axis = 0; axis < 3; ++axis) {
      key = (key ^ static_cast<uint32_t>(cell[axis])) * 0x9E3779B97F4A7C15ull;
      key ^= key >> 29;
    }
    return key;
  }

  double cell_px_;
  std::unordered_map<uint64_t, std::vector<int>> cells_;
};

}  // namespace limn
