#include "limn/drawing/corner_edges.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "limn/drawing/segment_evidence.h"
#include "limn/drawing/vertex_grid.h"
#include "limn/support/edgel_residual.h"

namespace limn {
namespace {

constexpr double kDeg = M_PI / 180;
// Edgels at these distances from the joint make rays, px: nearer, edges are rounded and mixed.
constexpr int kMinRayPx = 2;
constexpr int kMaxRayPx = 9;
// An edgel points at the joint when its tangent line passes it this near, px, and its direction from there
// is within the angle of its tangent.
constexpr double kMaxMissPx = 1.0;
constexpr double kMaxRadialAngleDeg = 25;
// Pixels of the ray that must have edgels.
constexpr int kMinRayCoverPx = 4;
// Edgels this near in direction are of one ray; a ray agrees with a direction within as much.
constexpr double kRayWidthDeg = 12;
// Directions this near to that of a link at the joint are explained by it.
constexpr double kExplainedDeg = 20;
// A step in space of so many px gives the direction in the image; below so many px projected it is seen
// end on.
constexpr double kProbePx = 6;
constexpr double kMinProbePx = 2;
// False alarms accepted per joint, natural logarithm, and the number of distinct directions tried.
const double kMaxLogChance = std::log(getenv("GC") ? atof(getenv("GC")) : 1e-2);
const double kLogNumDirections = std::log(130.0);
// Growing: steps, gaps, and how far.
constexpr double kStepPx = 1;
constexpr double kMaxGapPx = 3;
const double kMaxLengthPx = getenv("GL") ? atof(getenv("GL")) : 60;
constexpr double kMinLengthPx = 4;
constexpr double kSpacingPx = 2;
// An end this near to a joint ends there, px.
constexpr double kSnapPx = 4;

struct Ray {
  ViewId view = -1;
  double angle = 0;         // in the virtual image, pointing away from the joint
  Eigen::Vector3d normal;   // of the plane through the camera centre and the ray, world
};

struct Joint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double footprint = 0;
  std::vector<Eigen::Vector3d> leaving;   // unit directions into the links
  std::vector<std::pair<int, int>> ends;  // (link, end)
};

double AngleBetween(double a, double b) { return std::abs(std::remainder(a - b, 2 * M_PI)); }

class CornerEdges {
 public:
  CornerEdges(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
              const std::vector<std::unique_ptr<ViewEvidence>>& evidence,
              const DrawingOptions& options, SampleSet* samples, Draft* draft)
      : views_(views), curves_(curves), evidence_(evidence), options_(options), samples_(samples),
        draft_(draft), gate_(options.Gate()) {
    gate_.normal_px = 1.5;
    gate_.along_px = 1.5;
    gate_.angle_rad = 25 * kDeg;
  }

  int64_t Run() {
    CollectJoints();
    VertexGrid grid(kSnapPx);
    for (size_t i = 0; i < joints_.size(); ++i) {
      grid.Add(static_cast<int>(i), joints_[i].position, joints_[i].footprint);
    }
    int64_t added = 0;
    const size_t count = joints_.size();
    for (size_t i = 0; i < count; ++i) {
      while (GrowOne(static_cast<int>(i), grid)) ++added;
    }
    return added;
  }

 private:
  void CollectJoints() {
    std::map<int, int> of_node;
    for (size_t l = 0; l < draft_->links.size(); ++l) {
      const DraftLink& link = draft_->links[l];
      if (link.closed || link.size() < 2) continue;
      for (const int end : {0, 1}) {
        const int node = link.node[end];
        auto known = node >= 0 ? of_node.find(node) : of_node.end();
        const int id = known != of_node.end() ? known->second : static_cast<int>(joints_.size());
        if (known == of_node.end()) {
          joints_.emplace_back();
          if (node >= 0) of_node[node] = id;
        }
        Joint& joint = joints_[id];
        joint.position += end == 0 ? link.position.front() : link.position.back();
        joint.footprint += end == 0 ? link.footprint.front() : link.footprint.back();
        joint.leaving.push_back(-LineAtEnd(link, end).outward);
        joint.ends.push_back({static_cast<int>(l), end});
      }
    }
    for (Joint& joint : joints_) {
      joint.position /= static_cast<double>(joint.ends.size());
      joint.footprint /= static_cast<double>(joint.ends.size());
    }
  }

