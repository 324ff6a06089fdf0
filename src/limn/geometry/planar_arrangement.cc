// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/planar_arrangement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace limn {
namespace {

struct Segment {
  Eigen::Vector2d from;
  Eigen::Vector2d to;
  int stroke = -1;
  int index = -1;  // of its first point in the stroke

  double MinX() const { return std::min(from.x(), to.x()); }
  double MaxX() const { return std::max(from.x(), to.x()); }
  double MinY() const { return std::min(from.y(), to.y()); }
  double MaxY() const { return std::max(from.y(), to.y()); }
};

// Where a segment is cut.
struct Cut {
  double t = 0;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
};

// Gives places the number of a vertex, one for all that are near each other.
class Vertices {
 public:
  explicit Vertices(double tolerance) : tolerance_(tolerance) {}

  int At(const Eigen::Vector2d& place) {
    const auto [col, row] = CellOf(place);
    for (int64_t c = col - 1; c <= col + 1; ++c) {
      for (int64_t r = row - 1; r <= row + 1; ++r) {
        const auto cell = cells_.find({c, r});
        if (cell == cells_.end()) continue;
        for (const int vertex : cell->second) {
          if ((places_[vertex] - place).norm() < tolerance_) return vertex;
        }
      }
    }
    places_.push_back(place);
    cells_[{col, row}].push_back(static_cast<int>(places_.size()) - 1);
    return static_cast<int>(places_.size()) - 1;
  }
  std::vector<Eigen::Vector2d> Take() { return std::move(places_); }

 private:
  std::pair<int64_t, int64_t> CellOf(const Eigen::Vector2d& place) const {
    return {static_cast<int64_t>(std::floor(place.x() / tolerance_)),
            static_cast<int64_t>(std::floor(place.y() / tolerance_))};
  }

  double tolerance_;
  std::vector<Eigen::Vector2d> places_;
  std::map<std::pair<int64_t, int64_t>, std::vector<int>> cells_;
};

std::vector<Segment> SegmentsOf(const std::vector<Polyline2d>& strokes) {
  std::vector<Segment> segments;
  for (size_t s = 0; s < strokes.size(); ++s) {
    for (size_t i = 0; i + 1 < strokes[s].size(); ++i) {
      if (strokes[s][i] == strokes[s][i + 1]) continue;
      segments.push_back(
          {strokes[s][i], strokes[s][i + 1], static_cast<int>(s), static_cast<int>(i)});
    }
  }
  return segments;
}

// Cuts a segment where an end of another touches it.
void CutAtEnd(const Segment& segment, const Eigen::Vector2d& end, double tolerance,
              std::vector<Cut>* cuts) {
  const Eigen::Vector2d along = segment.to - segment.from;
  const double t = (end - segment.from).dot(along) / along.squaredNorm();
  if (t <= 0 || t >= 1) return;
  if ((segment.from + t * along - end).norm() < tolerance) cuts->push_back({t, end});
}

// Cuts two segments where they cross.
void CutAtCrossing(const Segment& a, const Segment& b, std::vector<Cut>* cuts_a,
                   std::vector<Cut>* cuts_b) {
  const Eigen::Vector2d along_a = a.to - a.from;
  const Eigen::Vector2d along_b = b.to - b.from;
  const double turn = Cross(along_a, along_b);
  if (turn == 0) return;
  const double t = Cross(b.from - a.from, along_b) / turn;
  const double u = Cross(b.from - a.from, along_a) / turn;
  if (!(t > 0 && t < 1 && u > 0 && u < 1)) return;
  const Eigen::Vector2d place = a.from + t * along_a;
  cuts_a->push_back({t, place});
  cuts_b->push_back({u, place});
}

// Per segment, its ends and all places where it is cut, ascending.
std::vector<std::vector<Cut>> FindCuts(const std::vector<Segment>& segments, double tolerance) {
  std::vector<std::vector<Cut>> cuts(segments.size());
  std::vector<int> by_x(segments.size());
  std::iota(by_x.begin(), by_x.end(), 0);
  std::ranges::sort(by_x, {}, [&](int s) { return std::pair(segments[s].MinX(), s); });
  for (size_t i = 0; i < by_x.size(); ++i) {
    const Segment& a = segments[by_x[i]];
    for (size_t j = i + 1; j < by_x.size(); ++j) {
      const Segment& b = segments[by_x[j]];
      if (b.MinX() > a.MaxX() + tolerance) break;
      if (b.MinY() > a.MaxY() + tolerance || a.MinY() > b.MaxY() + tolerance) continue;
      std::vector<Cut>& cuts_a = cuts[by_x[i]];
      std::vector<Cut>& cuts_b = cuts[by_x[j]];
      for (const Eigen::Vector2d& end : {b.from, b.to}) CutAtEnd(a, end, tolerance, &cuts_a);
      for (const Eigen::Vector2d& end : {a.from, a.to}) CutAtEnd(b, end, tolerance, &cuts_b);
      CutAtCrossing(a, b, &cuts_a, &cuts_b);
    }
  }
  for (size_t s = 0; s < segments.size(); ++s) {
    cuts[s].push_back({0, segments[s].from});
    cuts[s].push_back({1, segments[s].to});
    std::ranges::stable_sort(cuts[s], {}, &Cut::t);
  }
  return cuts;
}

// The cells between edges, by walking along their left sides.
class CellFinder {
 public:
  CellFinder(const PlanarArrangement& arrangement, std::vector<uint8_t> use_edge)
      : arrangement_(arrangement), use_edge_(std::move(use_edge)) {}

