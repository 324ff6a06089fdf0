// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/report_writers.h"

#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>

#include <nlohmann/json.hpp>

#include "limn/evaluation/feature_writers.h"
#include "limn/evaluation/hss_writers.h"
#include "limn/evaluation/report_cells.h"

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

Json OrNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json OrNull(const std::optional<int>& value) { return value ? Json(*value) : Json(nullptr); }

void AddInterval(const std::string& name, const std::optional<Interval>& interval, Json* json) {
  (*json)[name + "_low"] = interval ? Json(interval->low) : Json(nullptr);
  (*json)[name + "_high"] = interval ? Json(interval->high) : Json(nullptr);
}

void AddStructure(const StructureScores& scores, Json* json) {
  (*json)["links_per_chain"] = OrNull(scores.links_per_chain);
  (*json)["curves_per_chain"] = OrNull(scores.curves_per_chain);
  (*json)["num_chains"] = scores.num_chains;
  (*json)["num_drawn_chains"] = scores.num_drawn_chains;
  (*json)["num_free_ends"] = OrNull(scores.num_free_ends);
  (*json)["num_false_ends"] = OrNull(scores.num_false_ends);
  (*json)["false_ends_per_length"] = OrNull(scores.false_ends_per_length);
  (*json)["num_false_junctions"] = OrNull(scores.num_false_junctions);
  (*json)["false_junctions_per_length"] = OrNull(scores.false_junctions_per_length);
  (*json)["num_matched_junctions"] = scores.num_matched_junctions;
  (*json)["right_degrees"] = OrNull(scores.right_degrees);
  (*json)["arm_precision"] = OrNull(scores.arm_precision);
  (*json)["arm_recall"] = OrNull(scores.arm_recall);
  (*json)["connectivity"] = OrNull(scores.connectivity);
  (*json)["num_drawn_meetings"] = scores.num_drawn_meetings;
}

Json RowAsJson(const TauResult& row) {
  Json json = {{"tau", row.tau},
               {"precision", OrNull(row.precision)},
               {"recall", OrNull(row.recall)},
               {"f", OrNull(row.f)},
               {"sample_precision", OrNull(row.sample_precision)},
               {"accuracy", OrNull(row.accuracy)},
               {"median_accuracy", OrNull(row.median_accuracy)},
               {"completeness", OrNull(row.completeness)},
               {"median_completeness", OrNull(row.median_completeness)},
               {"duplicated", OrNull(row.duplicated)},
               {"reconstructed_length", row.reconstructed_length},
               {"true_length", row.true_length},
               {"junction_precision", OrNull(row.junction_precision)},
               {"junction_recall", OrNull(row.junction_recall)},
               {"num_junctions", row.num_junctions},
               {"num_true_junctions", row.num_true_junctions}};
  AddInterval("precision", row.precision_interval, &json);
  AddInterval("recall", row.recall_interval, &json);
  AddInterval("f", row.f_interval, &json);
  AddStructure(row.structure, &json);
  return json;
}

std::string Bounds(const std::optional<Interval>& interval) {
  return interval ? Percent(interval->low) + '-' + Percent(interval->high) : "-";
}

// A table whose first cells are "tau 2".
void PrintStructure(const EvaluationReport& report, std::ostream& out) {
  constexpr int kWidth = 11;
  const auto print_row = [&](const std::vector<std::string>& cells) {
    PrintRow(cells, kWidth, out);
  };
  print_row({"interval", "P %", "R %", "F %", "links", "curves", "false ends", "per length",
             "false junc.", "per length", "degree %", "arms P %", "arms R %", "joined %"});
  for (const TauResult& row : report.rows) {
    const StructureScores& scores = row.structure;
    print_row({"tau " + Cell(row.tau, 4), Bounds(row.precision_interval),
               Bounds(row.recall_interval), Bounds(row.f_interval), Cell(scores.links_per_chain, 3),
               Cell(scores.curves_per_chain, 3), Cell(scores.num_false_ends),
               Cell(scores.false_ends_per_length, 3), Cell(scores.num_false_junctions),
               Cell(scores.false_junctions_per_length, 3), Percent(scores.right_degrees),
               Percent(scores.arm_precision), Percent(scores.arm_recall),
               Percent(scores.connectivity)});
  }
}

