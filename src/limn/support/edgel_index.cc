#include "limn/support/edgel_index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/LU>

namespace limn {
namespace {

constexpr double kCellPx = 4;
// Cells on a side of a tile.
constexpr int kTileCells = 8;
// Squared distances along an edgel count by this: of edgels, those beside a place show it best.
constexpr double kAlongCost = 0.25;

double VirtualPerStored(const Edgel& edgel) {
  if (edgel.stored_from_virtual == Eigen::Matrix2f::Identity()) return 1;
  const Eigen::Matrix2f inverse = edgel.stored_from_virtual.inverse();
  return std::max(inverse.col(0).norm(), inverse.col(1).norm());
}

}  // namespace

EdgelIndex::EdgelIndex(const EdgeMap& edge_map, const std::vector<bool>& usable)
    : grid_(std::make_shared<const Grid>(edge_map, usable)) {}

EdgelIndex EdgelIndex::Subset(std::vector<bool> wanted) const {
  EdgelIndex subset = *this;
  subset.wanted_ = std::move(wanted);
  return subset;
}

EdgelIndex::Grid::Grid(const EdgeMap& edge_map, const std::vector<bool>& usable) {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  for (size_t id = 0; id < edge_map.edgels.size(); ++id) {
    if (!usable[id]) continue;
    low = low.cwiseMin(edge_map.edgels[id].position_px);
    high = high.cwiseMax(edge_map.edgels[id].position_px);
    max_scale = std::max(max_scale, VirtualPerStored(edge_map.edgels[id]));
  }
  if (!(low.x() <= high.x())) {
    cell_begin.assign(1, 0);
    return;
  }
  origin = low;
  cols = static_cast<int>((high.x() - low.x()) / kCellPx) + 1;
  rows = static_cast<int>((high.y() - low.y()) / kCellPx) + 1;
  MakeTiles(edge_map, usable);
  for (size_t id = 0; id < edge_map.edgels.size(); ++id) {
    if (usable[id]) ++cell_begin[CellOf(edge_map.edgels[id]) + 1];
  }
  for (size_t i = 1; i < cell_begin.size(); ++i) cell_begin[i] += cell_begin[i - 1];
  entries.resize(cell_begin.back());
  std::vector<int> next(cell_begin.begin(), cell_begin.end() - 1);
  for (size_t id = 0; id < edge_map.edgels.size(); ++id) {
    if (!usable[id]) continue;
    const Edgel& edgel = edge_map.edgels[id];
    const Eigen::Matrix2d stored_from_virtual = edgel.stored_from_virtual.cast<double>();
    const Eigen::Vector2d in_virtual = edgel.Tangent();
    const Eigen::Vector2d tangent = (stored_from_virtual * in_virtual).normalized();
    const Eigen::Vector2d normal(tangent.y(), -tangent.x());
    entries[next[CellOf(edgel)]++] = {edgel.position_px,
                                      (stored_from_virtual.transpose() * normal).cast<float>(),
                                      (stored_from_virtual.transpose() * tangent).cast<float>(),
                                      in_virtual.cast<float>(), static_cast<EdgelId>(id)};
  }
}

void EdgelIndex::Grid::MakeTiles(const EdgeMap& edge_map, const std::vector<bool>& usable) {
  tile_cols = (cols + kTileCells - 1) / kTileCells;
  const int tile_rows = (rows + kTileCells - 1) / kTileCells;
  first_cell.assign(static_cast<size_t>(tile_cols) * tile_rows, -1);
  for (size_t id = 0; id < edge_map.edgels.size(); ++id) {
    if (usable[id]) first_cell[TileOf(CellAt(edge_map.edgels[id].position_px))] = 0;
  }
  int num_cells = 0;
  for (int& first : first_cell) {
    if (first < 0) continue;
    first = num_cells;
    num_cells += kTileCells * kTileCells;
  }
  cell_begin.assign(num_cells + 1, 0);
}

Eigen::Vector2i EdgelIndex::Grid::CellAt(const Eigen::Vector2d& position_px) const {
  return ((position_px - origin) / kCellPx).cast<int>();
}

size_t EdgelIndex::Grid::TileOf(const Eigen::Vector2i& cell) const {
  return static_cast<size_t>(cell.y() / kTileCells) * tile_cols + cell.x() / kTileCells;
}

int EdgelIndex::Grid::CellOf(const Edgel& edgel) const {
  const Eigen::Vector2i cell = CellAt(edgel.position_px);
  return first_cell[TileOf(cell)] + cell.y() % kTileCells * kTileCells + cell.x() % kTileCells;
}

template <typename Visit>
void EdgelIndex::Grid::VisitCells(const Eigen::Vector2d& position_px, double radius_px,
                                  Visit&& visit) const {
  const Eigen::Vector2d low = (position_px - origin).array() - radius_px;
  const Eigen::Vector2d high = (position_px - origin).array() + radius_px;
  // Also false for what is not a number.
  if (!(high.x() >= 0 && high.y() >= 0 && low.x() < cols * kCellPx && low.y() < rows * kCellPx)) {
    return;
  }
  const int col_begin = static_cast<int>(std::max(0.0, low.x()) / kCellPx);
  const int col_end = static_cast<int>(std::min(high.x() / kCellPx, cols - 1.0));
  const int row_begin = static_cast<int>(std::max(0.0, low.y()) / kCellPx);
  const int row_end = static_cast<int>(std::min(high.y() / kCellPx, rows - 1.0));
  for (int row = row_begin; row <= row_end; ++row) {
    for (int col = col_begin; col <= col_end;) {
      const int next_col = std::min(col_end + 1, (col / kTileCells + 1) * kTileCells);
      const int first = first_cell[TileOf({col, row})];
      if (first >= 0) {
        // The cells of a row of a tile follow each other.
        const int* begin = cell_begin.data() + first + row % kTileCells * kTileCells;
        const int last = begin[(next_col - 1) % kTileCells + 1];
        for (int i = begin[col % kTileCells]; i < last; ++i) visit(entries[i]);
      }
      col = next_col;
    }
  }
}

std::optional<EdgelMatch> EdgelIndex::Best(const Eigen::Vector2d& position_px,
                                           const Eigen::Vector2d& direction,
                                           const SupportGate& gate) const {
  return FindBest<false>(position_px, direction, gate);
}

std::optional<EdgelMatch> EdgelIndex::BestAlong(const Eigen::Vector2d& position_px,
                                                const Eigen::Vector2d& direction,
                                                const SupportGate& gate) const {
  return FindBest<true>(position_px, direction, gate);
}

template <bool kAlong>
std::optional<EdgelMatch> EdgelIndex::FindBest(const Eigen::Vector2d& position_px,
                                               const Eigen::Vector2d& direction,
                                               const SupportGate& gate) const {
  if (!grid_) return std::nullopt;
  const double radius_px = std::hypot(gate.normal_px, gate.along_px) * grid_->max_scale;
  // From a right angle on every direction will do.
  const double max_sine = gate.angle_rad < M_PI / 2 ? std::sin(gate.angle_rad) : 2;
  const double per_squared_px = 1 / (gate.normal_px * gate.normal_px);
  const double per_squared_sine = 1 / (max_sine * max_sine);
  EdgelMatch best;
  double best_cost = std::numeric_limits<double>::infinity();
  grid_->VisitCells(position_px, radius_px, [&](const Entry& edgel) {
    const Eigen::Vector2d offset = position_px - edgel.position_px;
    const double normal = edgel.across.x() * offset.x() + edgel.across.y() * offset.y();
    const double along = edgel.along.x() * offset.x() + edgel.along.y() * offset.y();
    const double sine = edgel.tangent.x() * direction.y() - edgel.tangent.y() * direction.x();
    // Bitwise: one branch for all three.
    const bool is_in = (std::abs(normal) <= gate.normal_px) & (std::abs(along) <= gate.along_px) &
                       (std::abs(sine) <= max_sine);
    if (!is_in || !Has(edgel.id)) return;
    if constexpr (kAlong) {
      if (edgel.tangent.x() * direction.x() + edgel.tangent.y() * direction.y() <= 0) return;
    }
    const double cost = (normal * normal + kAlongCost * along * along) * per_squared_px +
                        sine * sine * per_squared_sine;
    if (cost < best_cost || (cost == best_cost && edgel.id < best.edgel)) {
      best_cost = cost;
      best = {edgel.id, normal};
    }
  });
  if (best.edgel == kInvalidEdgel) return std::nullopt;
  return best;
}

void EdgelIndex::ForEachWithin(const Eigen::Vector2d& position_px, double radius_px,
                               const std::function<void(EdgelId)>& visit) const {
  if (!grid_) return;
  grid_->VisitCells(position_px, radius_px, [&](const Entry& edgel) {
    const bool is_near = (edgel.position_px - position_px).squaredNorm() <= radius_px * radius_px;
    if (is_near && Has(edgel.id)) visit(edgel.id);
  });
}

bool EdgelIndex::AnyWithin(const Eigen::Vector2d& position_px, double radius_px) const {
  bool found = false;
  ForEachWithin(position_px, radius_px, [&](EdgelId) { found = true; });
  return found;
}

std::vector<bool> LinkedEdgels(const ImageCurves& curves) {
  std::vector<bool> linked(curves.edge_map.edgels.size(), false);
  for (const CurveFragment& fragment : curves.fragments) {
    for (const EdgelId id : fragment.edgel_ids) linked[id] = true;
  }
  return linked;
}

}  // namespace limn
