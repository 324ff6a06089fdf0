// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

// The angle by which the supporting views measure the depth of a link, deg: the largest one, up to
// 90, between two of them: the smaller one of the angle between their rays and of that between
// their planes. The plane of a view holds its center and the curve's tangent, so that motion of the
// camera along an edge adds nothing; two views on opposite sides have the same plane. Median over
// up to 9 points. -1, unknown, with fewer than two views: such links are held by their nodes
// (algorithm/belief.md#depth). Time: 9 times the square of the number of supporting views.
double TriAngleDeg(const DrawingLink& link, const std::vector<View>& views);

// Of all links.
std::vector<double> TriAnglesDeg(const DrawingGraph& graph, const std::vector<View>& views,
                                 const RunContext& context);

// The standard deviation of a link in the direction across it that its supporting views measure
// least, which is that of their depth, world units: the sigmas of its points (cameras included
// where these were refined), split as the planes and footprints of the views say. Median over up to
// 9 places. -1, unknown, with fewer than two supporting views, without known sigmas, and of
// contours, which are no curves in space. Time: 9 times the number of supporting views.
double DepthSigma(const DrawingLink& link, const std::vector<View>& views);

// Sets it for all links, and the covariances of nodes.
void MeasureSigmas(const std::vector<View>& views, const RunContext& context, DrawingGraph* graph);

// Sets angles and standard deviations of all links.
void MeasureDepth(const std::vector<View>& views, const RunContext& context, DrawingGraph* graph);

}  // namespace limn
