// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/evaluate_hss.h"

#include <algorithm>
#include <utility>

#include "colmap_ext/host/run_options.h"
#include "colmap_ext/options/option_group.h"
#include "colmap_ext/verbs/drawing_input.h"
#include "colmap_ext/verbs/limap_model.h"
#include "colmap_ext/verbs/selection_options.h"
#include "limn/files/whole_file.h"
#include "limn/formats/read_curves.h"
#include "limn/formats/wireframe_files.h"
#include "limn/pipeline/pipeline_options.h"
#include "limn/util/errors.h"
#include "limn/util/number_text.h"

namespace limn::colmap_ext {
namespace {

// A wireframe as a file has it, or else curves.
struct WireframeSource {
  std::optional<Wireframe> wireframe;
  std::vector<Polyline3d> curves;
  std::optional<Alignment> alignment;

  bool IsEmpty() const {
    return wireframe ? wireframe->vertices.empty() && wireframe->edges.empty() : curves.empty();
  }
};

std::vector<Polyline3d> SelectedCurves(DrawingGraph graph, const HssFiles& files,
                                       Console* console) {
  WarnOfUnknownCurves(graph, files.detail, console);
  graph.faces.clear();  // they do not depend on which links are chosen
  return ToCurveSet(Selected(std::move(graph), files.selection)).polylines;
}

std::vector<Polyline3d> CurvesOnly(CurveSet set, const std::string& path) {
  if (set.polylines.empty() && !set.points.empty()) {
    throw IoError(path, "has only points; a wireframe has edges (protocol = hss)");
  }
  return std::move(set.polylines);
}

WireframeSource ReadJudgedSource(const DrawingGraph* drawing, const HssFiles& files,
                                 Console* console) {
  if (drawing) return {std::nullopt, SelectedCurves(*drawing, files, console), files.alignment};
  if (auto wireframe = ReadWireframe(files.input_path)) return {std::move(wireframe), {}, {}};
  const bool is_drawing =
      FileExtension(files.input_path) == ".json" || HoldsLimapDrawing(files.input_path);
  if (!is_drawing) {
    return {std::nullopt, CurvesOnly(ReadCurves(files.input_path), files.input_path), {}};
  }
  DrawingFile file = ReadDrawing(files.input_path);
  return {std::nullopt, SelectedCurves(std::move(file.graph), files, console),
          file.metadata.alignment};
}

WireframeSource ReadTrueSource(const HssFiles& files) {
  WireframeSource source;
  if (files.truth_edges_path.empty()) source.wireframe = ReadWireframe(files.truth_path);
  if (!source.wireframe) {
    source.curves =
        CurvesOnly(ReadCurves(files.truth_path, files.truth_edges_path), files.truth_path);
  }
  if (source.IsEmpty()) throw IoError(files.truth_path, "no corners and no edges (truth_path)");
  return source;
}

double MetersPerUnit(const WireframeSource& judged, const WireframeSource& truth,
                     const HssInput& input, Console* console) {
  if (input.scale > 0) return input.scale;
  if (judged.alignment && judged.alignment->IsMetric()) {
    const double scale = judged.alignment->world_from_model.scale;
    console->Say("scale: " + ShortNumber(scale) +
                 " m per unit, as the drawing is aligned (--scale sets another)");
    return scale;
  }
  if (!judged.wireframe || !truth.wireframe) {
    console->Say(
        "WARNING: the scale is not known: one unit of the coordinates is taken as a meter "
        "(--scale, drawing_aligner)");
  }
  return 1;
}

// A file that tells its unit needs no other scale than what is asked for.
double ScaleOf(const WireframeSource& source, double scale, const HssInput& input) {
  const bool knows_unit = source.wireframe && source.wireframe->unit != LengthUnit::kNone;
  return knows_unit && input.scale == 0 ? Millimeters(source.wireframe->unit) / 1000 : scale;
}

// The same for both, so that they are equally coarse, and not so coarse that right corners move
// too far.
double ToleranceFor(const WireframeSource& judged, const WireframeSource& truth, double scale,
                    const HssInput& input) {
  if (input.wireframe.tolerance > 0) return input.wireframe.tolerance;
  const std::vector<Polyline3d>& curves = truth.wireframe ? judged.curves : truth.curves;
  constexpr double kShareOfCornerDistance = 0.3;
  return std::min(scale * DefaultWireframeTolerance(curves),
                  kShareOfCornerDistance * input.hss.corner_distance);
}

Wireframe ToMeters(WireframeSource source, double scale, const WireframeOptions& options,
                   const std::string& what, Console* console) {
  if (source.wireframe) {
    for (Eigen::Vector3d& vertex : source.wireframe->vertices) vertex *= scale;
    return *std::move(source.wireframe);
  }
  for (Polyline3d& line : source.curves) {
    for (Eigen::Vector3d& point : line) point *= scale;
  }
  Wireframe wireframe = ReduceToWireframe(source.curves, options);
  console->Say(what + ": " + std::to_string(source.curves.size()) + " curves reduced to " +
               std::to_string(wireframe.vertices.size()) + " corners and " +
               std::to_string(wireframe.edges.size()) + " edges, tolerance " +
               ShortNumber(options.tolerance) + " m (--Wireframe.tolerance)");
  return wireframe;
}

}  // namespace

void HssInput::AddOptions(OptionParser* parser) {
  parser->AddOption("scale", &scale,
                    "hss: meters per unit of the coordinates; 0 = as the drawing is aligned, else "
                    "1");
  AddGroup("Hss", &hss, parser);
  AddGroup("Wireframe", &wireframe, parser);
}

void HssInput::Check() const {
  CheckOptionValue("scale", scale, ZeroOr(Between(1e-12, 1e12)));
  CheckGroup("Hss", hss);
  CheckGroup("Wireframe", wireframe);
}

bool HssInput::IsDefault() const {
  const HssOptions by_default;
  return scale == 0 && wireframe.tolerance == 0 &&
         hss.corner_distance == by_default.corner_distance &&
         hss.edge_radius == by_default.edge_radius && hss.edge_shape == by_default.edge_shape &&
         hss.max_change == by_default.max_change;
}

HssScores JudgeWireframe(const DrawingGraph* drawing, const HssFiles& files, const HssInput& input,
                         Console* console) {
  WireframeSource judged = ReadJudgedSource(drawing, files, console);
  WireframeSource truth = ReadTrueSource(files);
  const double scale = MetersPerUnit(judged, truth, input, console);
  const WireframeOptions reduce = {ToleranceFor(judged, truth, scale, input)};
  const double judged_scale = ScaleOf(judged, scale, input);
  const double true_scale = ScaleOf(truth, scale, input);
  HssOptions options = input.hss;
  if (const auto box = BoxFromNumbers(files.box)) {
    options.region = Eigen::AlignedBox3d(true_scale * box->min(), true_scale * box->max());
  }
  const Wireframe wireframe =
      ToMeters(std::move(judged), judged_scale, reduce, "wireframe", console);
  const Wireframe true_wireframe = ToMeters(std::move(truth), true_scale, reduce, "truth", console);
  return ScoreHss(wireframe, true_wireframe, options, console->context());
}

}  // namespace limn::colmap_ext
