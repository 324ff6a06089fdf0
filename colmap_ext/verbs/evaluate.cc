// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/evaluate.h"

#include <cmath>
#include <filesystem>
#include <sstream>
#include <utility>

#include "colmap_ext/host/run_options.h"
#include "colmap_ext/verbs/drawing_input.h"
#include "colmap_ext/verbs/limap_model.h"
#include "colmap_ext/verbs/true_frame.h"
#include "colmap_ext/workspace/output_check.h"
#include "colmap_ext/workspace/to_views.h"
#include "limn/evaluation/kind_confusion.h"
#include "limn/evaluation/report_writers.h"
#include "limn/evaluation/rod_scores.h"
#include "limn/files/atomic_file.h"
#include "limn/formats/json_kinds_reader.h"
#include "limn/formats/mesh_reader.h"
#include "limn/formats/read_curves.h"
#include "limn/geometry/median_point.h"
#include "limn/model/drawing_transform.h"
#include "limn/pipeline/pipeline_options.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

std::vector<View> ReadViews(const EvaluatorOptions& options, Console* console) {
  if (options.views) return *options.views;
  LayoutOptions of_drawing = options.layout;
  if (!options.input_path.empty()) {
    of_drawing.starts_from = DrawingsToStartFrom(DrawingChoice::kNewest, options.input_path);
  }
  const WorkspaceLayout layout = ResolveLayout(of_drawing);
  if (!layout.note.empty()) console->Say(layout.note);
  return ToViews(ReadModelOf(layout), layout.image_dir, {}, console->context()).views;
}

// Without a path it is the drawing of the workspace.
bool IsDrawingJson(const std::string& input_path) {
  return input_path.empty() || input_path.ends_with(".json");
}

void CheckOutputs(const EvaluatorOptions& options) {
  const TruthInput& truth = options.truth;
  for (const std::string& path : {options.output_csv, options.output_json}) {
    if (path.empty()) continue;
    CheckNamedOutput(path,
                     {options.input_path, truth.truth_path, truth.truth_edges_path,
                      truth.junctions_path, truth.dont_care_path, options.true_kinds_path,
                      options.rods_path, options.truth_mesh_path, options.mesh_path},
                     options.overwrite);
  }
}

// What is evaluated: a drawing, or else curves; and a mesh instead of faces.
struct Judged {
  // All of the drawing, and what was chosen of it.
  std::optional<DrawingGraph> whole_drawing;
  std::optional<DrawingGraph> drawing;
  // The same in two, if there are true rods; `curves` are then the others.
  std::optional<RodsApart> apart;
  CurveSet curves;
  std::optional<TriangleMesh> mesh;
};

// What it is judged by: curves, with or without rods, a surface or both.
struct Truths {
  std::optional<Truth> of_curves;
  std::optional<CurveSet> rods;
  std::optional<TriangleMesh> surface;
};

// The views that footprints are measured in; none for the unit world.
std::vector<View> ViewsOfUnit(const std::vector<View>& views, const EvaluatorOptions& options) {
  return options.truth.unit == TruthInput::Unit::kFootprint ? views : std::vector<View>();
}

// At the middle one of the taus.
KindConfusion KindsOf(const DrawingGraph& drawing, const Truths& truths,
                      const EvaluatorOptions& options, const std::vector<View>& views) {
  const std::vector<double>& taus = options.truth.evaluation.taus;
  KindConfusionOptions of_kinds;
  of_kinds.tau = taus[taus.size() / 2];
  of_kinds.region = BoxFromNumbers(options.box);
  CurvesByKind kinds = ReadJsonKinds(options.true_kinds_path);
  std::vector<Polyline3d>& rods = kinds[static_cast<int>(LinkKind::kRod)].polylines;
  if (truths.rods) {
    rods.insert(rods.end(), truths.rods->polylines.begin(), truths.rods->polylines.end());
  }
  return CompareKinds(drawing, kinds, ViewsOfUnit(views, options), of_kinds);
}

