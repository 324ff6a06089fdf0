// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/dxf/chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>

#include "limn/util/angles.h"

namespace limn {
namespace {

// Lines go on in each other if their directions differ by less.
constexpr double kMaxTurn = 1 * kDeg;

template <typename Shape>
const Shape* ShapeAs(const DrawingLink& link) {
  return link.primitive ? std::get_if<Shape>(&link.primitive->shape) : nullptr;
}

// A link in the direction of its chain.
struct ChainStep {
  LinkId link = -1;
  bool reversed = false;

  int BeginEnd() const { return reversed ? 1 : 0; }
};

class ChainFinder {
 public:
  ChainFinder(const FlatLinks& flat, const std::vector<int>& layer_of_link, double tolerance)
      : flat_(flat), layers_(layer_of_link), tolerance_(tolerance) {
    for (const DrawingLink& link : flat.graph.links) {
      joinable_.push_back(IsJoinable(link));
      partners_.emplace_back();
    }
    for (const DrawingNode& node : flat.graph.nodes) Pair(node);
  }

  std::vector<FlatChain> Find() {
    std::vector<uint8_t> used(joinable_.size(), 0);
    std::vector<FlatChain> chains;
    for (LinkId id = 0; id < static_cast<LinkId>(joinable_.size()); ++id) {
      if (used[id] || !joinable_[id]) continue;
      const auto [steps, closed] = StepsThrough(id);
      for (const ChainStep& step : steps) used[step.link] = 1;
      chains.push_back(ChainOf(steps, closed));
    }
    return chains;
  }

 private:
  bool IsJoinable(const DrawingLink& link) const {
    const size_t id = joinable_.size();
    if (link.kind == LinkKind::kRod || flat_.ellipses[id]) return false;
    const auto* arc = ShapeAs<CircularArc>(link);
    return !ShapeAs<CubicBSpline>(link) && !(arc && arc->IsCircle());
  }

  // Where the link's end is left from, if it is a line.
  std::optional<Eigen::Vector3d> DirectionOf(const LinkEnd& end) const {
    const auto* line = ShapeAs<LineSegment>(flat_.graph.links[end.link]);
    if (!line) return std::nullopt;
    const Eigen::Vector3d way = line->end - line->start;
    return (end.end == 0 ? way : -way).normalized();
  }

  void Pair(const DrawingNode& node) {
    std::vector<LinkEnd> ends;
    std::ranges::copy_if(node.incident, std::back_inserter(ends),
                         [&](const LinkEnd& end) { return joinable_[end.link] != 0; });
    if (node.Degree() == 2 && ends.size() == 2) {
      if (ends[0].link != ends[1].link) PairIfOnOneLayer(ends[0], ends[1]);
      return;
    }
    PairLines(ends);
  }

  // Those that go on best come first.
  void PairLines(const std::vector<LinkEnd>& ends) {
    std::vector<std::pair<double, std::pair<LinkEnd, LinkEnd>>> candidates;
    for (size_t i = 0; i < ends.size(); ++i) {
      for (size_t k = i + 1; k < ends.size(); ++k) {
        const auto a = DirectionOf(ends[i]), b = DirectionOf(ends[k]);
        if (!a || !b || ends[i].link == ends[k].link) continue;
        const double cosine = a->dot(*b);
        if (cosine < -std::cos(kMaxTurn)) candidates.push_back({cosine, {ends[i], ends[k]}});
      }
    }
    std::ranges::stable_sort(candidates, std::less<>(),
                             [](const auto& candidate) { return candidate.first; });
    for (const auto& [cosine, pair] : candidates) PairIfOnOneLayer(pair.first, pair.second);
  }

  void PairIfOnOneLayer(const LinkEnd& a, const LinkEnd& b) {
    auto& of_a = partners_[a.link][a.end];
    auto& of_b = partners_[b.link][b.end];
    if (of_a || of_b || layers_[a.link] != layers_[b.link]) return;
    of_a = b;
    of_b = a;
  }

