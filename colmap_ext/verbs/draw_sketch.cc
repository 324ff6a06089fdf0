// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/draw_sketch.h"

#include <utility>

#include "colmap_ext/host/provenance.h"
#include "colmap_ext/verbs/refined_cameras.h"
#include "colmap_ext/verbs/trust.h"

namespace limn::colmap_ext {

std::string ProvenanceOfDrawing(const RunOptions& options, const std::string& of_sketch) {
  const ProvenanceKeys row = {
      .taken = {"Drawing", "Paper"},
      .dropped = {"DrawingRefinement", "Belief", "Primitives", "regularize", "Regularity"}};
  return ProvenanceAfter(of_sketch, row, options);
}

DrawingInScene DrawSketchInScene(const Job& job,
                                 std::shared_ptr<const std::vector<ImageCurves>> curves,
                                 const CurveSketch& sketch, const std::string& provenance) {
  DrawingResult result =
      DrawSketch({job.WithCurves(*curves), sketch}, job.options.pipeline, job.context());
  job.console->Report(result.summary);
  CheckGraph(result.graph);
  return {std::move(result.graph), Metadata(job.scene, provenance), job.views(), std::move(curves)};
}

void DrawSketchVerb::AddOptions(OptionParser* parser) {
  align_.AddOptions(/*of_drawing=*/false, parser);
}

void DrawSketchVerb::AddFileOptions(OptionParser* parser) { results_.AddOptions(parser); }

void DrawSketchVerb::Prepare(RunOptions*, Console*) { align_.Check(); }

std::vector<std::string> DrawSketchVerb::StartsFrom(const RunOptions& options) const {
  return {"curves/" + SketchFileName(options.pipeline.mode) + ".bin"};
}

void DrawSketchVerb::Run(const Project& project, const RunOptions& options, Console* console) {
  CheckDrawingFiles(project, options);
  const std::string replaced_cameras = CamerasOfDrawing(project);
  const SceneAligner aligner(project, options.layout, align_, console);
  const Job job = JobOf(project, options, console);
  auto curves = SharedImageCurves(job);
  const StoredCurveSketch stored =
      ReadSketchResult(project, SketchFileName(options.pipeline.mode), *curves, job.context());
  const std::string provenance = ProvenanceOfDrawing(options, stored.metadata.options_json);
  CheckReplaceable(project, options, "drawing.json", provenance);
  DrawingInScene drawing = DrawSketchInScene(job, std::move(curves), stored.sketch, provenance);
  drawing.metadata.refined_cameras = stored.metadata.refined_cameras;
  drawing.metadata.alignment = aligner.Align(drawing.views, drawing.graph, console);
  WriteDrawingResults(project, drawing, results_, console);
  RemoveOtherCameras(project, replaced_cameras, drawing.metadata.refined_cameras, console);
  ReportTrust(project.view_set(), drawing, console);
  console->RepeatWarnings();
}

}  // namespace limn::colmap_ext
