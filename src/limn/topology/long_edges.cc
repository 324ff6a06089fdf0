// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/long_edges.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include <Eigen/Eigenvalues>

#include "limn/geometry/tangent_frame.h"
#include "limn/support/segment_support.h"
#include "limn/topology/edgel_claims.h"
#include "limn/topology/fragment_neighbors.h"
#include "limn/topology/spanned_pairs.h"
#include "limn/util/angles.h"
#include "limn/util/map_items.h"

namespace limn {
namespace {

// Shortest edge, px.
constexpr double kMinEdgePx = 20;
// Number of views in which one image curve must run from end to end, of views in which edgels must
// run along the edge, and their least share of the views that show a link at either end.
constexpr int kMinSpanningViews = 3;
constexpr int kMinShowingViews = 4;
constexpr double kMinShowingShare = 0.5;
constexpr double kMaxEdgeChance = 1e-2;
// Narrower than near corners: the line is long.
constexpr SupportGate kEdgeGate = {1.0, 1.5, 15 * kDeg};
// Largest standard deviation of an end across the edge, px. Links tell the position of their ends
// from this far on, px.
constexpr double kMaxEndSigmaPx = 1;
constexpr int kEndBeginPx = 2;
constexpr int kEndEndPx = 14;
// Spacing of the points at which edgels along an edge are looked up, px.
constexpr double kEdgelStepPx = 1.2;
// An edge is drawn already if this share of its edgels, or neighbors on their fragments, support
// one link.
constexpr double kDrawnShare = 0.5;
// An edge is not added if better ones explain this share of its edgels, and replaces links of whose
// edgels it explains this share. An edgel explains its neighbors on the fragment, too.
constexpr double kMaxExplainedShare = 0.5;
constexpr double kReplacedShare = 0.8;
constexpr int kExplainedNeighbors = 2;

// A straight edge between two joints.
struct LongEdge {
  // Number of its edgels, each weighted by its distance.
  double score = 0;
  JointPair ends;
  std::vector<ViewId> seen_in;
};

// The edgels that the edges found so far explain.
class Explained {
 public:
  explicit Explained(const TopologyInput& input) : input_(input) {
    for (const ImageCurves& curves : input.curves) is_.emplace_back(curves.edge_map.edgels.size());
  }

  bool Contains(const EdgelRef& ref) const { return is_[ref.view][ref.edgel]; }

  void Add(const EdgelRef& ref) {
    ForEachNeighbor(input_, ref, kExplainedNeighbors,
                    [&](EdgelId id) { is_[ref.view][id] = true; });
  }

 private:
  const TopologyInput& input_;
  std::vector<std::vector<bool>> is_;
};

class LongEdgeFinder {
 public:
  LongEdgeFinder(const TopologyInput& input, GraphEditor* editor)
      : input_(input),
        editor_(editor),
        joints_(CollectJoints(editor->graph(), input.views.size())),
        claims_(CollectClaims(input, editor->graph())),
        explained_(input) {
    all_views_.resize(input.views.size());
    std::iota(all_views_.begin(), all_views_.end(), 0);
  }

  LongEdgeCounts Run(const RunContext& context) {
    const auto num_old = static_cast<LinkId>(editor_->NumLinks());
    LongEdgeCounts counts;
    for (const LongEdge& edge : Find(context)) counts.added += Add(edge);
    for (LinkId id = 0; id < num_old; ++id) {
      if (!IsReplaced(editor_->link(id))) continue;
      editor_->Remove(id);
      ++counts.replaced;
    }
    editor_->Compact();
    return counts;
  }

 private:
  const Joint& From(const JointPair& pair) const { return joints_[pair.from]; }
  const Joint& To(const JointPair& pair) const { return joints_[pair.to]; }

  // Best first.
  std::vector<LongEdge> Find(const RunContext& context) const {
    const auto pairs = FindSpannedPairs(input_, joints_, kMinSpanningViews, context);
    const auto of_pair =
        MapItems(context, "long edges", pairs.size(), [&](size_t p) { return EdgeOf(pairs[p]); });
    std::vector<LongEdge> edges;
    for (const auto& edge : of_pair) {
      if (edge) edges.push_back(*edge);
    }
    std::ranges::stable_sort(edges, std::greater<>(), &LongEdge::score);
    return edges;
  }

  std::optional<LongEdge> EdgeOf(const JointPair& pair) const {
    const Joint& from = From(pair);
    const Joint& to = To(pair);
    const Eigen::Vector3d along = to.position - from.position;
    if (along.norm() < kMinEdgePx * from.footprint) return std::nullopt;
    std::vector<uint8_t> visible = from.visible;
    for (size_t v = 0; v < visible.size(); ++v) visible[v] |= to.visible[v];
    const SegmentSupport support = FindSegmentSupport(from.position, to.position, visible,
                                                      input_.views, input_.edgels, kEdgeGate);
    const auto count = static_cast<int>(support.seen_in.size());
    if (count < kMinShowingViews || count < kMinShowingShare * support.num_views ||
        LogChance(count, support.num_views, support.background) > std::log(kMaxEdgeChance)) {
      return std::nullopt;
    }
    LongEdge edge = {0, pair, support.seen_in};
    if (SigmaPx(from, along.normalized(), edge.seen_in) > kMaxEndSigmaPx ||
        SigmaPx(to, -along.normalized(), edge.seen_in) > kMaxEndSigmaPx || IsDrawn(edge)) {
      return std::nullopt;
    }
    ForEachEdgel(pair, edge.seen_in, [&](const EdgelRef&, double distance_px) {
      edge.score += 1 - std::pow(distance_px / kEdgeGate.normal_px, 2);
    });
    return edge;
  }

