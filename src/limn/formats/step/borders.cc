// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/step/borders.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include <Eigen/Geometry>

#include "limn/formats/step/border_loops.h"
#include "limn/formats/step/border_vertices.h"
#include "limn/geometry/polyline.h"
#include "limn/geometry/polyline_position.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

// Per link the positions where it is cut, ascending, with both its ends.
using LinkCuts = std::vector<std::vector<double>>;

// Sorted positions without those that are nearer to another one or an end than 0.1 % of the link.
std::vector<double> DistinctCuts(const DrawingLink& link, std::vector<double> positions) {
  constexpr double kLeastShare = 1e-3;
  const std::vector<double> lengths = CumulativeLength(link.points_in_world);
  const auto length_at = [&](double position) { return LengthAtPosition(lengths, position); };
  const double least = kLeastShare * lengths.back();
  std::sort(positions.begin(), positions.end());
  std::vector<double> cuts = {0};
  for (const double position : positions) {
    const double length = length_at(position);
    if (length - length_at(cuts.back()) > least && lengths.back() - length > least) {
      cuts.push_back(position);
    }
  }
  cuts.push_back(link.size() - 1);
  return cuts;
}

LinkCuts CutsOf(const DrawingGraph& graph, const std::vector<StepSheet>& sheets) {
  LinkCuts cuts(graph.links.size());
  for (const StepSheet& sheet : sheets) {
    for (const FaceLoop& side : sheet.sides) {
      for (const FaceEdge& edge : side) {
        if (edge.IsBridge()) continue;
        cuts[edge.link].insert(cuts[edge.link].end(), {edge.from, edge.to});
      }
    }
  }
  for (size_t l = 0; l < cuts.size(); ++l) {
    if (!cuts[l].empty()) cuts[l] = DistinctCuts(graph.links[l], std::move(cuts[l]));
  }
  return cuts;
}

// Where an edge begins or ends on the points of its link, or its bridge.
Eigen::Vector3d FirstPointOf(const DrawingGraph& graph, const FaceEdge& edge) {
  if (edge.IsBridge()) return edge.bridge.front();
  return PointAtPosition(graph.links[edge.link].points_in_world, edge.from);
}
Eigen::Vector3d LastPointOf(const DrawingGraph& graph, const FaceEdge& edge) {
  if (edge.IsBridge()) return edge.bridge.back();
  return PointAtPosition(graph.links[edge.link].points_in_world, edge.to);
}

double SizeOf(const DrawingGraph& graph, const StepSheet& sheet) {
  Eigen::AlignedBox3d box;
  for (const FaceLoop& side : sheet.sides) {
    for (const FaceEdge& edge : side) {
      for (const Eigen::Vector3d& point : CourseOf(graph, edge)) box.extend(point);
    }
  }
  return box.diagonal().norm();
}

class BorderBuilder {
 public:
  BorderBuilder(const DrawingGraph& graph, double max_gap_rel)
      : graph_(graph), max_gap_rel_(max_gap_rel) {}

  FaceBorders Build(const std::vector<StepSheet>& sheets) {
    cuts_ = CutsOf(graph_, sheets);
    for (const DrawingNode& node : graph_.nodes) {
      places_.push_back(PlaceOfNode(graph_, node));
    }
    PlaceCuts();
    std::vector<PlacedSheet> placed;
    for (const StepSheet& sheet : sheets) placed.push_back(Place(sheet));
    Unite(placed);
    for (const PlacedSheet& sheet : placed) {
      if (!sheet.is_open) AddSheet(sheet);
    }
    DropUnusedVertices();
    FitVerticesToPlanes(graph_, &borders_);
    return std::move(borders_);
  }

 private:
  // An edge of a sheet between two places.
  struct PlacedEdge {
    const FaceEdge* edge;
    int start;
    int end;
  };
  struct PlacedSheet {
    const StepSheet* sheet;
    std::vector<std::vector<PlacedEdge>> sides;
    bool is_open = false;
  };

  size_t CutIndex(int link, double position) const {
    const std::vector<double>& cuts = cuts_[link];
    const auto above = std::lower_bound(cuts.begin(), cuts.end(), position);
    if (above == cuts.begin()) return 0;
    if (above == cuts.end()) return cuts.size() - 1;
    const auto below = std::prev(above);
    return (position - *below <= *above - position ? below : above) - cuts.begin();
  }

  int AddPlace(const Eigen::Vector3d& position) {
    places_.push_back(position);
    return static_cast<int>(places_.size()) - 1;
  }

