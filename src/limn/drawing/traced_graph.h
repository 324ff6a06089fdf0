// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "limn/drawing/consensus.h"
#include "limn/drawing/samples.h"
#include "limn/model/drawing_graph.h"

namespace limn {

struct TracedVertex {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // unit, along the curve
  double footprint = 0;
  int curve = -1;
  std::vector<int> samples;  // that it stands for
};

struct TracedCurve {
  std::vector<int> vertices;  // in order
  // The vertex, of another curve or its own, that the curve meets at its first and at its last end;
  // -1 if the end is free. Ends of closed curves meet nothing.
  std::array<int, 2> meets = {-1, -1};
  bool closed = false;
};

struct TracedCurves {
  std::vector<TracedVertex> vertices;
  std::vector<TracedCurve> curves;
};

// The drawing of traced curves (algorithm/drawing.md#the-graph): they are cut into links where
// others meet them, and every meeting is a node. A meeting near the end of the curve that is met is
// at that end, and if that end meets a curve, it is there. The points of a link are a px or two
// apart, also where the samples left a gap. Points are not smoothed, sigmas are 0. The graph passes
// Validate(). O(n log n) in the number of vertices.
DrawingGraph MakeTracedGraph(const SampleSet& samples, const Consensus& consensus,
                             const TracedCurves& traced);

}  // namespace limn
