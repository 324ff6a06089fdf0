#include "limn/topology/verify_links.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "limn/geometry/tangent_frame.h"
#include "limn/model/view_finder.h"
#include "limn/support/edgel_residual.h"
#include "limn/topology/link_geometry.h"
#include "limn/topology/occluding_contours.h"
#include "limn/util/map_items.h"

namespace limn {
namespace {

// Primary views that the samples of a link must come from.
constexpr int kMinMergedViews = 2;
// An edgel within this distance of a claimed one belongs to the same edge, virtual px.
constexpr double kSameEdgePx = 1.5;
// Shifts of the copies that measure chance, px, each in four directions.
constexpr double kShiftsPx[] = {6, 10};
// At most this many points of an uncertain link are tested.
constexpr int kMaxProbes = 60;

// Number of agreeing primary views, averaged along a link. Points that were added do not count.
double MeanAgreement(const DrawingLink& link) {
  double sum = 0;
  double length_px = 0;
  for (int k = 0; k < link.size(); ++k) {
    const int here = link.vertices[k].agreeing_views;
    if (here == 0) continue;
    const double own_px = ArcPx(link, std::max(k - 1, 0), std::min(k + 1, link.size() - 1));
    sum += here * own_px;
    length_px += own_px;
  }
  return length_px > 0 ? sum / length_px : 0;
}

// Mean number of views that contain a point of a link.
double MeanContaining(const DrawingLink& link, const std::vector<ViewId>& near,
                      const std::vector<View>& views) {
  int64_t sum = 0;
  for (const Eigen::Vector3d& point : link.points_in_world) {
    sum += std::count_if(near.begin(), near.end(),
                         [&](ViewId v) { return views[v].Project(point).has_value(); });
  }
  return static_cast<double>(sum) / link.size();
}

// Number of primary views that the samples of a link come from.
int NumPrimaryViews(const CurveSketch& sketch, const DrawingLink& link) {
  std::set<ViewId> views;
  for (const LinkVertex& vertex : link.vertices) {
    for (const SketchSample& from : vertex.samples) {
      views.insert(sketch.curves[from.curve].anchor.view);
    }
  }
  return static_cast<int>(views.size());
}

// The edgels that certain links explain.
class Claims {
 public:
  explicit Claims(const TopologyInput& input) : input_(input) {
    for (const ImageCurves& of_view : input.curves) {
      claimed_.emplace_back(of_view.edge_map.edgels.size());
    }
  }

  // Claims the edgels of one view that run along a link. Views may be processed in parallel.
  void Add(size_t view, const DrawingLink& link) {
    for (int k = 0; k < link.size(); ++k) {
      const EdgelId id = EdgelAt(view, link.points_in_world[k], TangentAt(link, k));
      if (id != kInvalidEdgel) claimed_[view][id] = true;
    }
  }

  // Mean number of views in which unclaimed edgels run along a link, less the number expected by
  // chance. Copies count claimed edgels, too, so that links beside known edges need more support.
  double OwnViews(const DrawingLink& link, const std::vector<ViewId>& near) const {
    const std::vector<int> probes = ProbePoints(link, kMaxProbes);
    int64_t own = 0;
    int64_t contained = 0;
    Copies copies;
    for (const int k : probes) {
      const Eigen::Vector3d& point = link.points_in_world[k];
      const Eigen::Vector3d tangent = TangentAt(link, k);
      for (const ViewId v : near) {
        if (!input_.views[v].Project(point)) continue;
        ++contained;
        const EdgelId id = EdgelAt(v, point, tangent);
        own += id != kInvalidEdgel && !IsClaimed(v, id);
        AddCopies(v, point, tangent, link.vertices[k].footprint, &copies);
      }
    }
    if (copies.num == 0) return 0;
    const double chance = static_cast<double>(copies.num_with_edgel) / copies.num;
    return (own - chance * contained) / static_cast<double>(probes.size());
  }

 private:
  struct Copies {
    int64_t num = 0;
    int64_t num_with_edgel = 0;
  };

