// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/grow_edges.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <utility>

#include <Eigen/LU>

#include "limn/geometry/spatial_index.h"
#include "limn/geometry/tangent_frame.h"
#include "limn/support/segment_support.h"
#include "limn/topology/edgel_claims.h"
#include "limn/topology/joint_rays.h"
#include "limn/util/map_items.h"

namespace limn {
namespace {

// Growth, px: step, start, longest gap without edgels, longest and shortest link.
constexpr double kStepPx = 1;
constexpr double kBeginPx = 2;
constexpr double kMaxGapPx = 3;
constexpr double kMaxLengthPx = 100;
constexpr double kMinLengthPx = 4;
// Number of steps after which the direction is fitted again.
constexpr int kFitSteps = 4;
// Weight of the old direction in the fit, px^2: it decides where nothing is seen.
constexpr double kOldDirectionWeight = 4;
// An edge ends at a joint within this distance of its end, px, and of its line.
constexpr double kSnapPx = 4;
constexpr double kMaxEdgeMissPx = 2;
// Joints nearer to each other than this are taken for one, px.
constexpr double kMinSegmentPx = 3;
// Largest chance that the images show a grown edge by accident, and the same for all segments from
// one joint together. A segment between two joints is more plausible to begin with. A smaller
// chance for grown edges finds fewer junctions.
constexpr double kMaxChance = 1e-2;
constexpr double kMaxSegmentChance = 1e-1;
// Views in which edgels must run along an edge. More find fewer junctions.
constexpr int kMinViews = 4;

// A straight edge, from one joint to another if it has two. The most certain ones sort first.
struct Segment {
  double log_chance = 0;
  int from = -1;
  int to = -1;
  std::vector<ViewId> seen_in;

  auto operator<=>(const Segment&) const = default;
};

class EdgeFinder {
 public:
  EdgeFinder(const TopologyInput& input, const TopologyOptions& options, GrowthEnd ends,
             const RunContext& context, GraphEditor* editor)
      : input_(input),
        options_(options),
        ends_(ends),
        editor_(editor),
        unclaimed_(UnclaimedEdgels(input, editor->graph(), context)),
        joints_(CollectJoints(editor->graph(), input.views.size())),
        index_(Positions(joints_)) {}

  int64_t GrowAll(const RunContext& context) {
    // Most joints have nothing to grow, which is found out in parallel. A direction is stale if a
    // link has been added at the joint since.
    auto first = MapItems(context, "edges from joints", joints_.size(),
                          [&](size_t i) { return DirectionAt(joints_[i]); });
    std::vector<size_t> num_leaving;
    for (const Joint& joint : joints_) num_leaving.push_back(joint.leaving.size());
    int64_t added = 0;
    for (size_t i = 0; i < joints_.size(); ++i) {
      ThrowIfCancelled(context);
      const bool is_current = joints_[i].leaving.size() == num_leaving[i];
      auto direction = is_current ? std::move(first[i]) : DirectionAt(joints_[i]);
      while (direction && Grow(*std::move(direction), &joints_[i])) {
        ++added;
        direction = DirectionAt(joints_[i]);
      }
    }
    return added;
  }

  int64_t AddSegments(const RunContext& context) {
    const auto of_joint = MapItems(context, "short edges", joints_.size(),
                                   [&](size_t i) { return SegmentsFrom(static_cast<int>(i)); });
    std::vector<Segment> found;
    for (const auto& segments : of_joint) {
      found.insert(found.end(), segments.begin(), segments.end());
    }
    std::sort(found.begin(), found.end());
    int64_t added = 0;
    for (const auto& [log_chance, from, to, seen_in] : found) {
      added += AddLink(joints_[to].position, seen_in, &joints_[from], &joints_[to]);
    }
    return added;
  }

 private:
  static std::vector<Eigen::Vector3d> Positions(const std::vector<Joint>& joints) {
    std::vector<Eigen::Vector3d> positions;
    for (const Joint& joint : joints) positions.push_back(joint.position);
    return positions;
  }

  std::optional<JointDirection> DirectionAt(const Joint& joint) const {
    return FindJointDirection(input_, joint, kMinViews);
  }

  // Returns whether a link was added.
  bool Grow(JointDirection direction, Joint* joint) {
    const double length_px = LengthAlong(*joint, &direction);
    if (length_px < kMinLengthPx) return false;
    const Eigen::Vector3d end = joint->position + length_px * joint->footprint * direction.unit;
    if (!Shown(joint->position, end, joint->visible, kMaxChance)) return false;
    Joint* target = JointNear(end, direction.unit, *joint);
    if (!target && ends_ == GrowthEnd::kJoint) return false;
    return AddLink(target ? target->position : end, direction.views, joint, target);
  }

  // Unless another link leaves in this direction. Returns whether the link was added.
  bool AddLink(const Eigen::Vector3d& end, const std::vector<ViewId>& in_views, Joint* joint,
               Joint* target) {
    if (IsTaken(*joint, end, target)) return false;
    AddStraightLink(input_, end, in_views, joint, target, editor_);
    return true;
  }

