// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limn/geometry/polygon2d.h"
#include "limn/model/drawing_graph.h"
#include "limn/surfaces/plane_strokes.h"

namespace limn {

// A place of a link: index of a point plus a fraction.
struct BorderPlace {
  LinkId link = -1;
  double position = 0;
};

// A place of a surface, and places of its border around it. A view that sees the place unobstructed
// sees most of these too.
struct CandidatePlace {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // either way
  std::vector<BorderPlace> border;
  int min_border = 1;  // an image with fewer of them cannot judge
};

struct FlatRegion {
  PlaneFrame frame;
  Polygon2d polygon;
};

// A surface that may be a face.
struct FaceCandidate {
  double footprint = 0;  // world units per px
  std::vector<CandidatePlace> places;
  // Share of the places that must be seen, if more than that of the options.
  double min_seen_share = 0;
  // Set if it is flat; of other surfaces a view may see only a part.
  std::optional<FlatRegion> flat = std::nullopt;
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;
};

}  // namespace limn
