// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <gtest/gtest.h>

#include "limn/surfaces/bent_candidate.h"
#include "limn/surfaces/face_links.h"
#include "support/synthetic_scene.h"

namespace limn::testing {

// What `find` finds in a drawing; each is a face that the drawing may have.
template <typename Find>
std::vector<BentCandidate> BentCandidatesOf(DrawingGraph graph, Find&& find) {
  graph.faces.clear();
  const SurfaceOptions options;
  const auto links = MeasureFaceLinks(graph, DomeViews(12, 8), options);
  std::vector<BentCandidate> candidates = find(links, graph, options);
  for (const BentCandidate& candidate : candidates) {
    graph.faces = {candidate.face};
    EXPECT_TRUE(Validate(graph).empty());
  }
  return candidates;
}

}  // namespace limn::testing
