#include "limn/support/fragment_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

constexpr double kCellPx = 5;

// The part of the segment inside a box, as parameters in [0, 1]; empty when first > second.
std::pair<double, double> ClipToBox(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                    const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
  double begin = 0;
  double end = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double delta = to[axis] - from[axis];
    if (delta == 0) {
      if (from[axis] < low[axis] || from[axis] > high[axis]) return {1, 0};
      continue;
    }
    double near = (low[axis] - from[axis]) / delta;
    double far = (high[axis] - from[axis]) / delta;
    if (near > far) std::swap(near, far);
    begin = std::max(begin, near);
    end = std::min(end, far);
  }
  return {begin, end};
}

}  // namespace

FragmentIndex::FragmentIndex(const ImageCurves& curves) {
  const auto& edgels = curves.edge_map.edgels;
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  std::vector<Chord> all;
  for (size_t f = 0; f < curves.fragments.size(); ++f) {
    const CurveFragment& fragment = curves.fragments[f];
    const int count = static_cast<int>(fragment.edgel_ids.size());
    const int num_chords = fragment.closed ? count : count - 1;
    for (int k = 0; k < num_chords; ++k) {
      const Eigen::Vector2d& begin = edgels[fragment.edgel_ids[k]].position_px;
      const Eigen::Vector2d& end = edgels[fragment.edgel_ids[(k + 1) % count]].position_px;
      low = low.cwiseMin(begin).cwiseMin(end);
      high = high.cwiseMax(begin).cwiseMax(end);
      const Eigen::Vector2d tangent = edgels[fragment.edgel_ids[k]].Tangent();
      const Eigen::Vector2d next = edgels[fragment.edgel_ids[(k + 1) % count]].Tangent();
      const double sign = tangent.dot(next) < 0 ? -1 : 1;
      all.push_back({static_cast<int>(f), k, begin.cast<float>(), end.cast<float>(),
                     tangent.cast<float>(), (sign * next).cast<float>()});
    }
  }
  if (all.empty()) {
    cell_begin_.assign(1, 0);
    return;
  }
  origin_ = low - Eigen::Vector2d::Constant(1e-3);
  cols_ = static_cast<int>((high.x() - origin_.x()) / kCellPx) + 1;
  rows_ = static_cast<int>((high.y() - origin_.y()) / kCellPx) + 1;
  cell_begin_.assign(static_cast<size_t>(cols_) * rows_ + 1, 0);
  const auto for_each_cell = [&](const Chord& chord, auto&& visit) {
    const Eigen::Vector2d a = (chord.begin.cast<double>() - origin_) / kCellPx;
    const Eigen::Vector2d b = (chord.end.cast<double>() - origin_) / kCellPx;
    for (int row = static_cast<int>(std::min(a.y(), b.y()));
         row <= static_cast<int>(std::max(a.y(), b.y())); ++row) {
      for (int col = static_cast<int>(std::min(a.x(), b.x()));
           col <= static_cast<int>(std::max(a.x(), b.x())); ++col) {
        visit(std::min(row, rows_ - 1) * cols_ + std::min(col, cols_ - 1));
      }
    }
  };
  for (const Chord& chord : all) for_each_cell(chord, [&](int cell) { ++cell_begin_[cell + 1]; });
  for (size_t i = 1; i < cell_begin_.size(); ++i) cell_begin_[i] += cell_begin_[i - 1];
  chords_.resize(cell_begin_.back());
  std::vector<int> next(cell_begin_.begin(), cell_begin_.end() - 1);
  for (const Chord& chord : all)
    for_each_cell(chord, [&](int cell) { chords_[next[cell]++] = chord; });
}