  std::vector<ArrangementCell> Run() {
    do {
      DropDeadEnds();
      TraceLoops();
    } while (DropBridges());
    return CellsOfLoops();
  }

 private:
  struct Loop {
    std::vector<HalfEdge> half_edges;
    Polyline2d outline;
    double area = 0;
    int component = -1;
  };

  int NumHalfEdges() const { return 2 * static_cast<int>(arrangement_.edges.size()); }
  int From(HalfEdge half) const {
    const ArrangementEdge& edge = arrangement_.edges[half / 2];
    return half % 2 == 0 ? edge.a : edge.b;
  }
  int To(HalfEdge half) const { return From(half ^ 1); }

  // Edges of which an end meets no other, again and again.
  void DropDeadEnds() {
    std::vector<std::vector<int>> edges_at(arrangement_.vertices.size());
    std::vector<int> degree(arrangement_.vertices.size(), 0);
    for (size_t e = 0; e < use_edge_.size(); ++e) {
      if (!use_edge_[e]) continue;
      for (const int vertex : {arrangement_.edges[e].a, arrangement_.edges[e].b}) {
        edges_at[vertex].push_back(static_cast<int>(e));
        ++degree[vertex];
      }
    }
    std::vector<int> ends;
    for (size_t v = 0; v < degree.size(); ++v) {
      if (degree[v] == 1) ends.push_back(static_cast<int>(v));
    }
    while (!ends.empty()) {
      const int vertex = ends.back();
      ends.pop_back();
      for (const int e : edges_at[vertex]) {
        if (!use_edge_[e]) continue;
        use_edge_[e] = 0;
        for (const int end : {arrangement_.edges[e].a, arrangement_.edges[e].b}) {
          if (--degree[end] == 1) ends.push_back(end);
        }
      }
    }
  }

  // Per half-edge, the next one around what is on its left: the first clockwise from the way back.
  std::vector<HalfEdge> FindNext() const {
    std::vector<std::vector<std::pair<double, HalfEdge>>> leaving(arrangement_.vertices.size());
    for (HalfEdge half = 0; half < NumHalfEdges(); ++half) {
      if (!use_edge_[half / 2]) continue;
      const Eigen::Vector2d way =
          arrangement_.vertices[To(half)] - arrangement_.vertices[From(half)];
      leaving[From(half)].push_back({std::atan2(way.y(), way.x()), half});
    }
    std::vector<HalfEdge> next(NumHalfEdges(), -1);
    for (auto& ways : leaving) {
      std::ranges::sort(ways);
      for (size_t i = 0; i < ways.size(); ++i) {
        next[ways[i].second ^ 1] = ways[(i + ways.size() - 1) % ways.size()].second;
      }
    }
    return next;
  }

  void TraceLoops() {
    const std::vector<HalfEdge> next = FindNext();
    loop_of_.assign(NumHalfEdges(), -1);
    loops_.clear();
    for (HalfEdge start = 0; start < NumHalfEdges(); ++start) {
      if (!use_edge_[start / 2] || loop_of_[start] >= 0) continue;
      Loop loop;
      for (HalfEdge half = start; loop_of_[half] < 0; half = next[half]) {
        loop_of_[half] = static_cast<int>(loops_.size());
        loop.half_edges.push_back(half);
        loop.outline.push_back(arrangement_.vertices[From(half)]);
      }
      loop.area = SignedArea(loop.outline);
      loops_.push_back(std::move(loop));
    }
  }

  // Edges with the same on both sides.
  bool DropBridges() {
    bool any = false;
    for (size_t e = 0; e < use_edge_.size(); ++e) {
      if (!use_edge_[e] || loop_of_[2 * e] != loop_of_[2 * e + 1]) continue;
      use_edge_[e] = 0;
      any = true;
    }
    return any;
  }