void PrintSawTeeth(const SawTeeth& teeth, std::ostream& out) {
  constexpr int kDigits = 4;
  out << "saw-teeth (length over smoothed length): median " << Cell(teeth.median, kDigits)
      << ", 90th percentile " << Cell(teeth.p90, kDigits) << " of " << teeth.num_curves
      << " links; by length " << Cell(teeth.median_by_length, kDigits) << ", "
      << Cell(teeth.p90_by_length, kDigits) << '\n';
}

Json SawTeethAsJson(const SawTeeth& teeth) {
  return {{"median", OrNull(teeth.median)},
          {"p90", OrNull(teeth.p90)},
          {"median_by_length", OrNull(teeth.median_by_length)},
          {"p90_by_length", OrNull(teeth.p90_by_length)},
          {"num_links", teeth.num_curves}};
}

void PrintNormalizedErrors(const NormalizedErrors& errors, std::ostream& out) {
  constexpr int kDigits = 3;
  out << "normalised errors (squares, 1 if sigmas are right): mean "
      << Cell(errors.variance, kDigits) << ", by the median "
      << Cell(errors.median_variance, kDigits) << " of " << errors.num_inliers
      << " vertices near the truth; mean with " << errors.num_false << " false ones "
      << Cell(errors.variance_with_false, kDigits) << '\n';
}

Json NormalizedErrorsAsJson(const NormalizedErrors& errors) {
  return {{"variance", OrNull(errors.variance)},
          {"median_variance", OrNull(errors.median_variance)},
          {"variance_with_false", OrNull(errors.variance_with_false)},
          {"num_inliers", errors.num_inliers},
          {"num_false", errors.num_false}};
}

void PrintCameras(const CameraAccuracy& cameras, std::ostream& out) {
  constexpr int kDigits = 3;
  out << "cameras off, median of " << cameras.num_views << ": centers "
      << Cell(cameras.center, kDigits) << ", rotations " << Cell(cameras.rotation_deg, kDigits)
      << " degrees = " << Cell(cameras.rotation_px, kDigits) << " px, rays "
      << Cell(cameras.ray_px, kDigits) << " px, focal lengths "
      << Cell(100 * cameras.focal, kDigits) << " %; " << cameras.num_wrong
      << " are too far off to count for the frame\n";
}

Json CamerasAsJson(const CameraAccuracy& cameras) {
  return {{"num_images", cameras.num_views},
          {"num_wrong", cameras.num_wrong},
          {"center", cameras.center},
          {"rotation_deg", cameras.rotation_deg},
          {"rotation_px", cameras.rotation_px},
          {"ray_px", cameras.ray_px},
          {"focal", cameras.focal}};
}

Json ReliabilityAsJson(const Reliability& reliability) {
  Json bins = Json::array();
  for (const ReliabilityBin& bin : reliability.bins) {
    bins.push_back({{"length", bin.length}, {"told", bin.told}, {"right", bin.right}});
  }
  return {{"tau", reliability.tau},
          {"calibration_error", reliability.CalibrationError()},
          {"bins", bins}};
}

// Per true kind ("none": no true curve is near) the drawn length by kind of the link.
Json KindsAsJson(const KindConfusion& kinds) {
  Json lengths;
  for (int t = 0; t < kNumLinkKinds; ++t) {
    const auto true_kind = static_cast<LinkKind>(t);
    Json& row = lengths[true_kind == LinkKind::kUnknown ? "none" : LinkKindName(true_kind)];
    for (int k = 0; k < kNumLinkKinds; ++k) {
      row[LinkKindName(static_cast<LinkKind>(k))] = kinds.length[t][k];
    }
  }
  return {{"tau", kinds.tau}, {"length", lengths}};
}

