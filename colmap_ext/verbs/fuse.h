#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "colmap_ext/dense_files/dense_cloud.h"
#include "colmap_ext/dense_files/products.h"
#include "colmap_ext/host/console.h"
#include "colmap_ext/host/project.h"
#include "limn/dense/fuse_drawing.h"
#include "limn/formats/json_drawing_reader.h"

namespace limn::colmap_ext {

// The options of drawing_fuser other than paths and selection.
struct FuserOptions {
  std::string drawing_path;
  DenseOptionsPaths paths;
  bool remove_occluded = false;
  int sparse_spacing_px = 4;

  void AddOptions(OptionParser* parser);
  // Throws OptionError.
  void Check() const;
};

constexpr const char* kFusedDrawing = "drawing-fused.json";

// Provenance of the fusion, with these options, of a drawing with provenance `drawing_provenance`.
std::string FusionProvenance(const RunOptions& options, const FuserOptions& fuser,
                             const std::string& drawing_provenance);

// Call it before the work: throws IoError if the results would replace something that is not a
// regular file or that limn did not write. Clouds and models carry no mark; they count as ours
// beside a drawing-fused.json.
void CheckFusionFiles(const Project& project, const RunOptions& options);

// The opened dense results.
struct DenseInput {
  DenseProducts products;
  DepthSource depths;
  // PMVS's or fused.ply; with depth maps, the fused cloud if there is one.
  std::optional<DenseCloud> cloud;
  // Its points, relative to the scene's origin.
  DensePointStream points;
  // fused.ply, if it exists and has the normals that meshers need; else empty.
  std::filesystem::path for_meshers;
};

// Finds and opens the dense results and prints what was chosen. Throws IoError, also if no view has
// a depth map.
DenseInput OpenDenseInput(const Scene& scene, const FuserOptions& options,
                          const std::string& workspace_path, Console* console);

// Reports the length of the drawing by class, and what it adds to the dense results.
void SayLengths(const FusionResult& result, const DenseOptions& options, Console* console);

// Colors every point from the photograph of the first of its views.
void ColorCurvePoints(const Project& project, const RunContext& context,
                      std::vector<CurvePoint>* points);

// Writes drawing-fused.{ply,json,obj} and, as far as the dense results allow, with-curves/,
// pmvs-with-curves.{patch,ply} and sparse-with-curves/; prints the meshers' commands.
void WriteFusionResults(const Project& project, const RunOptions& options,
                        const FuserOptions& fuser, const DenseInput& dense,
                        const DrawingMetadata& metadata, const FusionResult& result,
                        Console* console);

}  // namespace limn::colmap_ext
