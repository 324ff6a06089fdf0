#include "limn/topology/grow_edges.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <iterator>
#include <limits>
#include <utility>

#include <Eigen/LU>

#include "limn/geometry/spatial_index.h"
#include "limn/geometry/tangent_frame.h"
#include "limn/support/edgel_residual.h"
#include "limn/support/segment_support.h"
#include "limn/topology/corner_rays.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// A direction within this angle of a link is taken by that link. For F see kExplainedRad of
// corner_rays.cc.
constexpr double kTakenRad = 20 * kDeg;
// Growth, px: step, start, longest gap without edgels, longest and shortest link. F on day, room
// with a gap of 2.1: +.2, -.1; 4.2: 0, 0; a shortest link of 2.8 or 5.6: 0, 0.
constexpr double kStepPx = 1;
constexpr double kBeginPx = 2;
constexpr double kMaxGapPx = 3;
constexpr double kMaxLengthPx = 100;
constexpr double kMinLengthPx = 4;
// Number of steps after which the direction is fitted again.
constexpr int kFitSteps = 4;
// Weight of the old direction in the fit, px^2: it decides where nothing is seen.
constexpr double kOldDirectionWeight = 4;
// An edge ends at a joint within this distance of its end, px, and of its line. F on day, room with
// .7 times both: 0, 0; 1.4: 0, +.1.
constexpr double kSnapPx = 4;
constexpr double kMaxMissPx = 2;
// Joints nearer to each other than this are taken for one, px.
constexpr double kMinSegmentPx = 3;
// Largest chance that the images show a grown edge by accident, and the same for all segments from
// one joint together. A segment between two joints is more plausible to begin with. F on day, room
// with 1e-3 for grown edges: +.4, +.3, with 2 % and 0 % fewer junctions found; 1e-1: -.4, 0, with 6
// % and 2 % more; 1e-2 for segments: +.1, +.1; 1: -.1, 0.
constexpr double kMaxChance = 1e-2;
constexpr double kMaxSegmentChance = 1e-1;
// Views in which edgels must run along an edge. F on day, room with 3: 0, -.3; 5: 0, +.2, with 3 %
// fewer junctions found on day.
constexpr int kMinViews = 4;

// Logarithm of the chance that the images show this by accident; 0 if too few show it.
double LogChanceOf(const SegmentSupport& found) {
  const auto count = static_cast<int>(found.seen_in.size());
  return count < kMinViews ? 0 : LogChance(count, found.num_views, found.background);
}

// Returns whether some view shows the edge by edgels that no link has yet. Without this test, links
// grow along other links at a wrong depth.
bool IsNew(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
           const std::vector<uint8_t>& visible, const std::vector<View>& views,
           const EdgelClaims& claims) {
  return IsSeen(from, to, visible, views, claims.unclaimed, CornerGate());
}

std::vector<Eigen::Vector3d> Positions(const std::vector<Joint>& joints) {
  std::vector<Eigen::Vector3d> positions;
  for (const Joint& joint : joints) positions.push_back(joint.position);
  return positions;
}

class EdgeGrowth {
 public:
  EdgeGrowth(const TopologyInput& input, const TopologyOptions& options,
             const std::optional<Eigen::AlignedBox3d>& box, GraphEditor* editor)
      : views_(input.views),
        input_(input),
        claims_(CollectClaims(input, editor->graph())),
        box_(box),
        options_(options),
        editor_(editor),
        joints_(CollectJoints(editor->graph(), input.views.size())),
        index_(Positions(joints_)) {}

  int64_t Run(const RunContext& context) {
    // Most joints have nothing to grow, which is found out in parallel. A direction is stale if a
    // link has been added at the joint since.
    std::vector<std::optional<CornerDirection>> first(joints_.size());
    std::vector<size_t> num_leaving(joints_.size());
    ParallelFor(context, "corner edges", joints_.size(), [&](size_t i) {
      first[i] = DirectionAt(joints_[i]);
      num_leaving[i] = joints_[i].leaving.size();
    });
    int64_t added = 0;
    for (size_t i = 0; i < joints_.size(); ++i) {
      ThrowIfCancelled(context);
      const bool is_current = joints_[i].leaving.size() == num_leaving[i];
      auto direction = is_current ? std::move(first[i]) : DirectionAt(joints_[i]);
      while (direction && Grow(static_cast<int>(i), *std::move(direction))) {
        ++added;
        direction = DirectionAt(joints_[i]);
      }
    }
    return added;
  }

 private:
  std::optional<CornerDirection> DirectionAt(const Joint& joint) const {
    return FindCornerDirection(joint, views_, input_.curves, claims_.all, kMinViews);
  }

