// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cameras/camera_landmarks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "limn/model/footprint.h"
#include "limn/model/lens_jacobian.h"
#include "limn/model/shrunk.h"
#include "limn/util/angles.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// Edgels of a curve err together: so many of them, one next to the other, count as one.
constexpr double kEdgelsPerPoint = 10;
// Points are as exact as the photographs: pixels of these.
constexpr double kPointSigmaPx = 0.5;
constexpr double kPointRobustPx = 1;
// Some ray to a point must differ from the mean ray by this angle.
constexpr double kMinHalfParallaxDeg = 0.5;

// The row of the derivatives of a stored pixel that is across a line, given by its stored normal.
ParameterRow ByParameters(const LandmarkInput& input, const View& view,
                          const Eigen::Vector2d& virtual_px, const Eigen::RowVector2d& normal) {
  const auto per_px = input.parameters_per_px.find(view.camera_index);
  if (per_px == input.parameters_per_px.end()) return {};
  const auto columns = view.calibration->StoredByParameters(virtual_px);
  if (!columns) return ParameterRow::Zero(per_px->second.size());
  return (normal * *columns).cwiseProduct(per_px->second.transpose());
}

size_t CountPulls(const ControlGraph& control) {
  size_t count = 0;
  for (const ControlLink& link : control.links) {
    if (link.frozen) continue;
    for (const FitSample& sample : link.samples) count += sample.pulls.size();
  }
  return count;
}

Landmark LandmarkOf(const LandmarkInput& input, const ControlGraph& control,
                    const ControlLink& link, const FitSample& sample, double weight) {
  const int from = link.points[sample.segment];
  const int to = link.points[sample.segment + 1];
  Landmark landmark;
  landmark.position = (1 - sample.t) * control.position[from] + sample.t * control.position[to];
  landmark.robust_px = input.robust_px;
  const Eigen::Vector3d tangent = sample.tangent.normalized();
  const Eigen::Vector3d across = tangent.unitOrthogonal();
  landmark.ways.resize(3, 2);
  landmark.ways << across, tangent.cross(across);
  landmark.ways *= std::max(control.footprint[from], control.footprint[to]);
  for (const EdgelPull& pull : sample.pulls) {
    const double factor = ViewPxPerPicturePx(input.views[pull.ref.view], input.factor);
    const EdgelLine line = {GrownPx(pull.line.position_px, factor), pull.line.across / factor};
    landmark.lines.push_back(
        {pull.ref.view, line, weight * pull.weight, EdgelByParameters(input, pull)});
  }
  return landmark;
}

// A pixel as two lines; nothing where the lens cannot map.
void AddPixel(const LandmarkInput& input, const SeenPoint::Sight& sight,
              std::vector<LandmarkLine>* lines) {
  const View& view = input.views[sight.view];
  const auto pixel = ThroughLens(view.lens.get(), sight.stored_px);
  if (!pixel) return;
  for (const int axis : {0, 1}) {
    const Eigen::RowVector2d across = Eigen::RowVector2d::Unit(axis) / view.scale;
    const Eigen::Vector2d of_virtual = (across * pixel->stored_from_virtual).transpose();
    lines->push_back({sight.view, EdgelLine(pixel->virtual_px, of_virtual),
                      1 / (kPointSigmaPx * kPointSigmaPx),
                      ByParameters(input, view, pixel->virtual_px, across)});
  }
}

bool HasParallax(const std::vector<View>& views, const Landmark& landmark) {
  Eigen::Matrix3Xd rays(3, landmark.lines.size());
  for (size_t i = 0; i < landmark.lines.size(); ++i) {
    const View& view = views[landmark.lines[i].view];
    rays.col(i) = (landmark.position - view.CenterInWorld()).normalized();
  }
  const Eigen::Vector3d mean = rays.rowwise().sum().normalized();
  return (mean.transpose() * rays).minCoeff() < std::cos(kMinHalfParallaxDeg * kDeg);
}

}  // namespace

ParameterRow EdgelByParameters(const LandmarkInput& input, const EdgelPull& pull) {
  const View& view = input.views[pull.ref.view];
  if (!input.parameters_per_px.contains(view.camera_index)) return {};
  const Edgel& edgel = input.curves[pull.ref.view].edge_map.edgels[pull.ref.edgel];
  const Eigen::Vector2d along =
      (edgel.stored_from_virtual.cast<double>() * edgel.Tangent()).normalized();
  const double factor = ViewPxPerPicturePx(view, input.factor);
  return ByParameters(input, view, GrownPx(edgel.position_px, factor),
                      Eigen::RowVector2d(along.y(), -along.x()) / factor);
}

std::vector<Landmark> CurveLandmarks(const LandmarkInput& input, const ControlGraph& control,
                                     size_t max_lines) {
  const size_t stride = CountPulls(control) / max_lines + 1;
  std::vector<Landmark> landmarks;
  size_t count = 0;
  for (size_t l = 0; l < control.links.size(); ++l) {
    const ControlLink& link = control.links[l];
    if (link.frozen) continue;
    for (const FitSample& sample : link.samples) {
      if (sample.pulls.empty() || count++ % stride > 0) continue;
      landmarks.push_back(
          LandmarkOf(input, control, link, sample, static_cast<double>(stride) / kEdgelsPerPoint));
      landmarks.back().curve = static_cast<int>(l);
    }
  }
  return landmarks;
}

PointLandmarks LandmarksOfPoints(const LandmarkInput& input, const std::vector<SeenPoint>& points) {
  PointLandmarks result;
  for (size_t p = 0; p < points.size(); ++p) {
    Landmark landmark;
    landmark.position = points[p].position;
    landmark.robust_px = kPointRobustPx;
    std::vector<double> footprints;
    for (const SeenPoint::Sight& sight : points[p].sights) {
      const auto footprint = FootprintIn(input.views[sight.view], landmark.position);
      if (!footprint) continue;
      footprints.push_back(*footprint);
      AddPixel(input, sight, &landmark.lines);
    }
    if (landmark.lines.size() < 4 || !HasParallax(input.views, landmark)) continue;
    landmark.ways = Eigen::Matrix3d::Identity() * Median(std::move(footprints));
    result.landmarks.push_back(std::move(landmark));
    result.points.push_back(p);
  }
  return result;
}

}  // namespace limn
