#include "limn/alignment/known_lengths.h"

#include <charconv>
#include <optional>
#include <regex>
#include <utility>
#include <variant>

#include "limn/geometry/polyline.h"
#include "limn/util/errors.h"
#include "limn/util/length_unit.h"
#include "limn/util/printable.h"

namespace limn {
namespace {

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

}  // namespace

std::vector<KnownLength> ParseKnownLengths(const std::vector<std::string>& texts) {
  std::vector<KnownLength> lengths;
  for (const std::string& text : texts) lengths.push_back(ParseOne(text));
  return lengths;
}

LengthFit FitLengths(const DrawingGraph& graph, const std::vector<KnownLength>& lengths) {
  LengthFit fit;
  double product = 0, square = 0;
  for (const KnownLength& known : lengths) {
    const double length = LengthInDrawing(graph, known);
    fit.lengths.push_back(length);
    product += length * known.meters;
    square += length * length;
  }
  fit.scale = product / square;
  for (double& length : fit.lengths) length *= fit.scale;
  return fit;
}

}  // namespace limn
