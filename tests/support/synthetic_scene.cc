// SPDX-License-Identifier: BSD-3-Clause
#include "support/synthetic_scene.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <tuple>

#include "limn/util/angles.h"
#include "support/random_numbers.h"

namespace limn::testing {
namespace {

constexpr int kCircleVertices = 2880;
// Chords that a 3D segment is cut into before it is projected.
constexpr int kChordsPerSegment = 50;

std::vector<Eigen::Vector2d> ProjectDensely(const View& view, const SceneCurve& curve) {
  std::vector<Eigen::Vector2d> pixels;
  const size_t count = curve.points.size();
  const size_t segments = curve.closed ? count : count - 1;
  const int chords = count > 100 ? 1 : kChordsPerSegment;
  for (size_t i = 0; i <= segments; ++i) {
    const Eigen::Vector3d& from = curve.points[i % count];
    const Eigen::Vector3d& to = curve.points[(i + 1) % count];
    for (int k = 0; k < (i < segments ? chords : 1); ++k) {
      const auto pixel = view.Project(from + (to - from) * (static_cast<double>(k) / chords));
      if (!pixel) throw std::invalid_argument("curve outside of view " + view.name);
      pixels.push_back(*pixel);
    }
  }
  return pixels;
}

// Edgels at equal steps of about 1 px along a polyline, both ends included.
std::vector<Edgel> SampleEdgels(const std::vector<Eigen::Vector2d>& pixels, bool closed) {
  std::vector<double> arc = {0};
  for (size_t i = 1; i < pixels.size(); ++i) {
    arc.push_back(arc.back() + (pixels[i] - pixels[i - 1]).norm());
  }
  const int steps = std::max(1, static_cast<int>(std::lround(arc.back())));
  std::vector<Edgel> edgels;
  size_t segment = 0;
  for (int k = 0; k < steps + (closed ? 0 : 1); ++k) {
    const double at = arc.back() * k / steps;
    while (segment + 2 < arc.size() && arc[segment + 1] < at) ++segment;
    const Eigen::Vector2d chord = pixels[segment + 1] - pixels[segment];
    const double t = (at - arc[segment]) / (arc[segment + 1] - arc[segment]);
    edgels.push_back(MakeEdgel(pixels[segment] + t * chord, std::atan2(chord.y(), chord.x())));
  }
  return edgels;
}

std::tuple<long, long> PixelKey(const Edgel& edgel) {
  return {std::lround(edgel.stored_px.y()), std::lround(edgel.stored_px.x())};
}

// A projected curve.
struct PixelCurve {
  std::vector<Eigen::Vector2d> pixels;
  bool closed = false;
};

double Length(const std::vector<Eigen::Vector2d>& pixels) {
  double length = 0;
  for (size_t i = 1; i < pixels.size(); ++i) length += (pixels[i] - pixels[i - 1]).norm();
  return length;
}

void AddVisibleParts(const View& view, const SceneCurve& curve, std::vector<PixelCurve>* parts) {
  constexpr double kShortestPx = 2;
  PixelCurve part;
  const auto finish = [&] {
    if (Length(part.pixels) >= kShortestPx) parts->push_back(part);
    part.pixels.clear();
  };
  for (const Eigen::Vector3d& point : curve.points) {
    const auto pixel = view.Project(point);
    if (pixel) {
      part.pixels.push_back(*pixel);
    } else {
      finish();
    }
  }
  const auto first = view.Project(curve.points.front());
  if (curve.closed && first && !part.pixels.empty()) part.pixels.push_back(*first);
  finish();
}

ImageCurves MakeImageCurves(const View& view, const std::vector<PixelCurve>& curves,
                            double noise_px, unsigned seed) {
  std::mt19937 random(seed);
  testing::NormalDistribution<double> gauss(0, 1);
  std::vector<Edgel> edgels;
  std::vector<size_t> begins = {0};
  for (const PixelCurve& curve : curves) {
    for (Edgel edgel : SampleEdgels(curve.pixels, curve.closed)) {
      edgel.position_px += noise_px * gauss(random) * edgel.Normal();
      edgel.stored_px = edgel.position_px.cast<float>();
      if (noise_px > 0) edgel.position_sigma_px = static_cast<float>(noise_px);
      edgels.push_back(edgel);
    }
    begins.push_back(edgels.size());
  }
  std::vector<size_t> order(edgels.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return PixelKey(edgels[a]) < PixelKey(edgels[b]); });
  std::vector<Edgel> sorted;
  std::vector<EdgelId> id_of(edgels.size());
  for (const size_t from : order) {
    id_of[from] = static_cast<EdgelId>(sorted.size());
    sorted.push_back(edgels[from]);
  }
  ImageCurves result;
  result.edge_map = MakeEdgeMap(view, std::move(sorted));
  for (size_t c = 0; c < curves.size(); ++c) {
    result.fragments.push_back(
        {{id_of.begin() + begins[c], id_of.begin() + begins[c + 1]}, curves[c].closed});
  }
  return result;
}

}  // namespace

SceneCurve Segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return {{from, to}, false};
}

SceneCurve Circle(const Eigen::Vector3d& center, double radius) {
  SceneCurve circle;
  circle.closed = true;
  for (int i = 0; i < kCircleVertices; ++i) {
    const double angle = 2 * M_PI * i / kCircleVertices;
    circle.points.push_back(center + radius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0));
  }
  return circle;
}

std::vector<Eigen::Vector3d> CubeCorners(double half_side) {
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back(i & 1 ? half_side : -half_side, i & 2 ? half_side : -half_side,
                         i & 4 ? half_side : -half_side);
  }
  return corners;
}

