// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/epipolar_chords.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "limn/util/float8.h"

namespace limn {
namespace {

constexpr int kChordsPerBin = 48;
// Spans that are looked at together.
constexpr int kBatch = 8;
// Spans looked at before chords are fetched; a multiple of the former.
constexpr int kMaxHits = 128;
// Centers this near, as a share of their distance from the origin, are one: no baseline.
constexpr double kMinRelativeBaseline = 1e-12;
// A full turn, in the measure of PlaneOf.
constexpr float kTurn = 4;

Eigen::Matrix3d WorldDirectionFromPixel(const View& view) {
  const PinholeCamera& camera = view.camera;
  Eigen::Matrix3d ray_from_pixel = Eigen::Matrix3d::Identity();
  ray_from_pixel(0, 0) = 1 / camera.fx;
  ray_from_pixel(1, 1) = 1 / camera.fy;
  ray_from_pixel(0, 2) = -camera.cx / camera.fx;
  ray_from_pixel(1, 2) = -camera.cy / camera.fy;
  return view.cam_from_world.rotation.toRotationMatrix().transpose() * ray_from_pixel;
}

// Grows with the angle of (x, y) like atan2, from -2 to 2, for less.
float PlaneOf(double x, double y) {
  const double sum = std::abs(x) + std::abs(y);
  if (!(sum > 0)) return 0;
  const double share = x / sum;
  return static_cast<float>(y < 0 ? share - 1 : 1 - share);
}

// The spans of a bin, and what is asked of them.
struct SpanQuery {
  const float* begin_plane;
  const float* end_plane;
  const float* low_along;
  const float* high_along;
  int count;
  float plane;
  float low;
  float high;
};

// Writes the indices of the spans that cross the plane and overlap with the range; returns how
// many. Half open, so that a line through a vertex crosses one of its two chords.
LIMN_INLINE_KERNEL int FindHits(const SpanQuery& query, int* hits) {
  int num_hits = 0;
  for (int i = 0; i < query.count; i += kBatch) {
    Float8 begin, end, low, high;
    Load8(query.begin_plane + i, &begin);
    Load8(query.end_plane + i, &end);
    Load8(query.low_along + i, &low);
    Load8(query.high_along + i, &high);
    const Mask8 crosses = (begin <= query.plane) ^ (end <= query.plane);
    const Mask8 hit = crosses & (low <= query.high) & (high >= query.low);
    unsigned bits = Bits8(hit);
    const int left = query.count - i;
    if (left < kBatch) bits &= (1u << left) - 1;
    for (; bits != 0; bits &= bits - 1) hits[num_hits++] = i + std::countr_zero(bits);
  }
  return num_hits;
}

LIMN_FOR_AVX2 int FindHitsByAvx2(const SpanQuery& query, int* hits) {
  return FindHits(query, hits);
}

int FindHitsBySse2(const SpanQuery& query, int* hits) { return FindHits(query, hits); }

}  // namespace

struct EpipolarChords::Line {
  float plane;
  // Pixels of the other view with side * (x, y, 1) = 0 lie in the plane.
  Eigen::RowVector3d side;
  // An inverse depth is seen at along_of_zero + along_per_inverse_depth times it.
  double along_of_zero;
  double along_per_inverse_depth;

