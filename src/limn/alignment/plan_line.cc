// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/plan_line.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <regex>
#include <utility>

#include <Eigen/Geometry>

#include "limn/alignment/span_value.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "limn/util/number_text.h"
#include "limn/util/parse_number.h"
#include "limn/util/printable.h"

namespace limn {
namespace {

constexpr double kMaxDifference = 5 * kDeg;
// Steeper lines have no direction in the plan.
constexpr double kMinHorizontalShare = 0.3;

[[noreturn]] void FailLine(const std::string& text, const std::string& reason) {
  throw OptionError("plan_line = " + Printable(text) + ": " + reason);
}

std::optional<double> NamedDeg(const std::string& name) {
  const std::pair<const char*, double> names[] = {{"x", 0},      {"y", 90},     {"-x", 180},
                                                  {"-y", 270},   {"east", 0},   {"north", 90},
                                                  {"west", 180}, {"south", 270}};
  for (const auto& [known, degrees] : names) {
    if (name == known) return degrees;
  }
  return std::nullopt;
}

// Degrees. Nothing if this is not of the form.
std::optional<double> AngleOf(const std::string& text) {
  static const std::regex pattern(R"(\s*(?:\+?([0-9.eE-]{1,30})\s*deg|([a-z-]{1,5}))\s*)");
  std::smatch match;
  if (!std::regex_match(text, match, pattern)) return std::nullopt;
  if (match[2].matched) return NamedDeg(match[2]);
  const auto number = ParseNumber<double>(match.str(1));
  return number && std::abs(*number) <= 360 ? number : std::nullopt;
}

PlanLine ParseLine(const std::string& text) {
  const auto parsed = ParseSpanValue(text);
  const auto angle = parsed ? AngleOf(parsed->value) : std::nullopt;
  if (!angle) {
    FailLine(
        text.substr(0, kMaxSpanValueBytes),
        "must be like \"link 12 = 30 deg\" (from x, counter-clockwise), \"from 3 to 7 = north\" or "
        "\"a.jpg 120,340 to b.jpg 500,220 = x\"");
  }
  return {parsed->span, *angle * kDeg, text};
}

// What a line tells about the direction of x.
struct Told {
  double angle_rad = 0;  // from the hint, counter-clockwise
  double weight = 0;
  bool either_way = false;
};

std::complex<double> Turned(double angle_rad) { return std::polar(1.0, angle_rad); }

Told TellOne(const DrawingGraph& graph, const PlanLine& line, const Eigen::Vector3d& up,
             const Eigen::Vector3d& hint) {
  Eigen::Vector3d way = Eigen::Vector3d::Zero();
  try {
    way = WayOf(graph, line.span);
  } catch (const InputError& error) {
    FailLine(line.text, error.what());
  }
  const Eigen::Vector3d flat = way - up * up.dot(way);
  if (!(flat.norm() > kMinHorizontalShare * way.norm())) {
    FailLine(line.text, "is upright: it has no direction in a plan");
  }
  const double angle = std::atan2(flat.dot(up.cross(hint)), flat.dot(hint));
  return {angle - line.angle_rad, flat.norm(), line.span.link >= 0};
}

double Difference(double a, double b) { return std::abs(std::arg(Turned(a - b))); }

std::complex<double> SumOf(const std::vector<Told>& told, bool of_all) {
  std::complex<double> sum = 0;
  for (const Told& one : told) {
    if (of_all || !one.either_way) sum += one.weight * Turned(one.angle_rad);
  }
  return sum;
}

void CheckLinesAgree(const std::vector<PlanLine>& lines, const std::vector<Told>& told) {
  for (size_t i = 0; i < told.size(); ++i) {
    for (size_t k = i + 1; k < told.size(); ++k) {
      const double difference = Difference(told[i].angle_rad, told[k].angle_rad);
      if (difference <= kMaxDifference) continue;
      FailLine(lines[i].text, "contradicts \"" + Printable(lines[k].text) + "\": x differs by " +
                                  ShortNumber(Degrees(difference)) +
                                  " degrees; look at both again, or leave one out");
    }
  }
}

}  // namespace

std::vector<PlanLine> ParsePlanLines(const std::vector<std::string>& texts) {
  std::vector<PlanLine> lines;
  for (const std::string& text : texts) lines.push_back(ParseLine(text));
  return lines;
}

Eigen::Vector3d FitPlanLines(const DrawingGraph& graph, const std::vector<PlanLine>& lines,
                             const Eigen::Vector3d& up, const Eigen::Vector3d& hint) {
  const Eigen::Vector3d level = (hint - up * up.dot(hint)).normalized();
  std::vector<Told> told;
  for (const PlanLine& line : lines) told.push_back(TellOne(graph, line, up, level));
  const std::complex<double> sure = SumOf(told, /*of_all=*/false);
  const bool is_sure = std::abs(sure) > 0;
  double reference = is_sure ? std::arg(sure) : 0;
  for (Told& one : told) {
    const double right_angle = std::numbers::pi / 2;
    if (one.either_way && Difference(one.angle_rad, reference) > right_angle) {
      one.angle_rad += std::numbers::pi;
    }
    if (!is_sure) reference = told.front().angle_rad;
  }
  CheckLinesAgree(lines, told);
  const double angle = std::arg(SumOf(told, /*of_all=*/true));
  return std::cos(angle) * level + std::sin(angle) * up.cross(level);
}

}  // namespace limn
