// SPDX-License-Identifier: BSD-3-Clause
#include "bench/report_tables.h"

#include <ostream>
#include <string>
#include <vector>

#include "bench/markdown.h"

namespace limn::bench {
namespace {

bool IsDefault(const Json& run) { return run["threshold"].is_null(); }

void Append(const Cells& more, Cells* cells) {
  cells->insert(cells->end(), more.begin(), more.end());
}

Cells TauHeads(const Json& set) {
  Cells heads;
  for (const Json& tau : set["taus"]) heads.push_back("P/R/F at " + Short(tau));
  return heads;
}

// Of one box; junctions and duplicates at the tau of the header. "P smpl.": of samples
// (TauResult::sample_precision).
Cells TruthHeads(const Json& set, size_t junction_tau) {
  Cells heads = TauHeads(set);
  heads.push_back("P smpl. at " + Short(set["taus"][junction_tau]));
  heads.push_back("dupl. at " + Short(set["taus"][0]));
  heads.push_back("junctions P/R at " + Short(set["taus"][junction_tau]));
  return heads;
}

Cells TruthCells(const Json& report, size_t junction_tau) {
  Cells cells;
  for (const Json& row : report["rows"]) cells.push_back(Shares(row));
  const Json& row = report["rows"][junction_tau];
  cells.push_back(Percent(row["sample_precision"]));
  cells.push_back(Percent(report["rows"][0]["duplicated"]));
  cells.push_back(Percent(row["junction_precision"]) + " / " + Percent(row["junction_recall"]));
  return cells;
}

// Runs with default options, then the results of other programs.
std::vector<Json> Compared(const Json& set) {
  std::vector<Json> runs;
  for (const Json& run : set["runs"]) {
    if (IsDefault(run)) runs.push_back(run);
  }
  for (const Json& peer : set["peers"]) runs.push_back(peer);
  return runs;
}

void PrintTruth(const Json& set, std::ostream& out) {
  const size_t junction_tau = set["taus"].size() / 2;
  Cells heads = {"method", "box"};
  Append(TruthHeads(set, junction_tau), &heads);
  PrintHead(heads, out);
  for (const Json& run : Compared(set)) {
    for (const auto& [box, report] : run["truth"].items()) {
      Cells cells = {run["method"], box};
      Append(TruthCells(report, junction_tau), &cells);
      PrintRow(cells, out);
    }
  }
  for (const auto& [box, recalls] : set["ceiling"].items()) {
    Cells cells = {"*ceiling of recall*", box};
    for (const Json& recall : recalls) cells.push_back("- / " + Percent(recall) + " / -");
    Append({"-", "-", "-"}, &cells);
    PrintRow(cells, out);
  }
  out << '\n';
}

std::string Count(const Json& number) {
  return number.is_null() ? "-" : std::to_string(number.get<int>());
}

// "17 of 25 (0.31)": how many are false, and their number per true length.
std::string FalseOnes(const Json& num_false, const Json& count, const Json& per_length) {
  return Count(num_false) + " of " + Count(count) + " (" + Fixed(per_length, 2) + ")";
}

std::string IntervalOf(const Json& row, const std::string& share) {
  return Percent(row[share + "_low"]) + " to " + Percent(row[share + "_high"]);
}

// How curves are cut and joined, at the middle tau.
void PrintStructure(const Json& set, std::ostream& out) {
  const size_t tau = set["taus"].size() / 2;
  out << "Structure at tau = " << Short(set["taus"][tau])
      << ", and 95 % intervals (bootstrap over curves); in brackets: per true length:\n\n";
  PrintHead({"method", "box", "links, curves per true curve", "false free ends", "false junctions",
             "junctions' degree right", "arms P/R", "joined", "P", "R", "F"},
            out);
  for (const Json& run : Compared(set)) {
    for (const auto& [box, report] : run["truth"].items()) {
      const Json& row = report["rows"][tau];
      PrintRow(
          {run["method"], box,
           Fixed(row["links_per_chain"], 2) + ", " + Fixed(row["curves_per_chain"], 2),
           FalseOnes(row["num_false_ends"], row["num_free_ends"], row["false_ends_per_length"]),
           FalseOnes(row["num_false_junctions"], row["num_junctions"],
                     row["false_junctions_per_length"]),
           Percent(row["right_degrees"]),
           Percent(row["arm_precision"]) + " / " + Percent(row["arm_recall"]),
           Percent(row["connectivity"]), IntervalOf(row, "precision"), IntervalOf(row, "recall"),
           IntervalOf(row, "f")},
          out);
    }
  }
  out << '\n';
}

// Sums over the circles of all radii.
Cells CircleCells(const Json& circles) {
  int count = 0, one_curve = 0, circle = 0;
  double covered = 0;
  bool has_types = false;
  for (const Json& bin : circles) {
    count += bin["count"].get<int>();
    covered += bin["count"].get<int>() * bin["covered"].get<double>();
    one_curve += bin["one_curve"].get<int>();
    has_types = has_types || bin.contains("circle");
    circle += bin.value("circle", 0);
  }
  if (count == 0) return {"-", "-", "-", "-"};
  return {std::to_string(count), Percent(covered / count), std::to_string(one_curve),
          has_types ? std::to_string(circle) : "-"};
}

std::string CrossingCell(const Json& crossings) {
  if (crossings["count"] == 0) return "-";
  return Count(crossings["found"]) + " (" + Count(crossings["with_degree_4"]) + ") of " +
         Count(crossings["count"]);
}

bool HasFeatures(const Json& row) {
  return !row["circles"].empty() || row["crossings"]["count"] != 0;
}

// Circles and crossings at the middle tau, where the truth has any.
void PrintFeatures(const Json& set, std::ostream& out) {
  const size_t tau = set["taus"].size() / 2;
  std::vector<Cells> rows;
  for (const Json& run : Compared(set)) {
    for (const auto& [box, report] : run["truth"].items()) {
      const Json& row = report["rows"][tau];
      if (!HasFeatures(row)) continue;
      rows.push_back({run["method"], box});
      Append(CircleCells(row["circles"]), &rows.back());
      rows.back().push_back(CrossingCell(row["crossings"]));
    }
  }
  if (rows.empty()) return;
  out << "Circles and crossings of the truth at tau = " << Short(set["taus"][tau]) << ":\n\n";
  PrintHead({"method", "box", "circles", "covered", "drawn as one curve", "of type circle",
             "crossings with a node (of degree 4)"},
            out);
  for (const Cells& cells : rows) PrintRow(cells, out);
  out << '\n';
}

// Of drawings, at the middle tau, where the truth has center lines of rods.
void PrintRods(const Json& set, std::ostream& out) {
  const size_t tau = set["taus"].size() / 2;
  std::vector<Cells> rows;
  for (const Json& run : set["runs"]) {
    if (!IsDefault(run) || run["rods"].is_null()) continue;
    for (const auto& [box, per_tau] : run["rods"].items()) {
      const Json& rods = per_tau[tau];
      rows.push_back({run["method"], box, Fixed(rods["true_length"], 1), Percent(rods["recall"]),
                      Fixed(rods["links_per_length"], 2), Fixed(rods["false_per_length"], 3),
                      Fixed(rods["median_error"], 2), Fixed(rods["median_radius_ratio"], 2)});
    }
  }
  if (rows.empty()) return;
  out << "Rods at tau = " << Short(set["taus"][tau]) << ":\n\n";
  PrintHead({"method", "box", "true length", "told as rods", "drawn, per true length",
             "false rods, per true length", "median error", "radius over the true one"},
            out);
  for (const Cells& cells : rows) PrintRow(cells, out);
  out << '\n';
}

// Programs whose results are not there have no rows.
void PrintMissingPeers(const Json& set, std::ostream& out) {
  for (const Json& path : set["missing_peers"]) {
    out << "Left out, there is no such file: " << path.get<std::string>() << "\n\n";
  }
}

// Recall over what the image curves can give at all, default options.
void PrintShareOfCeiling(const Json& set, std::ostream& out) {
  for (const Json& run : set["runs"]) {
    if (!IsDefault(run)) continue;
    out << "Recall of the " << std::string(run["method"]) << " over its ceiling:";
    for (const auto& [box, recalls] : set["ceiling"].items()) {
      out << " box " << box << ' ';
      for (size_t i = 0; i < recalls.size(); ++i) {
        const Json& recall = run["truth"][box]["rows"][i]["recall"];
        const bool known = !recall.is_null() && !recalls[i].is_null() && recalls[i] > 0.0;
        const Json share =
            known ? Json(recall.get<double>() / recalls[i].get<double>()) : Json(nullptr);
        out << (i > 0 ? " / " : "") << Percent(share);
      }
      out << " %.";
    }
    out << "\n\n";
  }
}

// Drawings only: how well their sigmas tell their errors.
void PrintSigmas(const Json& set, std::ostream& out) {
  out << "Squared errors over those of sigma, 1 if sigmas are right, of vertices within 2 "
         "footprints "
         "of the truth:\n\n";
  PrintHead(
      {"method", "box", "mean", "by the median", "vertices", "mean with false ones", "false ones"},
      out);
  for (const Json& run : set["runs"]) {
    if (!IsDefault(run) || run["sigmas"].is_null()) continue;
    for (const auto& [box, errors] : run["sigmas"].items()) {
      PrintRow(
          {run["method"], box, Fixed(errors["variance"], 2), Fixed(errors["median_variance"], 2),
           std::to_string(errors["num_inliers"].get<int>()),
           Fixed(errors["variance_with_false"], 2), std::to_string(errors["num_false"].get<int>())},
          out);
    }
  }
  out << '\n';
}

std::string Distances(const Json& distances) {
  return Fixed(distances["median_px"], 2) + " / " + Fixed(distances["p90_px"], 2) + " (" +
         Percent(distances["lonely"]) + ")";
}

Cells ShapeCells(const Json& shape) {
  const Json& teeth = shape["saw_teeth"];
  return {Count(shape["num_links"]), Count(shape["num_components"]),
          Fixed(shape["total_length"], 2),
          Fixed(teeth["median"], 3) + " / " + Fixed(teeth["p90"], 3),
          Fixed(teeth["median_by_length"], 3) + " / " + Fixed(teeth["p90_by_length"], 3)};
}

void PrintShape(const Json& set, std::ostream& out) {
  PrintHead(
      {"method", "links", "components", "length", "saw-teeth median / 90 %", "the same by length",
       "held out: to edgels, px median / 90 % (lonely %)", "from edgels", "s", "CPU s"},
      out);
  for (const Json& run : set["runs"]) {
    if (!IsDefault(run)) continue;
    Cells cells = {run["method"]};
    Append(ShapeCells(run["shape"]), &cells);
    Append({Distances(run["held_out"]["to_edgels"]), Distances(run["held_out"]["from_edgels"]),
            Fixed(run["seconds"], 1), Fixed(run["cpu_seconds"], 1)},
           &cells);
    PrintRow(cells, out);
  }
  for (const Json& peer : set["peers"]) {
    Cells cells = {peer["method"]};
    Append(ShapeCells(peer["shape"]), &cells);
    Append({"-", "-", "-", "-"}, &cells);
    PrintRow(cells, out);
  }
  out << '\n';
}

void PrintEmap(const Json& set, std::ostream& out) {
  out << "EMAP's protocol, all true curves, mm (0.001 of the object's cube):\n\n";
  PrintHead({"method", "voxels", "Acc", "Comp", "P5 / R5 / F5", "P10 / R10 / F10",
             "P20 / R20 / F20", "links"},
            out);
  for (const Json& run : set["runs"]) {
    if (!IsDefault(run)) continue;
    for (const char* kind : {"points", "voxels"}) {
      const Json& scores = run["emap"][kind];
      if (scores.is_null()) continue;
      Cells cells = {run["method"], std::string(kind) == "voxels" ? "7.8 mm" : "none",
                     Fixed(scores["accuracy"], 2, 1000), Fixed(scores["completeness"], 2, 1000)};
      for (const Json& row : scores["rows"]) cells.push_back(Shares(row));
      cells.push_back(std::to_string(run["shape"]["num_links"].get<int>()));
      PrintRow(cells, out);
    }
  }
  out << '\n';
}

void PrintSweep(const Json& set, std::ostream& out) {
  const std::string box = set["boxes"][0];
  out << "Sweep of the support threshold, box " << box << ":\n\n";
  Cells heads = {"method", "threshold"};
  Append(TauHeads(set), &heads);
  Append({"links"}, &heads);
  PrintHead(heads, out);
  for (const Json& run : set["runs"]) {
    if (IsDefault(run)) continue;
    Cells cells = {run["method"], std::to_string(run["threshold"].get<int>()) + " " +
                                      run["threshold_name"].get<std::string>()};
    for (const Json& row : run["truth"][box]["rows"]) cells.push_back(Shares(row));
    cells.push_back(std::to_string(run["shape"]["num_links"].get<int>()));
    PrintRow(cells, out);
  }
  out << '\n';
}

bool HasSweep(const Json& set) {
  for (const Json& run : set["runs"]) {
    if (!IsDefault(run)) return true;
  }
  return false;
}

void PrintSet(const Json& set, std::ostream& out) {
  out << "## " << set["name"].get<std::string>() << "\n\n"
      << set["num_views"] << " views, " << set["num_held_out"]
      << " of them held out for reprojection; image curves took " << Fixed(set["seconds"], 1)
      << " s. Shares in percent";
  if (!set["ceiling"].is_null()) out << ", tau in the unit " << set["unit"].get<std::string>();
  out << ".\n\n";
  if (!set["ceiling"].is_null()) {
    PrintTruth(set, out);
    PrintStructure(set, out);
    PrintFeatures(set, out);
    PrintRods(set, out);
    PrintMissingPeers(set, out);
    PrintShareOfCeiling(set, out);
  }
  PrintShape(set, out);
  if (!set["ceiling"].is_null()) PrintSigmas(set, out);
  if (!set["runs"].empty() && !set["runs"][0]["emap"].is_null()) PrintEmap(set, out);
  if (!set["ceiling"].is_null() && HasSweep(set)) PrintSweep(set, out);
}

}  // namespace

void WriteTables(const Json& report, std::ostream& out) {
  out << "# Quality report\n\n";
  for (const Json& set : report["sets"]) PrintSet(set, out);
}

}  // namespace limn::bench
