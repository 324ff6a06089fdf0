#include "limn/topology/corner_rays.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "limn/support/segment_support.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// Edgels at these distances from the joint make rays, px. Nearer ones are rounded and mixed. F on
// day, room with kMaxRayPx 7: +.5, +.2; 14: -.6, -.1.
constexpr int kMinRayPx = 2;
constexpr int kMaxRayPx = 10;
// Number of pixels of a ray that must have edgels. F on day, room with 2: 0, +.1; 4: -.4, 0.
constexpr int kMinCoveredPx = 3;
// Largest distance, px, and angle of edgels from a ray. F on day, room with 17 degrees: -.1, +.1;
// 35: -.3, +.1.
constexpr double kMaxMissPx = 1.0;
constexpr double kMaxTurnRad = 25 * kDeg;
// A ray agrees with directions within this angle. F on day, room with 8 degrees: +.5, 0; 17: -.2,
// +.2.
constexpr double kRayWidthRad = 12 * kDeg;
// A link at the joint explains directions within this angle. F on day, room with 14 or 28 degrees,
// also for kTakenRad of grow_edges.cc: -.1, 0.
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
// false alarms among them. It may exceed one, since the whole edge is tested later. F on day, room
// with 1 false alarm: -.1, +.1; 100: +.1, 0.
constexpr double kNumDirections = 130;
constexpr double kMaxFalseAlarms = 10;

struct Ray {
  ViewId view = -1;
  double angle = 0;        // in the virtual image, pointing away from the joint
  Eigen::Vector3d normal;  // of the plane through the camera center and the ray, world, unit
};

double AngleBetween(double a, double b) { return std::abs(std::remainder(a - b, 2 * M_PI)); }

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

// The rays of one view.
class RayFinder {
 public:
  RayFinder(const Joint& joint, const View& view, const EdgeMap& edge_map, const EdgelIndex& edgels,
            const Eigen::Vector2d& center)
      : joint_(joint), view_(view), center_(center) {
    edgels.ForEachWithin(center, kMaxRayPx,
                         [&](EdgelId id) { near_.push_back(&edge_map.edgels[id]); });
  }

  // The direction in which edgels cover most pixels first; its neighborhood then no longer counts.
  std::vector<double> Find() const {
    std::vector<double> rays;
    std::vector<double> candidates = Candidates();
    while (true) {
      double best = 0;
      int most = 0;
      for (const double angle : candidates) {
        const int covered = Cover(angle).num_pixels;
        if (covered <= most) continue;
        most = covered;
        best = angle;
      }
      if (most < kMinCoveredPx) return rays;
      rays.push_back(best + Cover(best).correction);
      std::erase_if(candidates,
                    [&](double other) { return AngleBetween(other, best) < 1.5 * kRayWidthRad; });
    }
  }

 private:
  // Towards the edgels, and along those that point at the joint.
  std::vector<double> Candidates() const {
    std::vector<double> candidates;
    for (const Edgel* edgel : near_) {
      const Eigen::Vector2d offset = edgel->position_px - center_;
      if (offset.norm() < kMinRayPx) continue;
      if (std::abs(edgel->Normal().dot(offset)) > 2 * kMaxMissPx) continue;
      candidates.push_back(std::atan2(offset.y(), offset.x()));
      const bool outward = offset.dot(edgel->Tangent()) > 0;
      candidates.push_back(outward ? edgel->tangent_rad : edgel->tangent_rad + M_PI);
    }
    std::vector<double> explained;
    for (const Eigen::Vector3d& leaving : joint_.leaving) {
      const auto angle = ImageDirection(view_, joint_, leaving);
      if (angle) explained.push_back(*angle);
    }
    std::erase_if(candidates, [&](double angle) {
      return std::any_of(explained.begin(), explained.end(),
                         [&](double taken) { return AngleBetween(taken, angle) < kExplainedRad; });
    });
    return candidates;
  }

  struct Coverage {
    int num_pixels = 0;
    double correction = 0;  // turn towards the edgels, radians
  };

  Coverage Cover(double angle) const {
    const Eigen::Vector2d unit(std::cos(angle), std::sin(angle));
    unsigned pixels = 0;
    double sum = 0;
    double weight = 0;
    for (const Edgel* edgel : near_) {
      const Eigen::Vector2d offset = edgel->position_px - center_;
      const double along = offset.dot(unit);
      const double across = unit.x() * offset.y() - unit.y() * offset.x();
      if (along < kMinRayPx || along >= kMaxRayPx || std::abs(across) > kMaxMissPx) continue;
      if (std::abs(edgel->Tangent().dot(unit)) < std::cos(kMaxTurnRad)) continue;
      pixels |= 1u << static_cast<int>(along);
      sum += along * across;
      weight += along * along;
    }
    return {std::popcount(pixels), weight > 0 ? sum / weight : 0};
  }

  const Joint& joint_;
  const View& view_;
  Eigen::Vector2d center_;
  std::vector<const Edgel*> near_;
};