void FragmentIndex::VisitCell(int col, int row, const Segment& segment,
                              std::vector<LineCrossing>* crossings) const {
  const int cell = row * cols_ + col;
  for (int i = cell_begin_[cell]; i < cell_begin_[cell + 1]; ++i) {
    const Chord& chord = chords_[i];
    // Distances from the line, in single precision: good to 1e-4 px, and the same for both chords
    // at a shared vertex, so that a line through it crosses exactly one (half-open) of them.
    const Eigen::Vector2f to_begin = chord.begin - segment.origin;
    const Eigen::Vector2f to_end = chord.end - segment.origin;
    const Eigen::Vector2f& direction = segment.direction;
    const float side_begin = direction.x() * to_begin.y() - direction.y() * to_begin.x();
    const float side_end = direction.x() * to_end.y() - direction.y() * to_end.x();
    if ((side_begin >= 0) == (side_end >= 0)) continue;
    const double t = static_cast<double>(side_begin) / (side_begin - side_end);
    const Eigen::Vector2d begin = chord.begin.cast<double>();
    const Eigen::Vector2d position = begin + t * (chord.end.cast<double>() - begin);
    // A chord is listed in every cell it touches: only the cell of the crossing counts it.
    const Eigen::Vector2d at = (position - origin_) / kCellPx;
    if (static_cast<int>(at.x()) != col || static_cast<int>(at.y()) != row) continue;
    const float along = direction.dot(position.cast<float>() - segment.origin);
    if (along < 0 || along > segment.length) continue;
    crossings->push_back(
        {chord.fragment, chord.vertex + t, position,
         ((1 - t) * chord.tangent_begin.cast<double>() + t * chord.tangent_end.cast<double>())
             .normalized()});
  }
}

void FragmentIndex::Crossings(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                              std::vector<LineCrossing>* crossings) const {
  if (cols_ == 0) return;
  const Eigen::Vector2d high = origin_ + kCellPx * Eigen::Vector2d(cols_, rows_);
  const auto [begin, end] = ClipToBox(from, to, origin_, high);
  if (!(begin <= end)) return;
  const Segment segment{from.cast<float>(), (to - from).normalized().cast<float>(),
                        static_cast<float>((to - from).norm())};
  // Walk column by column (or row by row) of the steeper axis; in each, the cells the line touches.
  const Eigen::Vector2d start = (from + begin * (to - from) - origin_) / kCellPx;
  const Eigen::Vector2d stop = (from + end * (to - from) - origin_) / kCellPx;
  const int major = std::abs(stop.x() - start.x()) >= std::abs(stop.y() - start.y()) ? 0 : 1;
  const int minor = 1 - major;
  const int size[2] = {cols_, rows_};
  const auto clamp_cell = [&](double value, int axis) {
    return std::clamp(static_cast<int>(std::floor(value)), 0, size[axis] - 1);
  };
  const int first = clamp_cell(start[major], major);
  const int last = clamp_cell(stop[major], major);
  const int step = first <= last ? 1 : -1;
  const double delta = stop[major] - start[major];
  const double slope = delta != 0 ? (stop[minor] - start[minor]) / delta : 0;
  for (int i = first;; i += step) {
    const double low_edge = std::clamp<double>(i, std::min(start[major], stop[major]),
                                               std::max(start[major], stop[major]));
    const double high_edge = std::clamp<double>(i + 1, std::min(start[major], stop[major]),
                                                std::max(start[major], stop[major]));
    const int a = clamp_cell(start[minor] + slope * (low_edge - start[major]) - 1e-9, minor);
    const int b = clamp_cell(start[minor] + slope * (high_edge - start[major]) - 1e-9, minor);
    const int c = clamp_cell(start[minor] + slope * (low_edge - start[major]) + 1e-9, minor);
    const int d = clamp_cell(start[minor] + slope * (high_edge - start[major]) + 1e-9, minor);
    for (int j = std::min({a, b, c, d}); j <= std::max({a, b, c, d}); ++j) {
      VisitCell(major == 0 ? i : j, major == 0 ? j : i, segment, crossings);
    }
    if (i == last) break;
  }
}

}  // namespace limn
