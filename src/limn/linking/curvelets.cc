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
constexpr float kEmptyLow = 1e6f;

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
          std::clamp(sigma_px, angle, std::max(angle, 2 * angle))};
}

// A neighbour of the anchor that alone fits some arc.
struct Neighbour {
  EdgelId id;
  double distance;
  double along;  // coordinates in the anchor's frame
  double across;
  Bundle bundle;
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

// Curvature of the arc through the (shifted, turned) anchor that passes `offset` from the anchor
// with direction phi there: perpendicular to the line to the centre.
double CurvatureFromTangent(const Vector2d& offset, double turned_rad, double phi) {
  return std::sin(phi - turned_rad) / (offset.x() * std::cos(phi) + offset.y() * std::sin(phi));
}

// The bundle of arcs from the anchor to a neighbour `d` away. An arc of curvature k through the
// origin along t misses d by w (towards its left normal n) if k (|d|^2 - w^2) / 2 = d.n - w.
Bundle PairBundle(const Edgel& anchor, const Tolerance& of_anchor, const Edgel& other,
                  const Tolerance& of_other, double max_curvature) {
  Bundle bundle;
  bundle.low.fill(kEmptyLow);
  bundle.high.fill(-kEmptyLow);
  const Vector2d d = other.position_px - anchor.position_px;
  const double miss = of_other.position_px;
  const bool ahead = d.dot(anchor.Tangent()) > 0;
  for (int turn = 0; turn < kTurns; ++turn) {
    const double turned =
        anchor.tangent_rad + of_anchor.angle_rad * (2.0 * turn / (kTurns - 1) - 1);
    const Vector2d tangent(std::cos(turned), std::sin(turned));
    const Vector2d normal(-tangent.y(), tangent.x());
    for (int shift = 0; shift < kShifts; ++shift) {
      const Vector2d offset =
          d - of_anchor.position_px * (2.0 * shift / (kShifts - 1) - 1) * normal;
      const double half = 0.5 * (offset.squaredNorm() - miss * miss);
      const double across = offset.dot(normal);
      const double phi0 = other.tangent_rad - of_other.angle_rad;
      const double phi1 = other.tangent_rad + of_other.angle_rad;
      const double sign = ahead ? 1 : -1;
      // The formulas need the arc to run towards the neighbour, at both limits of its direction.
      const double run0 = sign * (offset.x() * std::cos(phi0) + offset.y() * std::sin(phi0));
      const double run1 = sign * (offset.x() * std::cos(phi1) + offset.y() * std::sin(phi1));
      if (run0 <= 0 || run1 <= 0 || sign * offset.dot(tangent) <= 0) continue;
      double low = -max_curvature;
      double high = max_curvature;
      if (half > 0) {
        low = std::max(low, (across - miss) / half);
        high = std::min(high, (across + miss) / half);
      }
      const double k0 = CurvatureFromTangent(offset, turned, phi0);
      const double k1 = CurvatureFromTangent(offset, turned, phi1);
      low = std::max(low, ahead ? k0 : k1);
      high = std::min(high, ahead ? k1 : k0);
      const int cell = turn * kShifts + shift;
      bundle.low[cell] = static_cast<float>(low);
      bundle.high[cell] = static_cast<float>(high);
    }
  }
  return bundle;
}

bool IsValid(const Bundle& bundle) {
  for (int c = 0; c < kCells; ++c) {
    if (bundle.high[c] > bundle.low[c]) return true;
  }
  return false;
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
  const Edgel& anchor = edgels_[anchor_id];
  const Tolerance of_anchor = ToleranceOf(anchor, options_);
  const Vector2d tangent = anchor.Tangent();
  std::vector<EdgelId> near;
  grid_.Near(anchor.position_px, options_.neighbour_radius_px, &near);
  std::vector<Neighbour> neighbours;
  for (const EdgelId id : near) {
    const Edgel& other = edgels_[id];
    if (id == anchor_id || other.Tangent().dot(tangent) <= 0) continue;
    const Vector2d d = other.position_px - anchor.position_px;
    const Bundle bundle =
        PairBundle(anchor, of_anchor, other, ToleranceOf(other, options_), options_.max_curvature);
    if (!IsValid(bundle)) continue;
    neighbours.push_back(
        {id, d.norm(), d.dot(tangent), d.dot(Vector2d(-tangent.y(), tangent.x())), bundle});
  }
  std::sort(neighbours.begin(), neighbours.end(), [](const Neighbour& a, const Neighbour& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.id < b.id;
  });

  std::vector<Curvelet> curvelets;
  for (size_t seed = 0; seed < neighbours.size(); ++seed) {
    if (!Follows(neighbours[seed], {})) continue;
    Bundle bundle = neighbours[seed].bundle;
    std::vector<const Neighbour*> members = {&neighbours[seed]};
    for (size_t j = 0; j < neighbours.size(); ++j) {
      if (j == seed || !Follows(neighbours[j], members)) continue;
      Bundle narrower = bundle;
      if (!Intersect(neighbours[j].bundle, &narrower)) continue;
      bundle = narrower;
      members.push_back(&neighbours[j]);
    }
    Curvelet curvelet = InOrder(anchor_id, std::move(members));
    const Vector2d extent =
        edgels_[curvelet.back()].position_px - edgels_[curvelet.front()].position_px;
    if (curvelet.size() < 3 || extent.norm() < options_.min_curvelet_px) continue;
    if (std::find(curvelets.begin(), curvelets.end(), curvelet) == curvelets.end()) {
      curvelets.push_back(std::move(curvelet));
    }
  }
  return curvelets;
}

}  // namespace limn
