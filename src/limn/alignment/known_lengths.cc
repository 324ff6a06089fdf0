#include "limn/alignment/known_lengths.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <regex>
#include <utility>
#include <variant>

#include "limn/geometry/polyline.h"
#include "limn/util/errors.h"
#include "limn/util/length_unit.h"
#include "limn/util/number_text.h"
#include "limn/util/printable.h"

namespace limn {
namespace {

// Two lengths make units of the drawing that differ by no more than this share, for what is
// measured, and so many standard deviations of the drawing; but never by more than the last.
constexpr double kSameShare = 0.05, kSigmas = 3, kMaxAllowed = 0.5;
constexpr double kMinMeters = 1e-6, kMaxMeters = 1e6;

[[noreturn]] void Fail(const std::string& text, const std::string& reason) {
  throw OptionError("known_length = " + Printable(text) + ": " + reason);
}

template <typename Number>
std::optional<Number> NumberIn(const std::string& text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

double MetersPer(const std::string& unit) {
  const std::pair<const char*, LengthUnit> units[] = {{"mm", LengthUnit::kMillimeter},
                                                      {"cm", LengthUnit::kCentimeter},
                                                      {"m", LengthUnit::kMeter},
                                                      {"in", LengthUnit::kInch},
                                                      {"ft", LengthUnit::kFoot}};
  for (const auto& [name, length] : units) {
    if (unit == name) return Millimeters(length) / 1000;
  }
  return 0;
}

KnownLength ParseOne(const std::string& text) {
  static const std::regex pattern(
      R"((?:link\s+(\d{1,9})|from\s+(\d{1,9})\s+to\s+(\d{1,9}))\s*=\s*([0-9.eE+-]{1,30})\s*(mm|cm|m|in|ft))");
  std::smatch match;
  // Long texts overflow the stack of std::regex.
  if (text.size() > 200 || !std::regex_match(text, match, pattern)) {
    Fail(text.substr(0, 200),
         "must be like \"link 12 = 2.40 m\" or \"from 3 to 7 = 2.40 m\", in mm, cm, m, in or ft");
  }
  KnownLength length;
  length.text = text;
  if (match[1].matched) {
    length.link = *NumberIn<int>(match[1]);
  } else {
    length.node0 = *NumberIn<int>(match[2]);
    length.node1 = *NumberIn<int>(match[3]);
  }
  length.meters = NumberIn<double>(match[4]).value_or(0) * MetersPer(match[5]);
  if (!(length.meters >= kMinMeters && length.meters <= kMaxMeters)) {
    Fail(text, "the length must be >= 1e-6 and <= 1e6 m");
  }
  return length;
}

double ShapeLength(const DrawingLink& link) {
  if (link.primitive) {
    const CurveShape& shape = link.primitive->shape;
    if (const auto* line = std::get_if<LineSegment>(&shape))
      return (line->end - line->start).norm();
    if (const auto* arc = std::get_if<CircularArc>(&shape)) return arc->radius * arc->sweep_rad;
  }
  return Length(link.points_in_world);
}

double LengthInDrawing(const DrawingGraph& graph, const KnownLength& known) {
  const auto check = [&](const char* what, int id, size_t count) {
    if (id < static_cast<int>(count)) return;
    Fail(known.text, "the drawing has no " + std::string(what) + " " + std::to_string(id) +
                         ", only " + std::to_string(count));
  };
  if (known.link >= 0) {
    check("link", known.link, graph.links.size());
    return ShapeLength(graph.links[known.link]);
  }
  for (const NodeId node : {known.node0, known.node1}) check("node", node, graph.nodes.size());
  const double distance =
      (graph.nodes[known.node0].position_in_world - graph.nodes[known.node1].position_in_world)
          .norm();
  if (!(distance > 0)) Fail(known.text, "both nodes are at the same place");
  return distance;
}

// What a known length makes of the drawing's unit.
struct UnitLength {
  double log_meters = 0;  // natural logarithm of the meters per unit
  double sigma = 0;       // of that, by the uncertainty of the drawing
};

double EndSigma(const DrawingGraph& graph, const LinkEnd& at) {
  const std::vector<double>& sigma = graph.links[at.link].sigma;
  if (sigma.empty()) return 0;
  return at.end == 0 ? sigma.front() : sigma.back();
}

double NodeSigma(const DrawingGraph& graph, NodeId node) {
  double largest = 0;
  for (const LinkEnd& end : graph.nodes[node].incident) {
    largest = std::max(largest, EndSigma(graph, end));
  }
  return largest;
}

UnitLength UnitBy(const DrawingGraph& graph, const KnownLength& known, double length) {
  const bool is_link = known.link >= 0;
  const double sigma0 = is_link ? EndSigma(graph, {known.link, 0}) : NodeSigma(graph, known.node0);
  const double sigma1 = is_link ? EndSigma(graph, {known.link, 1}) : NodeSigma(graph, known.node1);
  return {std::log(known.meters / length), std::hypot(sigma0, sigma1) / length};
}

// By how much two differ beyond what their uncertainties allow; not above 0 if they agree.
double Contradiction(const UnitLength& a, const UnitLength& b) {
  const double allowed = kSameShare + kSigmas * std::hypot(a.sigma, b.sigma);
  return std::abs(a.log_meters - b.log_meters) - std::min(allowed, kMaxAllowed);
}

size_t CountAgreeing(const std::vector<UnitLength>& units, size_t with) {
  return static_cast<size_t>(std::count_if(
             units.begin(), units.end(),
             [&](const UnitLength& unit) { return Contradiction(unit, units[with]) <= 0; })) -
         1;
}

// Which of two the others agree with, if this tells.
std::string SideOfOthers(const std::vector<KnownLength>& lengths,
                         const std::vector<UnitLength>& units, size_t a, size_t b) {
  const size_t with_a = CountAgreeing(units, a), with_b = CountAgreeing(units, b);
  if (with_a == with_b) return "";
  const size_t most = with_a > with_b ? a : b;
  return " (" + std::to_string(std::max(with_a, with_b)) + " of the others agree with \"" +
         Printable(lengths[most].text) + "\")";
}

[[noreturn]] void FailContradicting(const std::vector<KnownLength>& lengths,
                                    const std::vector<UnitLength>& units, size_t a, size_t b) {
  const auto meters = [&](size_t i) { return ShortNumber(std::exp(units[i].log_meters)) + " m"; };
  const double ratio = std::exp(std::abs(units[a].log_meters - units[b].log_meters));
  Fail(lengths[a].text, "contradicts \"" + Printable(lengths[b].text) +
                            "\": a unit of the drawing is " + meters(a) + " by the one and " +
                            meters(b) + " by the other, " + ShortNumber(100 * (ratio - 1)) +
                            " % apart" + SideOfOthers(lengths, units, a, b) +
                            "; measure both again, or leave one out");
}

// Throws for the two that contradict each other most.
void CheckAgree(const std::vector<KnownLength>& lengths, const std::vector<UnitLength>& units) {
  double worst = 0;
  size_t a = 0, b = 0;
  for (size_t i = 0; i < units.size(); ++i) {
    for (size_t k = i + 1; k < units.size(); ++k) {
      const double contradiction = Contradiction(units[i], units[k]);
      if (!(contradiction > worst)) continue;
      worst = contradiction;
      a = i;
      b = k;
    }
  }
  if (worst > 0) FailContradicting(lengths, units, a, b);
}

// Of the mean of several, each with this weight.
double ErrorOfScale(const LengthFit& fit, const std::vector<KnownLength>& lengths) {
  if (lengths.size() < 2) return 0;
  double squares = 0, weights = 0, squared_weights = 0;
  for (size_t i = 0; i < lengths.size(); ++i) {
    const double weight = fit.lengths[i] * fit.lengths[i];
    squares += weight * std::pow(lengths[i].meters / fit.lengths[i] - 1, 2);
    weights += weight;
    squared_weights += weight * weight;
  }
  // As many equal weights as these are worth.
  const double count = weights * weights / squared_weights;
  const double num_lengths = static_cast<double>(lengths.size());
  return std::sqrt(squares / weights * num_lengths / (num_lengths - 1) / count);
}

}  // namespace

std::vector<KnownLength> ParseKnownLengths(const std::vector<std::string>& texts) {
  std::vector<KnownLength> lengths;
  for (const std::string& text : texts) lengths.push_back(ParseOne(text));
  return lengths;
}

LengthFit FitLengths(const DrawingGraph& graph, const std::vector<KnownLength>& lengths) {
  LengthFit fit;
  std::vector<UnitLength> units;
  double product = 0, square = 0;
  for (const KnownLength& known : lengths) {
    const double length = LengthInDrawing(graph, known);
    fit.lengths.push_back(length);
    units.push_back(UnitBy(graph, known, length));
    product += length * known.meters;
    square += length * length;
  }
  CheckAgree(lengths, units);
  fit.scale = product / square;
  for (double& length : fit.lengths) length *= fit.scale;
  fit.error = ErrorOfScale(fit, lengths);
  return fit;
}

}  // namespace limn
