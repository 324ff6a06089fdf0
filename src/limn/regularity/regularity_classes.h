// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <vector>

#include "limn/regularity/common_planes.h"
#include "limn/regularity/equal_circles.h"
#include "limn/regularity/parallel_lines.h"

namespace limn {

// Regularities of lines and arcs by index of evidence, local units.
struct RegularityClasses {
  std::vector<DirectionClass> directions;
  std::vector<PlaneClass> planes;
  std::vector<RadiusClass> radii;
  std::vector<AxisClass> axes;
};

enum class RegularityKind { kDirection, kPlane, kRadius, kAxis };

// The fact that a line or arc follows a regularity.
struct Membership {
  LinkId link = -1;
  RegularityKind kind = RegularityKind::kDirection;
  int index = 0;   // of the regularity among its kind
  int member = 0;  // index of evidence

  auto operator<=>(const Membership&) const = default;
};

// What each link follows; only links that follow any.
using Memberships = std::map<LinkId, std::vector<Membership>>;
Memberships MembershipsOf(const RegularityClasses& classes, const DrawingEvidence& evidence);

// Ends these memberships, and regularities that too few then follow: directions and circles of
// fewer than two, planes of fewer than three. Those keep their index, without members or ties to
// others, so that other indices stay valid.
void Leave(const std::set<Membership>& memberships, const DrawingEvidence& evidence,
           RegularityClasses* classes);

// Returns lines and arcs to regularities that they left, where enough then follow them.
void Join(const std::set<Membership>& memberships, const DrawingEvidence& evidence,
          RegularityClasses* classes);

// Removes regularities without members; the others get new indices.
void RemoveEmpty(RegularityClasses* classes);

}  // namespace limn