  // Before ends of bridges: of places that are one, the first says where it is.
  void PlaceCuts() {
    for (size_t link = 0; link < cuts_.size(); ++link) {
      for (size_t cut = 1; cut + 1 < cuts_[link].size(); ++cut) {
        place_of_cut_[{static_cast<int>(link), cut}] =
            AddPlace(PlaceOnCurve(graph_, static_cast<int>(link), cuts_[link][cut]));
      }
    }
  }

  int PlaceOfCut(int link, size_t cut) const {
    if (cut == 0) return graph_.links[link].node0;
    if (cut + 1 == cuts_[link].size()) return graph_.links[link].node1;
    return place_of_cut_.at({link, cut});
  }

  PlacedSheet Place(const StepSheet& sheet) {
    PlacedSheet placed = {&sheet, {}, false};
    for (const FaceLoop& side : sheet.sides) {
      auto& edges = placed.sides.emplace_back();
      for (const FaceEdge& edge : side) {
        if (edge.IsBridge()) {
          edges.push_back({&edge, AddPlace(edge.bridge.front()), AddPlace(edge.bridge.back())});
        } else {
          edges.push_back({&edge, PlaceOfCut(edge.link, CutIndex(edge.link, edge.from)),
                           PlaceOfCut(edge.link, CutIndex(edge.link, edge.to))});
        }
      }
    }
    return placed;
  }

  // Where an edge ends and the next of the loop begins: two places that are one.
  struct Joint {
    PlacedEdge before;
    PlacedEdge after;
  };

  std::vector<Joint> JointsOf(const PlacedSheet& placed) const {
    std::vector<std::vector<PlacedEdge>> loops = placed.sides;
    if (graph_.faces[placed.sheet->face].surface != FaceSurface::kPlane) {
      loops = {{}};
      for (const auto& side : placed.sides) {
        loops[0].insert(loops[0].end(), side.begin(), side.end());
      }
    }
    std::vector<Joint> joints;
    for (const auto& loop : loops) {
      for (size_t i = 0; i < loop.size(); ++i) {
        joints.push_back({loop[i], loop[(i + 1) % loop.size()]});
      }
    }
    return joints;
  }

  // Between points: primitives may end elsewhere, but are moved. Borders of planes are projected
  // onto them: only what is left along the plane is a gap.
  double GapAt(int face_id, const Joint& joint) const {
    const DrawingFace& face = graph_.faces[face_id];
    Eigen::Vector3d gap =
        FirstPointOf(graph_, *joint.after.edge) - LastPointOf(graph_, *joint.before.edge);
    if (face.surface == FaceSurface::kPlane) gap -= face.normal.dot(gap) * face.normal;
    return gap.norm();
  }

  void Unite(std::vector<PlacedSheet>& sheets) {
    UnionFind same(static_cast<int>(places_.size()));
    for (PlacedSheet& placed : sheets) {
      const double max_gap = max_gap_rel_ * SizeOf(graph_, *placed.sheet);
      const std::vector<Joint> joints = JointsOf(placed);
      placed.is_open = std::any_of(joints.begin(), joints.end(), [&](const Joint& joint) {
        return GapAt(placed.sheet->face, joint) > max_gap;
      });
      if (placed.is_open) continue;
      for (const Joint& joint : joints) same.Union(joint.before.end, joint.after.start);
    }
    for (size_t p = 0; p < places_.size(); ++p) {
      vertex_of_place_.push_back(same.Find(static_cast<int>(p)));
    }
  }

  void AddSheet(const PlacedSheet& placed) {
    BorderSheet sheet;
    sheet.face = placed.sheet->face;
    const bool is_plane = graph_.faces[sheet.face].surface == FaceSurface::kPlane;
    for (const auto& side : placed.sides) {
      std::vector<BorderStep> steps = StepsOf(side);
      if (steps.empty()) return;
      if (is_plane) {
        Mark(steps, *placed.sheet);
        for (auto& loop : SimpleLoops(borders_.edges, steps))
          sheet.sides.push_back(std::move(loop));
      } else {
        sheet.sides.push_back(std::move(steps));
      }
    }
    borders_.sheets.push_back(std::move(sheet));
  }

  std::vector<BorderStep> StepsOf(const std::vector<PlacedEdge>& side) {
    std::vector<BorderStep> steps;
    for (const PlacedEdge& edge : side) {
      if (edge.edge->IsBridge()) {
        AddBridge(edge, &steps);
      } else {
        AddPartsOfLink(*edge.edge, &steps);
      }
    }
    return steps;
  }

