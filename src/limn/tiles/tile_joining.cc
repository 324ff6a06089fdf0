#include "limn/tiles/tile_joining.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "limn/geometry/polyline.h"
#include "limn/geometry/spatial_index.h"
#include "limn/model/footprint.h"
#include "limn/model/graph_edits.h"
#include "limn/tiles/tile_cropping.h"

namespace limn {
namespace {

// Ends of one curve in two tiles are this near to each other, px, and turn by no more than this.
constexpr double kMaxGapPx = 3;
constexpr double kMinCosine = 0.94;  // 20 degrees
// The gap is closed over this length of both links, px.
constexpr double kBlendPx = 15;
// A link that another tile does not go on with is kept from this length on, px.
constexpr double kMinOpenPx = 15;
// And one that closes itself from this length on, px.
constexpr double kMinLoopPx = 12;

// An end on the border of its tile.
struct CutEnd {
  LinkEnd end;
  int tile = 0;
  double footprint = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d outward = Eigen::Vector3d::Zero();
};

void Append(DrawingGraph tile, DrawingGraph* whole) {
  const auto first_node = static_cast<NodeId>(whole->nodes.size());
  const auto first_link = static_cast<LinkId>(whole->links.size());
  for (DrawingNode& node : tile.nodes) {
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
    const auto first_link = static_cast<LinkId>(graph_.links.size());
    for (const DrawingNode& node : tile.graph.nodes) {
      if (node.Degree() != 1 || !IsOnBorder(tile.core, node.position_in_world)) continue;
      AddCutEnd(node, tile.graph, first_link);
    }
    Append(std::move(tile.graph), &graph_);
    ++num_tiles_;
  }

  JoinedTiles Run() {
    keep_.assign(graph_.links.size(), 1);
    std::vector<uint8_t> used(cuts_.size(), 0);
    JoinedTiles result;
    for (const auto& [px, i, j] : FindPairs()) {
      if (used[i] || used[j] || !Join(cuts_[i], cuts_[j])) continue;
      used[i] = used[j] = 1;
      ++result.joined;
    }
    for (size_t i = 0; i < cuts_.size(); ++i) {
      if (used[i]) continue;
      const LinkId link = moves_.Now(cuts_[i].end).link;
      if (LengthPx(link, cuts_[i].footprint) >= kMinOpenPx) {
        ++result.open_ends;
      } else {
        result.stubs += keep_[link];
        keep_[link] = 0;
      }
    }
    RemoveLinks(keep_, &graph_);
    result.graph = std::move(graph_);
    return result;
  }

 private:
  using Pair = std::tuple<double, int, int>;  // gap, px, and two cut ends

  void AddCutEnd(const DrawingNode& node, const DrawingGraph& tile, LinkId first_link) {
    const LinkEnd end = node.incident.front();
    const DrawingLink& link = tile.links[end.link];
    const double footprint = LinkFootprint(link, node.position_in_world, views_);
    if (!(footprint > 0)) return;
    cuts_.push_back({{end.link + first_link, end.end},
                     num_tiles_,
                     footprint,
                     node.position_in_world,
                     TipOf(link, end.end, footprint).outward});
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
        pairs.push_back(
            {std::sqrt(neighbor.squared_distance) / cuts_[i].footprint, i, neighbor.index});
      }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  double LengthPx(LinkId link, double footprint) const {
    return Length(graph_.links[link].points_in_world) / footprint;
  }

  // False if the two are the ends of what is shorter than a loop.
  bool Join(const CutEnd& cut_a, const CutEnd& cut_b) {
    const LinkEnd a = moves_.Now(cut_a.end), b = moves_.Now(cut_b.end);
    if (a.link == b.link && LengthPx(a.link, cut_a.footprint) < kMinLoopPx) return false;
    const Eigen::Vector3d middle = (cut_a.position + cut_b.position) / 2;
    Bend(a, middle - cut_a.position, kBlendPx * cut_a.footprint);
    Bend(b, middle - cut_b.position, kBlendPx * cut_b.footprint);
    DropEnd(a);  // the other link has it, too
    JoinEnds(a, b, &graph_);
    if (a.link == b.link) {
      const DrawingLink& loop = graph_.links[a.link];
      graph_.nodes[loop.node0].position_in_world = loop.points_in_world.front();
      return true;
    }
    keep_[b.link] = 0;
    moves_.Joined(a, b);
    return true;
  }

  // Move an end, and less and less what is up to `reach` away along the link, but not its other
  // end.
  void Bend(const LinkEnd& end, const Eigen::Vector3d& offset, double reach) {
    std::vector<Eigen::Vector3d>& points = graph_.links[end.link].points_in_world;
    reach = std::min(reach, Length(points));
    const int size = static_cast<int>(points.size());
    const auto at = [&](int k) -> Eigen::Vector3d& {
      return points[end.end == 0 ? k : size - 1 - k];
    };
    double arc = 0;
    Eigen::Vector3d before = at(0);
    for (int k = 0; k + 1 < size && arc < reach; ++k) {
      const Eigen::Vector3d point = at(k);
      arc += (point - before).norm();
      if (arc < reach) at(k) += (1 - arc / reach) * offset;
      before = point;
    }
  }

  void DropEnd(const LinkEnd& end) {
    DrawingLink& link = graph_.links[end.link];
    const auto drop = [&](auto* values) {
      values->erase(end.end == 0 ? values->begin() : values->end() - 1);
    };
    drop(&link.points_in_world);
    drop(&link.sigma);
  }

  const std::vector<View>& views_;
  DrawingGraph graph_;
  std::vector<CutEnd> cuts_;
  int num_tiles_ = 0;
  std::vector<uint8_t> keep_;
  EndMoves moves_;
};

}  // namespace

JoinedTiles JoinTiles(std::vector<TileDrawing> tiles, const std::vector<View>& views) {
  TileJoiner joiner(views);
  for (TileDrawing& tile : tiles) joiner.Add(std::move(tile));
  return joiner.Run();
}

}  // namespace limn
