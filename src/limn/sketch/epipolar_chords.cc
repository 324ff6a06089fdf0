#include "limn/sketch/epipolar_chords.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

namespace limn {
namespace {

constexpr double kChordsPerBin = 16;
// Centers this near, as a share of their distance from the origin, are one: no baseline.
constexpr double kMinRelativeBaseline = 1e-12;

Eigen::Matrix3d WorldDirectionFromPixel(const View& view) {
  const PinholeCamera& camera = view.camera;
  Eigen::Matrix3d ray_from_pixel = Eigen::Matrix3d::Identity();
  ray_from_pixel(0, 0) = 1 / camera.fx;
  ray_from_pixel(1, 1) = 1 / camera.fy;
  ray_from_pixel(0, 2) = -camera.cx / camera.fx;
  ray_from_pixel(1, 2) = -camera.cy / camera.fy;
  return view.cam_from_world.rotation.toRotationMatrix().transpose() * ray_from_pixel;
}

float PlaneOf(const Eigen::Vector2d& offset) {
  return static_cast<float>(std::atan2(offset.y(), offset.x()));
}

template <typename Visit>
void ForEachChord(const ImageCurves& curves, Visit&& visit) {
  for (size_t f = 0; f < curves.fragments.size(); ++f) {
    const CurveFragment& fragment = curves.fragments[f];
    const int count = static_cast<int>(fragment.edgel_ids.size());
    const int num_chords = fragment.closed ? count : count - 1;
    for (int k = 0; k < num_chords; ++k) {
      visit(static_cast<int>(f), k, fragment.edgel_ids[k], fragment.edgel_ids[(k + 1) % count]);
    }
  }
}

}  // namespace

EpipolarChords::EpipolarChords(const View& primary, const View& other,
                               const ImageCurves& curves_of_other) {
  const Eigen::Vector3d from = primary.CenterInWorld();
  const Eigen::Vector3d to = other.CenterInWorld();
  const Eigen::Vector3d baseline = to - from;
  if (!(baseline.norm() > kMinRelativeBaseline * (from.norm() + to.norm()))) return;
  CollectChords(curves_of_other);
  if (chords_.empty()) return;
  const Eigen::Vector3d along = baseline.normalized();
  const Eigen::Matrix3d direction_from_pixel = WorldDirectionFromPixel(other);
  // Angles are measured from the middle of the chords, far from where they jump by a turn.
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Chord& chord : chords_) {
    const Eigen::Vector3d direction =
        direction_from_pixel * chord.begin.cast<double>().homogeneous();
    middle += direction - along * along.dot(direction);
  }
  const Eigen::Vector3d first = middle.norm() > 0 ? middle.normalized() : along.unitOrthogonal();
  Eigen::Matrix<double, 2, 3> across;
  across << first.transpose(), along.cross(first).transpose();
  offset_from_other_ = across * direction_from_pixel;
  offset_from_primary_ = across * WorldDirectionFromPixel(primary);
  SortIntoBins(FindSpans(curves_of_other));
}

void EpipolarChords::CollectChords(const ImageCurves& curves) {
  const auto& edgels = curves.edge_map.edgels;
  Eigen::Vector2d next = Eigen::Vector2d::Zero();
  ForEachChord(curves, [&](int fragment, int vertex, EdgelId begin, EdgelId end) {
    // A chord begins where the one before it ends.
    const Eigen::Vector2d tangent = vertex == 0 ? edgels[begin].Tangent() : next;
    next = edgels[end].Tangent();
    const double sign = tangent.dot(next) < 0 ? -1 : 1;
    chords_.push_back({fragment, vertex, edgels[begin].position_px.cast<float>(),
                       edgels[end].position_px.cast<float>(), tangent.cast<float>(),
                       (sign * next).cast<float>()});
  });
}

std::vector<EpipolarChords::Span> EpipolarChords::FindSpans(const ImageCurves& curves) const {
  const auto& edgels = curves.edge_map.edgels;
  std::vector<float> plane_rad(edgels.size());
  for (size_t id = 0; id < edgels.size(); ++id) {
    plane_rad[id] = PlaneOf(offset_from_other_ * edgels[id].position_px.homogeneous());
  }
  constexpr float kTurn = static_cast<float>(2 * M_PI);
  std::vector<Span> spans;
  int chord = 0;
  ForEachChord(curves, [&](int, int, EdgelId first, EdgelId second) {
    float begin = plane_rad[first];
    float end = plane_rad[second];
    if (std::abs(end - begin) > kTurn / 2) {
      // Across the jump: once on either side of it.
      (begin < end ? begin : end) += kTurn;
      spans.push_back({begin - kTurn, end - kTurn, chord});
    }
    spans.push_back({begin, end, chord++});
  });
  return spans;
}

