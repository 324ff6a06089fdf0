// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "limn/model/curve_fragment.h"

namespace limn {

// How near an edgel must be to a predicted edge to support it (algorithm/notation.md#support).
struct SupportGate {
  // Largest distance across the edgel's direction, stored pixels.
  double normal_px = 1.5;
  // Largest distance along it, stored pixels: about the spacing of edgels.
  double along_px = 1.0;
  // Largest angle between the predicted direction and the edgel's, radians, undirected.
  double angle_rad = 0.26;
};

struct EdgelMatch {
  EdgelId edgel = kInvalidEdgel;
  // Signed distance of the query from the edgel's tangent line along the edgel's normal, stored
  // pixels.
  double normal_residual_px = 0;
};

// Finds edgels of one view by place and direction, on a grid over the virtual image: cells of 4 px
// in tiles of 32 px, of which only those with edgels exist. Memory: about 45 bytes per edgel.
class EdgelIndex {
 public:
  // Has no edgels.
  EdgelIndex() = default;
  // Indexes the edgels with usable[id].
  EdgelIndex(const EdgeMap& edge_map, const std::vector<bool>& usable);

  // Those of its edgels with wanted[id]. Shares its memory: a bit per edgel.
  EdgelIndex Subset(std::vector<bool> wanted) const;

  // Returns the edgel within the gate, for a unit direction of any sign, with the smallest
  //   (across^2 + along^2 / 4) / normal_px^2 + (sin angle / sin angle_rad)^2,
  // where across and along are the parts of the offset in stored pixels; the smallest id on ties.
  // Constant expected time.
  std::optional<EdgelMatch> Best(const Eigen::Vector2d& position_px,
                                 const Eigen::Vector2d& direction, const SupportGate& gate) const;

  // The same among edgels that point along `direction`, not against it: it tells the brighter side.
  std::optional<EdgelMatch> BestAlong(const Eigen::Vector2d& position_px,
                                      const Eigen::Vector2d& direction,
                                      const SupportGate& gate) const;

  // Calls `visit` for every edgel whose virtual position is within radius_px, by ascending cell.
  void ForEachWithin(const Eigen::Vector2d& position_px, double radius_px,
                     const std::function<void(EdgelId)>& visit) const;

  // Returns whether there is such an edgel.
  bool AnyWithin(const Eigen::Vector2d& position_px, double radius_px) const;

 private:
  // What look-ups need of edgels, as arrays of its parts, padded for batches.
  struct Entries {
    // From the origin of the grid.
    std::vector<float> x_px;
    std::vector<float> y_px;
    // Rows that turn an offset in the virtual image into its parts across and along the edgel,
    // stored pixels.
    std::vector<float> across_x;
    std::vector<float> across_y;
    std::vector<float> along_x;
    std::vector<float> along_y;
    // Unit, virtual image.
    std::vector<float> tangent_x;
    std::vector<float> tangent_y;
    std::vector<EdgelId> id;
  };
  struct GateQuery;

  // The edgels by place.
  struct Grid {
    Grid(const EdgeMap& edge_map, const std::vector<bool>& usable);

    void MakeTiles(const EdgeMap& edge_map, const std::vector<bool>& usable);
    Eigen::Vector2i CellAt(const Eigen::Vector2d& position_px) const;  // column, row
    size_t TileOf(const Eigen::Vector2i& cell) const;
    // Index in cell_begin of the cell of an edgel whose tile exists.
    int CellOf(const Edgel& edgel) const;
    // Calls visit(begin, end) for runs of entries that hold all within the radius, and others.
    template <typename Visit>
    void VisitRuns(const Eigen::Vector2d& position_px, double radius_px, Visit&& visit) const;

    Eigen::Vector2d origin = Eigen::Vector2d::Zero();
    int cols = 0;
    int rows = 0;
    int tile_cols = 0;
    std::vector<int> first_cell;  // per tile, row-major: its place in cell_begin, -1 = no edgels
    std::vector<int> cell_begin;  // tile by tile, cells of a tile row-major; one more than cells
    Entries entries;              // by cell, ascending ids within a cell
    double max_scale = 1;
  };

  bool Has(EdgelId id) const { return wanted_.empty() || wanted_[id]; }
  template <bool kAlong>
  std::optional<EdgelMatch> FindBest(const Eigen::Vector2d& position_px,
                                     const Eigen::Vector2d& direction,
                                     const SupportGate& gate) const;

  std::shared_ptr<const Grid> grid_;  // null: no edgels
  std::vector<bool> wanted_;          // per edgel; empty: all
};

// Per edgel, whether it belongs to a fragment. An isolated edgel may be noise.
std::vector<bool> LinkedEdgels(const ImageCurves& curves);

}  // namespace limn