  // As edges of a plane.
  void Mark(const std::vector<BorderStep>& steps, const StepSheet& sheet) {
    for (const BorderStep& step : steps) {
      BorderEdge& edge = borders_.edges[step.edge];
      if (sheet.of_points) edge.of_points = true;
      if (edge.planes.empty() || edge.planes.back() != sheet.face) {
        edge.planes.push_back(sheet.face);
      }
    }
  }

  void AddPartsOfLink(const FaceEdge& edge, std::vector<BorderStep>* steps) {
    const size_t from = CutIndex(edge.link, edge.from), to = CutIndex(edge.link, edge.to);
    const bool reversed = from > to;
    for (size_t i = from; i != to; reversed ? --i : ++i) {
      const int part = EdgeOfPart(edge.link, reversed ? i - 1 : i);
      if (part >= 0) steps->push_back({part, reversed});
    }
  }

  // The edge from a cut of a link to the next; -1 if its ends are one vertex although it is not a
  // loop.
  int EdgeOfPart(int link, size_t cut) {
    const auto [found, is_new] = edge_of_part_.try_emplace({link, cut}, -1);
    if (!is_new) return found->second;
    BorderEdge part;
    part.link = link;
    part.from = cuts_[link][cut];
    part.to = cuts_[link][cut + 1];
    part.start = vertex_of_place_[PlaceOfCut(link, cut)];
    part.end = vertex_of_place_[PlaceOfCut(link, cut + 1)];
    const bool is_loop = graph_.links[link].closed && cuts_[link].size() == 2;
    if (part.start == part.end && !is_loop) return -1;
    part.course = CourseOf(graph_, {link, part.from, part.to, {}});
    found->second = static_cast<int>(borders_.edges.size());
    borders_.edges.push_back(std::move(part));
    return found->second;
  }

  // Bridges between the same vertices are one if they are straight or go through one middle.
  void AddBridge(const PlacedEdge& placed, std::vector<BorderStep>* steps) {
    const int start = vertex_of_place_[placed.start], end = vertex_of_place_[placed.end];
    if (start == end) return;
    const std::vector<Eigen::Vector3d>& course = placed.edge->bridge;
    std::vector<int>& others = bridges_[std::minmax(start, end)];
    for (const int id : others) {
      const BorderEdge& other = borders_.edges[id];
      if (!AreAlike(course, other.course)) continue;
      steps->push_back({id, other.start != start});
      return;
    }
    BorderEdge bridge;
    bridge.start = start;
    bridge.end = end;
    bridge.course = course;
    others.push_back(static_cast<int>(borders_.edges.size()));
    steps->push_back({others.back(), false});
    borders_.edges.push_back(std::move(bridge));
  }

  bool AreAlike(const std::vector<Eigen::Vector3d>& a,
                const std::vector<Eigen::Vector3d>& b) const {
    if (a.size() == 2 && b.size() == 2) return true;
    const double length = Length(a);
    const auto middle = CutPolyline(a, length / 2, length).front();
    return ClosestPoint(b, middle).squared_distance < max_gap_rel_ * max_gap_rel_ * length * length;
  }

  void DropUnusedVertices() {
    std::vector<int> new_vertex(places_.size(), -1);
    const auto rename = [&](int* vertex) {
      int& renamed = new_vertex[*vertex];
      if (renamed < 0) {
        renamed = static_cast<int>(borders_.vertices.size());
        borders_.vertices.push_back(places_[*vertex]);
      }
      *vertex = renamed;
    };
    for (BorderEdge& edge : borders_.edges) {
      rename(&edge.start);
      rename(&edge.end);
    }
  }

  const DrawingGraph& graph_;
  double max_gap_rel_;
  LinkCuts cuts_;
  // Nodes, then cuts of links and ends of bridges.
  std::vector<Eigen::Vector3d> places_;
  std::vector<int> vertex_of_place_;
  std::map<std::pair<int, size_t>, int> place_of_cut_;
  std::map<std::pair<int, size_t>, int> edge_of_part_;
  std::map<std::pair<int, int>, std::vector<int>> bridges_;
  FaceBorders borders_;
};

}  // namespace

FaceBorders MakeFaceBorders(const DrawingGraph& graph, const std::vector<StepSheet>& sheets,
                            double max_gap_rel) {
  return BorderBuilder(graph, max_gap_rel).Build(sheets);
}

}  // namespace limn
