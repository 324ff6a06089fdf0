// SPDX-License-Identifier: BSD-3-Clause
#include "limn/regularity/common_planes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "limn/util/angles.h"

namespace limn {
namespace {

constexpr int kParallelNeighbors = 5;
constexpr int kPlaneRefinements = 3;
// Two lines at a smaller angle tell no plane.
constexpr double kMinAngleRad = 10 * kDeg;
// A plane is the same as another if this share of what it holds is in that one, too, and their
// normals are this near.
constexpr double kSameShare = 0.6;
constexpr double kSameAngleRad = 5 * kDeg;
// The normal is a direction of a class if it is this near; the fit shows whether it can be.
constexpr double kNormalAngleRad = 0.5 * kDeg;

struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0;
};

struct Support {
  double gain = 0;  // nats, without what the plane itself takes
  std::vector<int> lines, arcs;
  bool Spans() const { return lines.size() + arcs.size() >= 3; }
};

// Deviations from a plane in two numbers: of both ends of a line; of center and tilt of an arc.
struct Deviation {
  Eigen::Vector2d value;
  Eigen::Matrix2d covariance;
  double shift_px = 0;
};

Deviation DeviationOf(const LineEvidence& line, const Plane& plane) {
  const Eigen::Vector3d& n = plane.normal;
  Eigen::Matrix<double, 2, 6> across = Eigen::Matrix<double, 2, 6>::Zero();
  across.block<1, 3>(0, 0) = n.transpose();
  across.block<1, 3>(1, 3) = n.transpose();
  Deviation deviation;
  deviation.value = {n.dot(line.start) - plane.offset, n.dot(line.end) - plane.offset};
  deviation.covariance = across * line.covariance * across.transpose();
  // The least move into the plane, as the images see it.
  const Vector6d move =
      line.covariance * across.transpose() * deviation.covariance.ldlt().solve(deviation.value);
  deviation.shift_px = std::sqrt(std::max(move.head<3>().dot(line.metric * move.head<3>()),
                                          move.tail<3>().dot(line.metric * move.tail<3>())));
  return deviation;
}

Deviation DeviationOf(const ArcEvidence& arc, const Plane& plane) {
  Eigen::Vector3d n = plane.normal;
  Deviation deviation;
  deviation.value.setConstant(1e9);
  deviation.covariance.setIdentity();
  deviation.shift_px = 1e9;
  if (n.dot(arc.arc.Normal()) < 0) n = -n;
  if (n.dot(arc.arc.Normal()) < std::cos(kMinAngleRad)) return deviation;
  // Where center and normal are off: along the normal, and the tilt times the radius.
  const double offset = n.dot(plane.normal) * plane.offset;
  const Eigen::Vector2d tilt(n.dot(arc.arc.x_axis), n.dot(arc.arc.y_axis));
  const double slope = arc.arc.radius * tilt.norm();
  const Eigen::Vector2d towards = slope > 0 ? tilt.normalized() : Eigen::Vector2d(1, 0);
  Eigen::Matrix<double, 2, 6> across = Eigen::Matrix<double, 2, 6>::Zero();
  across.block<1, 3>(0, 0) = n.transpose();
  across.block<1, 2>(1, 3) = towards.transpose();
  deviation.value = {n.dot(arc.arc.center) - offset, -slope};
  deviation.covariance = across * arc.covariance * across.transpose();
  const double px = std::sqrt(n.dot(arc.metric * n));
  deviation.shift_px = px * (std::abs(deviation.value[0]) + slope);
  return deviation;
}

class CommonPlaneFinder {
 public:
  CommonPlaneFinder(const DrawingGraph& graph, const DrawingEvidence& evidence,
                    const std::vector<DirectionClass>& directions, const RegularityOptions& options)
      : graph_(graph),
        evidence_(evidence),
        directions_(directions),
        options_(options),
        class_of_(evidence.lines.size(), -1) {
    for (size_t c = 0; c < directions.size(); ++c) {
      for (const int line : directions[c].lines) class_of_[line] = static_cast<int>(c);
    }
    std::vector<double> distances;
    for (const LineEvidence& line : evidence.lines) distances.push_back(line.start.norm());
    for (const ArcEvidence& arc : evidence.arcs) distances.push_back(arc.arc.center.norm());
    std::sort(distances.begin(), distances.end());
    if (!distances.empty()) reach_ = 2 * distances[distances.size() * 9 / 10] + 1;
    count_ = std::max<double>(2, static_cast<double>(distances.size()));
  }