  // Whether a link was added.
  bool Grow(int id, CornerDirection direction) {
    Joint& joint = joints_[id];
    const double length_px = LengthAlong(joint, &direction);
    if (length_px < kMinLengthPx) return false;
    Eigen::Vector3d end = joint.position + length_px * joint.footprint * direction.unit;
    if (!IsBelieved(joint, end)) return false;
    const int target = JointNear(id, end, direction.unit);
    if (target >= 0) end = joints_[target].position;
    const Eigen::Vector3d course = (end - joint.position).normalized();
    if (IsTaken(joint, course, kTakenRad)) return false;
    if (target >= 0 && IsTaken(joints_[target], -course, kTakenRad)) return false;
    AddStraightLink(input_, claims_.all, end, direction.views, &joint,
                    target >= 0 ? &joints_[target] : nullptr, editor_);
    return true;
  }

  // Length of the edge, px. Its direction is fitted to the edgels on the way. A view that loses the
  // edge is not asked again.
  double LengthAlong(const Joint& joint, CornerDirection* direction) const {
    std::vector<ViewId> active = direction->views;
    const size_t needed = std::max<size_t>(options_.min_junction_views, (active.size() + 1) / 2);
    std::vector<double> seen_at(views_.size(), kBeginPx);
    Footing footing;
    double length_px = 0;
    int num_steps = 0;
    for (double at = kBeginPx; at <= kMaxLengthPx; at += kStepPx) {
      const Eigen::Vector3d point = joint.position + at * joint.footprint * direction->unit;
      if (box_ && !box_->contains(point)) break;
      auto support = SupportAt(point, direction->unit, active, views_, claims_.all, CornerGate());
      for (const EdgelRef& ref : support) seen_at[ref.view] = at;
      std::erase_if(active, [&](ViewId v) { return at - seen_at[v] > kMaxGapPx; });
      if (active.size() < needed) break;
      if (support.size() < needed) continue;
      length_px = at;
      footing.push_back({at, std::move(support)});
      if (++num_steps % kFitSteps == 0) direction->unit = Fit(joint, direction->unit, footing);
    }
    direction->unit = Fit(joint, direction->unit, footing);
    return length_px;
  }

  // Distances from the joint, px, and the edgels there.
  using Footing = std::vector<std::pair<double, std::vector<EdgelRef>>>;

  // One Gauss-Newton step of the direction, with the joint held, on the distances to the edgels.
  Eigen::Vector3d Fit(const Joint& joint, const Eigen::Vector3d& direction,
                      const Footing& footing) const {
    const Eigen::Matrix<double, 3, 2> across = TangentFrame(direction);
    Eigen::Matrix2d sum = kOldDirectionWeight * Eigen::Matrix2d::Identity();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const auto& [at, support] : footing) {
      const double arm = at * joint.footprint;
      for (const EdgelRef& ref : support) {
        const Edgel& edgel = input_.curves[ref.view].edge_map.edgels[ref.edgel];
        const auto residual =
            ResidualToEdgel(views_[ref.view], edgel, joint.position + arm * direction);
        if (!residual) continue;
        const Eigen::Vector2d gradient = arm * across.transpose() * residual->gradient;
        sum += gradient * gradient.transpose();
        right -= gradient * residual->residual_px;
      }
    }
    return (direction + across * sum.inverse() * right).normalized();
  }

  bool IsBelieved(const Joint& joint, const Eigen::Vector3d& end) const {
    const SegmentSupport found =
        FindSegmentSupport(joint.position, end, joint.visible, views_, claims_.all, CornerGate());
    return LogChanceOf(found) <= std::log(kMaxChance) &&
           IsNew(joint.position, end, joint.visible, views_, claims_);
  }

  int JointNear(int from, const Eigen::Vector3d& end, const Eigen::Vector3d& direction) const {
    const double footprint = joints_[from].footprint;
    std::vector<SpatialIndex::Neighbor> near;
    index_.FindWithin(end, kSnapPx * footprint, &near);
    int best = -1;
    double best_squared = std::numeric_limits<double>::infinity();
    for (const SpatialIndex::Neighbor& neighbor : near) {
      if (neighbor.index == from || neighbor.squared_distance >= best_squared) continue;
      const Eigen::Vector3d offset = joints_[neighbor.index].position - joints_[from].position;
      const double along = offset.dot(direction);
      const double miss = (offset - along * direction).norm();
      if (along < kBeginPx * footprint || miss > kMaxMissPx * footprint) continue;
      best = neighbor.index;
      best_squared = neighbor.squared_distance;
    }
    return best;
  }

  const std::vector<View>& views_;
  const TopologyInput& input_;
  const EdgelClaims claims_;
  const std::optional<Eigen::AlignedBox3d>& box_;
  const TopologyOptions& options_;
  GraphEditor* editor_;
  std::vector<Joint> joints_;
  SpatialIndex index_;
};

