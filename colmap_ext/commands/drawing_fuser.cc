#include <optional>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/commands/console.h"
#include "colmap_ext/commands/fusion_results.h"
#include "colmap_ext/commands/project.h"
#include "colmap_ext/commands/results.h"
#include "colmap_ext/commands/run_options.h"

namespace limn::colmap_ext {
namespace {

void AddFusionOptions(FuserOptions* options, OptionParser* more) {
  DenseOptions& dense = options->dense;
  more->AddOption("drawing_path", &options->drawing_path,
                  "drawing.json to fuse, instead of the one in the output folder");
  more->AddOption("dense_type", &options->paths.dense_type,
                  {"auto", "depth_maps", "fused", "pmvs", "mesh"}, "which dense results");
  more->AddOption("dense_path", &options->paths.dense_path,
                  "their file or folder, instead of those found beside the model");
  more->AddOption("remove_occluded", &options->remove_occluded,
                  "leave out links behind the surface, instead of marking them");
  more->AddOption("sparse_spacing_px", &options->sparse_spacing_px,
                  "distance of the curves' points in sparse-with-curves, px");
  more->AddOption("DenseFusion.depth_tolerance_px", &dense.depth_tolerance_px,
                  "a curve this near in depth is on the surface, footprints");
  more->AddOption("DenseFusion.side_offset_px", &dense.side_offset_px,
                  "where the surface beside a curve is looked at, px");
  more->AddOption("DenseFusion.near_px", &dense.near_px,
                  "a dense point this near is of the same place, footprints");
  more->AddOption("DenseFusion.sample_spacing_px", &dense.sample_spacing_px,
                  "distance of the samples along a link, footprints");
  more->AddOption("DenseFusion.max_occluded_share", &dense.max_occluded_share,
                  "a link is behind the surface where more of its supporting views say so");
  more->AddOption("DenseFusion.min_judged_share", &dense.min_judged_share,
                  "share of them that must be able to say anything");
}

}  // namespace

int RunDrawingFuser(int argc, const char* const* argv) {
  RunOptions options;
  FuserOptions fuser;
  const auto parser = ParseRunOptions(
      "drawing_fuser", "compare a stored drawing with dense results and combine the two", {}, argc,
      argv, &options, [&](OptionParser* more) { AddFusionOptions(&fuser, more); });
  if (!parser) return 0;
  fuser.Check();
  Console console(options.num_threads);
  const Project project(options, &console);
  if (fuser.drawing_path.empty()) fuser.drawing_path = project.DrawingPath("drawing.json");
  const DrawingFile drawing = ReadDrawingResult(project, fuser.drawing_path);
  const DenseInput dense = OpenDenseInput(project, fuser, options.layout.workspace_path, &console);
  FusionResult result = FuseDrawing({project.views(), drawing.graph, dense.depths,
                                     dense.cloud ? std::optional(dense.points) : std::nullopt},
                                    fuser.dense, console.context());
  console.Report(result.summary);
  SayLengths(result, fuser, &console);
  ColorCurvePoints(project, console.context(), &result.points);
  WriteFusionResults(project, fuser, dense, drawing.metadata, result, &console);
  return 0;
}

}  // namespace limn::colmap_ext