  // Length of the edge, px. Its direction is fitted to the edgels on the way. A view that loses the
  // edge is not asked again.
  double LengthAlong(const Joint& joint, JointDirection* direction) const {
    std::vector<ViewId> active = direction->views;
    const size_t needed = std::max<size_t>(options_.min_junction_views, (active.size() + 1) / 2);
    std::vector<double> seen_at(input_.views.size(), kBeginPx);
    Footing footing;
    double length_px = 0;
    for (double at = kBeginPx; at <= kMaxLengthPx; at += kStepPx) {
      const Eigen::Vector3d point = joint.position + at * joint.footprint * direction->unit;
      if (input_.box && !input_.box->contains(point)) break;
      auto support = SupportAt(input_, point, direction->unit, active, kJointGate);
      for (const EdgelRef& ref : support) seen_at[ref.view] = at;
      std::erase_if(active, [&](ViewId v) { return at - seen_at[v] > kMaxGapPx; });
      if (active.size() < needed) break;
      if (support.size() < needed) continue;
      length_px = at;
      footing.push_back({at, std::move(support)});
      if (footing.size() % kFitSteps == 0) direction->unit = Fit(joint, direction->unit, footing);
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
        const auto residual = input_.Residual(ref, joint.position + arm * direction);
        if (!residual) continue;
        const Eigen::Vector2d gradient = arm * across.transpose() * residual->gradient;
        sum += gradient * gradient.transpose();
        right -= gradient * residual->residual_px;
      }
    }
    return (direction + across * sum.inverse() * right).normalized();
  }

  // What shows a straight edge, if enough views do, chance does not explain them, and some view
  // shows it by edgels that no link has yet. Without the last test, links grow along other links at
  // a wrong depth.
  std::optional<Segment> Shown(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                               const std::vector<uint8_t>& visible, double max_chance) const {
    const SegmentSupport found =
        FindSegmentSupport(from, to, visible, input_.views, input_.edgels, kJointGate);
    const auto count = static_cast<int>(found.seen_in.size());
    const double log_chance = LogChance(count, found.num_views, found.background);
    if (count < kMinViews || log_chance > std::log(max_chance)) return std::nullopt;
    for (size_t v = 0; v < visible.size(); ++v) {
      if (visible[v] && ShowsSegment(input_.views[v], from, to, unclaimed_[v], kJointGate)) {
        return Segment{log_chance, -1, -1, found.seen_in};
      }
    }
    return std::nullopt;
  }

  // The joint at which an edge in this direction ends.
  Joint* JointNear(const Eigen::Vector3d& end, const Eigen::Vector3d& direction,
                   const Joint& from) {
    std::vector<SpatialIndex::Neighbor> near;
    index_.FindWithin(end, kSnapPx * from.footprint, &near);
    std::erase_if(near, [&](const SpatialIndex::Neighbor& neighbor) {
      const Eigen::Vector3d offset = joints_[neighbor.index].position - from.position;
      const double along = offset.dot(direction);
      const double miss = (offset - along * direction).norm();
      return along < kBeginPx * from.footprint || miss > kMaxEdgeMissPx * from.footprint;
    });
    const auto nearest =
        std::ranges::min_element(near, {}, &SpatialIndex::Neighbor::squared_distance);
    return nearest == near.end() ? nullptr : &joints_[nearest->index];
  }

  bool CanHaveSegment(const Joint& a, const Joint& b) const {
    const Eigen::Vector3d offset = b.position - a.position;
    return offset.norm() >= kMinSegmentPx * a.footprint && !IsTaken(a, b.position, &b);
  }

  // Segments from a joint to later joints that the images show.
  std::vector<Segment> SegmentsFrom(int i) const {
    const Joint& from = joints_[i];
    std::vector<SpatialIndex::Neighbor> near;
    index_.FindWithin(from.position, options_.max_short_edge_px * from.footprint, &near);
    std::erase_if(near, [&](const SpatialIndex::Neighbor& neighbor) {
      return neighbor.index <= i || !CanHaveSegment(from, joints_[neighbor.index]);
    });
    std::vector<Segment> found;
    for (const SpatialIndex::Neighbor& neighbor : near) {
      const Joint& to = joints_[neighbor.index];
      std::vector<uint8_t> visible = from.visible;
      for (size_t v = 0; v < visible.size(); ++v) visible[v] &= to.visible[v];
      auto segment = Shown(from.position, to.position, visible,
                           kMaxSegmentChance / static_cast<double>(near.size()));
      if (!segment) continue;
      segment->from = i;
      segment->to = neighbor.index;
      found.push_back(*std::move(segment));
    }
    return found;
  }

  const TopologyInput& input_;
  const TopologyOptions& options_;
  const GrowthEnd ends_;
  GraphEditor* editor_;
  const std::vector<EdgelIndex> unclaimed_;
  std::vector<Joint> joints_;
  SpatialIndex index_;
};

}  // namespace

int64_t GrowEdges(const TopologyInput& input, const TopologyOptions& options, GrowthEnd ends,
                  const RunContext& context, GraphEditor* editor) {
  return EdgeFinder(input, options, ends, context, editor).GrowAll(context);
}

int64_t AddShortEdges(const TopologyInput& input, const TopologyOptions& options,
                      const RunContext& context, GraphEditor* editor) {
  return EdgeFinder(input, options, GrowthEnd::kJoint, context, editor).AddSegments(context);
}

}  // namespace limn