// A straight edge between two joints. The most certain ones sort first.
struct Segment {
  double log_chance = 0;
  int from = -1;
  int to = -1;
  std::vector<ViewId> seen_in;

  auto operator<=>(const Segment&) const = default;
};

bool CanHaveSegment(const Joint& a, const Joint& b, const TopologyOptions& options) {
  const Eigen::Vector3d offset = b.position - a.position;
  const double length_px = offset.norm() / a.footprint;
  if (length_px < kMinSegmentPx || length_px > options.max_short_edge_px) return false;
  const Eigen::Vector3d direction = offset.normalized();
  return !IsTaken(a, direction, kTakenRad) && !IsTaken(b, -direction, kTakenRad);
}

class SegmentFinder {
 public:
  SegmentFinder(const TopologyInput& input, const TopologyOptions& options,
                const EdgelClaims& claims, const std::vector<Joint>& joints)
      : input_(input),
        options_(options),
        claims_(claims),
        joints_(joints),
        index_(Positions(joints)) {}

  // Segments from a joint to later joints that the images show.
  std::vector<Segment> From(int i) const {
    std::vector<Segment> found;
    const std::vector<int> near = Near(i);
    for (const int j : near) {
      std::vector<uint8_t> visible = joints_[i].visible;
      for (size_t v = 0; v < visible.size(); ++v) visible[v] &= joints_[j].visible[v];
      const Eigen::Vector3d& from = joints_[i].position;
      const Eigen::Vector3d& to = joints_[j].position;
      SegmentSupport seen =
          FindSegmentSupport(from, to, visible, input_.views, claims_.all, CornerGate());
      const double chance = LogChanceOf(seen);
      if (chance <= std::log(kMaxSegmentChance / static_cast<double>(near.size())) &&
          IsNew(from, to, visible, input_.views, claims_)) {
        found.push_back({chance, i, j, std::move(seen.seen_in)});
      }
    }
    return found;
  }

 private:
  std::vector<int> Near(int i) const {
    std::vector<SpatialIndex::Neighbor> neighbors;
    const double radius = options_.max_short_edge_px * joints_[i].footprint;
    index_.FindWithin(joints_[i].position, radius, &neighbors);
    std::vector<int> near;
    for (const SpatialIndex::Neighbor& neighbor : neighbors) {
      const int j = neighbor.index;
      if (j > i && CanHaveSegment(joints_[i], joints_[j], options_)) near.push_back(j);
    }
    return near;
  }

  const TopologyInput& input_;
  const TopologyOptions& options_;
  const EdgelClaims& claims_;
  const std::vector<Joint>& joints_;
  SpatialIndex index_;
};

}  // namespace

int64_t GrowEdges(const TopologyInput& input, const TopologyOptions& options,
                  const std::optional<Eigen::AlignedBox3d>& box, const RunContext& context,
                  GraphEditor* editor) {
  if (editor->NumLinks() == 0) return 0;
  return EdgeGrowth(input, options, box, editor).Run(context);
}

int64_t AddShortEdges(const TopologyInput& input, const TopologyOptions& options,
                      const RunContext& context, GraphEditor* editor) {
  std::vector<Joint> joints = CollectJoints(editor->graph(), input.views.size());
  if (options.max_short_edge_px < kMinSegmentPx || joints.empty()) return 0;
  const EdgelClaims claims = CollectClaims(input, editor->graph());
  const SegmentFinder finder(input, options, claims, joints);
  std::vector<std::vector<Segment>> of_joint(joints.size());
  ParallelFor(context, "short edges", joints.size(),
              [&](size_t i) { of_joint[i] = finder.From(static_cast<int>(i)); });
  std::vector<Segment> found;
  for (auto& segments : of_joint) {
    std::move(segments.begin(), segments.end(), std::back_inserter(found));
  }
  std::sort(found.begin(), found.end());
  int64_t added = 0;
  for (const Segment& segment : found) {
    Joint& from = joints[segment.from];
    Joint& to = joints[segment.to];
    if (!CanHaveSegment(from, to, options)) continue;  // one before has taken it
    AddStraightLink(input, claims.all, to.position, segment.seen_in, &from, &to, editor);
    ++added;
  }
  return added;
}

}  // namespace limn
