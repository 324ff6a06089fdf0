// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/geometry/polyline.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// A line along which faces are cut; a closed one returns to its first point.
struct SectionLine {
  Polyline3d points;
  bool closed = false;
};

// A horizontal cut through a drawing.
struct Section {
  std::vector<SectionLine> lines;
  // Where links are cut.
  std::vector<Eigen::Vector3d> points;

  int NumClosed() const;
};

// The cut at z = height. Lines of faces end to end are joined into one where their ends are nearest
// to each other and not more than `gap` apart: along straight extensions of both lines if these
// meet as near, else by a straight piece. Lines shorter than the gap that join nothing are left
// out. Faces in the plane of the cut give no lines, and links in it no points. Time: triangles,
// points, and pairs of ends.
Section CutAt(double height, const std::vector<DrawingFace>& faces,
              const std::vector<DrawingLink>& links, double gap);

// About four pixels, for gaps between faces, from the sigmas of a drawing: in drawings that were
// fitted to images the median sigma is about a quarter of a pixel. 0 if there are no links.
double UsualGap(const std::vector<DrawingLink>& links);

}  // namespace limn
