// SPDX-License-Identifier: BSD-3-Clause
#include "limn/plans/section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "limn/geometry/polygon2d.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// Of a line's length: points that deviate less are rounding.
constexpr double kStraight = 1e-9;
constexpr double kGapSigmas = 16;

Eigen::Vector3d CrossingOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double height) {
  const double t = (height - a.z()) / (b.z() - a.z());
  Eigen::Vector3d point = a + t * (b - a);
  point.z() = height;
  return point;
}

// An edge of a face's triangles, in one direction whichever triangle has it.
using MeshEdge = std::pair<int, int>;

// The lines in which one face is cut: a segment per triangle, chained at their common edges.
class FaceCut {
 public:
  FaceCut(const DrawingFace& face, double height) : face_(face), height_(height) {
    for (const auto& triangle : face.triangles) AddTriangle(triangle);
  }

  void AppendTo(std::vector<SectionLine>* lines) {
    // Open chains first: from edges that only one triangle has.
    for (const bool only_ends : {true, false}) {
      for (size_t s = 0; s < segments_.size(); ++s) {
        for (const MeshEdge& edge : segments_[s]) {
          if (used_[s] || (only_ends && at_[edge].size() != 1)) continue;
          SectionLine line = ChainFrom(s, edge);
          if (Length(line.points) > 0) lines->push_back(std::move(line));
        }
      }
    }
  }

 private:
  void AddTriangle(const std::array<int, 3>& triangle) {
    std::vector<MeshEdge> crossed;
    for (int i = 0; i < 3; ++i) {
      const int a = triangle[i], b = triangle[(i + 1) % 3];
      if (IsAbove(a) != IsAbove(b)) crossed.emplace_back(std::min(a, b), std::max(a, b));
    }
    if (crossed.size() != 2) return;
    for (const MeshEdge& edge : crossed) at_[edge].push_back(segments_.size());
    segments_.push_back({crossed[0], crossed[1]});
    used_.push_back(0);
  }

  SectionLine ChainFrom(size_t segment, const MeshEdge& start) {
    SectionLine line;
    line.points = {PointOn(start)};
    MeshEdge edge = start;
    for (bool goes_on = true; goes_on;) {
      used_[segment] = 1;
      const auto& [first, second] = segments_[segment];
      edge = first == edge ? second : first;
      line.points.push_back(PointOn(edge));
      const std::vector<size_t>& here = at_[edge];
      const auto next =
          std::find_if(here.begin(), here.end(), [&](size_t other) { return !used_[other]; });
      goes_on = next != here.end();
      if (goes_on) segment = *next;
    }
    line.closed = edge == start && line.points.size() > 3;
    if (line.closed) line.points.pop_back();
    return line;
  }

  bool IsAbove(int vertex) const { return face_.vertices[vertex].z() >= height_; }
  Eigen::Vector3d PointOn(const MeshEdge& edge) const {
    return CrossingOf(face_.vertices[edge.first], face_.vertices[edge.second], height_);
  }

  const DrawingFace& face_;
  double height_;
  std::vector<std::array<MeshEdge, 2>> segments_;
  std::vector<uint8_t> used_;
  std::map<MeshEdge, std::vector<size_t>> at_;
};

// An end of an open line; 0: its first point.
struct LineEnd {
  size_t line = 0;
  int end = 0;

  auto operator<=>(const LineEnd&) const = default;
};

struct Joint {
  double distance = 0;
  LineEnd first, second;

  auto operator<=>(const Joint&) const = default;
};

const Eigen::Vector3d& PointAtEnd(const std::vector<SectionLine>& lines, const LineEnd& end) {
  const Polyline3d& points = lines[end.line].points;
  return end.end == 0 ? points.front() : points.back();
}

// Pairs of ends, the nearest first, each end once. The two ends of a line are joined only if it is
// longer than two gaps.
std::map<LineEnd, LineEnd> JointsOf(const std::vector<SectionLine>& lines, double gap) {
  std::vector<LineEnd> ends;
  for (size_t l = 0; l < lines.size(); ++l) {
    if (lines[l].closed) continue;
    ends.push_back({l, 0});
    ends.push_back({l, 1});
  }
  std::vector<Joint> joints;
  for (size_t i = 0; i < ends.size(); ++i) {
    for (size_t j = i + 1; j < ends.size(); ++j) {
      const double distance = (PointAtEnd(lines, ends[i]) - PointAtEnd(lines, ends[j])).norm();
      const bool is_same = ends[i].line == ends[j].line;
      if (distance > gap || (is_same && Length(lines[ends[i].line].points) <= 2 * gap)) continue;
      joints.push_back({distance, ends[i], ends[j]});
    }
  }
  std::sort(joints.begin(), joints.end());
  std::map<LineEnd, LineEnd> joined;
  for (const Joint& joint : joints) {
    if (joined.contains(joint.first) || joined.contains(joint.second)) continue;
    joined[joint.first] = joint.second;
    joined[joint.second] = joint.first;
  }
  return joined;
}