  // Loops whose edges hang together have the same number.
  void FindComponents() {
    std::vector<int> parent(arrangement_.vertices.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int v) {
      while (parent[v] != v) v = parent[v] = parent[parent[v]];
      return v;
    };
    for (size_t e = 0; e < use_edge_.size(); ++e) {
      if (use_edge_[e]) parent[root(arrangement_.edges[e].a)] = root(arrangement_.edges[e].b);
    }
    for (Loop& loop : loops_) loop.component = root(From(loop.half_edges.front()));
  }

  // The smallest cell of another component around a loop, -1: none.
  int CellAround(const Loop& hole, const std::vector<int>& cells) const {
    int around = -1;
    for (size_t c = 0; c < cells.size(); ++c) {
      const Loop& border = loops_[cells[c]];
      if (border.component == hole.component || border.area < -hole.area) continue;
      if (around >= 0 && loops_[cells[around]].area <= border.area) continue;
      if (Polygon2d{{border.outline}}.Contains(hole.outline[0])) around = static_cast<int>(c);
    }
    return around;
  }

  std::vector<ArrangementCell> CellsOfLoops() {
    FindComponents();
    std::vector<int> loop_of_cell;
    std::vector<ArrangementCell> cells;
    for (size_t l = 0; l < loops_.size(); ++l) {
      if (!(loops_[l].area > 0)) continue;
      loop_of_cell.push_back(static_cast<int>(l));
      cells.push_back({{loops_[l].half_edges}, {{loops_[l].outline}}});
    }
    for (const Loop& loop : loops_) {
      if (!(loop.area < 0)) continue;
      const int around = CellAround(loop, loop_of_cell);
      if (around < 0) continue;
      cells[around].loops.push_back(loop.half_edges);
      cells[around].polygon.outlines.push_back(loop.outline);
    }
    return cells;
  }

  const PlanarArrangement& arrangement_;
  std::vector<uint8_t> use_edge_;
  std::vector<Loop> loops_;
  std::vector<int> loop_of_;  // per half-edge
};

}  // namespace

PlanarArrangement Arrange(const std::vector<Polyline2d>& strokes, double tolerance) {
  const std::vector<Segment> segments = SegmentsOf(strokes);
  const std::vector<std::vector<Cut>> cuts = FindCuts(segments, tolerance);
  PlanarArrangement arrangement;
  Vertices vertices(tolerance);
  std::set<std::pair<int, int>> known;
  for (size_t s = 0; s < segments.size(); ++s) {
    int before = vertices.At(cuts[s][0].place);
    double from = segments[s].index;
    for (size_t i = 1; i < cuts[s].size(); ++i) {
      const int vertex = vertices.At(cuts[s][i].place);
      if (vertex == before) continue;
      const double to = segments[s].index + cuts[s][i].t;
      if (known.insert(std::minmax(before, vertex)).second) {
        arrangement.edges.push_back({before, vertex, {segments[s].stroke, from, to}});
      }
      before = vertex;
      from = to;
    }
  }
  arrangement.vertices = vertices.Take();
  return arrangement;
}

std::vector<ArrangementCell> FindCells(const PlanarArrangement& arrangement,
                                       std::vector<uint8_t> use_edge) {
  return CellFinder(arrangement, std::move(use_edge)).Run();
}

std::vector<StrokeRun> RunsAlong(const PlanarArrangement& arrangement,
                                 const std::vector<HalfEdge>& loop) {
  // Small parts at vertices are skipped, so that runs of one stroke may begin a little later.
  constexpr double kMaxSkipped = 1;
  std::vector<StrokeRun> runs;
  const auto continues = [&](const StrokeRun& run, const StrokeRun& next) {
    const bool forward = run.to > run.from;
    return run.stroke == next.stroke && forward == (next.to > next.from) &&
           (forward ? next.from >= run.to : next.from <= run.to) &&
           std::abs(next.from - run.to) < kMaxSkipped;
  };
  for (const HalfEdge half : loop) {
    StrokeRun run = arrangement.edges[half / 2].run;
    if (half % 2 == 1) std::swap(run.from, run.to);
    if (!runs.empty() && continues(runs.back(), run)) {
      runs.back().to = run.to;
    } else {
      runs.push_back(run);
    }
  }
  if (runs.size() > 1 && continues(runs.back(), runs.front())) {
    runs.front().from = runs.back().from;
    runs.pop_back();
  }
  return runs;
}

}  // namespace limn
