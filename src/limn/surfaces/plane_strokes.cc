// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/plane_strokes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include <Eigen/Geometry>

#include "limn/geometry/polyline_position.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// Projected links are simplified to this, px.
constexpr double kSimplifyPx = 0.1;
// An end is extended in the direction of its last part, of this length, px.
constexpr double kTangentPx = 12;
// The nearest link is preferred to the first straight on if it is that much nearer.
constexpr double kNearerShare = 0.7;

PlaneFrame FrameOf(const FacePlane& plane, const Eigen::Vector3d& center) {
  PlaneFrame frame;
  frame.origin = center - (plane.normal.dot(center) - plane.offset) * plane.normal;
  frame.x_axis = plane.normal.unitOrthogonal();
  frame.y_axis = plane.normal.cross(frame.x_axis);
  return frame;
}

// An end of a link that meets no other in the plane, and how it would continue.
struct OpenEnd {
  int stroke = -1;
  double footprint = 0;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::Zero();  // unit
  double reach = 0;                                     // straight on, plane coordinates
};

struct Target {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  double distance = std::numeric_limits<double>::infinity();
};

class StrokeMaker {
 public:
  StrokeMaker(const FacePlane& plane, const std::vector<FaceLink>& links, const DrawingGraph& graph,
              const SurfaceOptions& options)
      : links_(links), graph_(graph), options_(options) {
    result_.frame = FrameOf(plane, links[plane.members.front()].center);
    AddLinks(plane);
  }

  PlaneStrokes Run() {
    const std::vector<OpenEnd> ends = OpenEnds();
    std::vector<PlaneStroke> bridges;
    for (const OpenEnd& end : ends) {
      const Target target = BestTarget(end);
      if (std::isfinite(target.distance)) bridges.push_back(Bridge(end, target.place));
    }
    for (size_t i = 0; i < ends.size(); ++i) {
      for (size_t j = i + 1; j < ends.size(); ++j) {
        const auto crossing = CrossingOf(ends[i], ends[j]);
        if (!crossing) continue;
        bridges.push_back(Bridge(ends[i], *crossing));
        bridges.push_back(Bridge(ends[j], *crossing));
      }
    }
    std::ranges::move(bridges, std::back_inserter(result_.strokes));
    return std::move(result_);
  }

 private:
  void AddLinks(const FacePlane& plane) {
    Eigen::AlignedBox2d extent;
    for (const int l : plane.members) {
      for (const Eigen::Vector3d& sample : links_[l].samples) {
        extent.extend(result_.frame.Flat(sample));
      }
    }
    // What an extension can reach may bound faces, too.
    const Eigen::Vector2d margin = Eigen::Vector2d::Constant(
        options_.max_extension_px * links_[plane.members.front()].footprint);
    extent = Eigen::AlignedBox2d(extent.min() - margin, extent.max() + margin);
    std::vector<double> footprints;
    for (size_t l = 0; l < links_.size(); ++l) {
      if (!LiesIn(links_[l], plane.normal, plane.offset, options_.plane_tolerance_px) ||
          !IsWithin(links_[l], extent)) {
        continue;
      }
      result_.strokes.push_back(MakeStroke(links_[l], graph_, result_.frame));
      link_of_.push_back(static_cast<int>(l));
      footprints.push_back(links_[l].footprint);
      Eigen::AlignedBox2d& box = boxes_.emplace_back();
      for (const Eigen::Vector2d& point : result_.strokes.back().points) box.extend(point);
    }
    result_.footprint = Median(footprints);
  }

  bool IsWithin(const FaceLink& link, const Eigen::AlignedBox2d& extent) const {
    return std::ranges::all_of(link.samples, [&](const Eigen::Vector3d& sample) {
      return extent.contains(result_.frame.Flat(sample));
    });
  }

  bool MeetsOther(size_t stroke, NodeId node) const {
    const auto& incident = graph_.nodes[node].incident;
    return std::ranges::any_of(incident, [&](const LinkEnd& end) {
      return end.link != result_.strokes[stroke].link &&
             std::ranges::binary_search(result_.strokes, end.link, {}, &PlaneStroke::link);
    });
  }

  std::vector<OpenEnd> OpenEnds() const {
    std::vector<OpenEnd> ends;
    for (size_t s = 0; s < result_.strokes.size(); ++s) {
      const DrawingLink& link = graph_.links[result_.strokes[s].link];
      if (link.closed) continue;
      for (const int end : {0, 1}) {
        if (!MeetsOther(s, link.NodeAt(end))) ends.push_back(EndOf(static_cast<int>(s), end));
      }
    }
    return ends;
  }

  OpenEnd EndOf(int stroke, int end) const {
    const FaceLink& link = links_[link_of_[stroke]];
    Polyline2d points = result_.strokes[stroke].points;
    if (end == 0) std::ranges::reverse(points);
    OpenEnd open;
    open.stroke = stroke;
    open.footprint = link.footprint;
    open.place = points.back();
    const Eigen::Vector2d back = PointBefore(points, kTangentPx * link.footprint);
    open.direction = (open.place - back).normalized();
    open.reach = std::min(options_.max_extension_px, link.length_px);
    open.reach = std::max(open.reach, options_.max_bridge_px) * link.footprint;
    return open;
  }