  double Along(double inverse_depth) const {
    return along_of_zero + along_per_inverse_depth * inverse_depth;
  }
};

EpipolarChords::EpipolarChords(const View& primary, const View& other,
                               const FragmentChords& chords_of_other)
    : chords_(chords_of_other) {
  const Eigen::Vector3d from = primary.CenterInWorld();
  const Eigen::Vector3d to = other.CenterInWorld();
  const Eigen::Vector3d baseline = to - from;
  if (!(baseline.norm() > kMinRelativeBaseline * (from.norm() + to.norm()))) return;
  if (chords_.ends().empty()) return;
  baseline_ = baseline.norm();
  const Eigen::Vector3d along = baseline.normalized();
  const Eigen::Matrix3d direction_from_pixel = WorldDirectionFromPixel(other);
  // Planes are measured from the middle of the chords, far from where they jump by a turn.
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const FragmentChords::End& end : chords_.ends()) {
    sum += end.position_px.cast<double>().homogeneous();
  }
  const Eigen::Vector3d direction = direction_from_pixel * sum;
  const Eigen::Vector3d middle = direction - along * along.dot(direction);
  const Eigen::Vector3d first = middle.norm() > 0 ? middle.normalized() : along.unitOrthogonal();
  Eigen::Matrix3d frame;
  frame << first.transpose(), along.cross(first).transpose(), along.transpose();
  frame_from_primary_ = frame * WorldDirectionFromPixel(primary);
  frame_from_other_ = frame * direction_from_pixel;
  SortIntoBins(FindSights());
}

std::vector<EpipolarChords::Sight> EpipolarChords::FindSights() const {
  std::vector<Sight> sights;
  sights.reserve(chords_.ends().size());
  for (const FragmentChords::End& end : chords_.ends()) {
    const Eigen::Vector3d seen = frame_from_other_ * end.position_px.cast<double>().homogeneous();
    const double across = std::sqrt(seen.x() * seen.x() + seen.y() * seen.y());
    sights.push_back({PlaneOf(seen.x(), seen.y()), static_cast<float>(seen.z() / across)});
  }
  return sights;
}

template <typename Visit>
void EpipolarChords::ForEachSpan(const std::vector<Sight>& sights, const Visit& visit) const {
  chords_.ForEach([&](int chord) {
    Sight begin = sights[chord];
    Sight end = sights[chord + 1];
    if (std::abs(end.plane - begin.plane) > kTurn / 2) {
      // Across the jump: once on either side of it.
      (begin.plane < end.plane ? begin : end).plane += kTurn;
      visit({begin.plane - kTurn, begin.along}, {end.plane - kTurn, end.along}, chord);
    }
    visit(begin, end, chord);
  });
}

int EpipolarChords::Bin(float plane) const {
  return std::clamp(static_cast<int>((plane - low_plane_) * bins_per_plane_), 0,
                    static_cast<int>(bin_begin_.size()) - 2);
}

void EpipolarChords::SortIntoBins(const std::vector<Sight>& sights) {
  float high_plane = -std::numeric_limits<float>::infinity();
  low_plane_ = -high_plane;
  int num_spans = 0;
  ForEachSpan(sights, [&](const Sight& begin, const Sight& end, int) {
    low_plane_ = std::min({low_plane_, begin.plane, end.plane});
    high_plane = std::max({high_plane, begin.plane, end.plane});
    ++num_spans;
  });
  const int num_bins = num_spans / kChordsPerBin + 1;
  bins_per_plane_ =
      high_plane > low_plane_ ? static_cast<float>(num_bins) / (high_plane - low_plane_) : 0;
  bin_begin_.assign(num_bins + 1, 0);
  const auto for_each_bin = [&](const Sight& begin, const Sight& end, auto&& visit) {
    const auto [low, high] = std::minmax(begin.plane, end.plane);
    const int last = Bin(high);
    for (int bin = Bin(low); bin <= last; ++bin) visit(bin);
  };
  ForEachSpan(sights, [&](const Sight& begin, const Sight& end, int) {
    for_each_bin(begin, end, [&](int bin) { ++bin_begin_[bin + 1]; });
  });
  for (size_t i = 1; i < bin_begin_.size(); ++i) bin_begin_[i] += bin_begin_[i - 1];
  std::vector<int> next(bin_begin_.begin(), bin_begin_.end() - 1);
  const size_t size = bin_begin_.back();
  for (auto* part :
       {&spans_.begin_plane, &spans_.end_plane, &spans_.low_along, &spans_.high_along}) {
    part->resize(size + kBatch, 0);
  }
  spans_.chord.resize(size);
  ForEachSpan(sights, [&](const Sight& begin, const Sight& end, int chord) {
    const auto along = std::minmax(begin.along, end.along);
    for_each_bin(begin, end, [&](int bin) {
      const int place = next[bin]++;
      spans_.begin_plane[place] = begin.plane;
      spans_.end_plane[place] = end.plane;
      spans_.low_along[place] = along.first;
      spans_.high_along[place] = along.second;
      spans_.chord[place] = chord;
    });
  });
}

