// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/regularity/parallel_lines.h"

namespace limn {

// A plane that several lines and arcs lie in: normal . x = offset, local units.
struct PlaneClass {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0;
  std::vector<int> lines;  // indices of evidence, ascending
  std::vector<int> arcs;
  int normal_class = -1;  // class of directions that is the normal, -1: none

  size_t Size() const { return lines.size() + arcs.size(); }
};

// The planes that lines and arcs share (ours). Hypotheses are the planes of arcs, of two lines that
// meet at a node and of parallel neighbors. A line or arc is in a plane if describing it that way
// takes less information than describing its offset, and moves it by no more than max_shift_px; a
// plane stays if it saves more than its own description costs, is held by three lines or arcs of
// two directions, and does not nearly coincide with one that saves more. A line may be in several.
// Time: hypotheses, about seven per line, times lines.
std::vector<PlaneClass> FindCommonPlanes(const DrawingGraph& graph, const DrawingEvidence& evidence,
                                         const std::vector<DirectionClass>& directions,
                                         const RegularityOptions& options,
                                         const RunContext& context);

// Whether a plane with its present members saves more than its own description costs and is held by
// two directions.
bool SavesItsNormal(const PlaneClass& plane, const DrawingGraph& graph,
                    const DrawingEvidence& evidence, const std::vector<DirectionClass>& directions,
                    const RegularityOptions& options);

}  // namespace limn
