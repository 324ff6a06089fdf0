#include "limn/support/edgel_index.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "limn/util/float8.h"

namespace limn {
namespace {

constexpr double kCellPx = 4;
// Cells on a side of a tile.
constexpr int kTileCells = 8;
constexpr double kTilePx = kTileCells * kCellPx;

double VirtualPerStored(const Edgel& edgel) {
  if (edgel.stored_from_virtual == Eigen::Matrix2f::Identity()) return 1;
  const Eigen::Matrix2f inverse = edgel.stored_from_virtual.inverse();
  return std::max(inverse.col(0).norm(), inverse.col(1).norm());
}

}  // namespace

// A look-up in one tile: place from its corner, direction, gate and weights of the cost.
struct EdgelIndex::Query {
  float x, y;
  float direction_x, direction_y;
  float normal_px, along_px, sine;
  float per_squared_px, per_squared_sine;
};

struct EdgelIndex::Nearest {
  float cost = std::numeric_limits<float>::infinity();
  int entry = -1;
  size_t tile = 0;
};

EdgelIndex::EdgelIndex(const EdgeMap& edge_map, const std::vector<bool>& usable) {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  for (size_t id = 0; id < edge_map.edgels.size(); ++id) {
    if (!usable[id]) continue;
    low = low.cwiseMin(edge_map.edgels[id].position_px);
    high = high.cwiseMax(edge_map.edgels[id].position_px);
    max_scale_ = std::max(max_scale_, VirtualPerStored(edge_map.edgels[id]));
  }
  if (!(low.x() <= high.x())) {
    cell_begin_.assign(1, 0);
    return;
  }
  origin_ = low;
  cols_ = static_cast<int>((high.x() - low.x()) / kCellPx) + 1;
  rows_ = static_cast<int>((high.y() - low.y()) / kCellPx) + 1;
  MakeTiles(edge_map, usable);
  for (size_t id = 0; id < edge_map.edgels.size(); ++id) {
    if (usable[id]) ++cell_begin_[CellOf(edge_map.edgels[id]) + 1];
  }
  for (size_t i = 1; i < cell_begin_.size(); ++i) cell_begin_[i] += cell_begin_[i - 1];
  ids_.resize(cell_begin_.back());
  batches_.resize((ids_.size() + kLanes - 1) / kLanes);
  std::vector<int> next(cell_begin_.begin(), cell_begin_.end() - 1);
  for (size_t id = 0; id < edge_map.edgels.size(); ++id) {
    if (!usable[id]) continue;
    const Edgel& edgel = edge_map.edgels[id];
    const int entry = next[CellOf(edgel)]++;
    ids_[entry] = static_cast<EdgelId>(id);
    Fill(edgel, TileOf(CellAt(edgel.position_px)), entry);
  }
}

void EdgelIndex::Fill(const Edgel& edgel, size_t tile, int entry) {
  const Eigen::Matrix2d stored_from_virtual = edgel.stored_from_virtual.cast<double>();
  const Eigen::Vector2d in_virtual = edgel.Tangent();
  const Eigen::Vector2d tangent = (stored_from_virtual * in_virtual).normalized();
  const Eigen::Vector2d normal(tangent.y(), -tangent.x());
  const Eigen::Vector2d across = stored_from_virtual.transpose() * normal;
  const Eigen::Vector2d along = stored_from_virtual.transpose() * tangent;
  const Eigen::Vector2d place = edgel.position_px - CornerOf(tile);
  const Eigen::Vector2f rounded = place.cast<float>();
  const Eigen::Vector2f rest = (place - rounded.cast<double>()).cast<float>();
  Batch& batch = batches_[entry / kLanes];
  const int lane = entry % kLanes;
  batch.x[lane] = rounded.x();
  batch.y[lane] = rounded.y();
  batch.rest_x[lane] = rest.x();
  batch.rest_y[lane] = rest.y();
  batch.across_x[lane] = static_cast<float>(across.x());
  batch.across_y[lane] = static_cast<float>(across.y());
  batch.along_x[lane] = static_cast<float>(along.x());
  batch.along_y[lane] = static_cast<float>(along.y());
  batch.tangent_x[lane] = static_cast<float>(in_virtual.x());
  batch.tangent_y[lane] = static_cast<float>(in_virtual.y());
}

Eigen::Vector2d EdgelIndex::CornerOf(size_t tile) const {
  const auto col = static_cast<double>(tile % tile_cols_);
  const auto row = static_cast<double>(tile / tile_cols_);
  return origin_ + kTilePx * Eigen::Vector2d(col, row);
}

Eigen::Vector2d EdgelIndex::PositionOf(size_t tile, int entry) const {
  const Batch& batch = batches_[entry / kLanes];
  const int lane = entry % kLanes;
  const Eigen::Vector2d place(double{batch.x[lane]} + batch.rest_x[lane],
                              double{batch.y[lane]} + batch.rest_y[lane]);
  return CornerOf(tile) + place;
}

void EdgelIndex::MakeTiles(const EdgeMap& edge_map, const std::vector<bool>& usable) {
  tile_cols_ = (cols_ + kTileCells - 1) / kTileCells;
  const int tile_rows = (rows_ + kTileCells - 1) / kTileCells;
  first_cell_.assign(static_cast<size_t>(tile_cols_) * tile_rows, -1);
  for (size_t id = 0; id < edge_map.edgels.size(); ++id) {
    if (usable[id]) first_cell_[TileOf(CellAt(edge_map.edgels[id].position_px))] = 0;
  }
  int num_cells = 0;
  for (int& first : first_cell_) {
    if (first < 0) continue;
    first = num_cells;
    num_cells += kTileCells * kTileCells;
  }
  cell_begin_.assign(num_cells + 1, 0);
}

Eigen::Vector2i EdgelIndex::CellAt(const Eigen::Vector2d& position_px) const {
  return ((position_px - origin_) / kCellPx).cast<int>();
}

size_t EdgelIndex::TileOf(const Eigen::Vector2i& cell) const {
  return static_cast<size_t>(cell.y() / kTileCells) * tile_cols_ + cell.x() / kTileCells;
}

int EdgelIndex::CellOf(const Edgel& edgel) const {
  const Eigen::Vector2i cell = CellAt(edgel.position_px);
  return first_cell_[TileOf(cell)] + cell.y() % kTileCells * kTileCells + cell.x() % kTileCells;
}

template <typename Visit>
void EdgelIndex::VisitCells(const Eigen::Vector2d& position_px, double radius_px,
                            Visit&& visit) const {
  const Eigen::Vector2d low = (position_px - origin_).array() - radius_px;
  const Eigen::Vector2d high = (position_px - origin_).array() + radius_px;
  // Also false for what is not a number.
  if (!(high.x() >= 0 && high.y() >= 0 && low.x() < cols_ * kCellPx && low.y() < rows_ * kCellPx)) {
    return;
  }
  const int col_begin = static_cast<int>(std::max(0.0, low.x()) / kCellPx);
  const int col_end = static_cast<int>(std::min(high.x() / kCellPx, cols_ - 1.0));
  const int row_begin = static_cast<int>(std::max(0.0, low.y()) / kCellPx);
  const int row_end = static_cast<int>(std::min(high.y() / kCellPx, rows_ - 1.0));
  for (int row = row_begin; row <= row_end; ++row) {
    for (int col = col_begin; col <= col_end;) {
      const int next_col = std::min(col_end + 1, (col / kTileCells + 1) * kTileCells);
      const size_t tile = TileOf({col, row});
      if (const int first = first_cell_[tile]; first >= 0) {
        // The cells of a row of a tile follow each other.
        const int* begin = cell_begin_.data() + first + row % kTileCells * kTileCells;
        visit(tile, begin[col % kTileCells], begin[(next_col - 1) % kTileCells + 1]);
      }
      col = next_col;
    }
  }
}

// Of the entries in [begin, end) in the gate the one with the smallest cost, if below that of
// `nearest`. On ties the smallest id.
struct EdgelIndex::Kernel {
  LIMN_INLINE_KERNEL static void Find(const EdgelIndex& index, const Query& query, size_t tile,
                                      int begin, int end, Nearest* nearest) {
    for (int first = begin / kLanes * kLanes; first < end; first += kLanes) {
      const Batch& batch = index.batches_[first / kLanes];
      Float8 x, y, across_x, across_y, along_x, along_y, tangent_x, tangent_y;
      Load8(batch.x, &x);
      Load8(batch.y, &y);
      Load8(batch.across_x, &across_x);
      Load8(batch.across_y, &across_y);
      Load8(batch.along_x, &along_x);
      Load8(batch.along_y, &along_y);
      Load8(batch.tangent_x, &tangent_x);
      Load8(batch.tangent_y, &tangent_y);
      const Float8 right = query.x - x;
      const Float8 down = query.y - y;
      const Float8 normal = across_x * right + across_y * down;
      const Float8 along = along_x * right + along_y * down;
      const Float8 sine = tangent_x * query.direction_y - tangent_y * query.direction_x;
      const Float8 costs = (normal * normal + 0.25f * along * along) * query.per_squared_px +
                           sine * sine * query.per_squared_sine;
      const Mask8 is_in = (normal <= query.normal_px) & (normal >= -query.normal_px) &
                          (along <= query.along_px) & (along >= -query.along_px) &
                          (sine <= query.sine) & (sine >= -query.sine) & (costs <= nearest->cost);
      unsigned bits = Bits8(is_in);
      if (first < begin) bits &= ~0u << (begin - first);
      if (end - first < kLanes) bits &= (1u << (end - first)) - 1;
      if (bits == 0) continue;
      float cost[kLanes];
      Store8(costs, cost);
      for (; bits != 0; bits &= bits - 1) {
        const int lane = std::countr_zero(bits);
        const int entry = first + lane;
        const bool is_nearer =
            cost[lane] < nearest->cost ||
            (cost[lane] == nearest->cost && index.ids_[entry] < index.ids_[nearest->entry]);
        if (is_nearer) *nearest = {cost[lane], entry, tile};
      }
    }
  }
  LIMN_FOR_AVX2 static void FindByAvx2(const EdgelIndex& index, const Query& query, size_t tile,
                                       int begin, int end, Nearest* nearest) {
    Find(index, query, tile, begin, end, nearest);
  }
  static void FindBySse2(const EdgelIndex& index, const Query& query, size_t tile, int begin,
                         int end, Nearest* nearest) {
    Find(index, query, tile, begin, end, nearest);
  }
};

std::optional<EdgelMatch> EdgelIndex::Best(const Eigen::Vector2d& position_px,
                                           const Eigen::Vector2d& direction,
                                           const SupportGate& gate) const {
  const double radius_px = std::hypot(gate.normal_px, gate.along_px) * max_scale_;
  // From a right angle on every direction will do.
  const double max_sine = gate.angle_rad < M_PI / 2 ? std::sin(gate.angle_rad) : 2;
  Query query;
  query.direction_x = static_cast<float>(direction.x());
  query.direction_y = static_cast<float>(direction.y());
  query.normal_px = static_cast<float>(gate.normal_px);
  query.along_px = static_cast<float>(gate.along_px);
  query.sine = static_cast<float>(max_sine);
  query.per_squared_px = static_cast<float>(1 / (gate.normal_px * gate.normal_px));
  query.per_squared_sine = static_cast<float>(1 / (max_sine * max_sine));
  static const auto find = HasAvx2() ? Kernel::FindByAvx2 : Kernel::FindBySse2;
  Nearest nearest;
  VisitCells(position_px, radius_px, [&](size_t tile, int begin, int end) {
    const Eigen::Vector2f place = (position_px - CornerOf(tile)).cast<float>();
    query.x = place.x();
    query.y = place.y();
    find(*this, query, tile, begin, end, &nearest);
  });
  if (nearest.entry < 0) return std::nullopt;
  const Batch& batch = batches_[nearest.entry / kLanes];
  const int lane = nearest.entry % kLanes;
  const Eigen::Vector2d offset = position_px - PositionOf(nearest.tile, nearest.entry);
  return EdgelMatch{ids_[nearest.entry],
                    batch.across_x[lane] * offset.x() + batch.across_y[lane] * offset.y()};
}

void EdgelIndex::ForEachWithin(const Eigen::Vector2d& position_px, double radius_px,
                               const std::function<void(EdgelId)>& visit) const {
  VisitCells(position_px, radius_px, [&](size_t tile, int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const Eigen::Vector2d offset = PositionOf(tile, i) - position_px;
      if (offset.squaredNorm() <= radius_px * radius_px) visit(ids_[i]);
    }
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
