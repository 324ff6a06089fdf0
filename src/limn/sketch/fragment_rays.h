// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/curve_fragment.h"
#include "limn/model/view.h"

namespace limn {

// One sample of a 3D curve hypothesis, in the frame of the primary camera.
struct HypothesisSample {
  // Vertex of the primary fragment.
  int vertex = 0;
  // Place on the second view's fragment, in vertices.
  double second_parameter = 0;
  // Z in the primary camera: the point is depth * ray of the vertex.
  double depth = 0;
  // Unit tangent, pointing along the fragment.
  Eigen::Vector3d tangent_in_cam = Eigen::Vector3d::Zero();
  // Sine of the smaller of the angles between curve and epipolar line in the two views.
  double epipolar_sine = 0;
  // Sine of the angle between the two viewing rays.
  double triangulation_sine = 0;
};

// A fragment of the primary view matched with a fragment of the second view over a run of vertices.
struct CurveHypothesis {
  int second_fragment = -1;
  std::vector<HypothesisSample> samples;  // ascending vertices
};

// The vertices of a fragment as rays of their camera.
struct FragmentRays {
  std::vector<Eigen::Vector2d> positions_px;
  std::vector<Eigen::Vector2d> tangents_px;
  std::vector<Eigen::Vector3d> rays;     // z = 1
  std::vector<Eigen::Vector3d> normals;  // of the planes through the center and the tangent, unit
  // Arc length from the first vertex, px.
  std::vector<double> arc_px;
  bool closed = false;

  size_t size() const { return rays.size(); }
  // Arc length from the first vertex, px. From size() on, a vertex of a closed fragment once more,
  // after a full round.
  double ArcTo(int vertex) const;
};

FragmentRays MakeFragmentRays(const View& view, const ImageCurves& curves, int fragment);

// Vertices at least `spacing_px` of arc length apart, from the first on, and the last vertex.
std::vector<int> SpacedVertices(const FragmentRays& fragment, double spacing_px);

// The fragment reduced to some of its vertices.
FragmentRays Subset(const FragmentRays& fragment, const std::vector<int>& vertices);

// The vertices [begin, end) as an open fragment. In a closed one they may pass the last vertex:
// they are taken modulo its size.
FragmentRays OpenStretch(const FragmentRays& fragment, int begin, int end);

// Direction of a ray's change when its pixel moves along `tangent`.
Eigen::Vector3d RayTangent(const PinholeCamera& camera, const Eigen::Vector2d& tangent);

}  // namespace limn
