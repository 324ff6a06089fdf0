#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "colmap_ext/host/project.h"
#include "limn/cache/curve_sketch_file.h"
#include "limn/model/alignment.h"
#include "limn/model/curve3d.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view_subset.h"
#include "limn/pipeline/pipeline.h"
#include "limn/regularity/regularize.h"

namespace limn::colmap_ext {

// The options that a result depends on, as the text of a JSON object: no paths, no thread count.
std::string Provenance(const RunOptions& options);

// Provenance of a drawing made with `options` from a sketch with provenance `sketch_provenance`,
// before refinement and primitives.
std::string DrawingProvenance(const RunOptions& options, const std::string& sketch_provenance);

// Provenance of a refinement, with `options`, of a drawing with provenance `drawing_provenance`.
std::string RefinementProvenance(const RunOptions& options, const std::string& drawing_provenance);

// Provenance of a drawing that was made regular, with `options`.
std::string RegularityProvenance(const RunOptions& options, const std::string& drawing_provenance);

// Provenance of a drawing whose faces were found, with `options`.
std::string SurfaceProvenance(const RunOptions& options, const std::string& drawing_provenance);

// Whether a result with this provenance was made in a box.
bool HasBox(const std::string& provenance);

// Call it before the work. Throws IoError if the output folder has a drawing (.json) of this name
// that was made with options other than `provenance` or from other images, unless the options allow
// overwriting: another run might not bring it back.
void CheckReplaceable(const Project& project, const RunOptions& options, const std::string& name,
                      const std::string& provenance);

// Call it before the work: throws IoError if the drawing and its companion files would replace
// something that is not a regular file or that limn did not write (see CheckResultFile).
void CheckDrawingFiles(const Project& project, const RunOptions& options);
// The same for the files of the sketch.
void CheckSketchFiles(const Project& project, const RunOptions& options);

// All of these checks, for a run that writes sketch, drawing and refined cameras.
void CheckRunOutputs(const Project& project, const RunOptions& options);

// Name of a sketch's files in the folder of curves, without extension.
std::string SketchFileName(SketchMode mode);

// Throws InputError if the graph violates an invariant. Call it before anything is written.
void CheckGraph(const DrawingGraph& graph);

// Writes <curves>/<name>.bin, relative to the project's origin, and .ply, in the model's
// coordinates.
void WriteSketchResults(const Project& project, const std::string& name,
                        const std::vector<ImageCurves>& curves, const CurveSketch& sketch,
                        const std::string& provenance, const RunContext& context);

// Reads <curves>/<name>.bin. Throws IoError if it is missing, damaged or not made from these
// curves.
StoredCurveSketch ReadSketchResult(const Project& project, const std::string& name,
                                   const std::vector<ImageCurves>& curves,
                                   const RunContext& context);

// ReadDrawing for the scene's views. Throws IoError if the file is missing, damaged or of other
// views.
DrawingFile ReadDrawingOf(const Scene& scene, const std::string& path);

// The same; the returned graph is relative to the scene's origin.
DrawingFile ReadDrawingResult(const Scene& scene, const std::string& path);

// Reports the regularities of a drawing, and how far the ends of links moved for them.
void SayRegularities(const DrawingGraph& graph, const RegularityMoves& moves, Console* console);

// Warns if a drawing has fewer faces than the one it was made from.
void SayDroppedFaces(const DrawingGraph& before, const DrawingGraph& after, Console* console);

// Reports which links are hidden by faces from most of their views.
void SayLinksBehind(const std::vector<LinkId>& links, Console* console);

// The option --drawing_path of commands that start from a stored drawing (ReadStartingDrawing).
void AddDrawingPath(std::string* drawing_path, OptionParser* parser);

// A stored drawing that a command starts from, and the provenance of its result.
struct StartingDrawing {
  DrawingFile file;
  std::string provenance;
};
// Reads the drawing of the output folder, or of `drawing_path` if that is not empty; in the latter
// case it must not replace another drawing (CheckReplaceable). `provenance_of` is called with the
// options and the drawing's provenance. Throws IoError.
StartingDrawing ReadStartingDrawing(
    const Project& project, const RunOptions& options, const std::string& drawing_path,
    const std::function<std::string(const RunOptions&, const std::string&)>& provenance_of);

// The names of the scene's views, and the provenance of a result made from them.
DrawingMetadata Metadata(const Scene& scene, const std::string& provenance);

// Writes drawing.ply, .json and .obj, <curves>/tracks.txt and <curves>/overlays/<image name>.png.
// `views` are the project's views with the cameras that the drawing fits. An alignment is stored in
// drawing.json; all positions are the model's. Existing overlays of views other than `pictures` are
// kept.
void WriteDrawingResults(const Project& project, const std::vector<View>& views,
                         const DrawingGraph& graph, const std::string& provenance,
                         const std::optional<Alignment>& alignment, Console* console,
                         const ViewSubset& pictures = std::nullopt);

// Writes <curves>/account.csv and <curves>/account/<image name>.png: what became of every edgel
// (see edgel_account.h and DrawAccount).
void WriteAccount(const Project& project, const PipelineResult& result, Console* console);

}  // namespace limn::colmap_ext
