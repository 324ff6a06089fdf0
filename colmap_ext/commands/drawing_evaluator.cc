#include <iostream>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/options/option_parser.h"
#include "colmap_ext/run/run_options.h"
#include "colmap_ext/run/truth_input.h"
#include "colmap_ext/workspace/layout.h"
#include "colmap_ext/workspace/model_folder.h"
#include "colmap_ext/workspace/to_views.h"
#include "limn/evaluation/report_writers.h"
#include "limn/formats/atomic_file.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/read_curves.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

struct EvaluatorOptions {
  std::string input_path;
  TruthInput truth;
  std::vector<double> box;
  LayoutOptions layout;
  std::string output_csv, output_json;
  int num_threads = -1;
};

void AddOptions(EvaluatorOptions* options, OptionParser* parser) {
  parser->AddOption("input_path", &options->input_path, "curves or points to judge");
  options->truth.AddOptions(parser);
  parser->AddOption("box", &options->box, "only what is inside counts: x0,x1,y0,y1,z0,z1");
  parser->AddOption(
      "workspace_path", &options->layout.workspace_path,
      "COLMAP project whose pixels are the unit footprint; with it saw-teeth and the normalized "
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
  require(options.truth.truth_path, "truth_path");
  options.truth.Check();
  if (options.truth.unit == TruthInput::Unit::kFootprint) {
    require(options.layout.workspace_path, "workspace_path");
  }
  CheckOption(options.num_threads == -1 || options.num_threads >= 1, "num_threads",
              options.num_threads, "-1 or >= 1");
}

std::vector<View> ReadViews(const EvaluatorOptions& options, const RunContext& context) {
  const WorkspaceLayout layout = ResolveLayout(options.layout);
  return ToViews(ReadModel(layout.model_dir), layout.image_dir, {}, context).views;
}

EvaluationReport EvaluateFile(const EvaluatorOptions& options, const RunContext& context) {
  const CurveSet reconstruction = ReadCurves(options.input_path);
  const Truth truth = ReadTruth(options.truth);
  const bool has_views = !options.layout.workspace_path.empty();
  const std::vector<View> views = has_views ? ReadViews(options, context) : std::vector<View>();
  EvaluationReport report = Evaluate(reconstruction, truth, options.truth, views, context);
  if (!has_views) return report;
  report.saw_teeth = MeasureSawTeeth(reconstruction.polylines, views);
  if (options.input_path.ends_with(".json")) {
    NormalisedErrorOptions of_sigmas;
    of_sigmas.region = options.truth.evaluation.region;
    report.normalised_errors = MeasureNormalisedErrors(
        ReadDrawingJson(options.input_path).graph, truth.curves, truth.dont_care, views, of_sigmas);
  }
  return report;
}

}  // namespace

int RunDrawingEvaluator(int argc, const char* const* argv) {
  EvaluatorOptions options;
  OptionParser parser("drawing_evaluator", "compare curves or points with ground truth");
  AddOptions(&options, &parser);
  if (parser.Parse(argc, argv, std::cout) == OptionParser::Outcome::kHelp) return 0;
  options.truth.evaluation.region = BoxFromNumbers(options.box);
  Check(options);
  RunContext context;
  context.num_threads = options.num_threads;
  const EvaluationReport report = EvaluateFile(options, context);
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
