// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "colmap_ext/host/console.h"
#include "colmap_ext/verbs/evaluate_hss.h"
#include "colmap_ext/verbs/selection_options.h"
#include "colmap_ext/verbs/truth_input.h"
#include "colmap_ext/workspace/layout.h"
#include "limn/evaluation/face_scores.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// How a drawing is compared with the truth.
enum class Protocol {
  kCurves,  // by length (evaluate_curves.h)
  kHss,     // as wireframes (evaluation/hss.h)
};

// The options of drawing_evaluator.
struct EvaluatorOptions {
  Protocol protocol = Protocol::kCurves;
  HssInput hss;
  // Empty: the newest drawing of the workspace.
  std::string input_path;
  TruthInput truth;
  // A true surface, to judge the faces of the drawing too, or those of a mesh instead; empty: none.
  std::string truth_mesh_path, mesh_path;
  FaceScoreOptions faces;
  // Folder of a model with the true cameras, if what is judged was made with others: those of
  // refined/ beside it, else of the workspace. Empty: those of the workspace are true.
  std::string true_model_path;
  // True center lines of rods; empty: none.
  std::string rods_path;
  // Of a drawing. Truths of curves hold outlines of rods.
  SelectionOptions selection = {.rods_as_outlines = true};
  // Curves with their kinds, for a confusion table; empty: none.
  std::string true_kinds_path;
  std::vector<double> box;
  LayoutOptions layout;
  std::string output_csv, output_json;
  // Replace outputs that are also inputs, a drawing.json or files that limn did not write.
  bool overwrite = false;
  int num_threads = -1;
  // Instead of a workspace, in the coordinates of its model. Not a user option.
  std::optional<std::vector<View>> views;
  // Of a drawing in memory, if it has one. Not a user option.
  std::optional<Alignment> alignment;

  void AddOptions(OptionParser* parser);
  // Throws OptionError.
  void Check() const;
  // The links to judge: those of `selection`, but rods by their center lines if there are true
  // ones. Throws OptionError.
  LinkSelection Selection() const;
  // A mesh alone is judged: there are no curves to read.
  bool IsOfMeshOnly() const { return !mesh_path.empty() && truth.truth_path.empty(); }
};

// Evaluates a drawing in memory or, if that is null, the input file, by default the newest drawing
// of the workspace, and writes the report to the requested files. With a workspace or views also
// measures saw-teeth and, of a drawing, the normalized errors; with true kinds compares those of
// the links; with true rods scores rods; with a true surface scores faces. With a true model, all
// of this in its frame. By protocol kHss only compares wireframes. Throws IoError, also if an
// output must not be replaced, and InputError.
EvaluationReport EvaluateAndWrite(const DrawingGraph* drawing, EvaluatorOptions options,
                                  Console* console);

// drawing_evaluator: the same for a file, and shows the table.
void RunEvaluator(const EvaluatorOptions& options, Console* console);

}  // namespace limn::colmap_ext