// Where two lines meet, the first going on over its last point, the second beginning before its
// first; nothing if that is farther than the gap.
std::optional<Eigen::Vector3d> MeetingPlace(const Polyline3d& first, const Polyline3d& second,
                                            double gap) {
  const Eigen::Vector2d a = first.back().head<2>(), b = second.front().head<2>();
  const Eigen::Vector2d u = (a - (first.end() - 2)->head<2>()).normalized();
  const Eigen::Vector2d v = (b - second[1].head<2>()).normalized();
  constexpr double kLeastSine = 0.1;
  const double sine = Cross(u, v);
  if (std::abs(sine) < kLeastSine) return std::nullopt;
  const Eigen::Vector2d place = a + Cross(Eigen::Vector2d(b - a), v) / sine * u;
  if ((place - a).norm() > gap || (place - b).norm() > gap) return std::nullopt;
  return Eigen::Vector3d(place.x(), place.y(), first.back().z());
}

void Append(const Polyline3d& more, double gap, Polyline3d* points) {
  const auto place = MeetingPlace(*points, more, gap);
  if (place) points->back() = *place;
  points->insert(points->end(), more.begin() + (place ? 1 : 0), more.end());
}

// A closed line whose ends are the ends of its gap.
void Close(double gap, SectionLine* line) {
  line->closed = true;
  if (const auto place = MeetingPlace(line->points, line->points, gap)) {
    line->points.front() = *place;
    line->points.pop_back();
  }
}

class Chainer {
 public:
  Chainer(const std::vector<SectionLine>& lines, double gap)
      : lines_(lines), gap_(gap), joints_(JointsOf(lines, gap)), used_(lines.size(), 0) {}

  std::vector<SectionLine> Chains() {
    std::vector<SectionLine> chains;
    for (const bool only_ends : {true, false}) {
      for (size_t l = 0; l < lines_.size(); ++l) {
        for (const int end : {0, 1}) {
          if (used_[l] || (only_ends && joints_.contains({l, end}))) continue;
          chains.push_back(ChainFrom({l, end}));
        }
      }
    }
    return chains;
  }

 private:
  SectionLine ChainFrom(const LineEnd& start) {
    SectionLine chain = {{}, lines_[start.line].closed};
    for (LineEnd at = start;;) {
      used_[at.line] = 1;
      Polyline3d points = lines_[at.line].points;
      if (at.end == 1) std::reverse(points.begin(), points.end());
      chain.points.empty() ? chain.points.swap(points) : Append(points, gap_, &chain.points);
      const auto next = joints_.find({at.line, 1 - at.end});
      if (next == joints_.end()) return chain;
      if (next->second == start) {
        Close(gap_, &chain);
        return chain;
      }
      at = next->second;
    }
  }

  const std::vector<SectionLine>& lines_;
  double gap_;
  std::map<LineEnd, LineEnd> joints_;
  std::vector<uint8_t> used_;
};

bool IsStraight(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                double tolerance) {
  const double length = (c - a).norm();
  return length > 0 && (b - a).cross(c - a).norm() <= tolerance * length;
}

// Without points on the straight line between their neighbors, or on the one before.
SectionLine Tidied(SectionLine line) {
  const double tolerance = kStraight * Length(line.points);
  Polyline3d tidy;
  for (const Eigen::Vector3d& point : line.points) {
    if (!tidy.empty() && (point - tidy.back()).norm() <= tolerance) continue;
    if (tidy.size() > 1 && IsStraight(*(tidy.end() - 2), tidy.back(), point, tolerance)) {
      tidy.pop_back();
    }
    tidy.push_back(point);
  }
  if (line.closed && tidy.size() > 3) {
    if ((tidy.back() - tidy.front()).norm() <= tolerance) tidy.pop_back();
    const auto last = tidy.end() - 1;
    if (IsStraight(*(last - 1), *last, tidy.front(), tolerance)) tidy.pop_back();
    if (IsStraight(tidy.back(), tidy.front(), tidy[1], tolerance)) tidy.erase(tidy.begin());
  }
  line.points = std::move(tidy);
  return line;
}

}  // namespace

int Section::NumClosed() const {
  return static_cast<int>(
      std::count_if(lines.begin(), lines.end(), [](const auto& line) { return line.closed; }));
}

Section CutAt(double height, const std::vector<DrawingFace>& faces,
              const std::vector<DrawingLink>& links, double gap) {
  std::vector<SectionLine> of_faces;
  for (const DrawingFace& face : faces) FaceCut(face, height).AppendTo(&of_faces);
  Section section;
  for (SectionLine& line : Chainer(of_faces, gap).Chains()) {
    if (!line.closed && Length(line.points) <= gap) continue;
    section.lines.push_back(Tidied(std::move(line)));
  }
  for (const DrawingLink& link : links) {
    const Polyline3d& points = link.points_in_world;
    for (size_t i = 1; i < points.size(); ++i) {
      if ((points[i - 1].z() >= height) == (points[i].z() >= height)) continue;
      section.points.push_back(CrossingOf(points[i - 1], points[i], height));
    }
  }
  return section;
}

double UsualGap(const std::vector<DrawingLink>& links) {
  std::vector<double> sigmas;
  for (const DrawingLink& link : links) {
    sigmas.insert(sigmas.end(), link.sigma.begin(), link.sigma.end());
  }
  return kGapSigmas * Median(std::move(sigmas));
}

}  // namespace limn
