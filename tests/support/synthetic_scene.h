// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/geometry/polyline.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/view.h"

namespace limn::testing {

// A curve of a scene of bare wires: every view sees all of it.
struct SceneCurve {
  // Vertices close enough together to stand for the curve; a closed one does not repeat the first.
  Polyline3d points;
  bool closed = false;
};

SceneCurve Segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to);
// Parallel to the xy plane.
SceneCurve Circle(const Eigen::Vector3d& center, double radius);
// The 8 corners and 12 edges of the axis-parallel cube around the origin.
std::vector<Eigen::Vector3d> CubeCorners(double half_side);
std::vector<SceneCurve> CubeEdges(double half_side);

// The curves as evaluation wants them: a closed curve returns to its first point.
std::vector<Polyline3d> Polylines(const std::vector<SceneCurve>& curves);

// A camera of 640 x 480 px and 600 px focal length at `center`, looking at `target`, z up.
View LookAt(const Eigen::Vector3d& center, const Eigen::Vector3d& target);
// The same at this azimuth on a circle around the z axis, looking at the origin.
View RingView(double azimuth_deg, double radius, double height = 0);
// Looks along z from the origin; no border is left out.
View ForwardView(int width = 101, int height = 101, double focal = 100);
// Views of the origin from a dome of this radius, elevations 20 to 65 degrees, evenly spread.
std::vector<View> DomeViews(int count, double radius);
// Views side by side, straight down on the plane z = 0 from a height of 5: `cols` x `rows` of them,
// `spacing` apart, with the origin below their middle. On that plane a pixel of every view is
// kFrontalPx large.
std::vector<View> FrontalViews(int cols, int rows, double spacing);
constexpr double kFrontalPx = 1.0 / 128;
// A place on that plane, px from the origin.
inline Eigen::Vector3d FrontalPoint(double x_px, double y_px) {
  return {x_px * kFrontalPx, y_px * kFrontalPx, 0};
}
// The same cameras in a world `factor` times as large.
std::vector<View> Scaled(const std::vector<View>& views, double factor);

// The projections of the curves: one fragment per curve in the same order, edgels about 1 px apart,
// exact except for Gaussian noise of this standard deviation (px) across the edge. Throws
// std::invalid_argument if a curve is not wholly inside the view's region.
ImageCurves ProjectCurves(const View& view, const std::vector<SceneCurve>& curves,
                          double noise_px = 0, unsigned seed = 1);
// The same of what the view contains: a curve gives a fragment per stretch of its vertices inside,
// so vertices must be near together in the image. Stretches of less than 2 px are left out.
ImageCurves ProjectVisibleParts(const View& view, const std::vector<SceneCurve>& curves,
                                double noise_px = 0, unsigned seed = 1);
// For every view, each with a seed of its own.
std::vector<ImageCurves> ProjectCurves(const std::vector<View>& views,
                                       const std::vector<SceneCurve>& curves, double noise_px = 0);

// The edge map of these edgels alone, without fragments.
EdgeMap MakeEdgeMap(const View& view, std::vector<Edgel> edgels);
// An exact edgel of the stored image.
Edgel MakeEdgel(const Eigen::Vector2d& position_px, double tangent_rad);

}  // namespace limn::testing
