// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/host/job.h"
#include "colmap_ext/verbs/edge_results.h"
#include "colmap_ext/verbs/verb.h"

namespace limn::colmap_ext {

// edge_extractor: the edgels of all images, kept in the cache.
class ExtractEdgesVerb : public Verb {
 public:
  OptionGroups Groups() const override { return {.linking = true, .overwrites = true}; }
  void AddFileOptions(OptionParser* parser) override;
  void Run(const Project& project, const RunOptions& options, Console* console) override;

 private:
  EdgeFormat format_ = EdgeFormat::kNone;
};

// Per view, before ApplyLens; prints a summary.
std::vector<EdgeMap> FindEdgeMaps(const Job& job);

}  // namespace limn::colmap_ext
