#pragma once

#include <string>
#include <vector>

#include "colmap_ext/run/selection_options.h"
#include "colmap_ext/run/truth_input.h"
#include "colmap_ext/workspace/layout.h"

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

  void AddOptions(OptionParser* parser);
  // Throws OptionError.
  void Check() const;
};

// Evaluates the input file. Precondition: its path is given. With a workspace also measures
// saw-teeth and, of a drawing, the normalized errors; with true kinds compares those of the links.
// Throws IoError, also if an output must not be replaced, and InputError.
EvaluationReport EvaluateFile(const EvaluatorOptions& options);

// Writes the report to standard output and to the requested files. Throws IoError.
void WriteReport(const EvaluationReport& report, const EvaluatorOptions& options);

}  // namespace limn::colmap_ext
