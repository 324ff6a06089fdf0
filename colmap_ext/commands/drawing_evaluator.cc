#include <iostream>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/run/drawing_input.h"
#include "colmap_ext/run/evaluation_run.h"

namespace limn::colmap_ext {

int RunDrawingEvaluator(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  EvaluatorOptions options;
  OptionParser parser("drawing_evaluator", "compare curves or points with ground truth");
  options.AddOptions(&parser);
  if (parser.Parse(argc, argv, std::cout) == OptionParser::Outcome::kHelp) return 0;
  options.Check();
  const auto console = make_console(options.num_threads, /*speaks=*/true);
  if (options.input_path.empty()) {
    options.input_path = FindDrawing(options.layout, DrawingChoice::kNewest, "input_path");
    console->Say("drawing: " + options.input_path);
  }
  WriteReport(EvaluateFile(options, console->context()), options);
  return 0;
}

}  // namespace limn::colmap_ext
