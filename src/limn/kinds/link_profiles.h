// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/kinds/edge_profile.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// A place on a link where its profile is measured.
struct ProfilePlace {
  Eigen::Vector3d position_in_world = Eigen::Vector3d::Zero();
  Eigen::Vector3d tangent = Eigen::Vector3d::Zero();
};

// What one view shows at such a place.
struct LinkProfile {
  LinkId link = -1;
  int place = -1;   // of the link, in order along it
  float depth = 0;  // along the optical axis
  EdgeProfile profile;
};

// The places to measure.
struct ProfilePlan {
  std::vector<std::vector<ProfilePlace>> places;   // per link: one every 6 px, at most 32
  std::vector<std::vector<LinkId>> links_of_view;  // at most 24 of a link's supporting views
};

ProfilePlan PlanProfiles(const DrawingGraph& graph, const std::vector<View>& views);

// The profiles of one view, by link; places without one are left out. The image is the stored one.
std::vector<LinkProfile> MeasureProfiles(const View& view, const Image& image,
                                         const ProfilePlan& plan, const std::vector<LinkId>& links);

}  // namespace limn
