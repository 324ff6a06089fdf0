#include "colmap_ext/run/evaluation_run.h"

#include "colmap_ext/run/drawing_input.h"
#include "colmap_ext/run/limap_model.h"
#include "colmap_ext/run/run_options.h"
#include "colmap_ext/workspace/model_folder.h"
#include "colmap_ext/workspace/output_check.h"
#include "colmap_ext/workspace/to_views.h"
#include "limn/evaluation/kind_confusion.h"
#include "limn/evaluation/report_writers.h"
#include "limn/formats/atomic_file.h"
#include "limn/formats/json_kinds_reader.h"
#include "limn/formats/read_curves.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

std::vector<View> ReadViews(const EvaluatorOptions& options, const RunContext& context) {
  if (options.views) return *options.views;
  const WorkspaceLayout layout = ResolveLayout(options.layout);
  return ToViews(ReadModel(layout.model_dir), layout.image_dir, {}, context).views;
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
                      truth.junctions_path, truth.dont_care_path, options.true_kinds_path},
                     options.overwrite);
  }
}

// At the middle one of the taus.
KindConfusion KindsOf(const DrawingGraph& drawing, const EvaluatorOptions& options,
                      const std::vector<View>& views) {
  const std::vector<double>& taus = options.truth.evaluation.taus;
  KindConfusionOptions of_kinds;
  of_kinds.tau = taus[taus.size() / 2];
  of_kinds.region = BoxFromNumbers(options.box);
  const bool in_footprints = options.truth.unit == TruthInput::Unit::kFootprint;
  return CompareKinds(drawing, ReadJsonKinds(options.true_kinds_path),
                      in_footprints ? views : std::vector<View>(), of_kinds);
}

// What is evaluated: a drawing, or else curves.
struct Judged {
  std::optional<DrawingGraph> drawing;
  CurveSet curves;
};

EvaluationReport Judge(Judged judged, const EvaluatorOptions& options, const RunContext& context) {
  TruthInput input = options.truth;
  input.evaluation.region = BoxFromNumbers(options.box);
  if (judged.drawing) {
    judged.drawing = Selected(*std::move(judged.drawing), options.selection.Selection());
    judged.curves = ToCurveSet(*judged.drawing);
  }
  const Truth truth = ReadTruth(input);
  const bool has_views = options.views || !options.layout.workspace_path.empty();
  const std::vector<View> views = has_views ? ReadViews(options, context) : std::vector<View>();
  EvaluationReport report = Evaluate(judged.curves, truth, input, views, context);
  if (!options.true_kinds_path.empty()) report.kinds = KindsOf(*judged.drawing, options, views);
  if (!has_views) return report;
  report.saw_teeth = MeasureSawTeeth(judged.curves.polylines, views);
  if (judged.drawing) {
    NormalizedErrorOptions of_sigmas;
    of_sigmas.region = input.evaluation.region;
    report.normalized_errors =
        MeasureNormalizedErrors(*judged.drawing, truth.curves, truth.dont_care, views, of_sigmas);
  }
  return report;
}

}  // namespace

void EvaluatorOptions::AddOptions(OptionParser* parser) {
  parser->AddOption("input_path", &input_path,
                    BasicOption("curves or points to judge, instead of the newest drawing of the "
                                "workspace"));
  truth.AddOptions(/*are_basic=*/true, parser);
  selection.AddOptions(parser);
  parser->AddOption("true_kinds_path", &true_kinds_path,
                    BasicOption("true curves with their kinds, .json: also compare the kinds of "
                                "the links of a drawing.json"));
  parser->AddOption("box", &box, BasicOption("only what is inside counts: x0,x1,y0,y1,z0,z1"));
  parser->AddOption(
      "workspace_path", &layout.workspace_path,
      BasicOption(
          "COLMAP project, where the drawing is and whose pixels are the "
          "unit footprint; with it saw-teeth and the normalized errors of a drawing.json are told "
          "too"));
  parser->AddOption("image_path", &layout.image_path, "its images");
  parser->AddOption("model_index", &layout.model_index, "which of its models");
  parser->AddOption("output_csv", &output_csv, BasicOption("also write the table to this file"));
  parser->AddOption("output_json", &output_json,
                    BasicOption("also write all figures to this file"));
  parser->AddOption("overwrite", &overwrite, kOverwriteHelp);
  parser->AddOption("num_threads", &num_threads, BasicOption("processor cores to use, -1 = all"));
}

void EvaluatorOptions::Check() const {
  const auto require = [](const std::string& value, const char* name) {
    if (value.empty()) throw OptionError(std::string("--") + name + " must be given");
  };
  if (input_path.empty() && layout.workspace_path.empty()) {
    throw OptionError("--input_path or --workspace_path must be given");
  }
  require(truth.truth_path, "truth_path");
  truth.Check();
  selection.Selection();  // throws
  BoxFromNumbers(box);    // throws
  if (!true_kinds_path.empty() && !IsDrawingJson(input_path)) {
    throw OptionError("true_kinds_path: only links of a drawing.json have kinds");
  }
  if (truth.unit == TruthInput::Unit::kFootprint && !views) {
    require(layout.workspace_path, "workspace_path");
  }
  if (!layout.workspace_path.empty()) layout.Check();
  LIMN_CHECK_RANGE_OR(num_threads, -1, >= 1, <= 1e4);
}

EvaluationReport EvaluateFile(const EvaluatorOptions& options, const RunContext& context) {
  CheckOutputs(options);
  Judged judged;
  if (IsDrawingJson(options.input_path) || HoldsLimapDrawing(options.input_path)) {
    judged.drawing = ReadDrawing(options.input_path).graph;
  } else {
    judged.curves = ReadCurves(options.input_path);
  }
  return Judge(std::move(judged), options, context);
}

EvaluationReport EvaluateDrawing(const DrawingGraph& graph, const EvaluatorOptions& options,
                                 const RunContext& context) {
  CheckOutputs(options);
  return Judge({graph, {}}, options, context);
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

}  // namespace limn::colmap_ext