// At the middle one of the taus. Nothing if the drawing tells no confidences.
std::optional<Reliability> ReliabilityOf(const DrawingGraph& whole_drawing, const Truth& truth,
                                         const EvaluatorOptions& options,
                                         const std::vector<View>& views,
                                         const RunContext& context) {
  const EvaluationOptions& of_curves = options.truth.evaluation;
  ReliabilityOptions of_confidences;
  of_confidences.tau = of_curves.taus[of_curves.taus.size() / 2];
  of_confidences.dont_care_taus = of_curves.dont_care_taus;
  of_confidences.region = BoxFromNumbers(options.box);
  const Reliability reliability =
      CompareConfidences(whole_drawing, truth.curves, truth.dont_care, ViewsOfUnit(views, options),
                         of_confidences, context);
  if (reliability.Length() > 0) return reliability;
  return std::nullopt;
}

void AddRods(const Judged& judged, const CurveSet& truth, const EvaluationOptions& options,
             const std::vector<View>& views, const RunContext& context, EvaluationReport* report) {
  const CurveSet rods = judged.apart ? ToCurveSet(judged.apart->rods) : CurveSet();
  const std::vector<RodScores> scores =
      ScoreRods({rods, judged.curves, truth}, views, options, context);
  for (size_t i = 0; i < scores.size(); ++i) report->rows[i].features.rods = scores[i];
}

Truths ReadTruths(const EvaluatorOptions& options) {
  Truths truths;
  if (options.truth.IsGiven()) truths.of_curves = ReadTruth(options.truth);
  if (!options.rods_path.empty()) truths.rods = ReadCurves(options.rods_path);
  if (!options.truth_mesh_path.empty()) truths.surface = ReadMesh(options.truth_mesh_path);
  return truths;
}

// If there is nothing to judge, that of the cameras.
Eigen::Vector3d MiddleOf(const Judged& judged, const std::vector<View>& views) {
  const CurveSet curves = judged.drawing ? ToCurveSet(*judged.drawing) : judged.curves;
  std::vector<Eigen::Vector3d> points = curves.points;
  for (const Polyline3d& line : curves.polylines) {
    points.insert(points.end(), line.begin(), line.end());
  }
  if (points.empty() && judged.mesh) points = judged.mesh->vertices;
  if (points.empty()) {
    for (const View& view : views) points.push_back(view.CenterInWorld());
  }
  return MedianPoint(points);
}

void Move(const Eigen::Affine3d& similarity, std::vector<Eigen::Vector3d>* points) {
  for (Eigen::Vector3d& point : *points) point = similarity * point;
}

void Move(const Eigen::Affine3d& similarity, Judged* judged) {
  if (judged->drawing) {
    const double scale = std::cbrt(similarity.linear().determinant());
    judged->drawing = Transformed(*std::move(judged->drawing), scale, similarity.linear() / scale,
                                  similarity.translation());
  }
  for (Polyline3d& line : judged->curves.polylines) Move(similarity, &line);
  for (CurveNode& node : judged->curves.nodes) {
    node.position_in_world = similarity * node.position_in_world;
  }
  Move(similarity, &judged->curves.points);
  if (judged->mesh) Move(similarity, &judged->mesh->vertices);
}

EvaluationReport JudgeCurves(const Judged& judged, const Truths& truths,
                             const EvaluatorOptions& options, const std::vector<View>& views,
                             const RunContext& context) {
  const Truth& truth = *truths.of_curves;
  TruthInput input = options.truth;
  input.evaluation.region = BoxFromNumbers(options.box);
  EvaluationReport report = Evaluate(judged.curves, truth, input, views, context);
  if (truths.rods) {
    AddRods(judged, *truths.rods, input.evaluation, ViewsOfUnit(views, options), context, &report);
  }
  if (judged.whole_drawing) {
    report.reliability = ReliabilityOf(*judged.whole_drawing, truth, options, views, context);
  }
  if (!options.true_kinds_path.empty()) {
    report.kinds = KindsOf(*judged.drawing, truths, options, views);
  }
  if (judged.drawing && !views.empty()) {
    NormalizedErrorOptions of_sigmas;
    of_sigmas.region = input.evaluation.region;
    report.normalized_errors =
        MeasureNormalizedErrors(judged.apart ? judged.apart->others : *judged.drawing, truth.curves,
                                truth.dont_care, views, of_sigmas);
  }
  return report;
}

