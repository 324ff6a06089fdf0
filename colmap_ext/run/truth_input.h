#pragma once

#include <string>
#include <vector>

#include "colmap_ext/options/option_parser.h"
#include "limn/evaluation/evaluate_curves.h"

namespace limn::colmap_ext {

// What curves are judged by.
struct TruthInput {
  enum class Unit { kWorld, kFootprint };

  std::string truth_path, truth_edges_path, junctions_path, dont_care_path;
  EvaluationOptions evaluation;
  Unit unit = Unit::kWorld;

  bool IsGiven() const { return !truth_path.empty(); }
  // `are_basic`: the command is there to judge.
  void AddOptions(bool are_basic, OptionParser* parser);
  // Of a truth that is given. Throws OptionError.
  void Check() const;
};

// The files of a truth, read.
struct Truth {
  CurveSet curves;
  CurveSet dont_care;
};

// Throws IoError.
Truth ReadTruth(const TruthInput& input);

// EvaluateCurves, in the unit that was asked for. `views` are only needed for footprints.
EvaluationReport Evaluate(const CurveSet& reconstruction, const Truth& truth,
                          const TruthInput& input, const std::vector<View>& views,
                          const RunContext& context);

}  // namespace limn::colmap_ext