class DirectionFinder {
 public:
  DirectionFinder(const Joint& joint, const std::vector<View>& views,
                  const std::vector<ImageCurves>& curves, const EdgelIndexes& edgels,
                  size_t min_views)
      : joint_(joint), views_(views), min_views_(min_views) {
    for (size_t v = 0; v < views.size(); ++v) {
      const auto center = joint.visible[v] ? views[v].Project(joint.position) : std::nullopt;
      if (!center) continue;
      const Rigid3d& pose = views[v].cam_from_world;
      const Eigen::Vector3d point = pose * joint.position;
      const RayFinder finder(joint, views[v], curves[v].edge_map, *edgels[v], *center);
      std::vector<Ray> of_view;
      for (const double angle : finder.Find()) {
        const Eigen::Vector3d along(std::cos(angle) / views[v].camera.fx,
                                    std::sin(angle) / views[v].camera.fy, 0);
        rays_.push_back({static_cast<ViewId>(v), angle,
                         pose.rotation.conjugate() * point.cross(along).normalized()});
      }
      seen_in_.push_back({static_cast<ViewId>(v), rays_.size()});
    }
  }

  std::optional<CornerDirection> Find() const {
    std::optional<CornerDirection> best;
    double best_chance = std::log(kMaxFalseAlarms / kNumDirections);
    const std::vector<size_t> proposing = ProposingRays();
    for (size_t i = 0; i < proposing.size(); ++i) {
      for (size_t j = i + 1; j < proposing.size(); ++j) {
        const auto start = DirectionOf(rays_[proposing[i]], rays_[proposing[j]]);
        if (!start) continue;
        Vote vote = VotesFor(*start);
        if (vote.rays.size() < min_views_ || vote.LogChance() >= best_chance) continue;
        const Eigen::Vector3d direction = Fit(*start, vote.rays);
        vote = VotesFor(direction);
        if (vote.rays.size() < min_views_ || vote.LogChance() >= best_chance) continue;
        best_chance = vote.LogChance();
        best = CornerDirection{direction, {}};
        for (const int r : vote.rays) best->views.push_back(rays_[r].view);
      }
    }
    return best;
  }

 private:
  struct SeenIn {
    ViewId view;
    size_t rays_end;  // its rays end here and begin where those of the view before end
  };
  struct Vote {
    std::vector<int> rays;  // at most one per view
    int num_views = 0;
    double background = 0;
    double LogChance() const {
      return limn::LogChance(static_cast<int>(rays.size()), num_views, background);
    }
  };

  std::vector<size_t> ProposingRays() const {
    const size_t num_views = seen_in_.size();
    const size_t num_proposing = std::min(num_views, kProposingViews);
    std::vector<size_t> rays;
    size_t begin = 0;
    for (size_t i = 0; i < num_views; ++i) {
      const size_t end = seen_in_[i].rays_end;
      const bool proposes = i * num_proposing / num_views != (i + 1) * num_proposing / num_views;
      for (size_t r = begin; proposes && r < end; ++r) rays.push_back(r);
      begin = end;
    }
    return rays;
  }

  bool PointsAlong(const Ray& ray, const Eigen::Vector3d& direction) const {
    const auto angle = ImageDirection(views_[ray.view], joint_, direction);
    return angle && AngleBetween(*angle, ray.angle) < kRayWidthRad;
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
    double background = 0;
    size_t begin = 0;
    for (const SeenIn& seen : seen_in_) {
      const size_t first = begin;
      begin = seen.rays_end;
      const auto angle = ImageDirection(views_[seen.view], joint_, direction);
      if (!angle) continue;
      ++vote.num_views;
      const double num_rays = std::max(kMinNumRays, static_cast<double>(seen.rays_end - first));
      background += num_rays * kRayWidthRad / M_PI;
      int best = -1;
      double best_turn = kRayWidthRad;
      for (size_t r = first; r < seen.rays_end; ++r) {
        const double turn = AngleBetween(rays_[r].angle, *angle);
        if (turn >= best_turn) continue;
        best_turn = turn;
        best = static_cast<int>(r);
      }
      if (best >= 0) vote.rays.push_back(best);
    }
    if (vote.num_views > 0) vote.background = std::min(0.99, background / vote.num_views);
    return vote;
  }

  // The direction nearest to all planes of the rays.
  Eigen::Vector3d Fit(const Eigen::Vector3d& start, const std::vector<int>& chosen) const {
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const int r : chosen) scatter += rays_[r].normal * rays_[r].normal.transpose();
    const Eigen::Vector3d direction =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
    return direction.dot(start) < 0 ? Eigen::Vector3d(-direction) : direction;
  }

  const Joint& joint_;
  const std::vector<View>& views_;
  size_t min_views_;
  std::vector<Ray> rays_;  // by view
  std::vector<SeenIn> seen_in_;
};

}  // namespace

std::optional<CornerDirection> FindCornerDirection(const Joint& joint,
                                                   const std::vector<View>& views,
                                                   const std::vector<ImageCurves>& curves,
                                                   const EdgelIndexes& edgels, int min_views) {
  return DirectionFinder(joint, views, curves, edgels, static_cast<size_t>(min_views)).Find();
}

}  // namespace limn