FaceScores JudgeFaces(const PartedSurface& surface, const TriangleMesh& truth,
                      const EvaluatorOptions& options, const std::vector<View>& views,
                      const RunContext& context) {
  FaceScoreOptions of_faces = options.faces;
  of_faces.region = BoxFromNumbers(options.box);
  return ScoreFaces(surface, truth, views, of_faces, context);
}

EvaluationReport Judge(Judged judged, const EvaluatorOptions& options, Console* console) {
  const RunContext& context = console->context();
  const Truths truths = ReadTruths(options);
  const bool has_views = options.views || !options.layout.workspace_path.empty();
  std::vector<View> views = has_views ? ReadViews(options, console) : std::vector<View>();
  std::optional<CameraAccuracy> cameras;
  if (!options.true_model_path.empty()) {
    TrueFrame frame = FindTrueFrame(views, options.true_model_path, MiddleOf(judged, views));
    Move(frame.true_from_model, &judged);
    views = std::move(frame.views);
    cameras = frame.cameras;
  }
  std::vector<DrawingFace> faces;
  if (judged.drawing) {
    // Faces do not depend on which links are chosen.
    faces = std::move(judged.drawing->faces);
    judged.drawing->faces.clear();
    WarnOfUnknownCurves(*judged.drawing, options.selection.detail, console);
    judged.whole_drawing = judged.drawing;
    judged.drawing = Selected(*std::move(judged.drawing), options.Selection());
    if (truths.rods) judged.apart = TakeRodsApart(*judged.drawing);
    judged.curves = ToCurveSet(judged.apart ? judged.apart->others : *judged.drawing);
  }
  EvaluationReport report = truths.of_curves ? JudgeCurves(judged, truths, options, views, context)
                                             : CountCurves(judged.curves);
  report.cameras = cameras;
  if (has_views) report.saw_teeth = MeasureSawTeeth(judged.curves.polylines, views);
  if (truths.surface) {
    const PartedSurface surface = judged.mesh ? SurfaceOf(*judged.mesh) : SurfaceOf(faces);
    report.faces = JudgeFaces(surface, *truths.surface, options, views, context);
  }
  return report;
}

void AddFaceOptions(FaceScoreOptions* faces, OptionParser* parser) {
  parser->AddOption("Faces.taus", &faces->taus,
                    "distances at which a place of a surface counts as found, px");
  parser->AddOption("Faces.max_angle_deg", &faces->max_angle_deg,
                    "largest angle between the surfaces there");
  parser->AddOption("Faces.min_views", &faces->min_views,
                    "views that must see a place of the true surface");
  parser->AddOption("Faces.min_grazing_deg", &faces->min_grazing_deg,
                    "smallest angle between a surface and the ray of a view that sees it");
  parser->AddOption("Faces.occlusion_px", &faces->occlusion_px,
                    "how far behind the true surface a visible place may be, px");
  parser->AddOption("Faces.spacing_px", &faces->spacing_px,
                    "longest side of the triangles that surfaces are cut into, px");
  parser->AddOption("Faces.max_bend_deg", &faces->max_bend_deg,
                    "smooth regions of the true surface bend by less between triangles");
  parser->AddOption("Faces.min_region_px", &faces->min_region_px,
                    "side of the square that is as large as the smallest region that counts, px");
}

