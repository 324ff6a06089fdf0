// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/truth_input.h"

#include <algorithm>

#include "limn/formats/json_junctions_reader.h"
#include "limn/formats/read_curves.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {

void TruthInput::AddOptions(bool are_basic, OptionParser* parser) {
  const auto help = [&](const char* text) { return OptionHelp(text, are_basic); };
  parser->AddOption("truth_path", &truth_path, help("true curves or points"));
  parser->AddOption("truth_edges_path", &truth_edges_path,
                    help("edges between the points of a .txt truth"));
  parser->AddOption(
      "junctions_path", &junctions_path,
      help("JSON file of the truth's junctions: {\"junctions\": [{\"position\": [x, y, "
           "z], \"degree\": n}, ...]}"));
  parser->AddOption("dont_care_path", &dont_care_path,
                    help("curves near which results are ignored"));
  parser->AddOption("taus", &evaluation.taus, help("distances at which a curve counts as found"));
  parser->AddOption("unit", &unit, {{"world", Unit::kWorld}, {"footprint", Unit::kFootprint}},
                    help("unit of taus: the model's, or the size of a pixel there"));
  parser->AddOption("dont_care_taus", &evaluation.dont_care_taus,
                    "reach of don't-care curves, taus");
  parser->AddOption("junction_taus", &evaluation.junction_taus,
                    "reach of a junction or of a true end, taus");
  parser->AddOption("chain_taus", &evaluation.chain_taus,
                    "shortest true curve whose links are counted, taus");
  parser->AddOption("cover_taus", &evaluation.cover_taus,
                    "how much of a true curve a link on it covers, taus");
}

void TruthInput::Check() const {
  if (evaluation.taus.empty()) throw OptionError("--taus must be given");
  evaluation.Check();
}

Truth ReadTruth(const TruthInput& input) {
  Truth truth;
  truth.curves = ReadCurves(input.truth_path, input.truth_edges_path);
  const bool has_curves =
      std::ranges::any_of(truth.curves.polylines, [](const auto& line) { return !line.empty(); });
  if (!has_curves && truth.curves.points.empty()) {
    throw IoError(input.truth_path, "no curves and no points (truth_path)");
  }
  if (!input.junctions_path.empty()) truth.curves.nodes = ReadJunctions(input.junctions_path);
  if (!input.dont_care_path.empty()) truth.dont_care = ReadCurves(input.dont_care_path);
  return truth;
}

EvaluationReport Evaluate(const CurveSet& reconstruction, const Truth& truth,
                          const TruthInput& input, const std::vector<View>& views,
                          const RunContext& context) {
  if (input.unit == TruthInput::Unit::kWorld) {
    return EvaluateCurves(reconstruction, truth.curves, input.evaluation, truth.dont_care, context);
  }
  return EvaluateCurvesInFootprints(reconstruction, truth.curves, views, input.evaluation,
                                    truth.dont_care, context);
}

}  // namespace limn::colmap_ext