  std::vector<Plane> Hypotheses() const {
    std::vector<Plane> planes;
    for (const ArcEvidence& arc : evidence_.arcs) {
      planes.push_back({arc.arc.Normal(), arc.arc.Normal().dot(arc.arc.center)});
    }
    for (const auto& [a, b] : Pairs()) {
      if (const auto plane = PlaneOf(evidence_.lines[a], evidence_.lines[b])) {
        planes.push_back(*plane);
      }
    }
    return planes;
  }

  Support SupportOf(const Plane& plane, size_t count) const {
    Support support;
    for (size_t i = 0; i < evidence_.lines.size(); ++i) {
      const LineEvidence& line = evidence_.lines[i];
      if (line.length_px < kMinRegularLengthPx) continue;
      // Most lines are far from it.
      if (std::abs(plane.normal.dot(line.start) - plane.offset) > kFar) continue;
      const Deviation deviation = DeviationOf(line, plane);
      const double gain = GainOfLine(static_cast<int>(i), deviation, plane) - NameCost(count);
      if (!(gain > 0) || deviation.shift_px > options_.max_shift_px) continue;
      support.gain += gain;
      support.lines.push_back(static_cast<int>(i));
    }
    for (size_t i = 0; i < evidence_.arcs.size(); ++i) {
      const ArcEvidence& arc = evidence_.arcs[i];
      if (arc.length_px < kMinRegularLengthPx) continue;
      const Deviation deviation = DeviationOf(arc, plane);
      const double gain = GainOfBoth(deviation, 2 * arc.arc.radius) - NameCost(count);
      if (!(gain > 0) || deviation.shift_px > options_.max_shift_px) continue;
      support.gain += gain;
      support.arcs.push_back(static_cast<int>(i));
    }
    return support;
  }

  // By the lines and arcs that are in the plane; those that are so against their evidence count
  // nothing.
  Support SupportBy(const PlaneClass& members) const {
    const Plane plane = {members.normal, members.offset};
    const double name_cost = NameCost(std::max<size_t>(1, members.Size()));
    Support support = {0, members.lines, members.arcs};
    for (const int i : members.lines) {
      const double gain = GainOfLine(i, DeviationOf(evidence_.lines[i], plane), plane);
      support.gain += std::max(0.0, gain - name_cost);
    }
    for (const int i : members.arcs) {
      const ArcEvidence& arc = evidence_.arcs[i];
      const double gain = GainOfBoth(DeviationOf(arc, plane), 2 * arc.arc.radius);
      support.gain += std::max(0.0, gain - name_cost);
    }
    return support;
  }

  // What a plane takes to tell, in nats: its offset, and its normal, which is that of a direction
  // of the drawing or its own, to an accuracy of a tenth of a pixel.
  double OwnCost(const Plane& plane, const Support& support) const {
    constexpr double kAccuracy = 0.1;
    const double of_offset = std::log(reach_ / kAccuracy);
    if (NormalClass(plane) >= 0) {
      return of_offset + std::log(static_cast<double>(directions_.size() + 1));
    }
    double longest = 1;
    for (const int line : support.lines) {
      longest = std::max(longest, evidence_.lines[line].Chord().norm());
    }
    for (const int arc : support.arcs) {
      longest = std::max(longest, evidence_.arcs[arc].arc.radius);
    }
    return of_offset + 2 * std::log(longest / kAccuracy);
  }

