// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/drawing_paths.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "limn/geometry/polyline.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

NodeId NodeOf(const DrawingGraph& graph, const LinkEnd& end) {
  const DrawingLink& link = graph.links[end.link];
  return end.end == 0 ? link.node0 : link.node1;
}

// The link end that continues this one at its node.
std::optional<LinkEnd> Partner(const DrawingGraph& graph, const LinkEnd& end) {
  const DrawingNode& node = graph.nodes[NodeOf(graph, end)];
  for (const auto& [first, second] : node.continuations) {
    if (first == end) return second;
    if (second == end) return first;
  }
  if (node.Degree() != 2) return std::nullopt;
  return node.incident[0] == end ? node.incident[1] : node.incident[0];
}

// Continuations may name one end twice; a step is only taken if it leads back, too.
std::optional<LinkEnd> Next(const DrawingGraph& graph, const LinkEnd& leaving) {
  const std::optional<LinkEnd> entered = Partner(graph, leaving);
  if (!entered || entered->link == leaving.link) return std::nullopt;
  return Partner(graph, *entered) == leaving ? entered : std::nullopt;
}

// The steps after the one that leaves its link at `leaving`, through links without a path.
DrawingPath Follow(const DrawingGraph& graph, LinkEnd leaving, std::vector<uint8_t>* used) {
  DrawingPath path;
  for (auto entered = Next(graph, leaving); entered && !(*used)[entered->link];
       entered = Next(graph, leaving)) {
    (*used)[entered->link] = 1;
    path.push_back({entered->link, entered->end == 1});
    leaving = {entered->link, 1 - entered->end};
  }
  return path;
}

}  // namespace

std::vector<int> ComponentsOfLinks(const DrawingGraph& graph) {
  UnionFind sets(static_cast<int>(graph.nodes.size()));
  for (const DrawingLink& link : graph.links) sets.Union(link.node0, link.node1);
  struct Component {
    double length = 0;
    LinkId first_link = -1;
  };
  std::map<int, Component> components;  // by the representative node
  for (size_t l = 0; l < graph.links.size(); ++l) {
    Component& component = components[sets.Find(graph.links[l].node0)];
    component.length += Length(graph.links[l].points_in_world);
    if (component.first_link < 0) component.first_link = static_cast<LinkId>(l);
  }
  std::vector<std::pair<int, Component>> ordered(components.begin(), components.end());
  std::sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) {
    if (a.second.length != b.second.length) return a.second.length > b.second.length;
    return a.second.first_link < b.second.first_link;
  });
  std::map<int, int> number;
  for (size_t i = 0; i < ordered.size(); ++i) number[ordered[i].first] = static_cast<int>(i);
  std::vector<int> component_of_link;
  for (const DrawingLink& link : graph.links) {
    component_of_link.push_back(number.at(sets.Find(link.node0)));
  }
  return component_of_link;
}

std::vector<DrawingPath> PathsOf(const DrawingGraph& graph) {
  std::vector<uint8_t> used(graph.links.size(), 0);
  std::vector<DrawingPath> paths;
  for (LinkId link = 0; link < static_cast<LinkId>(graph.links.size()); ++link) {
    if (used[link]) continue;
    used[link] = 1;
    DrawingPath path = {{link, false}};
    if (!graph.links[link].closed) {
      const DrawingPath after = Follow(graph, {link, 1}, &used);
      DrawingPath before = Follow(graph, {link, 0}, &used);
      // Walked away from the link; the path runs the other way.
      std::reverse(before.begin(), before.end());
      for (PathStep& step : before) step.reversed = !step.reversed;
      path.insert(path.begin(), before.begin(), before.end());
      path.insert(path.end(), after.begin(), after.end());
    }
    paths.push_back(std::move(path));
  }
  return paths;
}

std::vector<LinkId> CurvesOf(const DrawingGraph& graph) {
  UnionFind sets(static_cast<int>(graph.links.size()));
  for (const DrawingNode& node : graph.nodes) {
    for (const auto& [a, b] : node.continuations) sets.Union(a.link, b.link);
  }
  std::vector<LinkId> curves;
  for (LinkId link = 0; link < static_cast<LinkId>(graph.links.size()); ++link) {
    curves.push_back(sets.Find(link));
  }
  return curves;
}

}  // namespace limn