  // Largest standard deviation of a joint across an edge that leaves it, as the edge and the links
  // there tell it.
  double SigmaPx(const Joint& joint, const Eigen::Vector3d& direction,
                 const std::vector<ViewId>& seen_in) const {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    for (int k = kEndBeginPx; k < kEndEndPx; ++k) {
      const Eigen::Vector3d point = joint.position + k * joint.footprint * direction;
      information +=
          input_.Information(SupportAt(input_, point, direction, seen_in, kEdgeGate), point);
    }
    information /= kEndEndPx - kEndBeginPx;
    for (const LinkEnd& end : editor_->node(joint.node).incident) {
      information += InformationOfEnd(end);
    }
    const Eigen::Matrix<double, 3, 2> across = TangentFrame(direction);
    const Eigen::Matrix2d part = across.transpose() * information * across;
    const double least =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>().computeDirect(part).eigenvalues()[0];
    return least > 0 ? 1 / (std::sqrt(least) * joint.footprint)
                     : std::numeric_limits<double>::infinity();
  }

  // The mean of the points near it: their edgels are not independent.
  Eigen::Matrix3d InformationOfEnd(const LinkEnd& end) const {
    const DrawingLink& link = editor_->link(end.link);
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    int count = 0;
    if (link.vertices.empty()) return sum;
    for (int k = kEndBeginPx; k < std::min(link.size(), kEndEndPx); ++k) {
      const int at = end.end == 0 ? k : link.size() - 1 - k;
      if (link.vertices[at].support.empty()) continue;
      sum += input_.Information(link.vertices[at].support, link.points_in_world[at]);
      ++count;
    }
    return sum / std::max(1, count);
  }

  // Returns whether most of the edgels along the edge support one link.
  bool IsDrawn(const LongEdge& edge) const {
    int num_edgels = 0;
    std::map<LinkId, int> num_claimed;
    ForEachEdgel(edge.ends, edge.seen_in, [&](const EdgelRef& ref, double) {
      ++num_edgels;
      for (const LinkId link : LinksAt(ref)) ++num_claimed[link];
    });
    return std::ranges::any_of(
        num_claimed, [&](const auto& item) { return item.second > kDrawnShare * num_edgels; });
  }

  // The links that the edgel, or a neighbor on the fragment, supports.
  std::set<LinkId> LinksAt(const EdgelRef& ref) const {
    std::set<LinkId> links;
    ForEachNeighbor(input_, ref, kClaimedNeighbors, [&](EdgelId id) {
      const LinkId link = claims_[ref.view][id].link;
      if (link >= 0) links.insert(link);
    });
    return links;
  }

  // Calls visit(EdgelRef, distance_px) for the edgels along the edge.
  template <typename Visit>
  void ForEachEdgel(const JointPair& pair, const std::vector<ViewId>& views, Visit&& visit) const {
    const Joint& from = From(pair);
    const Eigen::Vector3d along = To(pair).position - from.position;
    const int size = 1 + static_cast<int>(along.norm() / (kEdgelStepPx * from.footprint));
    for (const ViewId v : views) {
      for (int k = 0; k < size; ++k) {
        const Eigen::Vector3d point = from.position + along * (k + 0.5) / size;
        const auto ref = input_.EdgelAt(v, point, along, kEdgeGate);
        const auto residual = ref ? input_.Residual(*ref, point) : std::nullopt;
        if (residual) visit(*ref, residual->residual_px);
      }
    }
  }

  // Returns whether the edge was added.
  bool Add(const LongEdge& edge) {
    int num_edgels = 0;
    int num_explained = 0;
    ForEachEdgel(edge.ends, edge.seen_in, [&](const EdgelRef& ref, double) {
      ++num_edgels;
      num_explained += explained_.Contains(ref);
    });
    if (num_explained > kMaxExplainedShare * num_edgels) return false;
    AddStraightLink(input_, To(edge.ends).position, edge.seen_in, &joints_[edge.ends.from],
                    &joints_[edge.ends.to], editor_);
    // Also where one of its ends is hidden.
    ForEachEdgel(edge.ends, all_views_, [&](const EdgelRef& ref, double) { explained_.Add(ref); });
    return true;
  }

  bool IsReplaced(const DrawingLink& link) const {
    int num_edgels = 0;
    int num_explained = 0;
    for (const LinkVertex& vertex : link.vertices) {
      for (const EdgelRef& ref : vertex.support) {
        ++num_edgels;
        num_explained += explained_.Contains(ref);
      }
    }
    return num_edgels > 0 && num_explained > kReplacedShare * num_edgels;
  }

  const TopologyInput& input_;
  GraphEditor* editor_;
  std::vector<ViewId> all_views_;
  std::vector<Joint> joints_;
  const EdgelClaims claims_;
  Explained explained_;
};

}  // namespace

LongEdgeCounts AddLongEdges(const TopologyInput& input, const RunContext& context,
                            GraphEditor* editor) {
  return LongEdgeFinder(input, editor).Run(context);
}

}  // namespace limn
