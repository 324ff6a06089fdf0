// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/feature_writers.h"

#include <cmath>
#include <ostream>

#include <nlohmann/json.hpp>

#include "limn/evaluation/report_cells.h"

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

// "4 to 6", "from 30"; "all" of all there are.
std::string Range(double from, double to) {
  if (std::isfinite(to)) return Cell(from, 4) + " to " + Cell(to, 4);
  return from > 0 ? "from " + Cell(from, 4) : "all";
}

void PrintCircles(const std::vector<CircleScores>& circles, double tau, std::ostream& out) {
  constexpr int kWidth = 11;
  out << "circles by radius, at tau " << Cell(tau, 4) << ":\n";
  PrintRow({"radius", "number", "covered %", "one curve", "closed", "circle"}, kWidth, out);
  for (const CircleScores& bin : circles) {
    PrintRow({Range(bin.from, bin.to), std::to_string(bin.num_circles), Percent(bin.covered),
              std::to_string(bin.num_one_curve), std::to_string(bin.num_closed),
              Cell(bin.num_of_type_circle)},
             kWidth, out);
  }
}

void PrintKinds(const FeatureScores& scores, double tau, std::ostream& out) {
  const JunctionKindScores& corners = scores.corners;
  const JunctionKindScores& tees = scores.tees;
  const JunctionKindScores& crossings = scores.crossings;
  if (corners.num_junctions + tees.num_junctions + crossings.num_junctions == 0) return;
  out << "with a node, at tau " << Cell(tau, 4) << ": " << crossings.num_found << " of "
      << crossings.num_junctions << " crossings (" << crossings.num_with_4
      << " with one of degree 4), " << tees.num_found << " of " << tees.num_junctions
      << " T junctions, " << corners.num_found << " of " << corners.num_junctions << " corners\n";
}

void PrintCorners(const CornerScores& corners, double tau, std::ostream& out) {
  if (corners.num_drawn == 0) return;
  out << "open, at tau " << Cell(tau, 4) << ": " << corners.num_open << " of " << corners.num_drawn
      << " drawn corners, " << corners.num_open_meetings << " of " << corners.num_meetings
      << " meetings";
  if (corners.num_open_near) out << ", " << *corners.num_open_near << " with both ends near";
  out << '\n';
}

void PrintPairs(const std::vector<PairScores>& pairs, double tau, std::ostream& out) {
  std::string text;
  for (const PairScores& bin : pairs) {
    if (!bin.recall) continue;
    text += (text.empty() ? "" : ", ") + Percent(bin.recall) + " % of those " +
            Range(bin.from, bin.to) + " rho apart";
  }
  if (!text.empty())
    out << "found of pairs of curves, at tau " << Cell(tau, 4) << ": " << text << '\n';
}

void PrintRods(const RodScores& rods, double tau, std::ostream& out) {
  constexpr int kDigits = 3;
  out << "rods, at tau " << Cell(tau, 4) << ": " << Percent(rods.recall) << " % of "
      << Cell(rods.true_length, 4) << " told as rods, drawn "
      << Cell(rods.links_per_length, kDigits) << " times, false rods "
      << Cell(rods.false_per_length, kDigits) << " per true length";
  if (rods.median_error) out << ", median error " << Cell(rods.median_error, kDigits);
  if (rods.median_radius_ratio) {
    out << ", radius " << Cell(rods.median_radius_ratio, kDigits) << " of the true one";
  }
  out << '\n';
}

Json RodsAsJson(const RodScores& rods) {
  const auto or_null = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
  };
  return {{"true_length", rods.true_length},
          {"drawn_length", rods.drawn_length},
          {"recall", or_null(rods.recall)},
          {"links_per_length", or_null(rods.links_per_length)},
          {"false_per_length", or_null(rods.false_per_length)},
          {"median_error", or_null(rods.median_error)},
          {"median_radius_ratio", or_null(rods.median_radius_ratio)}};
}

Json CirclesAsJson(const std::vector<CircleScores>& circles) {
  Json json = Json::array();
  for (const CircleScores& bin : circles) {
    json.push_back({{"from", bin.from},
                    {"to", std::isfinite(bin.to) ? Json(bin.to) : Json(nullptr)},
                    {"count", bin.num_circles},
                    {"covered", bin.covered},
                    {"one_curve", bin.num_one_curve},
                    {"closed", bin.num_closed}});
    if (bin.num_of_type_circle) json.back()["circle"] = *bin.num_of_type_circle;
  }
  return json;
}

Json PairsAsJson(const std::vector<PairScores>& pairs) {
  Json json = Json::array();
  for (const PairScores& bin : pairs) {
    json.push_back({{"from", bin.from},
                    {"to", bin.to},
                    {"true_length", bin.true_length},
                    {"recall", bin.recall ? Json(*bin.recall) : Json(nullptr)}});
  }
  return json;
}

Json KindAsJson(const JunctionKindScores& scores) {
  return {{"count", scores.num_junctions},
          {"found", scores.num_found},
          {"with_degree_4", scores.num_with_4}};
}

void AddDrawnCorners(const CornerScores& corners, Json* json) {
  (*json)["drawn"] = corners.num_drawn;
  (*json)["open"] = corners.num_open;
  (*json)["meetings"] = corners.num_meetings;
  (*json)["open_meetings"] = corners.num_open_meetings;
  if (corners.num_open_near) (*json)["open_meetings_near"] = *corners.num_open_near;
}

}  // namespace

void PrintFeatures(const FeatureScores& scores, double tau, std::ostream& out) {
  if (!scores.circles.empty()) PrintCircles(scores.circles, tau, out);
  PrintKinds(scores, tau, out);
  PrintCorners(scores.drawn_corners, tau, out);
  PrintPairs(scores.pairs, tau, out);
  if (scores.rods) PrintRods(*scores.rods, tau, out);
}

void AddFeatures(const FeatureScores& scores, Json* json) {
  (*json)["circles"] = CirclesAsJson(scores.circles);
  (*json)["crossings"] = KindAsJson(scores.crossings);
  (*json)["t_junctions"] = KindAsJson(scores.tees);
  (*json)["corners"] = KindAsJson(scores.corners);
  AddDrawnCorners(scores.drawn_corners, &(*json)["corners"]);
  (*json)["pairs"] = PairsAsJson(scores.pairs);
  (*json)["rods"] = scores.rods ? RodsAsJson(*scores.rods) : Json(nullptr);
}

}  // namespace limn
