// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/curve_chains.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "limn/geometry/weld.h"

namespace limn {
namespace {

struct Edge {
  int label = 0;
  int a = 0;
  int b = 0;
  double radius = 0;
};

struct Chain {
  int first_edge = 0;  // the smallest
  Polyline3d points;
  double radius = 0;  // of that edge
};

std::vector<Edge> CleanEdges(const EdgeSoup& soup, const std::vector<int>& weld) {
  std::vector<Edge> edges;
  std::set<std::tuple<int, int, int>> seen;
  for (size_t i = 0; i < soup.edges.size(); ++i) {
    const auto [v0, v1] = soup.edges[i];
    const int label = soup.labels.empty() ? 0 : soup.labels[i];
    if (weld[v0] == weld[v1]) continue;
    const auto pair = soup.merge_copies ? std::minmax(weld[v0], weld[v1]) : std::minmax(v0, v1);
    if (seen.insert({label, pair.first, pair.second}).second) {
      edges.push_back({label, weld[v0], weld[v1], soup.radii.empty() ? 0 : soup.radii[i]});
    }
  }
  return edges;
}

// Walks along edges; keeps per (label, vertex) the edges that end there.
class Chainer {
 public:
  Chainer(const std::vector<Eigen::Vector3d>& vertices, std::vector<Edge> edges)
      : vertices_(vertices), edges_(std::move(edges)), used_(edges_.size(), false) {
    for (size_t e = 0; e < edges_.size(); ++e) {
      ends_.push_back({edges_[e].label, edges_[e].a, static_cast<int>(e)});
      ends_.push_back({edges_[e].label, edges_[e].b, static_cast<int>(e)});
    }
    std::sort(ends_.begin(), ends_.end());
  }

  std::vector<Chain> Run() {
    std::vector<Chain> chains;
    for (size_t e = 0; e < edges_.size(); ++e) {
      for (const int vertex : {edges_[e].a, edges_[e].b}) {
        if (!used_[e] && Degree(edges_[e].label, vertex) != 2) {
          chains.push_back(Walk(static_cast<int>(e), vertex));
        }
      }
    }
    // What is left are cycles.
    for (size_t e = 0; e < edges_.size(); ++e) {
      if (!used_[e]) chains.push_back(Walk(static_cast<int>(e), edges_[e].a));
    }
    std::ranges::sort(chains, {}, &Chain::first_edge);
    return chains;
  }

 private:
  using End = std::tuple<int, int, int>;  // label, vertex, edge

  std::pair<const End*, const End*> EndsAt(int label, int vertex) const {
    const auto begin = std::lower_bound(ends_.begin(), ends_.end(), End{label, vertex, -1});
    const auto end = std::lower_bound(begin, ends_.end(), End{label, vertex + 1, -1});
    return {ends_.data() + (begin - ends_.begin()), ends_.data() + (end - ends_.begin())};
  }

  int Degree(int label, int vertex) const {
    const auto [begin, end] = EndsAt(label, vertex);
    return static_cast<int>(end - begin);
  }

  // The chain from `vertex` along `edge`.
  Chain Walk(int edge, int vertex) {
    Chain chain = {edge, {vertices_[vertex]}};
    while (edge >= 0) {
      used_[edge] = true;
      chain.first_edge = std::min(chain.first_edge, edge);
      vertex = edges_[edge].a == vertex ? edges_[edge].b : edges_[edge].a;
      chain.points.push_back(vertices_[vertex]);
      edge = NextEdge(edges_[edge].label, vertex);
    }
    chain.radius = edges_[chain.first_edge].radius;
    return chain;
  }

  int NextEdge(int label, int vertex) const {
    const auto [begin, end] = EndsAt(label, vertex);
    if (end - begin != 2) return -1;
    for (const End* candidate = begin; candidate != end; ++candidate) {
      if (!used_[std::get<2>(*candidate)]) return std::get<2>(*candidate);
    }
    return -1;
  }

  const std::vector<Eigen::Vector3d>& vertices_;
  std::vector<Edge> edges_;
  std::vector<bool> used_;
  std::vector<End> ends_;
};

}  // namespace

CurveSet ChainEdges(const EdgeSoup& soup) {
  CurveSet set;
  std::vector<bool> in_edge(soup.vertices.size(), false);
  for (const auto& [a, b] : soup.edges) in_edge[a] = in_edge[b] = true;
  for (size_t i = 0; i < soup.vertices.size(); ++i) {
    if (!in_edge[i]) set.points.push_back(soup.vertices[i]);
  }
  const std::vector<int> weld = WeldPoints(soup.vertices);
  for (Chain& chain : Chainer(soup.vertices, CleanEdges(soup, weld)).Run()) {
    set.polylines.push_back(std::move(chain.points));
    if (!soup.radii.empty()) set.rod_radii.push_back(chain.radius);
  }
  return set;
}

}  // namespace limn
