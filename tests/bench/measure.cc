// SPDX-License-Identifier: BSD-3-Clause
#include "bench/measure.h"

#include <sstream>

#include "bench/measures/emap_protocol.h"
#include "bench/measures/held_out_reprojection.h"
#include "bench/measures/shown_truth.h"
#include "limn/evaluation/evaluate_curves.h"
#include "limn/evaluation/report_writers.h"
#include "limn/evaluation/rod_scores.h"
#include "limn/evaluation/saw_teeth.h"
#include "limn/formats/json_junctions_reader.h"
#include "limn/formats/read_curves.h"

namespace limn::bench {
namespace {

Json OrNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

EvaluationReport Evaluate(const DataSet& set, const Truth& truth, const NamedBox& box,
                          const std::vector<View>& views, const CurveSet& reconstruction,
                          bool find_duplicates, const RunContext& context) {
  EvaluationOptions options;
  options.find_duplicates = find_duplicates;
  options.taus = set.taus;
  options.region = box.region;
  if (!set.in_footprints) {
    return EvaluateCurves(reconstruction, truth.curves, options, truth.dont_care, context);
  }
  return EvaluateCurvesInFootprints(reconstruction, truth.curves, views, options, truth.dont_care,
                                    context);
}

Json AsJson(const EvaluationReport& report) {
  std::ostringstream text;
  WriteReportJson(report, text);
  return Json::parse(text.str());
}

Json DistancesAsJson(const ReprojectionDistances& distances) {
  return {{"median_px", OrNull(distances.median_px)},
          {"p90_px", OrNull(distances.p90_px)},
          {"lonely", OrNull(distances.lonely)},
          {"count", distances.count}};
}

Json EmapAsJson(const std::optional<EmapScores>& scores) {
  if (!scores) return nullptr;
  Json json = {{"accuracy", scores->accuracy},
               {"completeness", scores->completeness},
               {"num_points", scores->num_points},
               {"rows", Json::array()}};
  for (const EmapScores::Row& row : scores->rows) {
    json["rows"].push_back({{"threshold", row.threshold},
                            {"precision", row.precision},
                            {"recall", row.recall},
                            {"f", row.f}});
  }
  return json;
}

NamedBox AroundTruth(const CurveSet& truth) {
  constexpr double kMarginPerDiagonal = 0.05;
  Eigen::AlignedBox3d box;
  for (const Polyline3d& polyline : truth.polylines) {
    for (const Eigen::Vector3d& point : polyline) box.extend(point);
  }
  for (const Eigen::Vector3d& point : truth.points) box.extend(point);
  const Eigen::Vector3d margin =
      Eigen::Vector3d::Constant(kMarginPerDiagonal * box.diagonal().norm());
  return {"truth box", Eigen::AlignedBox3d(box.min() - margin, box.max() + margin)};
}

}  // namespace

Truth ReadTruth(const DataSet& set) {
  Truth truth;
  truth.boxes = set.boxes;
  if (set.truth_path.empty()) return truth;
  truth.curves = ReadCurves(set.truth_path, set.truth_edges_path);
  if (set.judge_around_truth) truth.boxes.push_back(AroundTruth(truth.curves));
  if (!set.junctions_path.empty()) truth.curves.nodes = ReadJunctions(set.junctions_path);
  if (!set.dont_care_path.empty()) truth.dont_care = ReadCurves(set.dont_care_path);
  if (!set.rods_path.empty()) truth.rods = ReadCurves(set.rods_path);
  if (!set.emap_truth_path.empty()) truth.emap_curves = ReadCurves(set.emap_truth_path);
  return truth;
}

Json MeasureAgainstTruth(const DataSet& set, const Truth& truth, const std::vector<View>& views,
                         const CurveSet& reconstruction, bool find_duplicates,
                         const RunContext& context) {
  if (!truth.IsKnown()) return nullptr;
  Json boxes = Json::object();
  for (const NamedBox& box : truth.boxes) {
    boxes[box.name] =
        AsJson(Evaluate(set, truth, box, views, reconstruction, find_duplicates, context));
  }
  return boxes;
}

Json MeasureSigmas(const Truth& truth, const std::vector<View>& views, const DrawingGraph& graph) {
  if (truth.curves.polylines.empty()) return nullptr;
  Json boxes = Json::object();
  for (const NamedBox& box : truth.boxes) {
    NormalizedErrorOptions options;
    options.region = box.region;
    EvaluationReport report;
    report.normalized_errors =
        MeasureNormalizedErrors(graph, truth.curves, truth.dont_care, views, options);
    boxes[box.name] = AsJson(report)["normalised_errors"];
  }
  return boxes;
}

Json MeasureRods(const DataSet& set, const Truth& truth, const std::vector<View>& views,
                 const DrawingGraph& graph, const RunContext& context) {
  if (truth.rods.polylines.empty()) return nullptr;
  const RodsApart apart = TakeRodsApart(graph);
  const CurveSet rods = ToCurveSet(apart.rods);
  const CurveSet others = ToCurveSet(apart.others);
  Json boxes = Json::object();
  for (const NamedBox& box : truth.boxes) {
    EvaluationOptions options;
    options.taus = set.taus;
    options.region = box.region;
    EvaluationReport report;
    for (const RodScores& scores :
         ScoreRods({rods, others, truth.rods}, set.in_footprints ? views : std::vector<View>(),
                   options, context)) {
      report.rows.emplace_back().features.rods = scores;
    }
    const Json json = AsJson(report);
    boxes[box.name] = Json::array();
    for (const Json& row : json["rows"]) boxes[box.name].push_back(row["rods"]);
  }
  return boxes;
}

Json MeasureShape(const CurveSet& reconstruction, const std::vector<View>& views) {
  EvaluationReport report = CountCurves(reconstruction);
  report.saw_teeth = MeasureSawTeeth(reconstruction.polylines, views);
  return AsJson(report);
}

Json MeasureByEmap(const Truth& truth, const CurveSet& reconstruction) {
  if (truth.emap_curves.polylines.empty()) return nullptr;
  EmapOptions voxels;
  voxels.average_voxels = true;
  return {{"points", EmapAsJson(EvaluateByEmap(reconstruction, truth.emap_curves))},
          {"voxels", EmapAsJson(EvaluateByEmap(reconstruction, truth.emap_curves, voxels))}};
}

Json MeasureHeldOutViews(const Scene& training, const Scene& held_out,
                         const std::vector<SupportedCurve>& curves, const RunContext& context) {
  const HeldOutReport report = MeasureHeldOut(
      curves, {training.views, training.curves, held_out.views, held_out.curves}, {}, context);
  return {{"num_views", held_out.views.size()},
          {"to_edgels", DistancesAsJson(report.to_edgels)},
          {"from_edgels", DistancesAsJson(report.from_edgels)}};
}

Json MeasureCeiling(const DataSet& set, const Truth& truth, const Scene& scene,
                    const RunContext& context) {
  if (!truth.IsKnown()) return nullptr;
  Json boxes = Json::object();
  for (const NamedBox& box : truth.boxes) {
    ShownTruthOptions options;
    options.region = box.region;
    const CurveSet shown = ShownTruth(truth.curves, scene.views, scene.curves, options, context);
    boxes[box.name] = Json::array();
    const EvaluationReport report = Evaluate(set, truth, box, scene.views, shown, false, context);
    for (const TauResult& row : report.rows) {
      boxes[box.name].push_back(OrNull(row.recall));
    }
  }
  return boxes;
}

}  // namespace limn::bench
