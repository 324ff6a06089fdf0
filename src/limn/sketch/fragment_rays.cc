// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/fragment_rays.h"

namespace limn {

Eigen::Vector3d RayTangent(const PinholeCamera& camera, const Eigen::Vector2d& tangent) {
  return {tangent.x() / camera.fx, tangent.y() / camera.fy, 0};
}

FragmentRays MakeFragmentRays(const View& view, const ImageCurves& curves, int fragment) {
  FragmentRays rays;
  rays.closed = curves.fragments[fragment].closed;
  const auto& ids = curves.fragments[fragment].edgel_ids;
  for (size_t i = 0; i < ids.size(); ++i) {
    const Edgel& edgel = curves.edge_map.edgels[ids[i]];
    // Edgel tangents follow luminance; the fragment's order decides the sign here.
    const Eigen::Vector2d& before = curves.edge_map.edgels[ids[i > 0 ? i - 1 : i]].position_px;
    const Eigen::Vector2d& after =
        curves.edge_map.edgels[ids[i + 1 < ids.size() ? i + 1 : i]].position_px;
    const double sign = edgel.Tangent().dot(after - before) < 0 ? -1 : 1;
    rays.positions_px.push_back(edgel.position_px);
    rays.tangents_px.push_back(sign * edgel.Tangent());
    rays.rays.push_back(view.camera.RayFromPixel(edgel.position_px));
    rays.normals.push_back(
        rays.rays.back().cross(RayTangent(view.camera, rays.tangents_px.back())).normalized());
    const double step =
        i > 0 ? (edgel.stored_px - curves.edge_map.edgels[ids[i - 1]].stored_px).norm() : 0;
    rays.arc_px.push_back(i > 0 ? rays.arc_px.back() + step : 0);
  }
  return rays;
}

double FragmentRays::ArcTo(int vertex) const {
  const int count = static_cast<int>(size());
  if (vertex < count) return arc_px[vertex];
  const double closing = (positions_px.front() - positions_px.back()).norm();
  return arc_px.back() + closing + arc_px[vertex - count];
}

std::vector<int> SpacedVertices(const FragmentRays& fragment, double spacing_px) {
  std::vector<int> vertices;
  const int count = static_cast<int>(fragment.size());
  for (int i = 0; i < count; ++i) {
    const bool due =
        vertices.empty() || fragment.arc_px[i] - fragment.arc_px[vertices.back()] >= spacing_px;
    if (due || i + 1 == count) vertices.push_back(i);
  }
  return vertices;
}

FragmentRays Subset(const FragmentRays& fragment, const std::vector<int>& vertices) {
  FragmentRays subset;
  subset.closed = fragment.closed;
  for (const int i : vertices) {
    subset.positions_px.push_back(fragment.positions_px[i]);
    subset.tangents_px.push_back(fragment.tangents_px[i]);
    subset.rays.push_back(fragment.rays[i]);
    subset.normals.push_back(fragment.normals[i]);
    subset.arc_px.push_back(fragment.arc_px[i]);
  }
  return subset;
}

FragmentRays OpenStretch(const FragmentRays& fragment, int begin, int end) {
  std::vector<int> vertices;
  for (int i = begin; i < end; ++i) vertices.push_back(i % static_cast<int>(fragment.size()));
  FragmentRays stretch = Subset(fragment, vertices);
  for (int i = begin; i < end; ++i) stretch.arc_px[i - begin] = fragment.ArcTo(i);
  stretch.closed = false;
  return stretch;
}

}  // namespace limn
