#include "bench/sample_study.h"

#include "colmap_ext/host/job.h"
#include "limn/drawing/drawing.h"
#include "limn/geometry/polyline.h"
#include "limn/pipeline/build_sketch.h"
#include "support/camera_errors.h"

namespace limn::bench {

SampleStudy LoadSampleStudy(const std::string& output_path, bool use_points,
                            colmap_ext::Console* console) {
  SampleStudy study;
  study.set = SelectDataSets(KnownDataSets("", LIMN_SAMPLE_DIR), "sample-day")[0];
  study.truth = ReadTruth(study.set);
  colmap_ext::RunOptions run;
  run.layout.workspace_path = study.set.workspace_path;
  run.layout.output_path = output_path;
  const colmap_ext::Project project(run, console);
  study.scene = {project.views(), ExtractImageCurves(JobOf(project, run, console)).curves, {}};
  if (use_points) study.scene.hints = project.view_set().hints;
  for (const Polyline3d& polyline : study.truth.curves.polylines) {
    const Polyline3d samples = ResampleUniform(polyline, 0.05);
    study.truth_points.insert(study.truth_points.end(), samples.begin(), samples.end());
  }
  return study;
}

DrawingGraph Draw(const SampleStudy& study, const std::vector<View>& views,
                  const RunContext& context) {
  const auto& curves = study.scene.curves;
  const CurveSketch sketch =
      BuildSketch(PipelineOptions().mode, {{views, curves, study.scene.hints}}, {}, context).sketch;
  return BuildDrawing({{views, curves}, sketch}, {}, context).graph;
}

DrawingGraph Refine(const SampleStudy& study, const std::vector<View>& views,
                    const DrawingGraph& graph, const RunContext& context) {
  return RefineDrawing({{views, study.scene.curves}, graph}, {}, {}, context).graph;
}

Json MeasureAligned(const SampleStudy& study, const std::vector<View>& views,
                    const DrawingGraph& graph, const RunContext& context) {
  const Eigen::Affine3d truth_from_world =
      testing::WorldFromTruth(views, study.scene.views).inverse();
  CurveSet set = ToCurveSet(graph);
  for (Polyline3d& polyline : set.polylines) {
    for (Eigen::Vector3d& point : polyline) point = truth_from_world * point;
  }
  for (CurveNode& node : set.nodes) {
    node.position_in_world = truth_from_world * node.position_in_world;
  }
  return MeasureAgainstTruth(study.set, study.truth, study.scene.views, set, false, context);
}

}  // namespace limn::bench
