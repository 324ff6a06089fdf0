#include "limn/linking/curvelets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limn {
namespace {

using Eigen::Vector2d;

// Cells over the perturbation of the anchor: position across the curve times direction.
constexpr int kShifts = 9;
constexpr int kTurns = 7;
constexpr int kCells = 64;  // 63 used; a power of two vectorises
constexpr float kEmpty = 1e6f;

// An interval of curvatures per cell.
struct Bundle {
  std::array<float, kCells> low;
  std::array<float, kCells> high;
};

struct Tolerance {
  double position_px;
  double angle_rad;
};

// A noisy edgel gets more slack. In white noise its direction error is about half its position
// error (radians and pixels, at sigma 1.5).
Tolerance ToleranceOf(const Edgel& edgel, const LinkingOptions& options) {
  const double sigma_px = edgel.position_sigma_px;
  const double angle = options.angle_tolerance_deg * M_PI / 180;
  return {std::clamp(2 * sigma_px, options.position_tolerance_px,
                     std::max(options.max_position_tolerance_px, options.position_tolerance_px)),
          std::clamp(sigma_px, angle, 2 * angle)};
}

// The anchor's frame and perturbations.
struct Anchor {
  EdgelId id;
  Vector2d position;
  Vector2d along;   // its tangent
  Vector2d across;  // the tangent turned by 90 degrees
  std::array<float, kTurns> turned_cos;
  std::array<float, kTurns> turned_sin;
  std::array<float, kShifts> shift_px;
};

Anchor MakeAnchor(const std::vector<Edgel>& edgels, EdgelId id, const LinkingOptions& options) {
  const Edgel& edgel = edgels[id];
  const Tolerance tolerance = ToleranceOf(edgel, options);
  Anchor anchor;
  anchor.id = id;
  anchor.position = edgel.position_px;
  anchor.along = edgel.Tangent();
  anchor.across = -edgel.Normal();
  for (int turn = 0; turn < kTurns; ++turn) {
    // Relative to the anchor's tangent: bundles are computed in its frame.
    const double turned = tolerance.angle_rad * (2.0 * turn / (kTurns - 1) - 1);
    anchor.turned_cos[turn] = static_cast<float>(std::cos(turned));
    anchor.turned_sin[turn] = static_cast<float>(std::sin(turned));
  }
  for (int shift = 0; shift < kShifts; ++shift) {
    anchor.shift_px[shift] =
        static_cast<float>(tolerance.position_px * (2.0 * shift / (kShifts - 1) - 1));
  }
  return anchor;
}

// A neighbour in the anchor's frame.
struct Neighbour {
  EdgelId id;
  double distance;
  double along;
  double across;
  double direction_rad;
  Tolerance tolerance;
};

bool Intersect(const Bundle& with, Bundle* bundle) {
  int valid = 0;
  for (int c = 0; c < kCells; ++c) {
    bundle->low[c] = std::max(bundle->low[c], with.low[c]);
    bundle->high[c] = std::min(bundle->high[c], with.high[c]);
    valid |= bundle->high[c] > bundle->low[c];
  }
  return valid != 0;
}

// The bundle of arcs from the anchor to a neighbour at d. An arc of curvature k through the origin
// along t misses d by w (towards its left normal n) if k (|d|^2 - w^2) / 2 = d.n - w, and has
// direction f at d if k = sin(f - t) / (d . f), because f is perpendicular to the line to the
// centre.
Bundle PairBundle(const Anchor& anchor, const Neighbour& other, double max_curvature) {
  Bundle bundle;
  bundle.low.fill(kEmpty);
  bundle.high.fill(-kEmpty);
  const float miss = static_cast<float>(other.tolerance.position_px);
  const float k_max = static_cast<float>(max_curvature);
  const float dx = static_cast<float>(other.along);
  const float dy = static_cast<float>(other.across);
  // The direction that bounds curvature from below is the right one ahead, the left one behind.
  const float sign = other.along > 0 ? 1.f : -1.f;
  const double first = other.direction_rad - sign * other.tolerance.angle_rad;
  const double second = other.direction_rad + sign * other.tolerance.angle_rad;
  const float first_cos = static_cast<float>(std::cos(first));
  const float first_sin = static_cast<float>(std::sin(first));
  const float second_cos = static_cast<float>(std::cos(second));
  const float second_sin = static_cast<float>(std::sin(second));
  for (int turn = 0; turn < kTurns; ++turn) {
    const float c = anchor.turned_cos[turn];
    const float s = anchor.turned_sin[turn];
    const float along = dx * c + dy * s;
    const float turn_first = first_sin * c - first_cos * s;
    const float turn_second = second_sin * c - second_cos * s;
    float* low = bundle.low.data() + turn * kShifts;
    float* high = bundle.high.data() + turn * kShifts;
    for (int i = 0; i < kShifts; ++i) {
      const float across = dy * c - dx * s - anchor.shift_px[i];
      const float half = 0.5f * (along * along + across * across - miss * miss);
      // Distance run along the two limits of the direction; the formulas need it to be forward.
      const float x = dx + anchor.shift_px[i] * s;
      const float y = dy - anchor.shift_px[i] * c;
      const float run_first = x * first_cos + y * first_sin;
      const float run_second = x * second_cos + y * second_sin;
      const float per_half = 1 / std::max(half, 1e-3f);
      float lowest = std::max(-k_max, turn_first / run_first);
      float highest = std::min(k_max, turn_second / run_second);
      lowest = std::max(lowest, half > 0 ? (across - miss) * per_half : -k_max);
      highest = std::min(highest, half > 0 ? (across + miss) * per_half : k_max);
      const bool forward = sign * run_first > 0 && sign * run_second > 0 && sign * along > 0;
      low[i] = forward ? lowest : kEmpty;
      high[i] = forward ? highest : -kEmpty;
    }
  }
  return bundle;
}

// Neighbours on the same side must follow each other: an edgel beside another one is a second
// strand, and linking across would make a zig-zag.
bool Follows(const Neighbour& candidate, const std::vector<const Neighbour*>& members) {
  for (const Neighbour* member : members) {
    if (std::abs(candidate.along - member->along) < std::abs(candidate.across - member->across)) {
      return false;
    }
  }
  return std::abs(candidate.along) >= std::abs(candidate.across);
}

Curvelet InOrder(EdgelId anchor, std::vector<const Neighbour*> members) {
  std::sort(members.begin(), members.end(),
            [](const Neighbour* a, const Neighbour* b) { return a->along < b->along; });
  Curvelet curvelet;
  bool anchored = false;
  for (const Neighbour* member : members) {
    if (!anchored && member->along > 0) {
      curvelet.push_back(anchor);
      anchored = true;
    }
    curvelet.push_back(member->id);
  }
  if (!anchored) curvelet.push_back(anchor);
  return curvelet;
}

}  // namespace