void PrintFaces(const FaceScores& scores, std::ostream& out) {
  constexpr int kWidth = 10;
  const auto print_row = [&](const std::vector<std::string>& cells) {
    PrintRow(cells, kWidth, out);
  };
  print_row({"faces", "P %", "R %", "F %", "right", "covered"});
  for (const FaceTauResult& row : scores.rows) {
    print_row({Cell(row.tau, 4) + " rho", Percent(row.precision), Percent(row.recall),
               Percent(row.f), std::to_string(row.num_right_faces),
               std::to_string(row.num_covered_regions)});
  }
  out << "faces " << scores.faces.size() << ", area " << Cell(scores.area, 5)
      << "; true surface that is seen " << Cell(scores.true_area, 5) << ", smooth regions "
      << scores.regions.size() << "; directions within " << Cell(scores.max_angle_deg, 4)
      << " degrees\n";
}

Json FaceRowAsJson(const FaceTauResult& row) {
  return {{"tau", row.tau},
          {"precision", OrNull(row.precision)},
          {"recall", OrNull(row.recall)},
          {"f", OrNull(row.f)},
          {"num_right_faces", row.num_right_faces},
          {"num_covered_regions", row.num_covered_regions}};
}

Json PartsAsJson(const char* id, const std::vector<PartScore>& parts) {
  Json json = Json::array();
  for (const PartScore& part : parts) {
    json.push_back({{id, part.part}, {"area", part.area}, {"within", part.within}});
  }
  return json;
}

Json FacesAsJson(const FaceScores& scores) {
  Json json = {{"unit", "footprint"}, {"max_angle_deg", scores.max_angle_deg}};
  json["rows"] = Json::array();
  for (const FaceTauResult& row : scores.rows) json["rows"].push_back(FaceRowAsJson(row));
  json["area"] = scores.area;
  json["true_area"] = scores.true_area;
  json["num_faces"] = scores.faces.size();
  json["num_regions"] = scores.regions.size();
  json["faces"] = PartsAsJson("face", scores.faces);
  json["regions"] = PartsAsJson("region", scores.regions);
  return json;
}

void WriteFacesCsv(const FaceScores& scores, std::ostream& out) {
  const Json names = FaceRowAsJson({});
  for (const auto& [name, value] : names.items()) out << name << ',';
  out << "max_angle_deg,faces,area,true_area,regions\n";
  for (const FaceTauResult& row : scores.rows) {
    const Json values = FaceRowAsJson(row);
    for (const auto& [name, value] : values.items()) {
      if (!value.is_null()) out << value;
      out << ',';
    }
    out << scores.max_angle_deg << ',' << scores.faces.size() << ',' << scores.area << ','
        << scores.true_area << ',' << scores.regions.size() << '\n';
  }
}

void PrintCurves(const EvaluationReport& report, std::ostream& out) {
  constexpr int kWidth = 10;
  const auto print_row = [&](const std::vector<std::string>& cells) {
    PrintRow(cells, kWidth, out);
  };
  print_row({report.in_footprints ? "tau [rho]" : "tau", "P %", "R %", "F %", "P smpl. %",
             "dupl. %", "accuracy", "complete", "length", "true len.", "junc. P %", "junc. R %"});
  for (const TauResult& row : report.rows) {
    print_row({Cell(row.tau, 4), Percent(row.precision), Percent(row.recall), Percent(row.f),
               Percent(row.sample_precision), Percent(row.duplicated), Cell(row.accuracy, 4),
               Cell(row.completeness, 4), Cell(row.reconstructed_length, 5),
               Cell(row.true_length, 5), Percent(row.junction_precision),
               Percent(row.junction_recall)});
  }
  PrintStructure(report, out);
  if (!report.rows.empty()) {
    const TauResult& middle = report.rows[report.rows.size() / 2];
    PrintFeatures(middle.features, middle.tau, out);
  }
  out << "links " << report.num_links << ", mean length " << Cell(report.mean_link_length, 4)
      << ", total " << Cell(report.total_length, 5) << ", components " << report.num_components
      << '\n';
  out << "nodes by degree:";
  for (const auto& [degree, count] : report.nodes_by_degree) out << ' ' << degree << ": " << count;
  out << '\n';
  if (report.saw_teeth) PrintSawTeeth(*report.saw_teeth, out);
  if (report.normalized_errors) PrintNormalizedErrors(*report.normalized_errors, out);
  if (report.reliability) PrintReliability(*report.reliability, out);
  if (report.kinds) PrintKindConfusion(*report.kinds, out);
  if (report.num_links == 0) out << "points " << report.num_points << '\n';
  if (report.num_ignored_points > 0) {
    out << "left out: " << report.num_ignored_points << " points that belong to no polyline\n";
  }
}

}  // namespace