  // Direction in the image in which a point leaves the joint; nothing if end on.
  std::optional<double> ImageDirection(const View& view, const Joint& joint,
                                       const Eigen::Vector3d& direction) const {
    const Eigen::Vector3d a = view.cam_from_world * joint.position;
    const Eigen::Vector3d b =
        view.cam_from_world * (joint.position + kProbePx * joint.footprint * direction);
    if (!(a.z() > 0 && b.z() > 0)) return std::nullopt;
    const Eigen::Vector2d offset = view.camera.Project(b) - view.camera.Project(a);
    if (offset.norm() < kMinProbePx) return std::nullopt;
    return std::atan2(offset.y(), offset.x());
  }

  void CollectRays(ViewId v, const Joint& joint, std::vector<Ray>* rays) const {
    const auto centre = views_[v].Project(joint.position);
    if (!centre) return;
    std::vector<double> explained;
    for (const Eigen::Vector3d& leaving : joint.leaving) {
      if (const auto angle = ImageDirection(views_[v], joint, leaving)) explained.push_back(*angle);
    }
    struct Spoke {
      double angle;
      int distance;
    };
    std::vector<Spoke> spokes;
    const auto& edgels = curves_[v].edge_map.edgels;
    evidence_[v]->edgels.ForEachWithin(*centre, kMaxRayPx + 1, [&](EdgelId id) {
      const Edgel& edgel = edgels[id];
      const Eigen::Vector2d offset = edgel.position_px - *centre;
      const double distance = offset.norm();
      if (distance < kMinRayPx || distance > kMaxRayPx) return;
      const double miss = std::abs(edgel.Normal().dot(offset));
      if (miss > kMaxMissPx || miss > std::sin(kMaxRadialAngleDeg * kDeg) * distance) return;
      const double angle = std::atan2(offset.y(), offset.x());
      for (const double taken : explained) {
        if (AngleBetween(taken, angle) < kExplainedDeg * kDeg) return;
      }
      spokes.push_back({angle, static_cast<int>(distance)});
    });
    // The widest-covered direction first; its edgels then no longer count.
    while (true) {
      double best_angle = 0;
      int best_cover = 0;
      for (const Spoke& candidate : spokes) {
        unsigned bins = 0;
        for (const Spoke& other : spokes) {
          if (AngleBetween(other.angle, candidate.angle) < 0.5 * kRayWidthDeg * kDeg) {
            bins |= 1u << other.distance;
          }
        }
        const int cover = std::popcount(bins);
        if (cover > best_cover) {
          best_cover = cover;
          best_angle = candidate.angle;
        }
      }
      if (best_cover < kMinRayCoverPx) break;
      // Centre of the ray: farther edgels tell the direction better.
      double sum = 0;
      double weight = 0;
      for (const Spoke& spoke : spokes) {
        const double turn = std::remainder(spoke.angle - best_angle, 2 * M_PI);
        if (std::abs(turn) >= 0.5 * kRayWidthDeg * kDeg) continue;
        sum += spoke.distance * turn;
        weight += spoke.distance;
      }
      const double angle = best_angle + sum / weight;
      std::erase_if(spokes, [&](const Spoke& spoke) {
        return AngleBetween(spoke.angle, angle) < kRayWidthDeg * kDeg;
      });
      const Rigid3d& pose = views_[v].cam_from_world;
      const PinholeCamera& camera = views_[v].camera;
      const Eigen::Vector3d point = pose * joint.position;
      const Eigen::Vector3d along(std::cos(angle) / camera.fx, std::sin(angle) / camera.fy, 0);
      rays->push_back({v, angle, pose.rotation.conjugate() * point.cross(along).normalized()});
    }
  }

  struct Vote {
    std::vector<int> rays;
    int num_views = 0;
    double background = 0;
    double LogChance() const {
      return limn::LogChance(static_cast<int>(rays.size()), num_views, background);
    }
  };