std::vector<SceneCurve> CubeEdges(double half_side) {
  const std::vector<Eigen::Vector3d> corners = CubeCorners(half_side);
  std::vector<SceneCurve> edges;
  for (int i = 0; i < 8; ++i) {
    for (const int bit : {1, 2, 4}) {
      if (!(i & bit)) edges.push_back(Segment(corners[i], corners[i | bit]));
    }
  }
  return edges;
}

std::vector<Polyline3d> Polylines(const std::vector<SceneCurve>& curves) {
  std::vector<Polyline3d> polylines;
  for (const SceneCurve& curve : curves) {
    polylines.push_back(curve.points);
    if (curve.closed) polylines.back().push_back(curve.points.front());
  }
  return polylines;
}

View LookAt(const Eigen::Vector3d& center, const Eigen::Vector3d& target) {
  const Eigen::Vector3d forward = (target - center).normalized();
  const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  Eigen::Matrix3d rotation;
  rotation << right.transpose(), forward.cross(right).transpose(), forward.transpose();
  View view;
  view.camera = {600, 600, 319.5, 239.5, 640, 480};
  view.cam_from_world.rotation = Eigen::Quaterniond(rotation).normalized();
  view.cam_from_world.translation = -(view.cam_from_world.rotation * center);
  view.region = MakeImageRegion(view.camera, nullptr, {}, 2);
  return view;
}

View RingView(double azimuth_deg, double radius, double height) {
  const double azimuth = azimuth_deg * kDeg;
  return LookAt({radius * std::cos(azimuth), radius * std::sin(azimuth), height},
                Eigen::Vector3d::Zero());
}

View ForwardView(int width, int height, double focal) {
  View view;
  view.camera = {focal, focal, 0.5 * (width - 1), 0.5 * (height - 1), width, height};
  view.region = MakeImageRegion(view.camera, nullptr, {}, 0);
  return view;
}

std::vector<View> DomeViews(int count, double radius) {
  const double golden_angle = M_PI * (3 - std::sqrt(5.0));
  std::vector<View> views;
  for (int i = 0; i < count; ++i) {
    const double elevation = (20 + 45 * (i + 0.5) / count) * kDeg;
    const double azimuth = i * golden_angle;
    views.push_back(LookAt(
        radius * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                 std::cos(elevation) * std::sin(azimuth), std::sin(elevation)),
        Eigen::Vector3d::Zero()));
    views.back().model_index = i;
    views.back().name = "view" + std::to_string(100 + i);
  }
  return views;
}

std::vector<View> FrontalViews(int cols, int rows, double spacing) {
  constexpr double kHeight = 5;
  constexpr double kFocal = kHeight / kFrontalPx;
  std::vector<View> views;
  for (int i = 0; i < cols * rows; ++i) {
    const Eigen::Vector3d center(spacing * (i % cols - 0.5 * (cols - 1)),
                                 spacing * (i / cols - 0.5 * (rows - 1)), kHeight);
    View view;
    view.camera = {kFocal, kFocal, 319.5, 239.5, 640, 480};
    view.cam_from_world.rotation = Eigen::Quaterniond(0, 1, 0, 0);
    view.cam_from_world.translation = -(view.cam_from_world.rotation * center);
    view.region = MakeImageRegion(view.camera, nullptr, {}, 2);
    view.model_index = i;
    view.name = "frontal" + std::to_string(100 + i);
    views.push_back(view);
  }
  return views;
}

std::vector<View> Scaled(const std::vector<View>& views, double factor) {
  std::vector<View> scaled = views;
  for (View& view : scaled) view.cam_from_world.translation *= factor;
  return scaled;
}

Edgel MakeEdgel(const Eigen::Vector2d& position_px, double tangent_rad) {
  Edgel edgel;
  edgel.position_px = position_px;
  edgel.tangent_rad = tangent_rad;
  edgel.strength = 20;
  edgel.position_sigma_px = 0.1f;
  edgel.stored_px = position_px.cast<float>();
  return edgel;
}

EdgeMap MakeEdgeMap(const View& view, std::vector<Edgel> edgels) {
  EdgeMap edge_map;
  edge_map.width = view.camera.width;
  edge_map.height = view.camera.height;
  edge_map.edgels = std::move(edgels);
  edge_map.gradient_noise = 1;
  return edge_map;
}

ImageCurves ProjectCurves(const View& view, const std::vector<SceneCurve>& curves, double noise_px,
                          unsigned seed) {
  std::vector<PixelCurve> projected;
  for (const SceneCurve& curve : curves) {
    projected.push_back({ProjectDensely(view, curve), curve.closed});
  }
  return MakeImageCurves(view, projected, noise_px, seed);
}

ImageCurves ProjectVisibleParts(const View& view, const std::vector<SceneCurve>& curves,
                                double noise_px, unsigned seed) {
  std::vector<PixelCurve> projected;
  for (const SceneCurve& curve : curves) AddVisibleParts(view, curve, &projected);
  return MakeImageCurves(view, projected, noise_px, seed);
}

std::vector<ImageCurves> ProjectCurves(const std::vector<View>& views,
                                       const std::vector<SceneCurve>& curves, double noise_px) {
  std::vector<ImageCurves> result;
  for (size_t v = 0; v < views.size(); ++v) {
    result.push_back(ProjectCurves(views[v], curves, noise_px, static_cast<unsigned>(1000 + v)));
  }
  return result;
}

}  // namespace limn::testing
