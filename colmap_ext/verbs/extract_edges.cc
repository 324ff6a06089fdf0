// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/extract_edges.h"

#include <utility>

#include "limn/util/parallel.h"

namespace limn::colmap_ext {

std::vector<EdgeMap> FindEdgeMaps(const Job& job) {
  EdgeMapsResult result = ExtractEdgeMaps({job.views(), job.scene.images(), job.cache},
                                          job.options.pipeline.edges, job.context());
  job.console->Report(result.summary);
  return std::move(result.edge_maps);
}

void ExtractEdgesVerb::AddFileOptions(OptionParser* parser) {
  parser->AddOption(
      "format", &format_,
      {{"none", EdgeFormat::kNone}, {"edg", EdgeFormat::kEdg}, {"cem", EdgeFormat::kCem}},
      BasicOption("also write edgels (.edg), or link them and write fragments"));
}

void ExtractEdgesVerb::Run(const Project& project, const RunOptions& options, Console* console) {
  CheckEdgeResults(project, format_, options.overwrite);
  const Job job = JobOf(project, options, console);
  const std::vector<EdgeMap> edge_maps = FindEdgeMaps(job);
  if (format_ == EdgeFormat::kEdg) {
    ParallelFor(job.context(), "files of edges", edge_maps.size(),
                [&](size_t v) { WriteEdgResult(project, static_cast<ViewId>(v), edge_maps[v]); });
  }
  if (format_ == EdgeFormat::kCem) ExtractImageCurves(job, CemWriter(project));
  SayEdgeResults(project, format_, console);
}

}  // namespace limn::colmap_ext
