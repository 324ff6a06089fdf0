// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/volume_overlap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

#include <Eigen/Geometry>

#include "limn/util/errors.h"
#include "limn/util/number_text.h"

namespace limn {
namespace {

constexpr double kFirstLinesPerRadius = 8;
constexpr double kMaxFirstChords = 1e8;
constexpr double kMaxChords = 4e8;
constexpr double kMaxLinesAcross = 1e14;

// Unlike any direction that buildings prefer: none of its angles with the axes, or of theirs in
// the horizontal plane, is a multiple of a simple share of a right angle.
Eigen::Matrix3d LinesFromWorld() {
  return (Eigen::AngleAxisd(0.4637, Eigen::Vector3d::UnitX()) *
          Eigen::AngleAxisd(-0.8327, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(0.3719, Eigen::Vector3d::UnitZ()))
      .toRotationMatrix();
}

struct SolidOfUnion {
  EdgeSolid solid;
  int of_union = 0;  // 0 or 1
};

// Lines at the middles of squares of this side, from (0, 0) on.
struct LineGrid {
  double spacing = 0;

  int64_t FirstFrom(double at) const { return static_cast<int64_t>(std::ceil(at / spacing - 0.5)); }
  double Middle(int64_t line) const { return (static_cast<double>(line) + 0.5) * spacing; }
};

// The x between which a solid may be on a row, by the strip within its radius of the edge as seen
// along the lines.
std::pair<double, double> ReachOnRow(const EdgeSolid& solid, double y) {
  const Eigen::Vector2d start = solid.start.head<2>(), end = solid.end.head<2>();
  const double rise = end.y() - start.y();
  double from = 0, to = 1;
  if (std::abs(rise) > 1e-12 * solid.radius) {
    const auto [low, high] =
        std::minmax({(y - solid.radius - start.y()) / rise, (y + solid.radius - start.y()) / rise});
    from = std::clamp(low, 0.0, 1.0);
    to = std::clamp(high, 0.0, 1.0);
  }
  const auto [left, right] = std::minmax(
      {start.x() + from * (end.x() - start.x()), start.x() + to * (end.x() - start.x())});
  return {left - solid.radius, right + solid.radius};
}

std::pair<double, double> RowsOf(const EdgeSolid& solid) {
  const auto [low, high] = std::minmax(solid.start.y(), solid.end.y());
  return {low - solid.radius, high + solid.radius};
}

// No fewer than there are, at this spacing.
double MaxChords(const std::vector<SolidOfUnion>& solids, double spacing) {
  double count = 0;
  for (const auto& [solid, of_union] : solids) {
    const double length = (solid.end - solid.start).head<2>().norm();
    const double width = 2 * solid.radius;
    // Of the strip with square ends, in a box of any direction around the ends.
    count += (width / spacing + 1) * ((length + width) / spacing + 1);
  }
  return 2 * count;
}

struct Chord {
  int64_t line = 0;
  int of_union = 0;
  double from = 0, to = 0;

  auto Key() const { return std::tuple(line, of_union, from, to); }
};

struct OverlapSums {
  double first = 0, second = 0, common = 0;

  void Add(const OverlapSums& other) {
    first += other.first;
    second += other.second;
    common += other.common;
  }
};

using LineParts = std::vector<std::pair<double, double>>;

// The union of chords of one line and one union, ascending by their begin.
LineParts PartsOf(const Chord* begin, const Chord* end) {
  LineParts parts;
  for (const Chord* chord = begin; chord != end; ++chord) {
    if (parts.empty() || chord->from > parts.back().second) {
      parts.emplace_back(chord->from, chord->to);
    } else {
      parts.back().second = std::max(parts.back().second, chord->to);
    }
  }
  return parts;
}

double LengthOf(const LineParts& parts) {
  double length = 0;
  for (const auto& [from, to] : parts) length += to - from;
  return length;
}

double CommonLength(const LineParts& first, const LineParts& second) {
  double length = 0;
  for (size_t i = 0, j = 0; i < first.size() && j < second.size();) {
    const double from = std::max(first[i].first, second[j].first);
    const double to = std::min(first[i].second, second[j].second);
    if (from < to) length += to - from;
    ++(first[i].second < second[j].second ? i : j);
  }
  return length;
}

OverlapSums SumsOfRow(std::vector<Chord>* chords) {
  std::ranges::sort(*chords, {}, &Chord::Key);
  OverlapSums sums;
  const Chord* const end = chords->data() + chords->size();
  for (const Chord* begin = chords->data(); begin != end;) {
    const int64_t line = begin->line;
    const Chord* const middle =
        std::find_if(begin, end, [&](const Chord& c) { return c.line != line || c.of_union == 1; });
    const Chord* const next =
        std::find_if(middle, end, [&](const Chord& c) { return c.line != line; });
    const LineParts first = PartsOf(begin, middle), second = PartsOf(middle, next);
    sums.Add({LengthOf(first), LengthOf(second), CommonLength(first, second)});
    begin = next;
  }
  return sums;
}

void AddChords(const SolidOfUnion& member, const LineGrid& grid, double y,
               std::vector<Chord>* chords) {
  const auto [left, right] = ReachOnRow(member.solid, y);
  for (int64_t line = grid.FirstFrom(left); grid.Middle(line) <= right; ++line) {
    const auto chord = ChordAlongZ(member.solid, grid.Middle(line), y);
    if (chord) chords->push_back({line, member.of_union, chord->first, chord->second});
  }
}

// A solid on a row.
struct RowMember {
  int64_t row = 0;
  int solid = 0;

  auto Key() const { return std::pair(row, solid); }
};

// By row. Only rows with solids: these may be far apart.
std::vector<RowMember> MembersOfRows(const std::vector<SolidOfUnion>& solids,
                                     const LineGrid& grid) {
  std::vector<RowMember> members;
  for (size_t s = 0; s < solids.size(); ++s) {
    const auto [low, high] = RowsOf(solids[s].solid);
    for (int64_t row = grid.FirstFrom(low); grid.Middle(row) <= high; ++row) {
      members.push_back({row, static_cast<int>(s)});
    }
  }
  std::ranges::sort(members, {}, &RowMember::Key);
  return members;
}

VolumeOverlap MeasureAt(const std::vector<SolidOfUnion>& solids, double spacing,
                        const RunContext& context) {
  const LineGrid grid{spacing};
  const std::vector<RowMember> members = MembersOfRows(solids, grid);
  std::vector<size_t> begins;
  for (size_t i = 0; i < members.size(); ++i) {
    if (i == 0 || members[i].row != members[i - 1].row) begins.push_back(i);
  }
  std::vector<OverlapSums> sums(begins.size());
  ParallelFor(context, "measuring the overlap of edges", sums.size(), [&](size_t r) {
    thread_local std::vector<Chord> chords;
    chords.clear();
    const double y = grid.Middle(members[begins[r]].row);
    const size_t end = r + 1 < begins.size() ? begins[r + 1] : members.size();
    for (size_t i = begins[r]; i < end; ++i) AddChords(solids[members[i].solid], grid, y, &chords);
    sums[r] = SumsOfRow(&chords);
  });
  OverlapSums all;
  for (const OverlapSums& row : sums) all.Add(row);
  const double area = spacing * spacing;
  return {area * all.first, area * all.second, area * all.common, 0};
}

// Both unions, turned, with all rows from 0 on.
std::vector<SolidOfUnion> InLines(const std::vector<EdgeSolid>& first,
                                  const std::vector<EdgeSolid>& second) {
  const Eigen::Matrix3d turn = LinesFromWorld();
  std::vector<SolidOfUnion> solids;
  Eigen::AlignedBox3d box;
  const auto add = [&](const std::vector<EdgeSolid>& members, int of_union) {
    for (const EdgeSolid& solid : members) {
      solids.push_back({solid, of_union});
      for (const Eigen::Vector3d& end : {solid.start, solid.end}) {
        box.extend(Eigen::Vector3d(turn * end - Eigen::Vector3d::Constant(solid.radius)));
      }
    }
  };
  add(first, 0);
  add(second, 1);
  // Near the origin first, so that far ones keep their digits.
  for (SolidOfUnion& member : solids) {
    member.solid = Moved(std::move(member.solid), turn, -box.min());
  }
  return solids;
}

double SizeOf(const std::vector<SolidOfUnion>& solids) {
  double size = 0;
  for (const auto& [solid, of_union] : solids) {
    size = std::max({size, solid.start.cwiseAbs().maxCoeff(), solid.end.cwiseAbs().maxCoeff()});
  }
  return size;
}

}  // namespace

double VolumeOverlap::Share() const {
  const double either = first + second - common;
  return either > 0 ? common / either : 0;
}

VolumeOverlap MeasureOverlap(const std::vector<EdgeSolid>& first,
                             const std::vector<EdgeSolid>& second, double max_change,
                             const RunContext& context) {
  const std::vector<SolidOfUnion> solids = InLines(first, second);
  if (solids.empty()) return {};
  double radius = 0, length = 0;
  for (const auto& [solid, of_union] : solids) {
    radius = std::max(radius, solid.radius);
    length += (solid.end - solid.start).norm();
  }
  double spacing = radius / kFirstLinesPerRadius;
  // Numbers of lines are exact far below 2^53.
  if (SizeOf(solids) > kMaxLinesAcross * spacing) {
    throw InputError("edges are too far apart for a radius of " + ShortNumber(radius) +
                     ": is the scale right?");
  }
  if (MaxChords(solids, spacing) > kMaxFirstChords) {
    throw InputError("edges of " + ShortNumber(length) + " in all are too long for a radius of " +
                     ShortNumber(radius) + ": is the scale right?");
  }
  VolumeOverlap overlap = MeasureAt(solids, spacing, context);
  do {
    const double before = overlap.Share();
    spacing /= 2;
    overlap = MeasureAt(solids, spacing, context);
    overlap.share_change = std::abs(overlap.Share() - before);
  } while (overlap.share_change > max_change && MaxChords(solids, spacing / 2) <= kMaxChords);
  return overlap;
}

}  // namespace limn
