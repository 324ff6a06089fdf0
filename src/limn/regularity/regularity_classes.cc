// SPDX-License-Identifier: BSD-3-Clause
#include "limn/regularity/regularity_classes.h"

#include <algorithm>

namespace limn {
namespace {

bool IsArc(const Membership& of, const DrawingEvidence& evidence) {
  const size_t i = of.member;
  return i < evidence.arcs.size() && evidence.arcs[i].link == of.link;
}

// The list of members that a membership is in.
std::vector<int>* MembersWith(const Membership& of, const DrawingEvidence& evidence,
                              RegularityClasses* classes) {
  switch (of.kind) {
    case RegularityKind::kDirection:
      return &classes->directions[of.index].lines;
    case RegularityKind::kPlane: {
      PlaneClass& plane = classes->planes[of.index];
      return IsArc(of, evidence) ? &plane.arcs : &plane.lines;
    }
    case RegularityKind::kRadius:
      return &classes->radii[of.index].arcs;
    default:
      return &classes->axes[of.index].arcs;
  }
}

void EmptySmall(RegularityClasses* classes) {
  for (PlaneClass& of : classes->planes) {
    if (of.Size() >= 3) continue;
    of.lines.clear();
    of.arcs.clear();
  }
  for (RadiusClass& of : classes->radii) {
    if (of.arcs.size() < 2) of.arcs.clear();
  }
  for (AxisClass& of : classes->axes) {
    if (of.arcs.size() < 2) of.arcs.clear();
  }
  std::vector<DirectionClass>& directions = classes->directions;
  for (DirectionClass& of : directions) {
    if (of.lines.size() < 2) of.lines.clear();
  }
  const auto is_empty = [&](int c) { return directions[c].lines.empty(); };
  for (DirectionClass& of : directions) {
    if (of.lines.empty()) of.orthogonal_to.clear();
    std::erase_if(of.orthogonal_to, is_empty);
  }
  for (PlaneClass& of : classes->planes) {
    if (of.normal_class >= 0 && is_empty(of.normal_class)) of.normal_class = -1;
  }
}

}  // namespace

Memberships MembershipsOf(const RegularityClasses& classes, const DrawingEvidence& evidence) {
  Memberships all;
  const auto add = [&](RegularityKind kind, size_t index, const std::vector<int>& members,
                       const auto& shapes) {
    for (const int i : members) {
      const LinkId link = shapes[i].link;
      all[link].push_back({link, kind, static_cast<int>(index), i});
    }
  };
  for (size_t c = 0; c < classes.directions.size(); ++c) {
    add(RegularityKind::kDirection, c, classes.directions[c].lines, evidence.lines);
  }
  for (size_t c = 0; c < classes.planes.size(); ++c) {
    add(RegularityKind::kPlane, c, classes.planes[c].lines, evidence.lines);
    add(RegularityKind::kPlane, c, classes.planes[c].arcs, evidence.arcs);
  }
  for (size_t c = 0; c < classes.radii.size(); ++c) {
    add(RegularityKind::kRadius, c, classes.radii[c].arcs, evidence.arcs);
  }
  for (size_t c = 0; c < classes.axes.size(); ++c) {
    add(RegularityKind::kAxis, c, classes.axes[c].arcs, evidence.arcs);
  }
  return all;
}

void Leave(const std::set<Membership>& memberships, const DrawingEvidence& evidence,
           RegularityClasses* classes) {
  for (const Membership& of : memberships) {
    std::erase(*MembersWith(of, evidence, classes), of.member);
  }
  EmptySmall(classes);
}

void Join(const std::set<Membership>& memberships, const DrawingEvidence& evidence,
          RegularityClasses* classes) {
  for (const Membership& of : memberships) {
    std::vector<int>& members = *MembersWith(of, evidence, classes);
    members.insert(std::lower_bound(members.begin(), members.end(), of.member), of.member);
  }
  EmptySmall(classes);
}

void RemoveEmpty(RegularityClasses* classes) {
  std::vector<DirectionClass>& directions = classes->directions;
  std::vector<int> index(directions.size(), -1);
  int count = 0;
  for (size_t c = 0; c < directions.size(); ++c) {
    if (!directions[c].lines.empty()) index[c] = count++;
  }
  std::erase_if(directions, [](const DirectionClass& of) { return of.lines.empty(); });
  for (DirectionClass& of : directions) {
    for (int& other : of.orthogonal_to) other = index[other];
  }
  std::erase_if(classes->planes, [](const PlaneClass& of) { return of.Size() == 0; });
  for (PlaneClass& of : classes->planes) {
    if (of.normal_class >= 0) of.normal_class = index[of.normal_class];
  }
  std::erase_if(classes->radii, [](const RadiusClass& of) { return of.arcs.empty(); });
  std::erase_if(classes->axes, [](const AxisClass& of) { return of.arcs.empty(); });
}

}  // namespace limn