// Nothing of what is to be judged is missing.
void CheckInputs(const EvaluatorOptions& options) {
  const bool has_workspace = !options.layout.workspace_path.empty();
  if (options.truth.truth_path.empty() && options.truth_mesh_path.empty() &&
      options.true_model_path.empty()) {
    throw OptionError("--truth_path or --truth_mesh_path must be given");
  }
  if (options.input_path.empty() && !has_workspace) {
    throw OptionError("--input_path or --workspace_path must be given");
  }
  if (!options.true_kinds_path.empty() &&
      (!IsDrawingJson(options.input_path) || !options.truth.IsGiven())) {
    throw OptionError(
        "true_kinds_path: only links of a drawing.json, compared with truth_path, "
        "have kinds");
  }
  if (!options.rods_path.empty() && !options.truth.IsGiven()) {
    throw OptionError("rods_path: needs truth_path");
  }
  const bool in_footprints = options.truth.unit == TruthInput::Unit::kFootprint;
  const bool needs_views =
      !options.truth_mesh_path.empty() || (options.truth.IsGiven() && in_footprints);
  if (needs_views && !has_workspace && !options.views) {
    throw OptionError("--workspace_path must be given");
  }
  if (!options.true_model_path.empty() && !has_workspace && !options.views) {
    throw OptionError(
        "true_model_path: needs workspace_path, with the images and the cameras that the drawing "
        "was made with");
  }
  if (!options.mesh_path.empty() && options.truth_mesh_path.empty()) {
    throw OptionError("mesh_path: needs truth_mesh_path");
  }
  if (!options.truth_mesh_path.empty() && options.mesh_path.empty() &&
      !IsDrawingJson(options.input_path)) {
    throw OptionError("truth_mesh_path: only a drawing.json or mesh_path has faces");
  }
}

// Nothing is given that wireframes are not judged by.
void CheckHssInputs(const EvaluatorOptions& options) {
  const auto refuse = [](const std::string& name) {
    throw OptionError(name + ": only by protocol = curves");
  };
  const TruthInput& truth = options.truth;
  for (const auto& [name, path] : {std::pair("junctions_path", truth.junctions_path),
                                   {"dont_care_path", truth.dont_care_path},
                                   {"truth_mesh_path", options.truth_mesh_path},
                                   {"mesh_path", options.mesh_path},
                                   {"true_kinds_path", options.true_kinds_path},
                                   {"rods_path", options.rods_path},
                                   {"true_model_path", options.true_model_path}}) {
    if (!path.empty()) refuse(name);
  }
  if (truth.unit != TruthInput::Unit::kWorld) refuse("unit = footprint");
  if (!truth.evaluation.taus.empty()) {
    throw OptionError(
        "taus: only by protocol = curves; hss has Hss.corner_distance and Hss.edge_radius");
  }
  if (!truth.IsGiven()) throw OptionError("--truth_path must be given");
}

EvaluationReport JudgeHss(const DrawingGraph* drawing, const EvaluatorOptions& options,
                          Console* console) {
  HssFiles files;
  files.input_path = options.input_path;
  files.truth_path = options.truth.truth_path;
  files.truth_edges_path = options.truth.truth_edges_path;
  files.selection = options.Selection();
  files.detail = options.selection.detail;
  files.box = options.box;
  files.alignment = options.alignment;
  EvaluationReport report;
  report.hss = JudgeWireframe(drawing, files, options.hss, console);
  return report;
}

// A drawing in memory, or the input file if that is null.
Judged ReadJudged(const DrawingGraph* drawing, const EvaluatorOptions& options) {
  Judged judged;
  if (!options.mesh_path.empty()) judged.mesh = ReadMesh(options.mesh_path);
  if (drawing) {
    judged.drawing = *drawing;
    return judged;
  }
  if (options.IsOfMeshOnly()) return judged;
  if (IsDrawingJson(options.input_path) || HoldsLimapDrawing(options.input_path)) {
    judged.drawing = ReadDrawing(options.input_path).graph;
  } else {
    judged.curves = ReadCurves(options.input_path);
  }
  return judged;
}

void WriteReportFiles(const EvaluationReport& report, const EvaluatorOptions& options) {
  if (!options.output_csv.empty()) {
    WriteFileAtomically(options.output_csv,
                        [&](std::ostream& out) { WriteReportCsv(report, out); });
  }
  if (!options.output_json.empty()) {
    WriteFileAtomically(options.output_json,
                        [&](std::ostream& out) { WriteReportJson(report, out); });
  }
}

}  // namespace

