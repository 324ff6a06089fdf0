// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/lit_places.h"

#include <cmath>

#include <Eigen/Eigenvalues>

#include "limn/geometry/polyline.h"
#include "limn/geometry/spatial_index.h"
#include "limn/model/footprint.h"

namespace limn {
namespace {

// The surface of a place is that of the places within this distance, px. It is a plane if they
// spread by at least 8 px along it, and most of them are within 6 px of it.
constexpr double kAroundPx = 60;
constexpr size_t kMinAround = 6;
constexpr double kMinSpreadPx = 8;
constexpr double kFlatPx = 6;
constexpr double kFlatShare = 0.6;

std::vector<LitPlace> Sample(const DrawingGraph& graph, const std::vector<View>& views) {
  std::vector<LitPlace> places;
  for (size_t l = 0; l < graph.links.size(); ++l) {
    const DrawingLink& link = graph.links[l];
    const double footprint = LinkFootprint(link, views);
    if (link.tentative || !(footprint > 0)) continue;
    const Polyline3d points = ResampleUniform(link.points_in_world, kPlaceStepPx * footprint);
    for (size_t k = 0; k + 1 < points.size(); ++k) {
      const Eigen::Vector3d along = points[k + 1] - points[k];
      places.push_back({static_cast<LinkId>(l), 0.5 * (points[k] + points[k + 1]),
                        along.stableNormalized(), footprint});
    }
  }
  return places;
}

// In how many more supporting views the side of the normal is seen than the other.
int SideOfViews(const LitPlace& place, const Eigen::Vector3d& normal, const DrawingLink& link,
                const std::vector<View>& views) {
  int side = 0;
  for (const ViewId v : link.supporting_views) {
    side += normal.dot(views[v].CenterInWorld() - place.position_in_world) > 0 ? 1 : -1;
  }
  return side;
}

// Sets the plane through the places around this one.
void SetSurface(const std::vector<SpatialIndex::Neighbor>& around,
                const std::vector<Eigen::Vector3d>& positions, const DrawingLink& link,
                const std::vector<View>& views, LitPlace* place) {
  if (around.size() < kMinAround) return;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const SpatialIndex::Neighbor& other : around) {
    const Eigen::Vector3d offset = positions[other.index] - place->position_in_world;
    spread += offset * offset.transpose() / static_cast<double>(around.size());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  if (std::sqrt(axes.eigenvalues()[1]) < kMinSpreadPx * place->footprint) return;
  const Eigen::Vector3d normal = axes.eigenvectors().col(0);
  size_t num_on_plane = 0;
  for (const SpatialIndex::Neighbor& other : around) {
    const double height = normal.dot(positions[other.index] - place->position_in_world);
    num_on_plane += std::abs(height) < kFlatPx * place->footprint ? 1 : 0;
  }
  const int side = SideOfViews(*place, normal, link, views);
  if (side == 0) return;
  place->normal = side > 0 ? normal : Eigen::Vector3d(-normal);
  place->on_plane =
      static_cast<double>(num_on_plane) > kFlatShare * static_cast<double>(around.size());
}

}  // namespace

std::vector<LitPlace> PlacesOfLinks(const DrawingGraph& graph, const std::vector<View>& views,
                                    const RunContext& context) {
  std::vector<LitPlace> places = Sample(graph, views);
  std::vector<Eigen::Vector3d> positions;
  for (const LitPlace& place : places) positions.push_back(place.position_in_world);
  const SpatialIndex index(positions);
  ParallelFor(context, "surfaces of places", places.size(), [&](size_t k) {
    std::vector<SpatialIndex::Neighbor> around;
    index.FindWithin(positions[k], kAroundPx * places[k].footprint, &around);
    SetSurface(around, positions, graph.links[places[k].link], views, &places[k]);
  });
  return places;
}

}  // namespace limn
