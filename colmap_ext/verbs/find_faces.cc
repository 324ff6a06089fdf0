// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/find_faces.h"

#include <algorithm>
#include <utility>

#include "colmap_ext/verbs/drawing_results.h"
#include "limn/surfaces/find_faces.h"

namespace limn::colmap_ext {
namespace {

// Which links faces hide from most of their views.
void SayLinksBehind(const std::vector<LinkId>& links, Console* console) {
  if (links.empty()) return;
  constexpr size_t kMaxNamed = 20;
  std::string text;
  for (size_t i = 0; i < std::min(links.size(), kMaxNamed); ++i) {
    text += (i == 0 ? "" : ", ") + std::to_string(links[i]);
  }
  if (links.size() > kMaxNamed) text += ", ...";
  console->Say("links that faces hide from most of their views, probably false: " +
               std::to_string(links.size()) + " (" + text + ")");
}

}  // namespace

DrawingInScene FindFacesVerb::Apply(const Job& job, const DrawingInScene& given) {
  auto curves = CurvesOf(job, given);
  SurfaceResult result = FindFaces({given.views, *curves, job.scene.view_set().hints},
                                   job.options.pipeline.refinement.Gate(), given.graph,
                                   job.options.pipeline.surfaces, job.context());
  job.console->Report(result.summary);
  SayLinksBehind(result.links_behind, job.console);
  CheckGraph(result.graph);
  return {std::move(result.graph), given.metadata, given.views, std::move(curves)};
}

}  // namespace limn::colmap_ext
