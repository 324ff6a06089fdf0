// SPDX-License-Identifier: BSD-3-Clause
#include "bench/measures/render_drawing.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "limn/formats/tracks_writer.h"
#include "limn/geometry/tangent_frame.h"
#include "limn/model/drawing_paths.h"
#include "limn/pictures/canvas.h"
#include "limn/pictures/draw_node.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

// Distance of the camera in radii of the drawing: a focal length of a mild telephoto lens.
constexpr double kDistanceInRadii = 3.5;

double Quantile(std::vector<double> values, double share) {
  const size_t last = values.size() - 1;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::lround(share * last));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::vector<Eigen::Vector3d> AllPoints(const DrawingGraph& graph) {
  std::vector<Eigen::Vector3d> points;
  for (const DrawingLink& link : graph.links) {
    points.insert(points.end(), link.points_in_world.begin(), link.points_in_world.end());
  }
  return points;
}

Eigen::Vector3d RobustCenter(const std::vector<Eigen::Vector3d>& points, double kept_share) {
  Eigen::Vector3d center;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Eigen::Vector3d& point : points) values.push_back(point[axis]);
    const double tail = 0.5 * (1 - kept_share);
    center[axis] = 0.5 * (Quantile(values, tail) + Quantile(values, 1 - tail));
  }
  return center;
}

}  // namespace

void OrbitOptions::Check() const {
  LIMN_CHECK_OPTION(elevation_deg, > -90);
  LIMN_CHECK_OPTION(elevation_deg, < 90);
  LIMN_CHECK_OPTION(width, > 0);
  LIMN_CHECK_OPTION(height, > 0);
  LIMN_CHECK_OPTION(kept_share, > 0);
  LIMN_CHECK_OPTION(kept_share, <= 1);
}

Eigen::Vector3d UpDirection(const std::vector<View>& views) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const View& view : views) {
    sum -= view.cam_from_world.rotation.conjugate() * Eigen::Vector3d::UnitY();
  }
  constexpr double kLeastMean = 1e-3;
  if (!(sum.norm() > kLeastMean * static_cast<double>(views.size()))) {
    return Eigen::Vector3d::UnitZ();
  }
  return sum.normalized();
}

View OrbitView(const DrawingGraph& graph, const Eigen::Vector3d& up, const OrbitOptions& options) {
  options.Check();
  const std::vector<Eigen::Vector3d> points = AllPoints(graph);
  if (points.empty()) throw InputError("the drawing has no links");
  const Eigen::Vector3d center = RobustCenter(points, options.kept_share);
  std::vector<double> distances;
  for (const Eigen::Vector3d& point : points) distances.push_back((point - center).norm());
  const double radius = Quantile(distances, options.kept_share);

  const double azimuth = options.azimuth_deg * kDeg;
  const double elevation = options.elevation_deg * kDeg;
  const Eigen::Vector3d level =
      TangentFrame(up) * Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth));
  const Eigen::Vector3d outward = std::cos(elevation) * level + std::sin(elevation) * up;

  Eigen::Matrix3d rotation;  // rows: right, down, forward
  rotation.row(2) = -outward;
  rotation.row(0) = rotation.row(2).cross(up).normalized();
  rotation.row(1) = rotation.row(2).cross(rotation.row(0));
  View view;
  view.name = "orbit";
  const double focal = 0.48 * kDistanceInRadii * std::min(options.width, options.height);
  view.camera = {
      focal,         focal,         0.5 * (options.width - 1), 0.5 * (options.height - 1),
      options.width, options.height};
  view.cam_from_world.rotation = rotation;
  const Eigen::Vector3d eye = center + kDistanceInRadii * radius * outward;
  view.cam_from_world.translation = -(rotation * eye);
  view.region = MakeImageRegion(view.camera, nullptr, {}, 0);
  return view;
}

Picture RenderDrawing(const DrawingGraph& graph, const View& view, const PictureOptions& options) {
  options.Check();
  Canvas canvas(view.camera.width, view.camera.height, std::max(options.scale, 1));
  const std::vector<LinkId> curves = CurvesOf(graph);
  for (size_t id = 0; id < graph.links.size(); ++id) {
    for (const auto& run : ProjectPolyline(view, graph.links[id].points_in_world)) {
      canvas.DrawLine(run, ColorOfCurve(curves[id]), options.line_width_px);
    }
  }
  for (const DrawingNode& node : graph.nodes) {
    DrawNode(view, node, options.node_radius_px, &canvas);
  }
  return canvas.picture();
}

}  // namespace limn
