// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/link_profiles.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "limn/geometry/polyline.h"
#include "limn/model/footprint.h"
#include "limn/support/edgel_residual.h"

namespace limn {
namespace {

constexpr int kMaxViews = 24;
constexpr int kMaxPlaces = 32;
// Profiles are means over 7 px.
constexpr double kSpacingPx = 6;
// Half the distance over which the tangent of a link and its direction in an image are measured.
constexpr double kTangentArmPx = 1.5;

// Evenly spread over the list.
std::vector<ViewId> SomeOf(const std::vector<ViewId>& views) {
  if (views.size() <= kMaxViews) return views;
  std::vector<ViewId> some;
  for (size_t k = 0; k < kMaxViews; ++k) some.push_back(views[k * views.size() / kMaxViews]);
  return some;
}

std::vector<ProfilePlace> PlacesOf(const DrawingLink& link, double footprint) {
  const std::vector<Eigen::Vector3d>& points = link.points_in_world;
  const std::vector<double> arc = CumulativeLength(points);
  const auto num_places = static_cast<int>(
      std::clamp(std::floor(arc.back() / (kSpacingPx * footprint)), 1.0, double{kMaxPlaces}));
  const double arm = kTangentArmPx * footprint;
  const auto at = [&](double length) {
    length = std::clamp(length, 0.0, arc.back());
    const auto next = std::upper_bound(arc.begin() + 1, arc.end() - 1, length) - arc.begin();
    const double step = arc[next] - arc[next - 1];
    const double share = step > 0 ? (length - arc[next - 1]) / step : 0;
    return Eigen::Vector3d(points[next - 1] + share * (points[next] - points[next - 1]));
  };
  std::vector<ProfilePlace> places;
  for (int k = 0; k < num_places; ++k) {
    const double here = (k + 0.5) / num_places * arc.back();
    const Eigen::Vector3d tangent = (at(here + arm) - at(here - arm)).stableNormalized();
    if (tangent.isZero()) continue;
    places.push_back({at(here), tangent});
  }
  return places;
}

// Position and direction of a place in the image as stored.
std::optional<CurveSight> SeeStored(const View& view, const ProfilePlace& place) {
  std::optional<CurveSight> sight = See(view, place.position_in_world, place.tangent);
  if (!sight || !view.lens) return sight;
  const auto center = view.StoredFromVirtual(sight->position_px);
  const auto ahead = view.StoredFromVirtual(sight->position_px + kTangentArmPx * sight->direction);
  if (!center || !ahead) return std::nullopt;
  return CurveSight{*center, (*ahead - *center).normalized()};
}

}  // namespace

ProfilePlan PlanProfiles(const DrawingGraph& graph, const std::vector<View>& views) {
  ProfilePlan plan;
  plan.places.resize(graph.links.size());
  plan.links_of_view.resize(views.size());
  for (size_t l = 0; l < graph.links.size(); ++l) {
    const DrawingLink& link = graph.links[l];
    const double footprint = LinkFootprint(link, views);
    if (!(footprint > 0)) continue;
    plan.places[l] = PlacesOf(link, footprint);
    for (const ViewId view : SomeOf(link.supporting_views)) {
      plan.links_of_view[view].push_back(static_cast<LinkId>(l));
    }
  }
  return plan;
}

std::vector<LinkProfile> MeasureProfiles(const View& view, const Image& image,
                                         const ProfilePlan& plan,
                                         const std::vector<LinkId>& links) {
  std::vector<LinkProfile> profiles;
  for (const LinkId link : links) {
    for (size_t p = 0; p < plan.places[link].size(); ++p) {
      const ProfilePlace& place = plan.places[link][p];
      const auto sight = SeeStored(view, place);
      if (!sight) continue;
      const auto profile =
          MeasureProfile(image, image.FromView(sight->position_px), sight->direction);
      if (!profile) continue;
      const double depth = (view.cam_from_world * place.position_in_world).z();
      profiles.push_back({link, static_cast<int>(p), static_cast<float>(depth), *profile});
    }
  }
  return profiles;
}

}  // namespace limn