  // Counts the shifted copies of a point in one view, and those with an edgel.
  void AddCopies(size_t view, const Eigen::Vector3d& point, const Eigen::Vector3d& tangent,
                 double footprint, Copies* copies) const {
    const Eigen::Matrix<double, 3, 2> across = footprint * TangentFrame(tangent);
    for (const double shift : kShiftsPx) {
      for (const Eigen::Vector3d offset : across.colwise()) {
        for (const double sign : {-1.0, 1.0}) {
          const Eigen::Vector3d copy = point + sign * shift * offset;
          if (!input_.views[view].Project(copy)) continue;
          ++copies->num;
          copies->num_with_edgel += EdgelAt(view, copy, tangent) != kInvalidEdgel;
        }
      }
    }
  }

  EdgelId EdgelAt(size_t view, const Eigen::Vector3d& point, const Eigen::Vector3d& tangent) const {
    const auto sight = See(input_.views[view], point, tangent);
    if (!sight) return kInvalidEdgel;
    const auto match =
        input_.edgels[view]->edgels.Best(sight->position_px, sight->direction_rad, input_.gate);
    return match ? match->edgel : kInvalidEdgel;
  }

  bool IsClaimed(size_t view, EdgelId id) const {
    bool claimed = false;
    input_.edgels[view]->edgels.ForEachWithin(
        input_.curves[view].edge_map.edgels[id].position_px, kSameEdgePx,
        [&](EdgelId near) { claimed = claimed || claimed_[view][near]; });
    return claimed;
  }

  const TopologyInput& input_;
  std::vector<std::vector<bool>> claimed_;  // per view, per edgel
};

enum class Belief : uint8_t { kNo, kUncertain, kCertain };

struct FirstJudgment {
  Belief belief = Belief::kNo;
  std::vector<ViewId> near;  // views that may contain the link
};

Belief FirstBelief(const TopologyInput& input, const CurveSketch& sketch,
                   const TopologyOptions& options, const DrawingLink& link,
                   const std::vector<ViewId>& near) {
  if (NumPrimaryViews(sketch, link) < kMinMergedViews || IsOccludingContour(input, link, near)) {
    return Belief::kNo;
  }
  const double required =
      std::clamp(options.primary_views_share * MeanContaining(link, near, input.views),
                 options.min_primary_views, options.max_primary_views);
  return MeanAgreement(link) >= required ? Belief::kCertain : Belief::kUncertain;
}

}  // namespace

std::vector<uint8_t> VerifyLinks(const TopologyInput& input, const CurveSketch& sketch,
                                 const TopologyOptions& options, const DrawingGraph& graph,
                                 const RunContext& context) {
  const ViewFinder finder(input.views);
  const auto first = MapItems(context, "link agreement", graph.links.size(), [&](size_t l) {
    FirstJudgment judgment;
    judgment.near = finder.NearAnyOf(graph.links[l].points_in_world);
    judgment.belief = FirstBelief(input, sketch, options, graph.links[l], judgment.near);
    return judgment;
  });
  Claims claims(input);
  std::vector<std::vector<size_t>> certain_in(input.views.size());
  for (size_t l = 0; l < first.size(); ++l) {
    if (first[l].belief != Belief::kCertain) continue;
    for (const ViewId v : first[l].near) certain_in[v].push_back(l);
  }
  ParallelFor(context, "claimed edgels", input.views.size(), [&](size_t v) {
    for (const size_t l : certain_in[v]) claims.Add(v, graph.links[l]);
  });
  return MapItems(context, "link support", first.size(), [&](size_t l) -> uint8_t {
    const auto& [belief, near] = first[l];
    if (belief != Belief::kUncertain) return belief == Belief::kCertain;
    const DrawingLink& link = graph.links[l];
    const double required =
        std::clamp(options.own_views_share * MeanContaining(link, near, input.views),
                   options.min_own_views, options.max_own_views);
    return claims.OwnViews(link, near) >= required;
  });
}

}  // namespace limn