void PrintReport(const EvaluationReport& report, std::ostream& out) {
  if (report.hss) {
    PrintHss(*report.hss, out);
    return;
  }
  const bool of_faces_only = report.faces && report.rows.empty();
  if (!of_faces_only) PrintCurves(report, out);
  if (report.faces) PrintFaces(*report.faces, out);
  if (report.cameras) PrintCameras(*report.cameras, out);
}

void WriteReportCsv(const EvaluationReport& report, std::ostream& out) {
  std::ostringstream text;
  text << std::setprecision(std::numeric_limits<double>::max_digits10);
  if (report.hss) WriteHssCsv(*report.hss, text);
  if (report.rows.empty() && report.faces) WriteFacesCsv(*report.faces, text);
  const SawTeeth teeth = report.saw_teeth.value_or(SawTeeth());
  bool first = true;
  for (const TauResult& row : report.rows) {
    const Json json = RowAsJson(row);
    if (first) {
      for (const auto& [name, value] : json.items()) text << name << ',';
      text << "unit,links,mean_link_length,total_length,components,"
              "saw_teeth_median,saw_teeth_p90\n";
      first = false;
    }
    for (const auto& [name, value] : json.items()) {
      if (!value.is_null()) text << value;
      text << ',';
    }
    text << (report.in_footprints ? "footprint" : "world") << ',' << report.num_links << ','
         << report.mean_link_length << ',' << report.total_length << ',' << report.num_components
         << ',';
    if (teeth.median) text << *teeth.median;
    text << ',';
    if (teeth.p90) text << *teeth.p90;
    text << '\n';
  }
  out << text.str();
}

void WriteReportJson(const EvaluationReport& report, std::ostream& out) {
  Json json;
  if (report.hss) {
    out << Json{{"unit", "m"}, {"hss", HssAsJson(*report.hss)}}.dump(2) << '\n';
    return;
  }
  json["unit"] = report.in_footprints ? "footprint" : "world";
  json["rows"] = Json::array();
  for (const TauResult& row : report.rows) {
    json["rows"].push_back(RowAsJson(row));
    AddFeatures(row.features, &json["rows"].back());
  }
  json["num_links"] = report.num_links;
  json["num_points"] = report.num_points;
  json["num_ignored_points"] = report.num_ignored_points;
  json["total_length"] = report.total_length;
  json["mean_link_length"] = report.mean_link_length;
  json["num_components"] = report.num_components;
  json["nodes_by_degree"] = Json::object();
  for (const auto& [degree, count] : report.nodes_by_degree) {
    json["nodes_by_degree"][std::to_string(degree)] = count;
  }
  json["saw_teeth"] = report.saw_teeth ? SawTeethAsJson(*report.saw_teeth) : Json(nullptr);
  json["normalised_errors"] =
      report.normalized_errors ? NormalizedErrorsAsJson(*report.normalized_errors) : Json(nullptr);
  json["reliability"] = report.reliability ? ReliabilityAsJson(*report.reliability) : Json(nullptr);
  json["kinds"] = report.kinds ? KindsAsJson(*report.kinds) : Json(nullptr);
  json["cameras"] = report.cameras ? CamerasAsJson(*report.cameras) : Json(nullptr);
  json["faces"] = report.faces ? FacesAsJson(*report.faces) : Json(nullptr);
  out << json.dump(2) << '\n';
}

}  // namespace limn
