// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/known_lengths.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>
#include <utility>

#include "limn/alignment/span_value.h"
#include "limn/util/errors.h"
#include "limn/util/length_unit.h"
#include "limn/util/number_text.h"
#include "limn/util/parse_number.h"
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

// 0 for no number. Nothing if this is not of the form.
std::optional<double> MetersOf(const std::string& text) {
  static const std::regex pattern(R"(\s*([0-9.eE+-]{1,30})\s*(mm|cm|m|in|ft))");
  std::smatch match;
  if (!std::regex_match(text, match, pattern)) return std::nullopt;
  const auto number = ParseNumber<double>(match.str(1));
  return number ? *number * MetersPer(match[2]) : 0;
}

KnownLength ParseOne(const std::string& text) {
  const auto parsed = ParseSpanValue(text);
  const auto meters = parsed ? MetersOf(parsed->value) : std::nullopt;
  if (!meters) {
    Fail(text.substr(0, kMaxSpanValueBytes),
         "must be like \"link 12 = 2.40 m\", \"from 3 to 7 = 2.40 m\" or \"a.jpg 120,340 to b.jpg "
         "500,220 = 2.40 m\", in mm, cm, m, in or ft");
  }
  if (!(*meters >= kMinMeters && *meters <= kMaxMeters)) {
    Fail(text, "the length must be >= 1e-6 and <= 1e6 m");
  }
  return {parsed->span, *meters, text};
}

MeasuredLength Measure(const DrawingGraph& graph, const KnownLength& known) {
  try {
    return MeasureSpan(graph, known.span);
  } catch (const InputError& error) {
    Fail(known.text, error.what());
  }
}

// What a known length makes of the drawing's unit.
struct UnitLength {
  double log_meters = 0;  // natural logarithm of the meters per unit
  double sigma = 0;       // of that, by the uncertainty of the drawing
};

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

// What the uncertainties of the drawing leave of the scale, relative; 0 if one is unknown.
double SigmaOfScale(const std::vector<MeasuredLength>& measured) {
  double squares = 0, weights = 0;
  for (const auto& [length, sigma] : measured) {
    if (!(sigma > 0)) return 0;
    squares += std::pow(length * sigma, 2);
    weights += length * length;
  }
  return std::sqrt(squares) / weights;
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
  std::vector<MeasuredLength> measured;
  double product = 0, square = 0;
  for (const KnownLength& known : lengths) {
    measured.push_back(Measure(graph, known));
    const auto [length, sigma] = measured.back();
    fit.lengths.push_back(length);
    units.push_back({std::log(known.meters / length), sigma / length});
    product += length * known.meters;
    square += length * length;
  }
  CheckAgree(lengths, units);
  fit.scale = product / square;
  for (double& length : fit.lengths) length *= fit.scale;
  fit.sigma = std::max(SigmaOfScale(measured), ErrorOfScale(fit, lengths));
  return fit;
}

}  // namespace limn