int EpipolarChords::Bin(float plane_rad) const {
  return std::clamp(static_cast<int>((plane_rad - low_rad_) * bins_per_rad_), 0,
                    static_cast<int>(bin_begin_.size()) - 2);
}

void EpipolarChords::SortIntoBins(const std::vector<Span>& spans) {
  float high_rad = -std::numeric_limits<float>::infinity();
  low_rad_ = -high_rad;
  for (const Span& span : spans) {
    low_rad_ = std::min({low_rad_, span.begin_rad, span.end_rad});
    high_rad = std::max({high_rad, span.begin_rad, span.end_rad});
  }
  const int num_bins = static_cast<int>(static_cast<double>(spans.size()) / kChordsPerBin) + 1;
  bins_per_rad_ = high_rad > low_rad_ ? static_cast<float>(num_bins) / (high_rad - low_rad_) : 0;
  bin_begin_.assign(num_bins + 1, 0);
  const auto for_each_bin = [&](const Span& span, auto&& visit) {
    const auto [low, high] = std::minmax(span.begin_rad, span.end_rad);
    for (int bin = Bin(low); bin <= Bin(high); ++bin) visit(bin);
  };
  for (const Span& span : spans) for_each_bin(span, [&](int bin) { ++bin_begin_[bin + 1]; });
  for (size_t i = 1; i < bin_begin_.size(); ++i) bin_begin_[i] += bin_begin_[i - 1];
  spans_.resize(bin_begin_.back());
  std::vector<int> next(bin_begin_.begin(), bin_begin_.end() - 1);
  for (const Span& span : spans) for_each_bin(span, [&](int bin) { spans_[next[bin]++] = span; });
  SortChordsAsInBins();
}

// Chords that are looked at together lie together.
void EpipolarChords::SortChordsAsInBins() {
  std::vector<Chord> sorted;
  sorted.reserve(chords_.size());
  std::vector<int> place(chords_.size(), -1);
  for (Span& span : spans_) {
    int& at = place[span.chord];
    if (at < 0) {
      at = static_cast<int>(sorted.size());
      sorted.push_back(chords_[span.chord]);
    }
    span.chord = at;
  }
  chords_ = std::move(sorted);
}

void EpipolarChords::Find(const Eigen::Vector2d& primary_px,
                          std::vector<LineCrossing>* crossings) const {
  if (spans_.empty()) return;
  const Eigen::Vector2d offset = offset_from_primary_ * primary_px.homogeneous();
  const float plane = PlaneOf(offset);
  // Pixels of the other view with side * (x, y, 1) = 0 lie in the plane.
  const Eigen::RowVector3d side =
      offset.y() * offset_from_other_.row(0) - offset.x() * offset_from_other_.row(1);
  const int bin = Bin(plane);
  // Chords come from far away in memory: all are requested before the first is needed.
  for (int i = bin_begin_[bin]; i < bin_begin_[bin + 1]; ++i) {
    __builtin_prefetch(&chords_[spans_[i].chord]);
  }
  for (int i = bin_begin_[bin]; i < bin_begin_[bin + 1]; ++i) {
    const Span& span = spans_[i];
    // Half open, so that a line through a vertex crosses one of its two chords.
    if ((span.begin_rad <= plane) == (span.end_rad <= plane)) continue;
    const Chord& chord = chords_[span.chord];
    const Eigen::Vector2d begin = chord.begin.cast<double>();
    const Eigen::Vector2d step = chord.end.cast<double>() - begin;
    const double slope = side.head<2>().dot(step);
    const double at_begin = side.head<2>().dot(begin) + side.z();
    const double t = slope != 0 ? std::clamp(-at_begin / slope, 0.0, 1.0) : 0.5;
    crossings->push_back(
        {chord.fragment, chord.vertex + t, begin + t * step,
         ((1 - t) * chord.tangent_begin.cast<double>() + t * chord.tangent_end.cast<double>())
             .normalized()});
  }
}

}  // namespace limn
