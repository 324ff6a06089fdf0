// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/joint_rays.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "limn/support/segment_support.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// Edgels at these distances from the joint make rays, px. Nearer ones are rounded and mixed.
constexpr int kMinRayPx = 2;
constexpr int kMaxRayPx = 10;
// Number of pixels of a ray that must have edgels.
constexpr int kMinCoveredPx = 3;
// Largest distance, px, and angle of edgels from a ray.
constexpr double kMaxMissPx = 1.0;
constexpr double kMaxTurnRad = 25 * kDeg;
// A ray agrees with directions within this angle.
constexpr double kRayWidthRad = 12 * kDeg;
// Rays nearer to a better one than this many widths are that one.
constexpr double kSameRayWidths = 1.5;
// The greatest chance that a view shows a ray in any direction: no view is proof.
constexpr double kMaxBackground = 0.99;
// A link at the joint explains directions within this angle.
constexpr double kExplainedRad = 20 * kDeg;
// Length of the step in space, px, whose projection gives the direction in the image. A projection
// shorter than the second value is seen end on.
constexpr double kProbePx = 6;
constexpr double kMinProbePx = 2;
// Rays whose planes meet at a smaller angle define no direction.
constexpr double kMinPlaneAngleRad = 8 * kDeg;
// Expected number of rays of a view in which none was found.
constexpr double kMinNumRays = 0.3;
// At most this many views, evenly spread, propose directions; all views vote.
constexpr size_t kProposingViews = 24;
// Number of directions that rays of this width can tell apart, and the largest expected number of
// false alarms among them. It may exceed one, since the whole edge is tested later.
constexpr double kNumDirections = 130;
constexpr double kMaxFalseAlarms = 10;

// Direction in the image in which a point leaves the joint; nothing if end on.
std::optional<double> ImageDirection(const View& view, const Joint& joint,
                                     const Eigen::Vector3d& direction) {
  const Eigen::Vector3d from = view.cam_from_world * joint.position;
  const Eigen::Vector3d to =
      view.cam_from_world * (joint.position + kProbePx * joint.footprint * direction);
  if (!(from.z() > 0 && to.z() > 0)) return std::nullopt;
  const Eigen::Vector2d offset = view.camera.Project(to) - view.camera.Project(from);
  if (offset.norm() < kMinProbePx) return std::nullopt;
  return std::atan2(offset.y(), offset.x());
}

// A direction in the image, away from the joint, and the edgels along it.
struct ImageRay {
  double angle = 0;
  int num_pixels = 0;     // that have edgels
  double correction = 0;  // turn towards the edgels, radians
};

// `near` holds edgels, with positions relative to the joint.
ImageRay RayAlong(double angle, const std::vector<Edgel>& near) {
  const Eigen::Vector2d unit(std::cos(angle), std::sin(angle));
  unsigned pixels = 0;
  double sum = 0;
  double weight = 0;
  for (const Edgel& edgel : near) {
    const double along = edgel.position_px.dot(unit);
    const double across = unit.x() * edgel.position_px.y() - unit.y() * edgel.position_px.x();
    if (along < kMinRayPx || along >= kMaxRayPx || std::abs(across) > kMaxMissPx) continue;
    if (std::abs(edgel.Tangent().dot(unit)) < std::cos(kMaxTurnRad)) continue;
    pixels |= 1u << static_cast<int>(along);
    sum += along * across;
    weight += along * along;
  }
  return {angle, std::popcount(pixels), weight > 0 ? sum / weight : 0};
}

// Directions towards the edgels, and along those that point at the joint.
std::vector<double> CandidateAngles(const std::vector<Edgel>& near) {
  std::vector<double> angles;
  for (const Edgel& edgel : near) {
    const Eigen::Vector2d& offset = edgel.position_px;
    if (offset.norm() < kMinRayPx) continue;
    if (std::abs(edgel.Normal().dot(offset)) > 2 * kMaxMissPx) continue;
    angles.push_back(std::atan2(offset.y(), offset.x()));
    const bool outward = offset.dot(edgel.Tangent()) > 0;
    angles.push_back(outward ? edgel.tangent_rad : edgel.tangent_rad + M_PI);
  }
  return angles;
}

// Directions in which edges leave the joint in one view, apart from its links. The one in which
// edgels cover most pixels comes first; its neighborhood then no longer counts.
std::vector<double> RayAngles(const View& view, const Joint& joint,
                              const std::vector<Edgel>& near) {
  std::vector<ImageRay> candidates;
  for (const double angle : CandidateAngles(near)) candidates.push_back(RayAlong(angle, near));
  const auto erase_near = [&](double angle, double width) {
    std::erase_if(candidates,
                  [&](const ImageRay& ray) { return TurnBetweenAngles(ray.angle, angle) < width; });
  };
  for (const Eigen::Vector3d& leaving : joint.leaving) {
    const auto explained = ImageDirection(view, joint, leaving);
    if (explained) erase_near(*explained, kExplainedRad);
  }
  std::vector<double> angles;
  while (!candidates.empty()) {
    const ImageRay best = *std::ranges::max_element(candidates, {}, &ImageRay::num_pixels);
    if (best.num_pixels < kMinCoveredPx) break;
    angles.push_back(best.angle + best.correction);
    erase_near(best.angle, kSameRayWidths * kRayWidthRad);
  }
  return angles;
}

struct Ray {
  ViewId view = -1;
  double angle = 0;        // in the virtual image, pointing away from the joint
  Eigen::Vector3d normal;  // of the plane through the camera center and the ray, world, unit
};

