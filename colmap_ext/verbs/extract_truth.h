#pragma once

#include <string>
#include <vector>

#include "colmap_ext/host/console.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/options/option_parser.h"
#include "limn/evaluation/sharp_edges.h"
#include "limn/evaluation/truth_extraction.h"

namespace limn::colmap_ext {

// The options of truth_extractor other than those of the project.
struct ExtractorOptions {
  std::string mesh_path, cloud_path;
  SharpEdgeOptions sharp_edges;
  TruthOptions truth;

  void AddOptions(OptionParser* parser);
  // Throws OptionError.
  void Check() const;
};

// The output is a single file, so its folder becomes the output path: the cache of the images is
// curves/cache beside it, shared with automatic_drawer if that writes there. Returns the file.
// Throws OptionError.
std::string TakeTruthPath(LayoutOptions* layout);

// What the truth is extracted from: a mesh with its sharp edges, or a cloud.
struct TruthSource {
  TriangleMesh mesh;
  std::vector<Polyline3d> edges;
  std::vector<Eigen::Vector3d> cloud;
};

// Throws IoError.
TruthSource ReadTruthSource(const ExtractorOptions& options, Console* console);

// The part of the source that the photographs show; reports how much that is. Throws InputError if
// it is nothing.
ExtractedTruth ExtractProjectTruth(const Project& project, const RunOptions& run,
                                   const TruthSource& source, const TruthOptions& options,
                                   Console* console);

}  // namespace limn::colmap_ext