CurveletBuilder::CurveletBuilder(const std::vector<Edgel>& edgels, const LinkingOptions& options)
    : edgels_(edgels), options_(options), grid_(edgels, options.neighbour_radius_px) {}

std::vector<Curvelet> CurveletBuilder::Around(EdgelId anchor_id) const {
  const Anchor anchor = MakeAnchor(edgels_, anchor_id, options_);
  const double anchor_rad = edgels_[anchor_id].tangent_rad;
  std::vector<EdgelId> near;
  grid_.Near(anchor.position, options_.neighbour_radius_px, &near);
  std::vector<Neighbour> neighbours;
  for (const EdgelId id : near) {
    if (id == anchor_id) continue;
    const Vector2d d = edgels_[id].position_px - anchor.position;
    const Neighbour neighbour{id,
                              d.norm(),
                              d.dot(anchor.along),
                              d.dot(anchor.across),
                              std::remainder(edgels_[id].tangent_rad - anchor_rad, 2 * M_PI),
                              ToleranceOf(edgels_[id], options_)};
    if (std::abs(neighbour.direction_rad) < M_PI_2 && Follows(neighbour, {})) {
      neighbours.push_back(neighbour);
    }
  }
  std::sort(neighbours.begin(), neighbours.end(), [](const Neighbour& a, const Neighbour& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.id < b.id;
  });
  std::vector<Bundle> bundles;
  bundles.reserve(neighbours.size());
  for (const Neighbour& neighbour : neighbours) {
    bundles.push_back(PairBundle(anchor, neighbour, options_.max_curvature));
  }

  std::vector<Curvelet> curvelets;
  std::vector<uint8_t> grouped(neighbours.size(), 0);
  for (size_t seed = 0; seed < neighbours.size(); ++seed) {
    Bundle bundle = bundles[seed];
    if (grouped[seed] || !Intersect(bundle, &bundle)) continue;
    std::vector<const Neighbour*> members = {&neighbours[seed]};
    for (size_t j = 0; j < neighbours.size(); ++j) {
      if (j == seed || !Follows(neighbours[j], members)) continue;
      Bundle narrower = bundle;
      if (!Intersect(bundles[j], &narrower)) continue;
      bundle = narrower;
      members.push_back(&neighbours[j]);
      grouped[j] = 1;
    }
    Curvelet curvelet = InOrder(anchor_id, std::move(members));
    const Vector2d extent =
        edgels_[curvelet.back()].position_px - edgels_[curvelet.front()].position_px;
    if (curvelet.size() < 3 || extent.norm() < options_.min_curvelet_px) continue;
    curvelets.push_back(std::move(curvelet));
  }
  return curvelets;
}

}  // namespace limn
