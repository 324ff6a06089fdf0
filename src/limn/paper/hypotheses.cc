// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/hypotheses.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "limn/geometry/epipolar.h"
#include "limn/geometry/triangulation.h"

namespace limn {
namespace {

// A run of intersections continues over at most this many vertices without one.
constexpr int kMaxVertexGap = 3;
// Vertices of the second fragment that it may advance by per vertex of the primary.
constexpr double kMaxParameterStep = 8;

double CrossNorm(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::abs(a.x() * b.y() - a.y() * b.x());
}

// Geometry of a second view as seen from the primary camera.
class PairGeometry {
 public:
  PairGeometry(const View& primary, const View& second)
      : second_(second),
        relative_(MakeRelativeProjection(primary.camera, primary.cam_from_world, second.camera,
                                         second.cam_from_world)) {
    const Rigid3d primary_from_second = primary.cam_from_world * Inverse(second.cam_from_world);
    rotation_ = primary_from_second.rotation.toRotationMatrix();
    second_center_ = primary_from_second.translation;
    primary_epipole_ = primary.camera.Calibration() * second_center_;
  }

  // Homogeneous projection of the point at `depth`: its last component is the depth in the second
  // view.
  Eigen::Vector3d Project(const Eigen::Vector2d& pixel, double depth) const {
    return depth * (relative_.infinite_homography * pixel.homogeneous()) + relative_.epipole;
  }

  // Cut the depth range to where the point is in front of the second camera.
  std::pair<double, double> DepthsInFront(const Eigen::Vector2d& pixel, double low,
                                          double high) const {
    const double slope = relative_.infinite_homography.row(2).dot(pixel.homogeneous());
    const double offset = relative_.epipole.z();
    const double margin = 1e-3 * (std::abs(slope) * high + std::abs(offset));
    // slope * depth + offset >= margin
    if (slope > 0) low = std::max(low, (margin - offset) / slope);
    if (slope < 0) high = std::min(high, (margin - offset) / slope);
    if (slope == 0 && offset < margin) high = low - 1;
    return {low, high};
  }

  // Depth in the primary camera of the point seen at `pixel` and, on its epipolar line, at `match`.
  double Depth(const Eigen::Vector2d& pixel, const Eigen::Vector2d& match) const {
    const Eigen::Vector3d a = relative_.infinite_homography * pixel.homogeneous();
    const Eigen::Vector2d numerator = relative_.epipole.head<2>() - match * relative_.epipole.z();
    const Eigen::Vector2d denominator = match * a.z() - a.head<2>();
    return numerator.dot(denominator) / denominator.squaredNorm();
  }

  // Sine of the angle between a tangent at a pixel of the primary view and the epipolar line there.
  double PrimaryEpipolarSine(const Eigen::Vector2d& pixel, const Eigen::Vector2d& tangent) const {
    const Eigen::Vector2d line = primary_epipole_.head<2>() - pixel * primary_epipole_.z();
    const double norm = line.norm();
    return norm > 0 ? CrossNorm(line, tangent) / norm : 0;
  }

  Eigen::Vector3d SecondPlaneNormal(const Eigen::Vector2d& match,
                                    const Eigen::Vector2d& tangent) const {
    const Eigen::Vector3d ray = second_.camera.RayFromPixel(match);
    return rotation_ * ray.cross(RayTangent(second_.camera, tangent)).normalized();
  }

  double TriangulationSine(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d other = point - second_center_;
    return point.cross(other).norm() / (point.norm() * other.norm());
  }