  // The point of a polyline this far before its end, or its first point.
  static Eigen::Vector2d PointBefore(const Polyline2d& points, double distance) {
    for (size_t i = points.size() - 1; i > 0; --i) {
      const double length = (points[i] - points[i - 1]).norm();
      if (length >= distance && length > 0) {
        return points[i] + distance / length * (points[i - 1] - points[i]);
      }
      distance -= length;
    }
    return points.front();
  }

  Target BestTarget(const OpenEnd& end) const {
    Target best = StraightOn(end);
    const Target near = Nearest(end);
    if (near.distance < kNearerShare * best.distance) best = near;
    return best;
  }

  // Those of the links that the end may reach.
  template <typename Visit>
  void ForEachOtherSegment(const OpenEnd& end, Visit&& visit) const {
    for (size_t s = 0; s < result_.strokes.size(); ++s) {
      if (static_cast<int>(s) == end.stroke) continue;
      if (boxes_[s].exteriorDistance(end.place) > end.reach) continue;
      const Polyline2d& points = result_.strokes[s].points;
      for (size_t i = 0; i + 1 < points.size(); ++i) visit(points[i], points[i + 1]);
    }
  }

  Target StraightOn(const OpenEnd& end) const {
    Target first;
    ForEachOtherSegment(end, [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
      const Eigen::Vector2d side = to - from;
      const double turn = Cross(end.direction, side);
      if (turn == 0) return;
      const double distance = Cross(from - end.place, side) / turn;
      const double t = Cross(from - end.place, end.direction) / turn;
      if (t < 0 || t > 1 || distance < 0 || distance > std::min(end.reach, first.distance)) return;
      first = {from + t * side, distance};
    });
    return first;
  }

  Target Nearest(const OpenEnd& end) const {
    Target nearest;
    ForEachOtherSegment(end, [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
      const Eigen::Vector2d side = to - from;
      const double length2 = side.squaredNorm();
      if (length2 == 0) return;
      const double t = std::clamp((end.place - from).dot(side) / length2, 0.0, 1.0);
      const double distance = (from + t * side - end.place).norm();
      if (distance > options_.max_bridge_px * end.footprint || distance >= nearest.distance) return;
      nearest = {from + t * side, distance};
    });
    return nearest;
  }

  // Where two ends meet that both go straight on.
  static std::optional<Eigen::Vector2d> CrossingOf(const OpenEnd& a, const OpenEnd& b) {
    const double turn = Cross(a.direction, b.direction);
    if (turn == 0 || a.stroke == b.stroke) return std::nullopt;
    const double along_a = Cross(b.place - a.place, b.direction) / turn;
    const double along_b = Cross(b.place - a.place, a.direction) / turn;
    if (along_a < 0 || along_a > a.reach || along_b < 0 || along_b > b.reach) return std::nullopt;
    return a.place + along_a * a.direction;
  }

  static PlaneStroke Bridge(const OpenEnd& end, const Eigen::Vector2d& place) {
    return {-1, {end.place, place}, {}, {}};
  }

  const std::vector<FaceLink>& links_;
  const DrawingGraph& graph_;
  const SurfaceOptions& options_;
  PlaneStrokes result_;
  // Per stroke.
  std::vector<int> link_of_;
  std::vector<Eigen::AlignedBox2d> boxes_;
};

}  // namespace

PlaneStroke MakeStroke(const FaceLink& link, const DrawingGraph& graph, const PlaneFrame& frame) {
  PlaneStroke stroke;
  stroke.link = link.link;
  Polyline3d& flat = stroke.course;
  for (const Eigen::Vector3d& point : graph.links[link.link].points_in_world) {
    const Eigen::Vector2d place = frame.Flat(point);
    flat.emplace_back(place.x(), place.y(), 0);
  }
  size_t next = 0;
  for (const Eigen::Vector3d& kept : Simplified(flat, kSimplifyPx * link.footprint)) {
    while (flat[next] != kept) ++next;
    stroke.points.push_back(kept.head<2>());
    stroke.at.push_back(static_cast<double>(next));
    if (next + 1 < flat.size()) ++next;
  }
  return stroke;
}

Eigen::Vector2d PointOn(const PlaneStroke& stroke, double position) {
  const auto [i, t] = SegmentAt(position, stroke.points.size());
  return stroke.points[i] + t * (stroke.points[i + 1] - stroke.points[i]);
}

double PositionOnLink(const PlaneStroke& stroke, double position) {
  const auto [i, t] = SegmentAt(position, stroke.points.size());
  const double begin = stroke.at[i], end = stroke.at[i + 1];
  if (end - begin <= 1) return begin + t * (end - begin);
  const std::span part(stroke.course.begin() + static_cast<std::ptrdiff_t>(begin),
                       stroke.course.begin() + static_cast<std::ptrdiff_t>(end) + 1);
  const Eigen::Vector2d place = PointOn(stroke, position);
  const PolylinePoint on_link = ClosestPoint(part, {place.x(), place.y(), 0});
  return begin + on_link.segment + on_link.t;
}

Eigen::Vector3d PlaneFrame::Normal() const { return x_axis.cross(y_axis); }

PlaneStrokes MakeStrokes(const FacePlane& plane, const std::vector<FaceLink>& links,
                         const DrawingGraph& graph, const SurfaceOptions& options) {
  return StrokeMaker(plane, links, graph, options).Run();
}

}  // namespace limn
