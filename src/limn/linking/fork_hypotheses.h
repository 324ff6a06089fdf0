// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/linking/link_graph.h"
#include "limn/linking/side_colors.h"

namespace limn {

// Decides again at the forks of chains that mutual choice made (after Guo, Kumar, Narayanan and
// Kimia, "A multi-stage approach to curve extraction", ECCV 2014). A fork is a link of the graph
// that no chain uses and that would take the place of one or two others. Each possible continuation
// is a fragment hypothesis with a score (see Continuation); the link replaces those in its way if
// it scores clearly better than they do together, the largest gain first. If the two edgels that
// lose their neighbors are linked in the graph, they are joined too, and that counts. Returns the
// number of changed forks. Time: forks times 60 px of chains.
int ResolveForks(const std::vector<Edgel>& edgels, const std::vector<SideColors>& colors,
                 const std::vector<EdgelLink>& links, Chaining* chaining);

}  // namespace limn