 private:
  const View& second_;
  RelativeProjection relative_;
  Eigen::Matrix3d rotation_;
  Eigen::Vector3d second_center_;
  Eigen::Vector3d primary_epipole_;
};

std::optional<HypothesisSample> Triangulate(const FragmentRays& fragment, int vertex,
                                            const LineCrossing& crossing, int second_vertex,
                                            const Eigen::Vector2d& epipolar_direction,
                                            const PairGeometry& pair) {
  HypothesisSample sample;
  sample.vertex = vertex;
  sample.second_parameter = second_vertex + crossing.fraction;
  sample.depth = pair.Depth(fragment.positions_px[vertex], crossing.position_px);
  const auto tangent = TangentFromPlanes(
      fragment.normals[vertex], pair.SecondPlaneNormal(crossing.position_px, crossing.tangent));
  if (!tangent || !(sample.depth > 0)) return std::nullopt;
  const Eigen::Vector3d& ray = fragment.rays[vertex];
  // Image motion of the primary pixel when the point moves along the tangent.
  const Eigen::Vector2d motion = tangent->head<2>() - ray.head<2>() * tangent->z();
  const double sign = motion.dot(fragment.tangents_px[vertex]) < 0 ? -1 : 1;
  sample.tangent_in_cam = sign * *tangent;
  sample.epipolar_sine = std::min(
      pair.PrimaryEpipolarSine(fragment.positions_px[vertex], fragment.tangents_px[vertex]),
      CrossNorm(epipolar_direction, crossing.tangent));
  sample.triangulation_sine = pair.TriangulationSine(sample.depth * ray);
  return sample;
}

// Collects intersections into runs: each continues the run of its fragment that ends nearest to it.
class RunBuilder {
 public:
  // Runs pass the first vertex of the closed ones among these fragments; null: of none.
  explicit RunBuilder(const std::vector<CurveFragment>* fragments) : fragments_(fragments) {}

  void Add(int fragment, const HypothesisSample& sample) {
    std::vector<int>& open = open_[fragment];
    int best = -1;
    double best_step = 0;
    for (const int run : open) {
      const HypothesisSample& last = runs_[run].samples.back();
      const int gap = sample.vertex - last.vertex;
      if (gap < 1 || gap > kMaxVertexGap) continue;
      const double step = ParameterStep(fragment, sample, last);
      if (step > kMaxParameterStep * gap) continue;
      if (best < 0 || step < best_step) {
        best = run;
        best_step = step;
      }
    }
    if (best < 0) {
      best = static_cast<int>(runs_.size());
      runs_.push_back({fragment, {}});
      std::erase_if(open, [&](int run) {
        return sample.vertex - runs_[run].samples.back().vertex > kMaxVertexGap;
      });
      open.push_back(best);
    }
    runs_[best].samples.push_back(sample);
  }

  std::vector<CurveHypothesis> Take() { return std::move(runs_); }

 private:
  double ParameterStep(int fragment, const HypothesisSample& a, const HypothesisSample& b) const {
    const double step = std::abs(a.second_parameter - b.second_parameter);
    if (!fragments_ || !(*fragments_)[fragment].closed) return step;
    return std::min(step, static_cast<double>((*fragments_)[fragment].edgel_ids.size()) - step);
  }

  const std::vector<CurveFragment>* fragments_;
  std::vector<CurveHypothesis> runs_;
  std::map<int, std::vector<int>> open_;  // by second fragment
};

}  // namespace

std::vector<CurveHypothesis> FindHypotheses(const FragmentRays& fragment, const View& primary,
                                            const View& second,
                                            const EpipolarChords& chords_of_second,
                                            double min_depth, double max_depth,
                                            const std::vector<CurveFragment>* seamless) {
  const PairGeometry pair(primary, second);
  RunBuilder runs(seamless);
  std::vector<LineCrossing> crossings;
  for (size_t vertex = 0; vertex < fragment.size(); ++vertex) {
    const Eigen::Vector2d& pixel = fragment.positions_px[vertex];
    const auto [near, far] = pair.DepthsInFront(pixel, min_depth, max_depth);
    if (!(near < far)) continue;
    const Eigen::Vector2d from = pair.Project(pixel, near).hnormalized();
    const Eigen::Vector2d to = pair.Project(pixel, far).hnormalized();
    const double length = (to - from).norm();
    if (!(length > 1e-6)) continue;
    crossings.clear();
    chords_of_second.Find(pixel, &crossings);
    for (const LineCrossing& crossing : crossings) {
      const FragmentPlace place = chords_of_second.chords().PlaceOf(crossing.chord);
      const auto sample = Triangulate(fragment, static_cast<int>(vertex), crossing, place.index,
                                      (to - from) / length, pair);
      const bool in_range = sample && sample->depth >= near && sample->depth <= far;
      if (in_range) runs.Add(place.fragment, *sample);
    }
  }
  std::vector<CurveHypothesis> hypotheses = runs.Take();
  std::erase_if(hypotheses, [&](const CurveHypothesis& hypothesis) {
    return fragment.arc_px[hypothesis.samples.back().vertex] -
               fragment.arc_px[hypothesis.samples.front().vertex] <
           kMinOverlapPx;
  });
  return hypotheses;
}

}  // namespace limn
