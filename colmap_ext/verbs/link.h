// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/verbs/edge_results.h"
#include "colmap_ext/verbs/verb.h"

namespace limn::colmap_ext {

// curve_linker: the curve fragments of all images (ExtractImageCurves), kept in the cache.
class LinkVerb : public Verb {
 public:
  OptionGroups Groups() const override { return {.linking = true, .overwrites = true}; }
  void AddFileOptions(OptionParser* parser) override;
  void Run(const Project& project, const RunOptions& options, Console* console) override;

 private:
  EdgeFormat format_ = EdgeFormat::kNone;
};

}  // namespace limn::colmap_ext