void EvaluatorOptions::AddOptions(OptionParser* parser) {
  parser->AddOption("input_path", &input_path,
                    BasicOption("curves or points to judge, instead of the newest drawing of the "
                                "workspace"));
  parser->AddOption("protocol", &protocol, {{"curves", Protocol::kCurves}, {"hss", Protocol::kHss}},
                    BasicOption("how: curves = by length, at each of taus; hss = as wireframes in "
                                "meters, by corner F1, edge IoU and their mean (S23DR challenge)"));
  hss.AddOptions(parser);
  truth.AddOptions(/*are_basic=*/true, parser);
  parser->AddOption("truth_mesh_path", &truth_mesh_path,
                    BasicOption("true surface, .ply or .obj: judge the faces of the drawing; needs "
                                "the workspace, truth_path may be left out"));
  parser->AddOption("mesh_path", &mesh_path,
                    BasicOption("surface to judge instead of the faces of the drawing"));
  AddFaceOptions(&faces, parser);
  selection.AddOptions(parser);
  parser->AddOption("true_kinds_path", &true_kinds_path,
                    "true curves with their kinds, .json: also compare the kinds of the links of a "
                    "drawing.json");
  parser->AddOption("rods_path", &rods_path,
                    "true center lines of rods, with a vertex property radius if they "
                    "are .ply and it is known: judge rods by these, and neither rods "
                    "nor their outlines as curves");
  parser->AddOption("box", &box, BasicOption("only what is inside counts: x0,x1,y0,y1,z0,z1"));
  parser->AddOption(
      "workspace_path", &layout.workspace_path,
      BasicOption(
          "COLMAP project, where the drawing is and whose pixels are the "
          "unit footprint; with it saw-teeth and the normalized errors of a drawing.json are told "
          "too"));
  parser->AddOption("true_model_path", &true_model_path,
                    "folder of a model with the true cameras: judge in their frame what was drawn "
                    "with those of the workspace, or of refined/ beside the drawing, and say how "
                    "far these are off");
  parser->AddOption("image_path", &layout.image_path, "its images");
  parser->AddOption("model_index", &layout.model_index, "which of its models");
  parser->AddOption("output_csv", &output_csv, BasicOption("also write the table to this file"));
  parser->AddOption("output_json", &output_json,
                    BasicOption("also write all figures to this file"));
  parser->AddOption("overwrite", &overwrite, kOverwriteHelp);
  parser->AddOption("num_threads", &num_threads, BasicOption("processor cores to use, -1 = all"));
}

void EvaluatorOptions::Check() const {
  if (truth.IsGiven() && protocol == Protocol::kCurves) truth.Check();
  hss.Check();
  CheckGroup("Faces", faces);
  Selection();          // throws
  BoxFromNumbers(box);  // throws
  LIMN_CHECK_RANGE_OR(num_threads, -1, >= 1, <= 1e4);
  if (!layout.workspace_path.empty()) layout.Check();
  CheckInputs(*this);
  if (protocol == Protocol::kHss) CheckHssInputs(*this);
  if (protocol != Protocol::kHss && !hss.IsDefault()) {
    throw OptionError("scale, Hss and Wireframe: only by protocol = hss");
  }
}

LinkSelection EvaluatorOptions::Selection() const {
  LinkSelection selected = selection.Selection();
  if (!rods_path.empty()) selected.rods_as_outlines = false;
  return selected;
}

EvaluationReport EvaluateAndWrite(const DrawingGraph* drawing, EvaluatorOptions options,
                                  Console* console) {
  if (!drawing && options.input_path.empty() && !options.IsOfMeshOnly()) {
    options.input_path = FindDrawing(options.layout, DrawingChoice::kNewest, "input_path");
    console->Say("drawing: " + options.input_path);
  }
  CheckOutputs(options);
  const EvaluationReport report = options.protocol == Protocol::kHss
                                      ? JudgeHss(drawing, options, console)
                                      : Judge(ReadJudged(drawing, options), options, console);
  ThrowIfCancelled(console->context());
  WriteReportFiles(report, options);
  return report;
}

void RunEvaluator(const EvaluatorOptions& options, Console* console) {
  std::ostringstream table;
  PrintReport(EvaluateAndWrite(nullptr, options, console), table);
  console->ShowTable(table.str());
}

}  // namespace limn::colmap_ext
