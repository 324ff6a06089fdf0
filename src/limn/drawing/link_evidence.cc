#include "limn/drawing/link_evidence.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "limn/drawing/occluding_contours.h"
#include "limn/support/edgel_residual.h"

namespace limn {
namespace {

// Primary views whose samples a link has.
constexpr int kMinMergedViews = 2;
// An edgel this near to a claimed one belongs to the same edge, px.
constexpr double kSameEdgePx = 1.5;
// Shifts of the copies that measure what chance does, px, each in four directions.
constexpr double kShiftsPx[] = {6, 10};
// Points at which an uncertain link is asked, at most.
constexpr int kMaxProbes = 60;

// Mean along a link of the number of primary views that agree; points that were added have none to
// ask.
double MeanAgreement(const DraftLink& link, const std::vector<int>& agreeing_views) {
  double sum = 0;
  double length_px = 0;
  for (int k = 0; k < link.size(); ++k) {
    int here = 0;
    for (const int s : link.samples[k]) here = std::max(here, agreeing_views[s]);
    if (here == 0) continue;
    const double own_px = ArcPx(link, std::max(k - 1, 0), std::min(k + 1, link.size() - 1));
    sum += here * own_px;
    length_px += own_px;
  }
  return length_px > 0 ? sum / length_px : 0;
}

// Mean number of views that contain a point of a link.
double MeanContaining(const DraftLink& link, const std::vector<View>& views) {
  int64_t sum = 0;
  for (const Eigen::Vector3d& point : link.position) {
    sum += std::count_if(views.begin(), views.end(),
                         [&](const View& view) { return view.Project(point).has_value(); });
  }
  return static_cast<double>(sum) / link.size();
}

// Number of primary views that the samples of a link come from.
int NumPrimaryViews(const SampleSet& samples, const DraftLink& link) {
  std::set<ViewId> views;
  for (const auto& of_point : link.samples) {
    for (const int s : of_point) views.insert(samples.origins[samples.curve_of[s]].anchor_view);
  }
  return static_cast<int>(views.size());
}

// Edgels of certain links, and what is left for the others.
class Claims {
 public:
  Claims(const LinkJudgementInput& input, const DrawingOptions& options)
      : input_(input), gate_(options.Gate()) {
    for (const ImageCurves& of_view : input.curves) {
      claimed_.emplace_back(of_view.edge_map.edgels.size());
    }
  }

  void Add(const DraftLink& link) {
    for (int k = 0; k < link.size(); ++k) {
      const Eigen::Vector3d tangent = TangentAt(link, k);
      for (size_t v = 0; v < input_.views.size(); ++v) {
        const EdgelId id = EdgelAt(v, link.position[k], tangent);
        if (id != kInvalidEdgel) claimed_[v][id] = true;
      }
    }
  }

  // Mean number of views in which edgels that nobody has claimed run along a link, less what the
  // link's copies have by chance.
  double OwnViews(const DraftLink& link) const {
    int64_t own = 0;
    int64_t contained = 0;
    int64_t copies = 0;
    int64_t copies_with_edgel = 0;
    int64_t probes = 0;
    const int step = std::max(1, link.size() / kMaxProbes);
    for (int k = 0; k < link.size(); k += step) {
      ++probes;
      const Eigen::Vector3d& point = link.position[k];
      const Eigen::Vector3d tangent = TangentAt(link, k);
      const Eigen::Vector3d u = link.footprint[k] * tangent.unitOrthogonal();
      const Eigen::Vector3d w = tangent.cross(u);
      for (size_t v = 0; v < input_.views.size(); ++v) {
        if (!input_.views[v].Project(point)) continue;
        ++contained;
        const EdgelId id = EdgelAt(v, point, tangent);
        own += id != kInvalidEdgel && !IsClaimed(v, id);
        for (const double shift : kShiftsPx) {
          for (const Eigen::Vector3d& offset : {u, w}) {
            for (const double sign : {-1.0, 1.0}) {
              ++copies;
              copies_with_edgel +=
                  EdgelAt(v, point + sign * shift * offset, tangent) != kInvalidEdgel;
            }
          }
        }
      }
    }
    if (copies == 0) return 0;
    const double chance = static_cast<double>(copies_with_edgel) / copies;
    return (own - chance * contained) / probes;
  }

 private:
  EdgelId EdgelAt(size_t v, const Eigen::Vector3d& point, const Eigen::Vector3d& tangent) const {
    const auto pixel = input_.views[v].Project(point);
    const auto direction = ProjectedDirection(input_.views[v], point, tangent);
    if (!pixel || !direction) return kInvalidEdgel;
    const auto match = input_.evidence[v]->edgels.Best(*pixel, *direction, gate_);
    return match ? match->edgel : kInvalidEdgel;
  }

  bool IsClaimed(size_t v, EdgelId id) const {
    bool claimed = false;
    input_.evidence[v]->edgels.ForEachWithin(
        input_.curves[v].edge_map.edgels[id].position_px, kSameEdgePx,
        [&](EdgelId near) { claimed = claimed || claimed_[v][near]; });
    return claimed;
  }

  const LinkJudgementInput& input_;
  const SupportGate gate_;
  std::vector<std::vector<bool>> claimed_;  // per view, per edgel
};

}  // namespace

std::vector<uint8_t> BelievedLinks(const LinkJudgementInput& input, const DrawingOptions& options,
                                   const Draft& draft, const RunContext& context) {
  std::vector<uint8_t> possible(draft.links.size(), 0);
  ParallelFor(context, "occluding contours", draft.links.size(), [&](size_t l) {
    const DraftLink& link = draft.links[l];
    possible[l] =
        NumPrimaryViews(input.samples, link) >= kMinMergedViews &&
        !IsOccludingContour(link, input.views, input.curves, input.evidence, options.Gate());
  });
  std::vector<uint8_t> believed(draft.links.size(), 0);
  std::vector<int> uncertain;
  Claims claims(input, options);
  for (size_t l = 0; l < draft.links.size(); ++l) {
    if (!possible[l]) continue;
    const DraftLink& link = draft.links[l];
    const double required =
        std::clamp(options.primary_views_share * MeanContaining(link, input.views),
                   options.min_primary_views, options.max_primary_views);
    believed[l] = MeanAgreement(link, input.agreeing_views) >= required;
    if (believed[l]) {
      claims.Add(link);
    } else {
      uncertain.push_back(static_cast<int>(l));
    }
  }
  ParallelFor(context, "link evidence", uncertain.size(), [&](size_t i) {
    const DraftLink& link = draft.links[uncertain[i]];
    const double required = std::clamp(options.own_views_share * MeanContaining(link, input.views),
                                       options.min_own_views, options.max_own_views);
    believed[uncertain[i]] = claims.OwnViews(link) >= required;
  });
  return believed;
}

}  // namespace limn