  // Least squares of the places of its lines and arcs, weighted by their information across it.
  Plane Refined(const Plane& plane, const Support& support) const {
    std::vector<std::pair<Eigen::Vector3d, double>> points;
    for (const int i : support.lines) {
      const LineEvidence& line = evidence_.lines[i];
      const Deviation deviation = DeviationOf(line, plane);
      points.push_back({line.start, 1 / deviation.covariance(0, 0)});
      points.push_back({line.end, 1 / deviation.covariance(1, 1)});
    }
    for (const int i : support.arcs) {
      const ArcEvidence& arc = evidence_.arcs[i];
      const double weight = 1 / DeviationOf(arc, plane).covariance(0, 0);
      for (const double t : {0.0, 1.0 / 3, 2.0 / 3}) {
        points.push_back({PointAt(arc.arc, t), weight / 3});
      }
    }
    double sum = 0;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto& [point, weight] : points) {
      sum += weight;
      mean += weight * point;
    }
    mean /= sum;
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const auto& [point, weight] : points) {
      scatter += weight * (point - mean) * (point - mean).transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(scatter);
    Eigen::Vector3d normal = eigen.eigenvectors().col(0);
    if (normal.dot(plane.normal) < 0) normal = -normal;
    return {normal, normal.dot(mean)};
  }

  // Whether lines of two directions, or an arc, hold its tilt.
  bool IsHeld(const Support& support) const {
    if (!support.Spans()) return false;
    if (!support.arcs.empty()) return true;
    const Eigen::Vector3d first = evidence_.lines[support.lines.front()].Chord().normalized();
    return std::any_of(support.lines.begin(), support.lines.end(), [&](int i) {
      const Eigen::Vector3d other = evidence_.lines[i].Chord().normalized();
      return first.cross(other).norm() > std::sin(kMinAngleRad);
    });
  }

  int NormalClass(const Plane& plane) const {
    for (size_t c = 0; c < directions_.size(); ++c) {
      if (plane.normal.cross(directions_[c].direction).norm() < std::sin(kNormalAngleRad)) {
        return static_cast<int>(c);
      }
    }
    return -1;
  }

 private:
  static constexpr double kFar = 50;              // local units, about px
  static constexpr double kParallelSine = 0.005;  // to the plane

  // To name a plane that `count` lines and arcs are in takes the less, the more there are.
  double NameCost(size_t count) const { return std::log(count_ / static_cast<double>(count)); }

  double GainOfLine(int i, const Deviation& deviation, const Plane& plane) const {
    const bool is_parallel =
        class_of_[i] >= 0 &&
        std::abs(plane.normal.dot(directions_[class_of_[i]].direction)) < kParallelSine;
    return is_parallel ? GainOfOffset(deviation)
                       : GainOfBoth(deviation, evidence_.lines[i].Chord().norm());
  }

  // Nats saved by being in the plane: an offset within the scene and a tilt over the extent of the
  // line or arc, each to its accuracy.
  double GainOfBoth(const Deviation& deviation, double extent) const {
    const double determinant = std::max(deviation.covariance.determinant(), 1e-12);
    return std::log(reach_ * extent / (2 * M_PI)) - 0.5 * std::log(determinant) -
           0.5 * deviation.value.dot(deviation.covariance.ldlt().solve(deviation.value));
  }

  // The same where the direction of the line is in the plane anyway.
  double GainOfOffset(const Deviation& deviation) const {
    const double sigma = std::sqrt(deviation.covariance.mean());
    const double offset = deviation.value.mean();
    return std::log(reach_ / sigma) - 0.5 * std::log(2 * M_PI) -
           0.5 * offset * offset / (sigma * sigma);
  }

  std::optional<Plane> PlaneOf(const LineEvidence& a, const LineEvidence& b) const {
    const Eigen::Vector3d u = a.Chord().normalized();
    const Eigen::Vector3d v = b.Chord().normalized();
    Eigen::Vector3d normal = u.cross(v);
    if (normal.norm() < std::sin(kMinAngleRad)) {
      const Eigen::Vector3d between = (b.start + b.end - a.start - a.end) / 2;
      const Eigen::Vector3d along = (u + (u.dot(v) < 0 ? -1 : 1) * v).normalized();
      normal = along.cross(between);
      if (!(normal.norm() > 1)) return std::nullopt;  // one line
    }
    normal.normalize();
    return Plane{normal, normal.dot(a.start + a.end + b.start + b.end) / 4};
  }

