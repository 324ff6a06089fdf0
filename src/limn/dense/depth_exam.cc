// SPDX-License-Identifier: BSD-3-Clause
#include "limn/dense/depth_exam.h"

#include <algorithm>
#include <cmath>

#include "limn/dense/depth_tolerance.h"

namespace limn {
namespace {

constexpr size_t kMaxPlaces = 1000;
// Depths fit if they agree by so much beyond chance, or nearly everywhere: before a wall, depths of
// another image are right, too.
constexpr double kMinBeyondChance = 0.4, kMinNear = 0.8;
// Chance is that of so many other places for each.
constexpr size_t kNumOthers = 4;

// The depths around a place; those that are unknown are left out.
struct Surroundings {
  double depth = 0;  // of the place
  int num_cells = 0;
  int num_known = 0;
  float known[9] = {};
};

Surroundings Around(const SeenPlace& place, const DepthImage& image) {
  Surroundings around;
  around.depth = place.depth;
  const Eigen::Vector2i cell = image.CellAt(place.pixel);
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (!image.Contains(cell.x() + dx, cell.y() + dy)) continue;
      ++around.num_cells;
      const float depth = image.At(cell.x() + dx, cell.y() + dy);
      if (depth > 0) around.known[around.num_known++] = depth;
    }
  }
  return around;
}

double NearShare(const Surroundings& around, double depth, double tolerance) {
  const auto num_near = std::count_if(around.known, around.known + around.num_known,
                                      [=](float at) { return std::abs(at - depth) <= tolerance; });
  return static_cast<double>(num_near) / around.num_known;
}

// From sums to means.
void Divide(DepthAgreement* sum) {
  if (sum->num_places > 0) sum->known /= static_cast<double>(sum->num_places);
  if (sum->num_known > 0) {
    sum->near /= static_cast<double>(sum->num_known);
    sum->chance /= static_cast<double>(sum->num_known);
  }
}

}  // namespace

DepthAgreement Pooled(const std::vector<DepthAgreement>& of_views) {
  DepthAgreement sum;
  for (const DepthAgreement& of_view : of_views) {
    const auto num_known = static_cast<double>(of_view.num_known);
    sum.num_places += of_view.num_places;
    sum.num_known += of_view.num_known;
    sum.known += static_cast<double>(of_view.num_places) * of_view.known;
    sum.near += num_known * of_view.near;
    sum.chance += num_known * of_view.chance;
  }
  Divide(&sum);
  return sum;
}

bool FitsOverall(const DepthAgreement& agreement) {
  return agreement.near >= kMinNear || agreement.BeyondChance() >= kMinBeyondChance;
}

std::vector<SeenPlace> Thinned(const std::vector<SeenPlace>& places, size_t max_count) {
  const size_t every = (places.size() + max_count - 1) / max_count;
  std::vector<SeenPlace> thinned;
  for (size_t p = 0; p < places.size(); p += every) thinned.push_back(places[p]);
  return thinned;
}

SurelySeen::SurelySeen(const DrawingGraph& graph, const DrawingSamples& samples,
                       const std::vector<View>& views)
    : samples_(samples), views_(views), samples_of_view_(views.size()) {
  const auto for_all = [&](const auto& visit) {
    for (size_t s = 0; s < samples.size(); ++s) {
      const DrawingLink& link = graph.links[samples.link[s]];
      if (link.tentative || link.kind == LinkKind::kContour) continue;
      for (const ViewId view : link.supporting_views) visit(view, static_cast<int32_t>(s));
    }
  };
  std::vector<size_t> count(views.size()), seen(views.size());
  for_all([&](ViewId view, int32_t) { ++count[view]; });
  for_all([&](ViewId view, int32_t sample) {
    const size_t every = (count[view] + kMaxPlaces - 1) / kMaxPlaces;
    if (seen[view]++ % every == 0) samples_of_view_[view].push_back(sample);
  });
}

std::vector<SeenPlace> SurelySeen::In(ViewId view) const {
  std::vector<SeenPlace> places;
  for (const int32_t sample : samples_of_view_[view]) {
    const Eigen::Vector3d& position = samples_.position[sample];
    const auto pixel = views_[view].Project(position);
    if (pixel) places.push_back({*pixel, (views_[view].cam_from_world * position).z()});
  }
  return places;
}

DepthAgreement Agreement(const std::vector<SeenPlace>& places, const View& view,
                         const DepthImage& image, const DenseOptions& options) {
  const double tolerance = DepthTolerancePx(options.depth_tolerance_px, image.cell_px.maxCoeff()) /
                           view.camera.MeanFocal();
  DepthAgreement agreement;
  std::vector<Surroundings> known;
  for (const SeenPlace& place : places) {
    const Surroundings around = Around(place, image);
    if (around.num_cells == 0) continue;
    ++agreement.num_places;
    agreement.known += static_cast<double>(around.num_known) / around.num_cells;
    if (around.num_known > 0) known.push_back(around);
  }
  agreement.num_known = known.size();
  for (size_t i = 0; i < known.size(); ++i) {
    agreement.near += NearShare(known[i], known[i].depth, tolerance * known[i].depth);
    for (size_t k = 1; k <= kNumOthers; ++k) {
      const double other = known[(i + k * known.size() / (kNumOthers + 1)) % known.size()].depth;
      agreement.chance += NearShare(known[i], other, tolerance * other) / kNumOthers;
    }
  }
  Divide(&agreement);
  return agreement;
}

}  // namespace limn