  // The rays, at most one per view, that agree with a direction.
  Vote VotesFor(const Joint& joint, const Eigen::Vector3d& direction,
                const std::vector<Ray>& rays) const {
    Vote vote;
    double background = 0;
    size_t next = 0;
    for (size_t v = 0; v < views_.size(); ++v) {
      const size_t begin = next;
      while (next < rays.size() && rays[next].view == static_cast<ViewId>(v)) ++next;
      if (!views_[v].Project(joint.position)) continue;
      const auto angle = ImageDirection(views_[v], joint, direction);
      if (!angle) continue;
      ++vote.num_views;
      background += std::max(0.3, static_cast<double>(next - begin)) * 2 * kRayWidthDeg / 360;
      int best = -1;
      double best_turn = kRayWidthDeg * kDeg;
      for (size_t r = begin; r < next; ++r) {
        const double turn = AngleBetween(rays[r].angle, *angle);
        if (turn >= best_turn) continue;
        best_turn = turn;
        best = static_cast<int>(r);
      }
      if (best >= 0) vote.rays.push_back(best);
    }
    if (vote.num_views > 0) vote.background = background / vote.num_views;
    return vote;
  }

  // The direction in all planes of the rays, on the side they point to.
  Eigen::Vector3d FitDirection(const Eigen::Vector3d& start, const std::vector<int>& chosen,
                               const std::vector<Ray>& rays) const {
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const int r : chosen) scatter += rays[r].normal * rays[r].normal.transpose();
    const Eigen::Vector3d direction =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
    return direction.dot(start) < 0 ? Eigen::Vector3d(-direction) : direction;
  }

  bool PointsAlong(const Joint& joint, const Ray& ray, const Eigen::Vector3d& direction) const {
    const auto angle = ImageDirection(views_[ray.view], joint, direction);
    return angle && AngleBetween(*angle, ray.angle) < kRayWidthDeg * kDeg;
  }

  struct Direction {
    Eigen::Vector3d unit;
    std::vector<ViewId> views;
    double log_chance = 0;
  };

  std::optional<Direction> BestDirection(const Joint& joint, const std::vector<Ray>& rays) const {
    std::optional<Direction> best;
    double best_chance = kMaxLogChance - kLogNumDirections;
    for (size_t i = 0; i < rays.size(); ++i) {
      for (size_t j = i + 1; j < rays.size(); ++j) {
        if (rays[i].view == rays[j].view) continue;
        Eigen::Vector3d direction = rays[i].normal.cross(rays[j].normal);
        if (direction.norm() < std::sin(8 * kDeg)) continue;
        direction.normalize();
        if (!PointsAlong(joint, rays[i], direction)) direction = -direction;
        if (!PointsAlong(joint, rays[i], direction) || !PointsAlong(joint, rays[j], direction)) {
          continue;
        }
        Vote vote = VotesFor(joint, direction, rays);
        if (static_cast<int>(vote.rays.size()) < options_.min_supporting_views) continue;
        if (vote.LogChance() >= best_chance) continue;
        direction = FitDirection(direction, vote.rays, rays);
        vote = VotesFor(joint, direction, rays);
        if (static_cast<int>(vote.rays.size()) < options_.min_supporting_views) continue;
        if (vote.LogChance() >= best_chance) continue;
        best_chance = vote.LogChance();
        best = Direction{direction, {}, best_chance};
        for (const int r : vote.rays) best->views.push_back(rays[r].view);
      }
    }
    return best;
  }

  std::vector<EdgelRef> SupportAt(const Eigen::Vector3d& position, const Eigen::Vector3d& direction,
                                  const std::vector<ViewId>& in_views) const {
    std::vector<EdgelRef> support;
    for (const ViewId v : in_views) {
      const auto pixel = views_[v].Project(position);
      const auto angle = ProjectedDirection(views_[v], position, direction);
      if (!pixel || !angle) continue;
      const auto match = evidence_[v]->edgels.Best(*pixel, *angle, gate_);
      if (match) support.push_back({v, match->edgel});
    }
    return support;
  }

