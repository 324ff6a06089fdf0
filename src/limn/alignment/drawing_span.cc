#include "limn/alignment/drawing_span.h"

#include <algorithm>
#include <charconv>
#include <regex>
#include <variant>

#include "limn/util/errors.h"

namespace limn {
namespace {

template <typename Number>
std::optional<Number> NumberOf(const std::string& text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::optional<ImagePoint> PixelOf(const std::string& image, const std::string& x,
                                  const std::string& y) {
  const auto column = NumberOf<double>(x), row = NumberOf<double>(y);
  if (!column || !row) return std::nullopt;
  return ImagePoint{image, {*column, *row}};
}

SpanEnd EndOfLink(const DrawingLink& link, int end) {
  SpanEnd result{end == 0 ? link.points_in_world.front() : link.points_in_world.back()};
  if (!link.sigma.empty()) result.sigma = end == 0 ? link.sigma.front() : link.sigma.back();
  const auto* line = link.primitive ? std::get_if<LineSegment>(&link.primitive->shape) : nullptr;
  if (line) result.position = end == 0 ? line->start : line->end;
  return result;
}

SpanEnd AtNode(const DrawingGraph& graph, NodeId node) {
  SpanEnd result{graph.nodes[node].position_in_world};
  for (const LinkEnd& at : graph.nodes[node].incident) {
    result.sigma = std::max(result.sigma, EndOfLink(graph.links[at.link], at.end).sigma);
  }
  return result;
}

void CheckIsThere(const char* what, int id, size_t count) {
  if (id < static_cast<int>(count)) return;
  throw InputError("the drawing has no " + std::string(what) + " " + std::to_string(id) +
                   ", only " + std::to_string(count));
}

}  // namespace

std::optional<DrawingSpan> ParseSpan(const std::string& text) {
  static const std::regex graph_pattern(
      R"(\s*(?:link\s+(\d{1,9})|from\s+(\d{1,9})\s+to\s+(\d{1,9}))\s*)");
  static const std::regex pixel_pattern(
      R"(\s*(?:from\s+)?(\S.*?)\s+([0-9.]{1,20}),([0-9.]{1,20})\s+to\s+(\S.*?)\s+([0-9.]{1,20}),([0-9.]{1,20})\s*)");
  // Long texts overflow the stack of std::regex.
  if (text.size() > 600) return std::nullopt;
  DrawingSpan span;
  std::smatch match;
  if (std::regex_match(text, match, graph_pattern)) {
    if (match[1].matched) {
      span.link = *NumberOf<int>(match[1]);
    } else {
      span.node0 = *NumberOf<int>(match[2]);
      span.node1 = *NumberOf<int>(match[3]);
    }
    return span;
  }
  if (!std::regex_match(text, match, pixel_pattern)) return std::nullopt;
  const auto from = PixelOf(match[1], match[2], match[3]);
  const auto to = PixelOf(match[4], match[5], match[6]);
  if (!from || !to) return std::nullopt;
  span.pixels = {*from, *to};
  return span;
}

SpanEnds EndsOf(const DrawingGraph& graph, const DrawingSpan& span) {
  if (!span.places.empty()) {
    const auto& from = span.places.front();
    const auto& to = span.places.back();
    return {{from.position, from.sigma}, {to.position, to.sigma}};
  }
  if (span.link >= 0) {
    CheckIsThere("link", span.link, graph.links.size());
    return {EndOfLink(graph.links[span.link], 0), EndOfLink(graph.links[span.link], 1)};
  }
  for (const NodeId node : {span.node0, span.node1}) {
    CheckIsThere("node", node, graph.nodes.size());
  }
  return {AtNode(graph, span.node0), AtNode(graph, span.node1)};
}

}  // namespace limn
