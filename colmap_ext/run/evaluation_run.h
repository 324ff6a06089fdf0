#pragma once

#include <optional>
#include <string>
#include <vector>

#include "colmap_ext/run/selection_options.h"
#include "colmap_ext/run/truth_input.h"
#include "colmap_ext/workspace/layout.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// The options of drawing_evaluator.
struct EvaluatorOptions {
  // Empty: the newest drawing of the workspace.
  std::string input_path;
  TruthInput truth;
  // Of a drawing.
  SelectionOptions selection;
  // Curves with their kinds, for a confusion table; empty: none.
  std::string true_kinds_path;
  std::vector<double> box;
  LayoutOptions layout;
  std::string output_csv, output_json;
  // Replace outputs that are inputs, a drawing.json or not ours.
  bool overwrite = false;
  int num_threads = -1;
  // Instead of a workspace, in the coordinates of its model. Not a user option.
  std::optional<std::vector<View>> views;

  void AddOptions(OptionParser* parser);
  // Throws OptionError.
  void Check() const;
};

// Evaluates the input file. Precondition: its path is given. With a workspace also measures
// saw-teeth and, of a drawing, the normalized errors; with true kinds compares those of the links.
// Throws IoError, also if an output must not be replaced, and InputError.
EvaluationReport EvaluateFile(const EvaluatorOptions& options, const RunContext& context);

// The same for a drawing that is in memory, with the kinds, box and truth of the options.
EvaluationReport EvaluateDrawing(const DrawingGraph& graph, const EvaluatorOptions& options,
                                 const RunContext& context);

// Writes the report to the requested files. Throws IoError.
void WriteReportFiles(const EvaluationReport& report, const EvaluatorOptions& options);

}  // namespace limn::colmap_ext
