#include <iostream>
#include <sstream>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/verbs/drawing_input.h"
#include "colmap_ext/verbs/evaluate.h"
#include "limn/evaluation/report_writers.h"

namespace limn::colmap_ext {

int RunDrawingEvaluator(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  EvaluatorOptions options;
  OptionParser parser("drawing_evaluator", "compare curves, points or faces with ground truth");
  options.AddOptions(&parser);
  if (parser.Parse(argc, argv, std::cout) == OptionParser::Outcome::kHelp) return 0;
  options.Check();
  const auto console = make_console(options.num_threads, /*speaks=*/true);
  if (options.input_path.empty() && !options.IsOfMeshOnly()) {
    options.input_path = FindDrawing(options.layout, DrawingChoice::kNewest, "input_path");
    console->Say("drawing: " + options.input_path);
  }
  const EvaluationReport report = EvaluateFile(options, console->context());
  WriteReportFiles(report, options);
  std::ostringstream table;
  PrintReport(report, table);
  console->ShowTable(table.str());
  return 0;
}

}  // namespace limn::colmap_ext
