// SPDX-License-Identifier: BSD-3-Clause
#include "limn/tiles/tile_joining.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "limn/geometry/polyline.h"
#include "limn/geometry/spatial_index.h"
#include "limn/model/footprint.h"
#include "limn/tiles/tile_cropping.h"
#include "limn/topology/graph_editor.h"
#include "limn/topology/join_ends.h"
#include "limn/topology/link_geometry.h"

namespace limn {
namespace {

// Largest distance, px, and turn between ends of one curve in two tiles.
constexpr double kMaxGapPx = 3;
constexpr double kMinCosine = 0.94;  // 20 degrees
// Length of both links over which the gap is blended, px.
constexpr double kBlendPx = 15;
// Shortest link that is kept if no other tile continues it, px.
constexpr double kMinOpenPx = 15;

// An end on the border of its tile.
struct CutEnd {
  LinkEnd end;
  int tile = 0;
  double footprint = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d outward = Eigen::Vector3d::Zero();
  bool is_rod = false;
};

void Append(DrawingGraph tile, DrawingGraph* whole) {
  const auto first_node = static_cast<NodeId>(whole->nodes.size());
  const auto first_link = static_cast<LinkId>(whole->links.size());
  for (DrawingNode& node : tile.nodes) {
    for (LinkEnd& end : node.incident) end.link += first_link;
    for (auto& [a, b] : node.continuations) {
      a.link += first_link;
      b.link += first_link;
    }
    whole->nodes.push_back(std::move(node));
  }
  for (DrawingLink& link : tile.links) {
    link.node0 += first_node;
    link.node1 += first_node;
    link.members.clear();
    whole->links.push_back(std::move(link));
  }
}

class TileJoiner {
 public:
  explicit TileJoiner(const std::vector<View>& views) : views_(views) {}

  void Add(TileDrawing tile) {
    CropDrawing(tile.core, &tile.graph);
    for (const Eigen::AlignedBox3d& hole : tile.holes) CutOut(hole, &tile.graph);
    const auto first_link = static_cast<LinkId>(graph_.links.size());
    for (const DrawingNode& node : tile.graph.nodes) {
      if (node.Degree() != 1 || !IsCut(tile, node.position_in_world)) continue;
      AddCutEnd(node, tile.graph, first_link);
    }
    Append(std::move(tile.graph), &graph_);
    ++num_tiles_;
  }

  JoinedTiles Run() {
    GraphEditor editor(&graph_);
    std::vector<uint8_t> used(cuts_.size(), 0);
    JoinedTiles result;
    for (const auto& [px, i, j] : FindPairs()) {
      if (used[i] || used[j] || !Join(cuts_[i], cuts_[j], px, &editor)) continue;
      used[i] = used[j] = 1;
      ++result.joined;
    }
    for (size_t i = 0; i < cuts_.size(); ++i) {
      if (used[i]) continue;
      const LinkId id = editor.CurrentEnd(cuts_[i].end).link;
      if (!editor.IsLink(id)) continue;
      if (Length(editor.link(id).points_in_world) >= kMinOpenPx * cuts_[i].footprint) {
        ++result.open_ends;
      } else {
        ++result.stubs;
        editor.Remove(id);
      }
    }
    editor.Compact();
    result.graph = std::move(graph_);
    return result;
  }

 private:
  using Pair = std::tuple<double, int, int>;  // gap, px, and two cut ends

  static bool IsCut(const TileDrawing& tile, const Eigen::Vector3d& end) {
    return IsOnBorder(tile.core, end) ||
           std::ranges::any_of(tile.holes, [&](const auto& hole) { return IsOnBorder(hole, end); });
  }

  void AddCutEnd(const DrawingNode& node, const DrawingGraph& tile, LinkId first_link) {
    const LinkEnd end = node.incident.front();
    const DrawingLink& link = tile.links[end.link];
    const double footprint = LinkFootprint(link, node.position_in_world, views_);
    if (!(footprint > 0)) return;
    cuts_.push_back({{end.link + first_link, end.end},
                     num_tiles_,
                     footprint,
                     node.position_in_world,
                     TipOf(link, end.end, footprint).outward,
                     link.kind == LinkKind::kRod});
  }

  std::vector<Pair> FindPairs() const {
    std::vector<Eigen::Vector3d> points;
    for (const CutEnd& cut : cuts_) points.push_back(cut.position);
    std::vector<Pair> pairs;
    if (points.empty()) return pairs;
    const SpatialIndex index(points);
    std::vector<SpatialIndex::Neighbor> near;
    for (int i = 0; i < static_cast<int>(cuts_.size()); ++i) {
      index.FindWithin(points[i], kMaxGapPx * cuts_[i].footprint, &near);
      for (const SpatialIndex::Neighbor& neighbor : near) {
        const CutEnd& other = cuts_[neighbor.index];
        if (neighbor.index <= i || other.tile == cuts_[i].tile) continue;
        if (cuts_[i].outward.dot(-other.outward) < kMinCosine) continue;
        if (cuts_[i].is_rod != other.is_rod) continue;  // an outline beside it
        pairs.push_back(
            {std::sqrt(neighbor.squared_distance) / cuts_[i].footprint, i, neighbor.index});
      }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  // Returns false for the two ends of one link that is too short for a loop.
  static bool Join(const CutEnd& cut_a, const CutEnd& cut_b, double gap_px, GraphEditor* editor) {
    const LinkEnd a = editor->CurrentEnd(cut_a.end), b = editor->CurrentEnd(cut_b.end);
    const double length = Length(editor->link(a.link).points_in_world);
    if (a.link == b.link && !MayClose(length / cut_a.footprint, gap_px)) return false;
    const Eigen::Vector3d middle = (cut_a.position + cut_b.position) / 2;
    Bend(a, middle, kBlendPx * cut_a.footprint, editor);
    Bend(b, middle, kBlendPx * cut_b.footprint, editor);
    editor->Join(a, b);
    return true;
  }

  // Moves an end, and points within `reach` along the link by less and less, but not the other end.
  static void Bend(const LinkEnd& end, const Eigen::Vector3d& to, double reach,
                   GraphEditor* editor) {
    const std::vector<Eigen::Vector3d>& points = editor->link(end.link).points_in_world;
    const Eigen::Vector3d offset = to - EndPoint(editor->link(end.link), end.end);
    reach = std::min(reach, Length(points));
    const int size = static_cast<int>(points.size());
    const auto index = [&](int k) { return end.end == 0 ? k : size - 1 - k; };
    double arc = 0;
    Eigen::Vector3d before = points[index(0)];
    for (int k = 1; k + 1 < size && arc < reach; ++k) {
      const Eigen::Vector3d point = points[index(k)];
      arc += (point - before).norm();
      if (arc < reach) editor->MovePoint(end.link, index(k), point + (1 - arc / reach) * offset);
      before = point;
    }
    editor->MoveNode(editor->NodeAt(end), to);
  }

  const std::vector<View>& views_;
  DrawingGraph graph_;
  std::vector<CutEnd> cuts_;
  int num_tiles_ = 0;
};

}  // namespace

JoinedTiles JoinTiles(std::vector<TileDrawing> tiles, const std::vector<View>& views) {
  TileJoiner joiner(views);
  for (TileDrawing& tile : tiles) joiner.Add(std::move(tile));
  return joiner.Run();
}

}  // namespace limn
