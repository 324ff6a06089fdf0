// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/measured_depth.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>

#include "limn/util/median.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

// What a link says about depth.
enum class Depth : uint8_t { kNoPart, kUnknown, kUnmeasured, kMeasured };

std::vector<Depth> DepthsOf(const DrawingGraph& graph, const std::vector<double>& angle_deg,
                            double min_angle_deg) {
  std::vector<Depth> depths;
  for (size_t l = 0; l < graph.links.size(); ++l) {
    const DrawingLink& link = graph.links[l];
    if (link.doubt != LinkDoubt::kNone) {
      depths.push_back(Depth::kNoPart);
    } else if (angle_deg[l] < 0) {
      depths.push_back(Depth::kUnknown);
    } else {
      depths.push_back(angle_deg[l] < min_angle_deg ? Depth::kUnmeasured : Depth::kMeasured);
    }
  }
  return depths;
}

// A run of links that were not measured.
struct Run {
  int measured_ends = 0;
  bool meets_unmeasured = false;  // or has such a link
};

// The representatives of the runs: the two links of a node that has no others are in one, if
// neither was measured.
UnionFind FindRuns(const DrawingGraph& graph, const std::vector<Depth>& depths) {
  UnionFind runs(static_cast<int>(depths.size()));
  for (const DrawingNode& node : graph.nodes) {
    std::vector<LinkId> links;
    bool is_measured = false;
    for (const LinkEnd& end : node.incident) {
      is_measured |= depths[end.link] == Depth::kMeasured;
      if (depths[end.link] != Depth::kNoPart) links.push_back(end.link);
    }
    if (!is_measured && links.size() == 2) runs.Union(links[0], links[1]);
  }
  return runs;
}

}  // namespace

double LeastAngleDeg(const std::vector<double>& angle_deg, double min_angle_deg) {
  std::vector<double> known = angle_deg;
  std::erase_if(known, [](double angle) { return angle < 0; });
  const bool hardly_moved = !known.empty() && Median(std::move(known)) < kWideAngleDeg;
  return hardly_moved ? std::max(min_angle_deg, kWideAngleDeg) : min_angle_deg;
}

void DoubtUnmeasuredDepth(const std::vector<double>& angle_deg, double min_angle_deg,
                          DrawingGraph* graph) {
  const std::vector<Depth> depths = DepthsOf(*graph, angle_deg, min_angle_deg);
  UnionFind run_of = FindRuns(*graph, depths);
  std::vector<Run> runs(depths.size());
  for (const DrawingNode& node : graph->nodes) {
    std::set<int> at_node;  // a loop ends here twice
    const auto has = [&](Depth depth) {
      return std::ranges::any_of(node.incident,
                                 [&](const LinkEnd& end) { return depths[end.link] == depth; });
    };
    for (const LinkEnd& end : node.incident) {
      if (!at_node.insert(run_of.Find(end.link)).second) continue;
      Run& run = runs[run_of.Find(end.link)];
      run.measured_ends += has(Depth::kMeasured);
      run.meets_unmeasured |= has(Depth::kUnmeasured);
    }
  }
  for (size_t l = 0; l < depths.size(); ++l) {
    const Run& run = runs[run_of.Find(static_cast<LinkId>(l))];
    const bool is_doubted =
        depths[l] == Depth::kUnmeasured
            ? run.measured_ends < 2
            : depths[l] == Depth::kUnknown && run.measured_ends < 1 && run.meets_unmeasured;
    if (is_doubted) graph->links[l].doubt = LinkDoubt::kDepth;
  }
}

}  // namespace limn
