// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "colmap_ext/verbs/verb.h"
#include "limn/evaluation/sharp_edges.h"
#include "limn/evaluation/truth_extraction.h"

namespace limn::colmap_ext {

// What truth is extracted from: a mesh with its sharp edges, or a cloud.
struct TruthSource {
  TriangleMesh mesh;
  std::vector<Polyline3d> edges;
  std::vector<Eigen::Vector3d> cloud;
};

// truth_extractor: what the photographs show of a surface or a dense cloud, in a file. Its folder
// becomes the output path: the cache of the images is curves/cache beside it, shared with
// automatic_drawer if that writes there.
class ExtractTruthVerb : public Verb {
 public:
  OptionGroups Groups() const override {
    return {.linking = true, .overwrites = true, .output_help = "file of the truth, .ply"};
  }
  void AddOptions(OptionParser* parser) override;
  void Prepare(RunOptions* options, Console* console) override;
  void Run(const Project& project, const RunOptions& options, Console* console) override;

 private:
  std::string mesh_path_, cloud_path_;
  SharpEdgeOptions sharp_edges_;
  TruthOptions truth_;
  std::string output_path_;
  TruthSource source_;
};

}  // namespace limn::colmap_ext