EpipolarChords::Line EpipolarChords::LineOf(const Eigen::Vector2d& primary_px) const {
  const Eigen::Vector3d ray = frame_from_primary_ * primary_px.homogeneous();
  const double across = std::sqrt(ray.x() * ray.x() + ray.y() * ray.y());
  return {PlaneOf(ray.x(), ray.y()),
          ray.y() * frame_from_other_.row(0) - ray.x() * frame_from_other_.row(1), ray.z() / across,
          -baseline_ / across};
}

LineCrossing EpipolarChords::Cross(const Line& line, int chord) const {
  const FragmentChords::End& first = chords_.ends()[chord];
  const FragmentChords::End& second = chords_.ends()[chord + 1];
  const Eigen::Vector2d begin = first.position_px.cast<double>();
  const Eigen::Vector2d step = second.position_px.cast<double>() - begin;
  const double slope = line.side.head<2>().dot(step);
  const double at_begin = line.side.head<2>().dot(begin) + line.side.z();
  const double t = slope != 0 ? std::clamp(-at_begin / slope, 0.0, 1.0) : 0.5;
  const Eigen::Vector2d tangent = first.tangent.cast<double>();
  const Eigen::Vector2d next = second.tangent.cast<double>();
  const double sign = tangent.dot(next) < 0 ? -1 : 1;
  return {chord, t, begin + t * step, ((1 - t) * tangent + (t * sign) * next).normalized()};
}

void EpipolarChords::Find(const Eigen::Vector2d& primary_px,
                          std::vector<LineCrossing>* crossings) const {
  const double infinity = std::numeric_limits<double>::infinity();
  const InverseDepthRange all{-infinity, infinity};
  Find(primary_px, {&all, 1}, crossings);
}

void EpipolarChords::Find(const Eigen::Vector2d& primary_px,
                          std::span<const InverseDepthRange> ranges,
                          std::vector<LineCrossing>* crossings) const {
  if (spans_.chord.empty() || ranges.empty()) return;
  const Line line = LineOf(primary_px);
  // Greater inverse depths are seen farther back.
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const InverseDepthRange& range : ranges) {
    low = std::min(low, line.Along(range.to));
    high = std::max(high, line.Along(range.from));
  }
  const auto is_in = [&](const InverseDepthRange& range, int span) {
    return line.Along(range.to) <= spans_.high_along[span] &&
           line.Along(range.from) >= spans_.low_along[span];
  };
  std::array<int, kMaxHits> hits;
  const int bin = Bin(line.plane);
  for (int first = bin_begin_[bin]; first < bin_begin_[bin + 1]; first += kMaxHits) {
    const SpanQuery query{spans_.begin_plane.data() + first,
                          spans_.end_plane.data() + first,
                          spans_.low_along.data() + first,
                          spans_.high_along.data() + first,
                          std::min(kMaxHits, bin_begin_[bin + 1] - first),
                          line.plane,
                          static_cast<float>(low),
                          static_cast<float>(high)};
    const std::span<int> found(hits.data(), HasAvx2() ? FindHitsByAvx2(query, hits.data())
                                                      : FindHitsBySse2(query, hits.data()));
    // Chords come from far away in memory: all are requested before the first is needed.
    for (int& span : found) {
      span += first;
      __builtin_prefetch(&chords_.ends()[spans_.chord[span]]);
    }
    for (const int span : found) {
      const auto overlaps = [&](const InverseDepthRange& range) { return is_in(range, span); };
      if (ranges.size() > 1 && std::ranges::none_of(ranges, overlaps)) continue;
      crossings->push_back(Cross(line, spans_.chord[span]));
    }
  }
}

}  // namespace limn
