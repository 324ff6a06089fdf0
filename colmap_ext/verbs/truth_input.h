// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "colmap_ext/options/option_parser.h"
#include "limn/evaluation/evaluate_curves.h"

namespace limn::colmap_ext {

// The truth that curves are evaluated against.
struct TruthInput {
  enum class Unit { kWorld, kFootprint };

  std::string truth_path, truth_edges_path, junctions_path, dont_care_path;
  EvaluationOptions evaluation;
  Unit unit = Unit::kWorld;

  bool IsGiven() const { return !truth_path.empty(); }
  // `are_basic`: list them in the basic help, for commands whose purpose is evaluation.
  void AddOptions(bool are_basic, OptionParser* parser);
  // Precondition: a truth is given. Throws OptionError.
  void Check() const;
};

// The content of the files of a truth.
struct Truth {
  CurveSet curves;
  CurveSet dont_care;
};

// Throws IoError.
Truth ReadTruth(const TruthInput& input);

// EvaluateCurves in the requested unit. `views` are only needed for footprints.
EvaluationReport Evaluate(const CurveSet& reconstruction, const Truth& truth,
                          const TruthInput& input, const std::vector<View>& views,
                          const RunContext& context);

}  // namespace limn::colmap_ext
