// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "limn/topology/graph_editor.h"
#include "limn/topology/topology_options.h"

namespace limn {

struct TidyCounts {
  int64_t forks_cut = 0;  // ends freed because they left a node along another link
  int64_t dissolved_nodes = 0;
  int64_t samples_short = 0;    // sketch samples in links that were too short
  int64_t samples_covered = 0;  // and in links that ran along others
};

// Tidies a drawing (algorithm/topology.md#tidying-and-finishing). Forks are cut, nodes dissolved
// and covered links removed once; then dissolving nodes and removing short links repeat until
// nothing changes. Every link must have vertices. O(n log n) in the number of points.
TidyCounts Tidy(const TopologyOptions& options, GraphEditor* editor);

// The steps of Tidy.

// Frees an end of each pair of links that leave a node at less than min_junction_angle_deg from
// each other. Tracing and merging leave such forks where two strands of one edge, or two parallel
// edges, part slowly; real edges do not meet like this. Of a pair, the link that continues a third
// link of the node better stays, or else the longer one. Returns the number of ends freed.
int64_t CutForks(const TopologyOptions& options, GraphEditor* editor);

// Joins two links that are alone at a node and continue each other. Returns the number of nodes
// dissolved.
int64_t DissolveNodes(const TopologyOptions& options, GraphEditor* editor);

// Removes links shorter than min_link_length_px, loops included. Links between two different nodes,
// and those grown from a node (they have no sketch samples), are removed below 2 px only. Returns
// the number of sketch samples in the removed links.
int64_t RemoveShortLinks(const TopologyOptions& options, GraphEditor* editor);

// Removes links marked 0. Returns the number of sketch samples in them. Ids change.
int64_t KeepAndCount(const std::vector<uint8_t>& keep, GraphEditor* editor);

}  // namespace limn