  // Of lines that meet, and of parallel neighbors.
  std::set<std::pair<int, int>> Pairs() const {
    std::set<std::pair<int, int>> pairs;
    std::map<NodeId, std::vector<int>> at_node;
    for (size_t i = 0; i < evidence_.lines.size(); ++i) {
      const DrawingLink& link = graph_.links[evidence_.lines[i].link];
      for (const NodeId node : {link.node0, link.node1}) {
        for (const int other : at_node[node]) pairs.insert({other, static_cast<int>(i)});
        at_node[node].push_back(static_cast<int>(i));
      }
    }
    for (const DirectionClass& parallel : directions_) {
      for (const int a : parallel.lines) {
        const LineEvidence& line = evidence_.lines[a];
        std::vector<std::pair<double, int>> near;
        for (const int b : parallel.lines) {
          if (a == b) continue;
          const LineEvidence& other = evidence_.lines[b];
          near.push_back({(line.start + line.end - other.start - other.end).norm(), b});
        }
        const size_t count = std::min<size_t>(kParallelNeighbors, near.size());
        std::partial_sort(near.begin(), near.begin() + count, near.end());
        for (size_t k = 0; k < count; ++k) pairs.insert(std::minmax(a, near[k].second));
      }
    }
    return pairs;
  }

  const DrawingGraph& graph_;
  const DrawingEvidence& evidence_;
  const std::vector<DirectionClass>& directions_;
  const RegularityOptions& options_;
  std::vector<int> class_of_;
  double reach_ = 1;
  double count_ = 2;  // of lines and arcs
};

// Share of the lines and arcs of one that the other has, too.
double SharedShare(const Support& of, const PlaneClass& with) {
  std::vector<int> shared;
  std::set_intersection(of.lines.begin(), of.lines.end(), with.lines.begin(), with.lines.end(),
                        std::back_inserter(shared));
  std::set_intersection(of.arcs.begin(), of.arcs.end(), with.arcs.begin(), with.arcs.end(),
                        std::back_inserter(shared));
  return static_cast<double>(shared.size()) / static_cast<double>(of.lines.size() + of.arcs.size());
}

}  // namespace

std::vector<PlaneClass> FindCommonPlanes(const DrawingGraph& graph, const DrawingEvidence& evidence,
                                         const std::vector<DirectionClass>& directions,
                                         const RegularityOptions& options,
                                         const RunContext& context) {
  const CommonPlaneFinder finder(graph, evidence, directions, options);
  std::vector<Plane> planes = finder.Hypotheses();
  std::vector<Support> supports(planes.size());
  ParallelFor(context, "finding planes", planes.size(), [&](size_t p) {
    supports[p] = finder.SupportOf(planes[p], 1);
    for (int k = 0; k < kPlaneRefinements && supports[p].Spans(); ++k) {
      const Plane refined = finder.Refined(planes[p], supports[p]);
      Support more = finder.SupportOf(refined, supports[p].lines.size() + supports[p].arcs.size());
      if (more.gain <= supports[p].gain) break;
      planes[p] = refined;
      supports[p] = std::move(more);
    }
    supports[p].gain -= finder.OwnCost(planes[p], supports[p]);
  });
  std::vector<size_t> order;
  for (size_t p = 0; p < planes.size(); ++p) {
    if (supports[p].gain > 0 && finder.IsHeld(supports[p])) order.push_back(p);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return supports[a].gain > supports[b].gain; });
  std::vector<PlaneClass> classes;
  for (const size_t p : order) {
    const bool is_known = std::any_of(classes.begin(), classes.end(), [&](const PlaneClass& known) {
      return known.normal.cross(planes[p].normal).norm() < std::sin(kSameAngleRad) &&
             SharedShare(supports[p], known) >= kSameShare;
    });
    if (is_known) continue;
    classes.push_back({planes[p].normal, planes[p].offset, supports[p].lines, supports[p].arcs,
                       finder.NormalClass(planes[p])});
  }
  return classes;
}

bool SavesItsNormal(const PlaneClass& plane, const DrawingGraph& graph,
                    const DrawingEvidence& evidence, const std::vector<DirectionClass>& directions,
                    const RegularityOptions& options) {
  const CommonPlaneFinder finder(graph, evidence, directions, options);
  const Support support = finder.SupportBy(plane);
  return finder.IsHeld(support) &&
         support.gain > finder.OwnCost({plane.normal, plane.offset}, support);
}

}  // namespace limn
