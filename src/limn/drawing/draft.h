#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "limn/drawing/drawing_options.h"
#include "limn/drawing/merging.h"
#include "limn/drawing/samples.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// A link on its way into the graph: geometry with what is needed to extend, cut and judge it.
struct DraftLink {
  std::vector<Eigen::Vector3d> position;
  std::vector<Eigen::Matrix3d> information;  // inverse covariance across the curve
  std::vector<double> footprint;
  // Per point the samples merged into it; empty where a point was added.
  std::vector<std::vector<int>> samples;
  int node[2] = {-1, -1};  // -1 = free end
  bool grown = false;      // whole, from the images at its joints: see corner_edges.h
  bool closed = false;     // the last point is followed by the first, which is not repeated

  int size() const { return static_cast<int>(position.size()); }
};

struct Draft {
  std::vector<DraftLink> links;
  int num_nodes = 0;
  int num_sketch_samples = 0;  // samples from this id on are not of the sketch, but of grown links

  // Samples of the sketch merged into a link.
  int64_t NumSketchSamples(const DraftLink& link) const;
};

// Fit the merged curves (algorithm.md 11.4, zip and re-fit): every vertex moves to the weighted
// mean of the samples merged into it, across the curve; then the link is smoothed by the same rule
// as the samples.
Draft FitLinks(const SampleSet& samples, const MergedCurves& merged, const DrawingOptions& options);

// Arc length in footprints between two points of a link, from <= to.
double ArcPx(const DraftLink& link, int from, int to);
double LengthPx(const DraftLink& link);

// Unit direction of the link at a point; zero where it has no extent.
Eigen::Vector3d TangentAt(const DraftLink& link, int point);

// At most `count` points of a link, evenly spread, by which it is judged.
std::vector<int> ProbePoints(const DraftLink& link, int count);

// Unit direction in which a link leaves at an end, from a line fitted to its last pixels; and that
// line's point at the end. Zero direction for a link without extent.
struct EndLine {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d outward = Eigen::Vector3d::Zero();
  double footprint = 1;
};
EndLine LineAtEnd(const DraftLink& link, int end);

// Cut a link at an inner point, which both parts keep; both end at `node` there. The second part is
// appended to the draft.
void SplitLink(Draft* draft, int link, int index, int node);

// The ends at every node, ascending.
using EndsAtNode = std::map<int, std::vector<LinkEnd>>;
EndsAtNode CollectEnds(const Draft& draft);

// Remove links marked 0. Ends that are then alone at their node are free.
void KeepLinks(const std::vector<uint8_t>& keep, Draft* draft);

}  // namespace limn