  std::optional<ChainStep> Next(const ChainStep& step) const {
    const auto& partner = partners_[step.link][1 - step.BeginEnd()];
    if (!partner) return std::nullopt;
    return ChainStep{partner->link, partner->end == 1};
  }

  // From its first link, and whether it is a loop.
  std::pair<std::vector<ChainStep>, bool> StepsThrough(LinkId id) const {
    // Backwards to the beginning, or once around.
    ChainStep step = {id, true};
    while (const auto next = Next(step)) {
      step = *next;
      if (step.link == id) break;
    }
    const bool closed = step.link == id && Next({id, true}).has_value();
    ChainStep first = closed ? ChainStep{id, false} : ChainStep{step.link, !step.reversed};
    std::vector<ChainStep> steps = {first};
    for (auto next = Next(first); next && next->link != first.link; next = Next(*next)) {
      steps.push_back(*next);
    }
    return {steps, closed};
  }

  FlatChain ChainOf(const std::vector<ChainStep>& steps, bool closed) const {
    FlatChain chain;
    bool before_is_line = false;
    std::vector<Eigen::Vector2d> skipped;  // between the last vertex and the end of the last line
    Eigen::Vector2d end = Eigen::Vector2d::Zero();
    for (const ChainStep& step : steps) {
      const DrawingLink& link = flat_.graph.links[step.link];
      chain.links.push_back(step.link);
      const bool is_line = ShapeAs<LineSegment>(link) != nullptr;
      std::vector<ChainVertex> vertices = VerticesOf(step, &end);
      if (is_line && before_is_line) {
        skipped.push_back(vertices.front().place);
        if (IsStraight(chain.vertices.back().place, end, skipped)) continue;
      }
      skipped.clear();
      chain.vertices.insert(chain.vertices.end(), vertices.begin(), vertices.end());
      before_is_line = is_line;
    }
    chain.closed = closed || flat_.graph.links[steps.front().link].closed;
    if (!chain.closed) chain.vertices.push_back({end, 0});
    return chain;
  }

  bool IsStraight(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                  const std::vector<Eigen::Vector2d>& between) const {
    const Eigen::Vector2d way = to - from;
    if (!(way.norm() > 0)) return false;
    const Eigen::Vector2d across = Eigen::Vector2d(-way.y(), way.x()).normalized();
    return std::ranges::all_of(between, [&](const Eigen::Vector2d& place) {
      const double along = (place - from).dot(way);
      return std::abs((place - from).dot(across)) <= tolerance_ && along > 0 &&
             along < way.squaredNorm();
    });
  }

  // All but its last, which is `*end`.
  std::vector<ChainVertex> VerticesOf(const ChainStep& step, Eigen::Vector2d* end) const {
    const DrawingLink& link = flat_.graph.links[step.link];
    Polyline3d points = link.points_in_world;
    double bulge = 0;
    if (link.primitive) {
      const CurveShape& shape = link.primitive->shape;
      points = {PointAt(shape, 0), PointAt(shape, 1)};
      if (const auto* arc = ShapeAs<CircularArc>(link)) {
        bulge = std::copysign(std::tan(arc->sweep_rad / 4), arc->Normal().z());
      }
    }
    if (step.reversed) {
      std::reverse(points.begin(), points.end());
      bulge = -bulge;
    }
    std::vector<ChainVertex> vertices;
    for (size_t i = 0; i + 1 < points.size(); ++i) {
      vertices.push_back({points[i].head<2>(), bulge});
    }
    *end = points.back().head<2>();
    return vertices;
  }

  const FlatLinks& flat_;
  const std::vector<int>& layers_;
  double tolerance_;
  std::vector<uint8_t> joinable_;
  std::vector<std::array<std::optional<LinkEnd>, 2>> partners_;  // per link and end
};

}  // namespace

std::vector<FlatChain> FindChains(const FlatLinks& flat, const std::vector<int>& layer_of_link,
                                  double tolerance) {
  return ChainFinder(flat, layer_of_link, tolerance).Find();
}

}  // namespace limn