class DirectionFinder {
 public:
  DirectionFinder(const TopologyInput& input, const Joint& joint, size_t min_views)
      : input_(input), joint_(joint), min_views_(min_views) {
    for (ViewId v = 0; v < static_cast<ViewId>(input.views.size()); ++v) {
      if (!joint.visible[v]) continue;
      const auto center = input.views[v].Project(joint.position);
      if (center) seen_in_.push_back({v, RaysIn(v, *center)});
    }
  }

  std::optional<JointDirection> Find() const {
    std::optional<JointDirection> best;
    double best_chance = std::log(kMaxFalseAlarms / kNumDirections);
    const std::vector<const Ray*> proposing = ProposingRays();
    for (size_t i = 0; i < proposing.size(); ++i) {
      for (size_t j = i + 1; j < proposing.size(); ++j) {
        const auto start = DirectionOf(*proposing[i], *proposing[j]);
        if (!start) continue;
        Vote vote = VotesFor(*start);
        if (vote.log_chance >= best_chance) continue;
        const Eigen::Vector3d direction = Fit(*start, vote.rays);
        vote = VotesFor(direction);
        if (vote.log_chance >= best_chance) continue;
        best_chance = vote.log_chance;
        best = JointDirection{direction, {}};
        for (const Ray* ray : vote.rays) best->views.push_back(ray->view);
      }
    }
    return best;
  }

 private:
  struct Vote {
    std::vector<const Ray*> rays;  // at most one per view
    double log_chance = 0;         // 0 if there are too few
  };

  std::vector<Ray> RaysIn(ViewId v, const Eigen::Vector2d& center) const {
    const View& view = input_.views[v];
    std::vector<Edgel> near;
    input_.edgels[v]->edgels.ForEachWithin(center, kMaxRayPx, [&](EdgelId id) {
      near.push_back(input_.EdgelOf({v, id}));
      near.back().position_px -= center;
    });
    const Eigen::Vector3d point = view.cam_from_world * joint_.position;
    std::vector<Ray> rays;
    for (const double angle : RayAngles(view, joint_, near)) {
      const Eigen::Vector3d along(std::cos(angle) / view.camera.fx,
                                  std::sin(angle) / view.camera.fy, 0);
      rays.push_back(
          {v, angle, view.cam_from_world.rotation.conjugate() * point.cross(along).normalized()});
    }
    return rays;
  }

  std::vector<const Ray*> ProposingRays() const {
    const size_t num_views = seen_in_.size();
    const size_t num_proposing = std::min(num_views, kProposingViews);
    std::vector<const Ray*> rays;
    for (size_t i = 0; i < num_views; ++i) {
      if (i * num_proposing / num_views == (i + 1) * num_proposing / num_views) continue;
      for (const Ray& ray : seen_in_[i].second) rays.push_back(&ray);
    }
    return rays;
  }

  bool PointsAlong(const Ray& ray, const Eigen::Vector3d& direction) const {
    const auto angle = ImageDirection(input_.views[ray.view], joint_, direction);
    return angle && TurnBetweenAngles(*angle, ray.angle) < kRayWidthRad;
  }

  // The line in which the planes of two rays meet, on the side they point to.
  std::optional<Eigen::Vector3d> DirectionOf(const Ray& a, const Ray& b) const {
    if (a.view == b.view) return std::nullopt;
    Eigen::Vector3d direction = a.normal.cross(b.normal);
    if (direction.norm() < std::sin(kMinPlaneAngleRad)) return std::nullopt;
    direction.normalize();
    if (!PointsAlong(a, direction)) direction = -direction;
    if (!PointsAlong(a, direction) || !PointsAlong(b, direction)) return std::nullopt;
    return direction;
  }

  Vote VotesFor(const Eigen::Vector3d& direction) const {
    Vote vote;
    int num_views = 0;
    double background = 0;
    for (const auto& [view, rays] : seen_in_) {
      const auto angle = ImageDirection(input_.views[view], joint_, direction);
      if (!angle) continue;
      ++num_views;
      const double num_rays = std::max(kMinNumRays, static_cast<double>(rays.size()));
      background += num_rays * kRayWidthRad / M_PI;
      const auto turn = [&](const Ray& ray) { return TurnBetweenAngles(ray.angle, *angle); };
      const auto nearest = std::ranges::min_element(rays, {}, turn);
      if (nearest != rays.end() && turn(*nearest) < kRayWidthRad) vote.rays.push_back(&*nearest);
    }
    if (vote.rays.size() >= min_views_) {
      vote.log_chance = LogChance(static_cast<int>(vote.rays.size()), num_views,
                                  std::min(kMaxBackground, background / num_views));
    }
    return vote;
  }

  // The direction nearest to all planes of the rays.
  static Eigen::Vector3d Fit(const Eigen::Vector3d& start, const std::vector<const Ray*>& rays) {
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const Ray* ray : rays) scatter += ray->normal * ray->normal.transpose();
    const Eigen::Vector3d direction =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
    return direction.dot(start) < 0 ? Eigen::Vector3d(-direction) : direction;
  }

  const TopologyInput& input_;
  const Joint& joint_;
  size_t min_views_;
  // Views that show the joint, and their rays.
  std::vector<std::pair<ViewId, std::vector<Ray>>> seen_in_;
};

}  // namespace

std::optional<JointDirection> FindJointDirection(const TopologyInput& input, const Joint& joint,
                                                 size_t min_views) {
  return DirectionFinder(input, joint, min_views).Find();
}

}  // namespace limn
