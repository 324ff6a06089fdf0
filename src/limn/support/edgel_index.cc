// SPDX-License-Identifier: BSD-3-Clause
#include "limn/support/edgel_index.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/LU>

#include "limn/util/float8.h"

namespace limn {
namespace {

constexpr double kCellPx = 4;
// Cells on a side of a tile.
constexpr int kTileCells = 8;
// Squared distances along an edgel count by this: of edgels, those beside a place show it best.
constexpr double kAlongCost = 0.25;
// Entries that are looked at together.
constexpr int kBatch = 8;
// Entries looked at before one is judged; a multiple of the former.
constexpr int kMaxInGate = 64;

double VirtualPerStored(const Edgel& edgel) {
  if (edgel.stored_from_virtual == Eigen::Matrix2f::Identity()) return 1;
  const Eigen::Matrix2f inverse = edgel.stored_from_virtual.inverse();
  return std::max(inverse.col(0).norm(), inverse.col(1).norm());
}

}  // namespace

// What is asked of the entries.
struct EdgelIndex::GateQuery {
  Eigen::Vector2f position_px;  // from the origin
  Eigen::Vector2f direction;
  float normal_px;
  float along_px;
  float max_sine;

  // Writes the indices of the entries from `begin` to `end` that are within the gate; returns how
  // many.
  LIMN_INLINE_KERNEL int Find(const Entries& entries, int begin, int end, int* found) const {
    int num_found = 0;
    for (int i = begin; i < end; i += kBatch) {
      Float8 x, y, across_x, across_y, along_x, along_y, tangent_x, tangent_y;
      Load8(entries.x_px.data() + i, &x);
      Load8(entries.y_px.data() + i, &y);
      Load8(entries.across_x.data() + i, &across_x);
      Load8(entries.across_y.data() + i, &across_y);
      Load8(entries.along_x.data() + i, &along_x);
      Load8(entries.along_y.data() + i, &along_y);
      Load8(entries.tangent_x.data() + i, &tangent_x);
      Load8(entries.tangent_y.data() + i, &tangent_y);
      x = position_px.x() - x;
      y = position_px.y() - y;
      const Float8 normal = across_x * x + across_y * y;
      const Float8 along = along_x * x + along_y * y;
      const Float8 sine = tangent_x * direction.y() - tangent_y * direction.x();
      const Mask8 is_in = (normal <= normal_px) & (normal >= -normal_px) & (along <= along_px) &
                          (along >= -along_px) & (sine <= max_sine) & (sine >= -max_sine);
      unsigned bits = Bits8(is_in);
      const int left = end - i;
      if (left < kBatch) bits &= (1u << left) - 1;
      for (; bits != 0; bits &= bits - 1) found[num_found++] = i + std::countr_zero(bits);
    }
    return num_found;
  }
  LIMN_FOR_AVX2 int FindByAvx2(const Entries& entries, int begin, int end, int* found) const {
    return Find(entries, begin, end, found);
  }
  int FindBySse2(const Entries& entries, int begin, int end, int* found) const {
    return Find(entries, begin, end, found);
  }
};

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
  const size_t size = cell_begin.back();
  for (auto* part : {&entries.x_px, &entries.y_px, &entries.across_x, &entries.across_y,
                     &entries.along_x, &entries.along_y, &entries.tangent_x, &entries.tangent_y}) {
    part->resize(size + kBatch, 0);
  }
  entries.id.resize(size);
  std::vector<int> next(cell_begin.begin(), cell_begin.end() - 1);
  for (size_t id = 0; id < edge_map.edgels.size(); ++id) {
    if (!usable[id]) continue;
    const Edgel& edgel = edge_map.edgels[id];
    const Eigen::Matrix2d stored_from_virtual = edgel.stored_from_virtual.cast<double>();
    const Eigen::Vector2d in_virtual = edgel.Tangent();
    const Eigen::Vector2d tangent = (stored_from_virtual * in_virtual).normalized();
    const Eigen::Vector2d normal(tangent.y(), -tangent.x());
    const Eigen::Vector2f position = (edgel.position_px - origin).cast<float>();
    const Eigen::Vector2f across = (stored_from_virtual.transpose() * normal).cast<float>();
    const Eigen::Vector2f along = (stored_from_virtual.transpose() * tangent).cast<float>();
    const int at = next[CellOf(edgel)]++;
    entries.x_px[at] = position.x();
    entries.y_px[at] = position.y();
    entries.across_x[at] = across.x();
    entries.across_y[at] = across.y();
    entries.along_x[at] = along.x();
    entries.along_y[at] = along.y();
    entries.tangent_x[at] = static_cast<float>(in_virtual.x());
    entries.tangent_y[at] = static_cast<float>(in_virtual.y());
    entries.id[at] = static_cast<EdgelId>(id);
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
void EdgelIndex::Grid::VisitRuns(const Eigen::Vector2d& position_px, double radius_px,
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
        visit(begin[col % kTileCells], begin[(next_col - 1) % kTileCells + 1]);
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
  const Entries& entries = grid_->entries;
  const double radius_px = std::hypot(gate.normal_px, gate.along_px) * grid_->max_scale;
  // From a right angle on every direction will do.
  const double max_sine = gate.angle_rad < M_PI / 2 ? std::sin(gate.angle_rad) : 2;
  const double per_squared_px = 1 / (gate.normal_px * gate.normal_px);
  const double per_squared_sine = 1 / (max_sine * max_sine);
  const Eigen::Vector2d from_origin = position_px - grid_->origin;
  const GateQuery query{from_origin.cast<float>(), direction.cast<float>(),
                        static_cast<float>(gate.normal_px), static_cast<float>(gate.along_px),
                        static_cast<float>(max_sine)};
  EdgelMatch best;
  double best_cost = std::numeric_limits<double>::infinity();
  const auto judge = [&](int i) {
    const EdgelId id = entries.id[i];
    if (!Has(id)) return;
    const double turn = entries.tangent_x[i] * direction.x() + entries.tangent_y[i] * direction.y();
    if (kAlong && turn <= 0) return;
    const Eigen::Vector2d offset = from_origin - Eigen::Vector2d(entries.x_px[i], entries.y_px[i]);
    const double normal = entries.across_x[i] * offset.x() + entries.across_y[i] * offset.y();
    const double along = entries.along_x[i] * offset.x() + entries.along_y[i] * offset.y();
    const double sine = entries.tangent_x[i] * direction.y() - entries.tangent_y[i] * direction.x();
    const double cost = (normal * normal + kAlongCost * along * along) * per_squared_px +
                        sine * sine * per_squared_sine;
    if (cost < best_cost || (cost == best_cost && id < best.edgel)) {
      best_cost = cost;
      best = {id, normal};
    }
  };
  const bool has_avx2 = HasAvx2();
  grid_->VisitRuns(position_px, radius_px, [&](int begin, int end) {
    std::array<int, kMaxInGate> hits;
    for (int first = begin; first < end; first += kMaxInGate) {
      const int last = std::min(end, first + kMaxInGate);
      const int num_hits = has_avx2 ? query.FindByAvx2(entries, first, last, hits.data())
                                    : query.FindBySse2(entries, first, last, hits.data());
      for (int h = 0; h < num_hits; ++h) judge(hits[h]);
    }
  });
  if (best.edgel == kInvalidEdgel) return std::nullopt;
  return best;
}

void EdgelIndex::ForEachWithin(const Eigen::Vector2d& position_px, double radius_px,
                               const std::function<void(EdgelId)>& visit) const {
  if (!grid_) return;
  const Entries& entries = grid_->entries;
  const Eigen::Vector2d from_origin = position_px - grid_->origin;
  grid_->VisitRuns(position_px, radius_px, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const Eigen::Vector2d offset =
          Eigen::Vector2d(entries.x_px[i], entries.y_px[i]) - from_origin;
      const bool is_near = offset.squaredNorm() <= radius_px * radius_px;
      if (is_near && Has(entries.id[i])) visit(entries.id[i]);
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
