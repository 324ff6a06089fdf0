// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "limn/geometry/polyline.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// Manual edits of a drawing. They refer to links by geometry, so that they can be applied again
// after the scene has been redrawn; ids only decide between links that fit equally well. World
// units.

// A link as it was when the edit was made.
struct LinkRef {
  LinkId id = -1;  // -1: none
  bool closed = false;
  // At least two, evenly spaced by arc length, from its first to its last end.
  Polyline3d points;
};

struct EndRef {
  LinkRef link;
  int end = 0;  // 0 or 1
};

struct PlaceRef {
  LinkRef link;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
};

struct DeleteLinks {
  std::vector<LinkRef> links;
};

// Makes tentative links firm.
struct RestoreLinks {
  std::vector<LinkRef> links;
};

struct SetLinkKind {
  std::vector<LinkRef> links;
  LinkKind kind = LinkKind::kUnknown;
};

struct SplitLink {
  PlaceRef place;
};

// Two ends become one: free ends that continue each other make one link, others meet at a node.
struct JoinEnds {
  std::array<EndRef, 2> ends;
};

// Two links that show the same curve become one.
struct MergeLinks {
  std::array<LinkRef, 2> links;
};

// Writes a length into the drawing; see DrawingDimension.
struct AddDimension {
  PlaceRef from, to;
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
};

struct RemoveDimension {
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
};

using Edit = std::variant<DeleteLinks, RestoreLinks, SetLinkKind, SplitLink, JoinEnds, MergeLinks,
                          AddDimension, RemoveDimension>;

// "delete", "restore", "set_kind", "split", "join", "merge", "dimension", "remove_dimension".
const char* EditName(const Edit& edit);

// With `shift` added to all positions.
std::vector<Edit> Moved(std::vector<Edit> edits, const Eigen::Vector3d& shift);

}  // namespace limn
