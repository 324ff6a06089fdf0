// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "colmap_ext/host/project.h"
#include "colmap_ext/host/provenance.h"
#include "colmap_ext/options/option_parser.h"
#include "colmap_ext/verbs/drawing_in_scene.h"
#include "limn/cache/curve_sketch_file.h"
#include "limn/evaluation/edgel_account.h"
#include "limn/model/curve3d.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/link_selection.h"
#include "limn/model/view_subset.h"
#include "limn/pipeline/pipeline.h"

namespace limn::colmap_ext {

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
                        const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                        const CurveSketch& sketch, const DrawingMetadata& metadata,
                        const RunContext& context);

// Reads <curves>/<name>.bin. Throws IoError if it is missing, damaged or not made from these
// curves.
StoredCurveSketch ReadSketchResult(const Project& project, const std::string& name,
                                   const std::vector<ImageCurves>& curves,
                                   const RunContext& context);

// Warns if a drawing has fewer faces than the one it was made from.
void SayDroppedFaces(const DrawingGraph& before, const DrawingGraph& after, Console* console);

// What the files of a drawing show of it, except for drawing.json, which has everything.
struct ResultOptions {
  Detail detail = Detail::kNormal;
  // Whether overlays mark nodes.
  bool overlay_markers = true;

  void AddOptions(OptionParser* parser);
};

// Writes drawing.ply, .json and .obj, <curves>/tracks.txt and <curves>/overlays/<image name>.png.
// All positions in the files are the model's. Existing overlays of views other than `pictures` are
// kept.
void WriteDrawingResults(const Project& project, const DrawingInScene& drawing,
                         const ResultOptions& options, Console* console,
                         const ViewSubset& pictures = std::nullopt);

// Writes <curves>/account.csv and <curves>/account/<image name>.png: what became of every edgel
// (see DrawAccount).
void WriteAccount(const Project& project, const AccountInput& input, Console* console);

}  // namespace limn::colmap_ext
