#pragma once

#include <string>
#include <vector>

#include "colmap_ext/run/project.h"
#include "limn/formats/curve_sketch_file.h"
#include "limn/model/curve3d.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/drawing_graph.h"
#include "limn/pipeline/pipeline.h"

namespace limn::colmap_ext {

// The options that a result depends on, as the text of a JSON object: no paths, no number of
// threads.
std::string Provenance(const RunOptions& options);

// Of a drawing made with `options` from a sketch that says in `sketch_provenance` how it was made;
// it is not refined and has no primitives yet.
std::string DrawingProvenance(const RunOptions& options, const std::string& sketch_provenance);

// Of a drawing refined with `options` that says in `drawing_provenance` how it was made.
std::string RefinementProvenance(const RunOptions& options, const std::string& drawing_provenance);

// To be called before work starts. Throws IoError if the output folder has a file of this name (a
// drawing, .json) that was not made in the same way, with the options of `provenance` from images
// of these names, and the run's options do not say that it may be replaced: then it may hold work
// that running again does not bring back.
void CheckReplaceable(const Project& project, const RunOptions& options, const std::string& name,
                      const std::string& provenance);

// Name of a sketch's files, without extension, in the folder of curves.
std::string SketchFileName(SketchMode mode);

// Throws InputError if the graph breaks an invariant. To be called before anything is written.
void CheckGraph(const DrawingGraph& graph);

// Write <curves>/<name>.bin, around the project's origin as its views are, and .ply, in the model's
// coordinates.
void WriteSketchResults(const Project& project, const std::string& name,
                        const std::vector<ImageCurves>& curves, const CurveSketch& sketch,
                        const std::string& provenance, const RunContext& context);

// Read <curves>/<name>.bin. Throws IoError if it is missing, damaged or not made from these curves.
StoredCurveSketch ReadSketchResult(const Project& project, const std::string& name,
                                   const std::vector<ImageCurves>& curves,
                                   const RunContext& context);

// Read a drawing.json; the graph is then around the project's origin. Throws IoError if it is
// missing, damaged or of other views.
DrawingFile ReadDrawingResult(const Project& project, const std::string& path);

// Write drawing.ply, .json and .obj, <curves>/tracks.txt and <curves>/overlays/<image name>.png.
// `views` are the project's, with the cameras that the drawing fits.
void WriteDrawingResults(const Project& project, const std::vector<View>& views,
                         const DrawingGraph& graph, const std::string& provenance,
                         Console* console);

// Write <curves>/account.csv and <curves>/account/<image name>.png: what became of every edgel (see
// edgel_account.h and DrawAccount).
void WriteAccount(const Project& project, const PipelineResult& result, Console* console);

}  // namespace limn::colmap_ext
