#pragma once

#include <string>
#include <vector>

#include "colmap_ext/options/option_parser.h"
#include "colmap_ext/run/console.h"
#include "colmap_ext/run/project.h"
#include "limn/evaluation/sharp_edges.h"
#include "limn/evaluation/truth_extraction.h"

namespace limn::colmap_ext {

// The options of truth_extractor beside those of the project.
struct ExtractorOptions {
  std::string mesh_path, cloud_path;
  SharpEdgeOptions sharp_edges;
  TruthOptions truth;

  void AddOptions(OptionParser* parser);
  // Throws OptionError.
  void Check() const;
};

// The truth is one file; what is kept of the images goes to curves/cache beside it, where
// automatic_drawer has it too when it writes there. Returns the file, and makes its folder the
// output path. Throws OptionError.
std::string TakeTruthPath(LayoutOptions* layout);

// What the truth is looked for in: a surface with its sharp edges, or points.
struct TruthSource {
  TriangleMesh mesh;
  std::vector<Polyline3d> edges;
  std::vector<Eigen::Vector3d> cloud;
};

// Throws IoError.
TruthSource ReadTruthSource(const ExtractorOptions& options, Console* console);

// What the photographs show of the source, and says how much. Throws InputError if it is nothing.
ExtractedTruth ExtractProjectTruth(const Project& project, const RunOptions& run,
                                   const TruthSource& source, const TruthOptions& options,
                                   Console* console);

}  // namespace limn::colmap_ext
