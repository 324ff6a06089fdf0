#include <iostream>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/commands/run_options.h"
#include "colmap_ext/options/option_parser.h"
#include "colmap_ext/workspace/layout.h"
#include "colmap_ext/workspace/model.h"
#include "colmap_ext/workspace/to_views.h"
#include "limn/evaluation/evaluate_curves.h"
#include "limn/evaluation/report_writers.h"
#include "limn/io/atomic_file.h"
#include "limn/io/drawing_json_reader.h"
#include "limn/io/junctions_reader.h"
#include "limn/io/read_curves.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

enum class Unit { kWorld, kFootprint };

struct EvaluatorOptions {
  std::string input_path;
  std::string truth_path, truth_edges_path, junctions_path, dont_care_path;
  EvaluationOptions evaluation;
  std::vector<double> box;
  Unit unit = Unit::kWorld;
  LayoutOptions layout;
  std::string output_csv, output_json;
  int num_threads = -1;
};

void AddOptions(EvaluatorOptions* options, OptionParser* parser) {
  EvaluationOptions& evaluation = options->evaluation;
  parser->AddOption("input_path", &options->input_path, "curves or points to judge");
  parser->AddOption("truth_path", &options->truth_path, "true curves or points");
  parser->AddOption("truth_edges_path", &options->truth_edges_path,
                    "edges between the points of a .txt truth");
  parser->AddOption(
      "junctions_path", &options->junctions_path,
      "JSON file of the truth's junctions: {\"junctions\": [{\"position\": [x, y, z], "
      "\"degree\": n}, ...]}");
  parser->AddOption("dont_care_path", &options->dont_care_path, "curves near which nothing counts");
  parser->AddOption("taus", &evaluation.taus, "distances at which a curve counts as found");
  parser->AddOption("unit", &options->unit,
                    {{"world", Unit::kWorld}, {"footprint", Unit::kFootprint}},
                    "unit of taus: the model's, or the size of a pixel there");
  parser->AddOption("box", &options->box, "only what is inside counts: x0,x1,y0,y1,z0,z1");
  parser->AddOption("dont_care_taus", &evaluation.dont_care_taus,
                    "reach of don't-care curves, taus");
  parser->AddOption("junction_taus", &evaluation.junction_taus, "reach of a junction, taus");
  parser->AddOption(
      "workspace_path", &options->layout.workspace_path,
      "COLMAP project whose pixels are the unit footprint; with it saw-teeth and the normalised "
      "errors of a drawing.json are told too");
  parser->AddOption("image_path", &options->layout.image_path, "its images");
  parser->AddOption("model_index", &options->layout.model_index, "which of its models");
  parser->AddOption("output_csv", &options->output_csv, "also write the table to this file");
  parser->AddOption("output_json", &options->output_json, "also write all figures to this file");
  parser->AddOption("num_threads", &options->num_threads, "-1 = all cores");
}

void Check(const EvaluatorOptions& options) {
  const auto require = [](const std::string& value, const char* name) {
    if (value.empty()) throw OptionError(std::string("--") + name + " must be given");
  };
  require(options.input_path, "input_path");
  require(options.truth_path, "truth_path");
  if (options.evaluation.taus.empty()) throw OptionError("--taus must be given");
  if (options.unit == Unit::kFootprint) require(options.layout.workspace_path, "workspace_path");
  CheckOption(options.num_threads == -1 || options.num_threads >= 1, "num_threads",
              options.num_threads, "-1 or >= 1");
  options.evaluation.Check();
}

std::vector<View> ReadViews(const EvaluatorOptions& options, const RunContext& context) {
  const WorkspaceLayout layout = ResolveLayout(options.layout);
  return ToViews(ReadModel(layout.model_dir), layout.image_dir, {}, context).views;
}

EvaluationReport Evaluate(const EvaluatorOptions& options, const RunContext& context) {
  const CurveSet reconstruction = ReadCurves(options.input_path);
  CurveSet truth = ReadCurves(options.truth_path, options.truth_edges_path);
  if (!options.junctions_path.empty()) truth.nodes = ReadJunctions(options.junctions_path);
  const CurveSet dont_care =
      options.dont_care_path.empty() ? CurveSet() : ReadCurves(options.dont_care_path);
  if (options.layout.workspace_path.empty()) {
    return EvaluateCurves(reconstruction, truth, options.evaluation, dont_care, context);
  }
  const std::vector<View> views = ReadViews(options, context);
  EvaluationReport report =
      options.unit == Unit::kWorld
          ? EvaluateCurves(reconstruction, truth, options.evaluation, dont_care, context)
          : EvaluateCurvesInFootprints(reconstruction, truth, views, options.evaluation, dont_care,
                                       context);
  report.saw_teeth = MeasureSawTeeth(reconstruction.polylines, views);
  if (options.input_path.ends_with(".json")) {
    NormalisedErrorOptions of_sigmas;
    of_sigmas.region = options.evaluation.region;
    report.normalised_errors = MeasureNormalisedErrors(ReadDrawingJson(options.input_path).graph,
                                                       truth, dont_care, views, of_sigmas);
  }
  return report;
}

}  // namespace

int RunDrawingEvaluator(int argc, const char* const* argv) {
  EvaluatorOptions options;
  OptionParser parser("drawing_evaluator", "compare curves or points with ground truth");
  AddOptions(&options, &parser);
  if (parser.Parse(argc, argv, std::cout) == OptionParser::Outcome::kHelp) return 0;
  options.evaluation.region = BoxFromNumbers(options.box);
  Check(options);
  RunContext context;
  context.num_threads = options.num_threads;
  const EvaluationReport report = Evaluate(options, context);
  PrintReport(report, std::cout);
  if (!options.output_csv.empty()) {
    WriteFileAtomically(options.output_csv,
                        [&](std::ostream& out) { WriteReportCsv(report, out); });
  }
  if (!options.output_json.empty()) {
    WriteFileAtomically(options.output_json,
                        [&](std::ostream& out) { WriteReportJson(report, out); });
  }
  return 0;
}

}  // namespace limn::colmap_ext
