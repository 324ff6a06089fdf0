// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "limn/geometry/tangent_frame.h"
#include "limn/util/angles.h"
#include "limn/util/median.h"

namespace limn {
namespace {

constexpr size_t kMaxLights = 3;
// First on this many directions, at each of these inverse distances, every second place is filed in
// wide cells. Light that reaches few of the surfaces is left out.
constexpr int kNumDirections = 1200;
constexpr std::array<double, 3> kInverseDistances = {0, 0.3, 0.6};
constexpr int kCoarseStride = 2;
constexpr double kCoarsePx = 5;
constexpr double kMinLitShare = 0.25;
// Then the best ones, this far from each other, are moved to where narrow cells agree most.
constexpr size_t kNumCandidates = 6;
constexpr double kApartRad = 0.2;
constexpr double kFinePx = 2.5;
constexpr double kFirstStepRad = 0.04;
constexpr double kLastStepRad = 0.002;
constexpr double kInversePerRad = 4;
constexpr double kMaxInverseDistance = 0.9;
// Around a light, the number of places on covered links falls to less than half, and by this
// number, at these angles.
constexpr std::array<double, 3> kRingRad = {0.1, 0.15, 0.2};
constexpr int kNumOnRing = 12;
constexpr double kPeakRatio = 2;
constexpr int kMinMore = 200;
// Boxes and prisms look like lit by a light in the direction of their edges: of places on links
// within 6 degrees of it there are no more than this share of those on covered links.
constexpr double kAlongRad = 6 * kDeg;
constexpr double kMaxAlongShare = 0.25;

// Of directions of lines, and the length of a cell along the line over its width.
constexpr int kNumAngles = 18;
constexpr double kCellLength = 4;
// What the light sees more edge-on than this casts no shadow that could be told.
constexpr double kMinSine = 0.25;
// A surface that light grazes is not lit.
constexpr double kMinLit = 0.2;
// Of the distance between the light and the middle of the scene.
constexpr double kMinDepth = 0.05;

// Directions evenly over the sphere: a spiral of golden angles.
std::vector<Eigen::Vector3d> Sphere(int count) {
  std::vector<Eigen::Vector3d> directions;
  for (int k = 0; k < count; ++k) {
    const double z = 1 - (2 * k + 1.0) / count;
    const double angle = 2 * std::numbers::pi * k / std::numbers::phi;
    const double r = std::sqrt(1 - z * z);
    directions.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  return directions;
}

// The side that the views see; surfaces of no plane have no angle that could be too small.
bool IsLit(const LitPlace& place, const Eigen::Vector3d& towards_light) {
  return place.normal.isZero() || place.normal.dot(towards_light) > (place.on_plane ? kMinLit : 0);
}

// A place in a cell of position and direction. By cell, the places nearest to the light first.
struct Filed {
  uint64_t cell = 0;
  float height = 0;
  int place = -1;

  bool operator<(const Filed& other) const {
    if (cell != other.cell) return cell < other.cell;
    return height != other.height ? height > other.height : place < other.place;
  }
};

// The bins of angles, in the order of their directions' first coordinates, from 1 to -1.
struct AngleBins {
  AngleBins() {
    for (int bin = 0; bin < kNumAngles; ++bin) {
      const double width = std::numbers::pi / kNumAngles;
      cosine_of_end[bin] = std::cos((bin + 1) * width);
      middle[bin] = {std::cos((bin + 0.5) * width), std::sin((bin + 0.5) * width)};
    }
  }

  // Of an undirected line.
  int Of(const Eigen::Vector2d& direction) const {
    const bool is_turned = direction.y() < 0 || (direction.y() == 0 && direction.x() < 0);
    const double cosine = is_turned ? -direction.x() : direction.x();
    int bin = 0;
    for (int k = 0; k + 1 < kNumAngles; ++k) bin += cosine <= cosine_of_end[k] ? 1 : 0;
    return bin;
  }

  std::array<double, kNumAngles> cosine_of_end;
  std::array<Eigen::Vector2d, kNumAngles> middle;
};

uint64_t CellOf(const PlaceFromLight& seen, double width) {
  static const AngleBins bins;
  const int bin = bins.Of(seen.tangent);
  const Eigen::Vector2d& along = bins.middle[bin];
  const Eigen::Vector2d across(-along.y(), along.x());
  const auto x = static_cast<int64_t>(std::floor(seen.position.dot(along) / (kCellLength * width)));
  const auto y = static_cast<int64_t>(std::floor(seen.position.dot(across) / width));
  return (static_cast<uint64_t>(x + (1 << 24)) * (1 << 25) + static_cast<uint64_t>(y + (1 << 24))) *
             kNumAngles +
         static_cast<uint64_t>(bin);
}

// Places that lie behind other links in their cell. Where things lie at more than two heights in
// one cell the light looks along a surface.
std::vector<int> PlacesBehind(const Light& light, const LitScene& scene, double width_px,
                              int stride) {
  std::vector<Filed> filed;
  std::vector<uint8_t> is_lit(scene.places.size(), 0);
  const LightView view(light, scene);
  for (size_t k = 0; k < scene.places.size(); k += stride) {
    const auto seen = view.See(scene.places[k]);
    if (!seen) continue;
    is_lit[k] = seen->is_lit;
    filed.push_back({CellOf(*seen, width_px * scene.footprint), static_cast<float>(seen->height),
                     static_cast<int>(k)});
  }
  std::sort(filed.begin(), filed.end());
  const auto gap = static_cast<float>(kMinCastPx * scene.footprint);
  std::vector<int> behind;
  for (size_t begin = 0, end = 0; begin < filed.size(); begin = end) {
    size_t lower = begin;  // the first place below the gap
    int num_heights = 1;
    for (end = begin + 1; end < filed.size() && filed[end].cell == filed[begin].cell; ++end) {
      if (filed[end - 1].height - filed[end].height <= gap) continue;
      lower = end;
      ++num_heights;
    }
    if (num_heights != 2) continue;
    for (size_t k = lower; k < end; ++k) {
      const LitPlace& place = scene.places[filed[k].place];
      const bool is_covered = std::any_of(
          filed.begin() + begin, filed.begin() + lower,
          [&](const Filed& above) { return scene.places[above.place].link != place.link; });
      if (is_lit[filed[k].place] != 0 && is_covered) behind.push_back(filed[k].place);
    }
  }
  return behind;
}

struct Candidate {
  Light light;
  int score = 0;  // number of places behind others
};

// The best ones, best first, apart from each other in direction. A score of 0 is none.
std::vector<Candidate> BestApart(std::vector<Candidate> candidates, size_t max_count) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  std::vector<Candidate> best;
  for (const Candidate& candidate : candidates) {
    const bool is_apart = std::none_of(best.begin(), best.end(), [&](const Candidate& other) {
      return candidate.light.direction.dot(other.light.direction) > std::cos(kApartRad);
    });
    if (best.size() < max_count && candidate.score > 0 && is_apart) best.push_back(candidate);
  }
  return best;
}

int FineScore(const Light& light, const LitScene& scene) {
  return static_cast<int>(PlacesBehind(light, scene, kFinePx, 1).size());
}

// Places behind others, of links that are behind others over half of their length: by accident
// links are crossed and touched, but seldom covered.
int NumOnCoveredLinks(const Light& light, const LitScene& scene) {
  std::vector<int> num_behind(scene.num_places_of_link.size(), 0);
  for (const int place : PlacesBehind(light, scene, kFinePx, 1)) {
    ++num_behind[scene.places[place].link];
  }
  int num_on_covered = 0;
  for (size_t l = 0; l < num_behind.size(); ++l) {
    const int num_places = scene.num_places_of_link[l];
    if (num_places >= kMinPlacesToTell && 2 * num_behind[l] >= num_places) {
      num_on_covered += num_behind[l];
    }
  }
  return num_on_covered;
}

bool LightsSurfaces(const Light& light, const LitScene& scene) {
  const LightView view(light, scene);
  int num_known = 0;
  int num_lit = 0;
  for (size_t k = 0; k < scene.places.size(); k += kCoarseStride) {
    const LitPlace& place = scene.places[k];
    if (place.normal.isZero()) continue;
    ++num_known;
    num_lit += IsLit(place, view.DirectionFrom(place)) ? 1 : 0;
  }
  return num_lit >= kMinLitShare * num_known;
}

// The best of the coarse grid, apart from each other, best first.
std::vector<Candidate> CoarseCandidates(const LitScene& scene, const RunContext& context) {
  std::vector<Candidate> all;
  for (const double inverse : kInverseDistances) {
    for (const Eigen::Vector3d& direction : Sphere(kNumDirections)) {
      all.push_back({{direction, inverse}, 0});
    }
  }
  ParallelFor(context, "lights", all.size(), [&](size_t k) {
    if (!LightsSurfaces(all[k].light, scene)) return;
    all[k].score =
        static_cast<int>(PlacesBehind(all[k].light, scene, kCoarsePx, kCoarseStride).size());
  });
  return BestApart(std::move(all), kNumCandidates);
}

// Steps in two directions across and in the inverse distance.
constexpr std::array<std::array<double, 3>, 14> kMoves = {{{1, 0, 0},
                                                           {-1, 0, 0},
                                                           {0, 1, 0},
                                                           {0, -1, 0},
                                                           {1, 1, 0},
                                                           {1, -1, 0},
                                                           {-1, 1, 0},
                                                           {-1, -1, 0},
                                                           {0, 0, 1},
                                                           {0, 0, -1},
                                                           {1, 0, 1},
                                                           {-1, 0, 1},
                                                           {0, 1, 1},
                                                           {0, -1, 1}}};

Light Moved(const Light& light, double first, double second, double inverse) {
  const auto across = TangentFrame(light.direction);
  return {(light.direction + across * Eigen::Vector2d(first, second)).normalized(),
          std::clamp(light.inverse_distance + inverse, 0.0, kMaxInverseDistance)};
}

// Moved to where narrow cells agree most.
Candidate Refined(const Light& from, const LitScene& scene, const RunContext& context) {
  Candidate best = {from, FineScore(from, scene)};
  for (double step = kFirstStepRad; step > kLastStepRad;) {
    ThrowIfCancelled(context);
    const Candidate before = best;
    for (const auto& [first, second, inverse] : kMoves) {
      const Light moved =
          Moved(before.light, step * first, step * second, kInversePerRad * step * inverse);
      const int score = FineScore(moved, scene);
      if (score > best.score) best = {moved, score};
    }
    if (best.score == before.score) step /= 2;
  }
  return best;
}

int NumAlong(const Light& light, const LitScene& scene) {
  const LightView view(light, scene);
  int num_along = 0;
  for (const LitPlace& place : scene.places) {
    const double cosine = place.tangent.dot(view.DirectionFrom(place));
    num_along += std::abs(cosine) > std::cos(kAlongRad) ? 1 : 0;
  }
  return num_along;
}

bool IsPeak(const Light& light, const LitScene& scene, const RunContext& context) {
  const int num_here = NumOnCoveredLinks(light, scene);
  if (num_here < kMinMore || NumAlong(light, scene) > kMaxAlongShare * num_here) return false;
  for (const double radius : kRingRad) {
    ThrowIfCancelled(context);
    for (int k = 0; k < kNumOnRing; ++k) {
      const double angle = 2 * std::numbers::pi * k / kNumOnRing;
      const Light beside = Moved(light, radius * std::cos(angle), radius * std::sin(angle), 0);
      const int num_beside = NumOnCoveredLinks(beside, scene);
      if (num_here < kPeakRatio * num_beside || num_here < num_beside + kMinMore) return false;
    }
  }
  return true;
}

}  // namespace

LitScene LitSceneOf(std::vector<LitPlace> places) {
  LitScene scene;
  scene.places = std::move(places);
  for (const LitPlace& place : scene.places) {
    if (place.link >= std::ssize(scene.num_places_of_link)) {
      scene.num_places_of_link.resize(place.link + 1, 0);
    }
    ++scene.num_places_of_link[place.link];
  }
  if (scene.places.empty()) return scene;
  std::vector<double> values(scene.places.size());
  const auto median = [&](auto&& value_of) {
    std::transform(scene.places.begin(), scene.places.end(), values.begin(), value_of);
    return Median(values);
  };
  for (int c = 0; c < 3; ++c) {
    scene.center[c] = median([c](const LitPlace& place) { return place.position_in_world[c]; });
  }
  scene.footprint = median([](const LitPlace& place) { return place.footprint; });
  std::transform(
      scene.places.begin(), scene.places.end(), values.begin(),
      [&](const LitPlace& place) { return (place.position_in_world - scene.center).norm(); });
  const auto most = values.begin() + static_cast<std::ptrdiff_t>(0.9 * (values.size() - 1));
  std::nth_element(values.begin(), most, values.end());
  scene.radius = *most;
  return scene;
}

LightView::LightView(const Light& light, const LitScene& scene)
    : scene_(scene),
      direction_(light.direction),
      nearness_(light.inverse_distance / scene.radius),
      across_(TangentFrame(light.direction)) {}

Eigen::Vector3d LightView::DirectionFrom(const LitPlace& place) const {
  return (direction_ - nearness_ * (place.position_in_world - scene_.center)).normalized();
}

std::optional<PlaceFromLight> LightView::See(const LitPlace& place) const {
  const Eigen::Vector3d towards_light = DirectionFrom(place);
  if (place.tangent.cross(towards_light).norm() < kMinSine) return std::nullopt;
  const Eigen::Vector3d offset = place.position_in_world - scene_.center;
  PlaceFromLight seen;
  seen.height = offset.dot(direction_);
  const double depth = 1 - nearness_ * seen.height;
  if (!(depth >= kMinDepth)) return std::nullopt;
  seen.position = across_.transpose() * offset / depth;
  seen.tangent = (across_.transpose() * place.tangent +
                  nearness_ * place.tangent.dot(direction_) * seen.position)
                     .normalized();
  seen.footprint = place.footprint / depth;
  seen.is_lit = IsLit(place, towards_light);
  return seen;
}

std::vector<Light> FindLights(const LitScene& scene, const RunContext& context) {
  if (std::ssize(scene.places) < kMinMore || !(scene.radius > 0)) return {};
  std::vector<Candidate> found = CoarseCandidates(scene, context);
  ParallelFor(context, "lights", found.size(), [&](size_t k) {
    found[k] = Refined(found[k].light, scene, context);
    if (!IsPeak(found[k].light, scene, context)) found[k].score = 0;
  });
  std::vector<Light> lights;
  for (const Candidate& candidate : BestApart(std::move(found), kMaxLights)) {
    lights.push_back(candidate.light);
  }
  return lights;
}

}  // namespace limn