  // How far edgels support the edge, px; the direction is fitted to them on the way.
  double Grow(const Joint& joint, Direction* direction) const {
    std::vector<std::pair<double, std::vector<EdgelRef>>> support;
    double reached = 0;
    for (double at = kMinRayPx; at <= kMaxLengthPx && at <= reached + kMaxGapPx + kMinRayPx; at += kStepPx) {
      auto here = SupportAt(joint.position + at * joint.footprint * direction->unit,
                            direction->unit, direction->views);
      if (static_cast<int>(here.size()) < options_.min_junction_views) continue;
      reached = at;
      support.push_back({at, std::move(here)});
      // Turn about the joint so that the residuals vanish.
      if (static_cast<int>(at) % 4 == 0) direction->unit = FitToEdgels(joint, direction->unit, support);
    }
    direction->unit = FitToEdgels(joint, direction->unit, support);
    return reached;
  }

  Eigen::Vector3d FitToEdgels(
      const Joint& joint, const Eigen::Vector3d& direction,
      const std::vector<std::pair<double, std::vector<EdgelRef>>>& support) const {
    Eigen::Matrix<double, 3, 2> across;
    across.col(0) = direction.unitOrthogonal();
    across.col(1) = direction.cross(across.col(0));
    Eigen::Matrix2d sum = Eigen::Matrix2d::Identity() * 4;  // in px^2: keeps what is not seen
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const auto& [at, edgels] : support) {
      const double arm = at * joint.footprint;
      for (const EdgelRef& ref : edgels) {
        const auto residual = ResidualToEdgel(views_[ref.view], curves_[ref.view].edge_map.edgels[ref.edgel],
                                              joint.position + arm * direction);
        if (!residual) continue;
        const Eigen::Vector2d gradient = arm * across.transpose() * residual->gradient;
        sum += gradient * gradient.transpose();
        right -= gradient * residual->residual_px;
      }
    }
    return (direction + across * sum.inverse() * right).normalized();
  }

  bool GrowOne(int id, const VertexGrid& grid) {
    const Joint joint = joints_[id];
    std::vector<Ray> rays;
    for (size_t v = 0; v < views_.size(); ++v) CollectRays(static_cast<ViewId>(v), joint, &rays);
    if (getenv("DBGJ")) {
      Eigen::Vector3d q, d; sscanf(getenv("DBGJ"), "%lf,%lf,%lf,%lf,%lf,%lf", &q.x(), &q.y(), &q.z(), &d.x(), &d.y(), &d.z());
      if ((q - joint.position).norm() < 3 * joint.footprint) {
        auto v = VotesFor(joint, d, rays);
        printf("JOINT %.3f %.3f %.3f links %zu rays %zu votes %zu of %d bg %.3f chance %.2f\n", joint.position.x(), joint.position.y(), joint.position.z(), joint.leaving.size(), rays.size(), v.rays.size(), v.num_views, v.background, v.LogChance());
        for (size_t w = 0; w < views_.size(); ++w) { auto a = ImageDirection(views_[w], joint, d); if (!a || !views_[w].Project(joint.position)) continue; auto c = *views_[w].Project(joint.position); printf("  view %zu at %.1f %.1f predicted %.0f rays:", w, c.x(), c.y(), *a / kDeg); for (auto& r : rays) if (r.view == (int)w) printf(" %.0f", r.angle / kDeg); 
          printf("  expl:"); for (auto& l : joint.leaving) if (auto e = ImageDirection(views_[w], joint, l)) printf(" %.0f", *e / kDeg);
          printf("  sup:"); for (double at = 1; at < 16; at += 1) { auto P = joint.position + at * joint.footprint * d; auto px = views_[w].Project(P); auto an = ProjectedDirection(views_[w], P, d); printf("%d", px && an && evidence_[w]->edgels.Best(*px, *an, gate_).has_value()); }
          printf("\n"); }
      }
    }
    auto direction = BestDirection(joint, rays);
    if (!direction) return false;
    const double length_px = Grow(joint, &*direction);
    if (getenv("DBG")) printf("GR %.3f %.3f %.3f dir %.2f %.2f %.2f len %.1f views %zu chance %.1f\n", joint.position.x(), joint.position.y(), joint.position.z(), direction->unit.x(), direction->unit.y(), direction->unit.z(), length_px, direction->views.size(), direction->log_chance);
    if (length_px < kMinLengthPx) return false;
    Eigen::Vector3d end = joint.position + length_px * joint.footprint * direction->unit;
    const int target = JointNear(id, end, direction->unit, grid);
    if (target >= 0) end = joints_[target].position;
    for (const Eigen::Vector3d& leaving : joint.leaving) {
      if (leaving.dot((end - joint.position).normalized()) > std::cos(kExplainedDeg * kDeg)) return false;
    }
    AddLink(id, target, end, direction->views);
    return true;
  }

  int JointNear(int from, const Eigen::Vector3d& end, const Eigen::Vector3d& direction,
                const VertexGrid& grid) const {
    int best = -1;
    double best_distance = std::numeric_limits<double>::infinity();
    grid.ForEachNear(end, joints_[from].footprint, [&](int id) {
      if (id == from) return;
      const Joint& joint = joints_[id];
      const Eigen::Vector3d offset = joint.position - joints_[from].position;
      const double along = offset.dot(direction);
      const double miss = (offset - along * direction).norm();
      const double distance = (joint.position - end).norm();
      if (along < 2 * joint.footprint || miss > 2 * joint.footprint) return;
      if (distance > kSnapPx * joint.footprint) return;
      if (distance < best_distance || (distance == best_distance && id < best)) {
        best = id;
        best_distance = distance;
      }
    });
    return best;
  }

  int NodeAt(const Joint& joint) {
    int node = -1;
    for (const auto& [link, end] : joint.ends) node = std::max(node, draft_->links[link].node[end]);
    if (node < 0) node = draft_->num_nodes++;
    for (const auto& [link, end] : joint.ends) draft_->links[link].node[end] = node;
    return node;
  }

  void AddLink(int from, int target, const Eigen::Vector3d& end, const std::vector<ViewId>& in_views) {
    const Eigen::Vector3d begin = joints_[from].position;
    const double footprint = joints_[from].footprint;
    const Eigen::Vector3d direction = (end - begin).normalized();
    const int count =
        std::max(3, static_cast<int>(std::lround((end - begin).norm() / footprint / kSpacingPx)) + 1);
    DraftLink link;
    link.grown = true;
    link.node[0] = NodeAt(joints_[from]);
    if (target >= 0) link.node[1] = NodeAt(joints_[target]);
    const int first_sample = samples_->NumSamples();
    const int curve = samples_->NumCurves();
    samples_->origins.push_back({});
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - direction * direction.transpose();
    for (int k = 0; k < count; ++k) {
      const Eigen::Vector3d position = begin + (end - begin) * k / (count - 1.0);
      const auto support = SupportAt(position, direction, in_views);
      Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
      for (const EdgelRef& ref : support) {
        const auto residual = ResidualToEdgel(
            views_[ref.view], curves_[ref.view].edge_map.edgels[ref.edgel], position);
        if (residual) information += residual->gradient * residual->gradient.transpose();
      }
      samples_->curve_of.push_back(curve);
      samples_->position.push_back(position);
      samples_->tangent.push_back(direction);
      samples_->information.push_back(across * information * across);
      samples_->footprint.push_back(footprint);
      samples_->support.Append(support);
      link.position.push_back(position);
      link.information.push_back(samples_->information.back());
      link.footprint.push_back(footprint);
      link.samples.push_back({first_sample + k});
    }
    samples_->curve_begin.push_back(samples_->NumSamples());
    const int id = static_cast<int>(draft_->links.size());
    draft_->links.push_back(std::move(link));
    joints_[from].leaving.push_back(direction);
    joints_[from].ends.push_back({id, 0});
    if (target < 0) return;
    joints_[target].leaving.push_back(-direction);
    joints_[target].ends.push_back({id, 1});
  }

  const std::vector<View>& views_;
  const std::vector<ImageCurves>& curves_;
  const std::vector<std::unique_ptr<ViewEvidence>>& evidence_;
  const DrawingOptions& options_;
  SampleSet* samples_;
  Draft* draft_;
  SupportGate gate_;
  std::vector<Joint> joints_;
};

}  // namespace

int64_t GrowCornerEdges(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                        const std::vector<std::unique_ptr<ViewEvidence>>& evidence,
                        const DrawingOptions& options, SampleSet* samples, Draft* draft) {
  return CornerEdges(views, curves, evidence, options, samples, draft).Run();
}

}  // namespace limn
