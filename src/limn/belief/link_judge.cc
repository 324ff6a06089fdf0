// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/link_judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "limn/belief/confidence.h"
#include "limn/belief/link_claims.h"
#include "limn/belief/measured_depth.h"
#include "limn/belief/seen_through.h"
#include "limn/belief/still_edgels.h"
#include "limn/belief/tri_angle.h"
#include "limn/geometry/polyline.h"
#include "limn/model/view_finder.h"
#include "limn/support/view_edgels.h"
#include "limn/topology/topology_input.h"
#include "limn/util/angles.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// Views that contradict a link are at least this share of the number that show it: few of many are
// places of low contrast.
constexpr double kMinContradictingShare = 0.25;
// And at least this many: one view may be wrong.
constexpr int kMinContradictingViews = 2;
// What an end that meets another link counts instead of evidence, natural logarithm: chance seldom
// makes ends meet.
constexpr double kJoinedEndEvidence = 5;
// Fewer views do not determine a curve.
constexpr double kMinViews = 3;
// The better the place of a link is determined, the fewer links could be in its stead: their number
// is proportional to the variance across it. At this sigma that is no evidence either way; smaller
// ones than the second are not trusted, unknown ones are the third, px.
constexpr double kUsualSigmaPx = 0.65;
constexpr double kMinSigmaPx = 0.05;
constexpr double kMaxSigmaPx = 1e3;

// A link is at another depth than those that explain it if more than this share of its edgels are
// theirs.
constexpr double kMostElsewhere = 0.5;

// A link stands still if more than this share of its edgels do.
constexpr double kMaxStillShare = 0.5;

bool StandsStill(const ImageEvidence& evidence, const StillEdgels& still) {
  double num_hits = 0, num_still = 0;
  for (const LinkSight& sight : evidence.sights) {
    num_hits += static_cast<double>(sight.hits.size());
    num_still += static_cast<double>(std::ranges::count_if(
        sight.hits, [&](const SampleHit& hit) { return still[sight.view][hit.edgel] != 0; }));
  }
  return num_still > kMaxStillShare * num_hits;
}

// Of the median sigma.
double EvidenceOfSigma(const DrawingLink& link, double footprint) {
  if (!(footprint > 0)) return 0;
  const double sigma_px = Median(link.sigma) / footprint;
  return 2 * std::log(kUsualSigmaPx / std::clamp(sigma_px, kMinSigmaPx, kMaxSigmaPx));
}

class Judge {
 public:
  Judge(const BeliefInput& input, const BeliefOptions& options, const TopologyOptions& topology,
        const RunContext& context)
      : graph_(input.graph),
        fitted_(input.fitted),
        options_(options),
        topology_(topology),
        links_(input.graph.links.size()) {
    const auto edgels = BuildViewEdgels(input.scene.curves, context);
    const TopologyInput images = {input.scene.views, input.scene.curves, edgels, input.gate};
    const ViewFinder finder(input.scene.views);
    ParallelFor(context, "evidence for links", links_.size(),
                [&](size_t l) { links_[l] = FindEvidence(images, finder, graph_.links[l]); });
    for (size_t l = 0; l < links_.size(); ++l) {
      evidence_.push_back(links_[l].evidence +
                          EvidenceOfSigma(graph_.links[l], links_[l].footprint));
    }
    FindClaims(images, context, &links_);
    views_through_ = CountViewsThrough(images, links_, kSureEvidence, context);
    const StillEdgels still = FindStillEdgels(input.scene.views, input.scene.curves, input.graph);
    for (const ImageEvidence& of_link : links_) {
      stands_still_.push_back(StandsStill(of_link, still));
    }
  }

  LinkDoubt DoubtOf(size_t l) const {
    const ImageEvidence& evidence = links_[l];
    const DrawingLink& link = graph_.links[l];
    const int num_free = IsFree(l, link.node0) + IsFree(l, link.node1);
    // Accidents among edgels that stand still are seldom sure; what slides along itself is.
    if (stands_still_[l] && evidence_[l] < kSureEvidence) return LinkDoubt::kStill;
    if (!fitted_.empty() && !fitted_[l] && !IsInferred(link, evidence, num_free)) {
      return LinkDoubt::kFewViews;
    }
    const double needed = options_.min_evidence - kJoinedEndEvidence * (2 - num_free);
    if (evidence_[l] < needed) {
      return LinkDoubt::kChance;
    }
    if (IsContradicted(l)) return LinkDoubt::kSeenThrough;
    // Joined ends are no excuse at another depth: fences are whole networks of such links.
    if (evidence.OwnShare() < options_.min_own_share &&
        (num_free > 0 || evidence.ElsewhereShare() > kMostElsewhere)) {
      return LinkDoubt::kExplained;
    }
    return LinkDoubt::kNone;
  }

  // Of the images and of the sigma, per link.
  const std::vector<double>& evidence() const { return evidence_; }

  double LengthPx(size_t l) const {
    const double footprint = links_[l].footprint;
    return footprint > 0 ? Length(graph_.links[l].points_in_world) / footprint : 0;
  }

 private:
  // Whether enough views see others through the link, also compared with those that show it.
  bool IsContradicted(size_t l) const {
    return views_through_[l] >= kMinContradictingViews &&
           views_through_[l] >= kMinContradictingShare * links_[l].showing_views;
  }

  // Whether the link meets nothing at the node. What has grown from its end, without samples of the
  // sketch, does not count unless it would be believed by itself.
  bool IsFree(size_t l, NodeId node) const {
    return std::ranges::all_of(graph_.nodes[node].incident, [&](const LinkEnd& end) {
      return end.link == static_cast<LinkId>(l) || (graph_.links[end.link].members.empty() &&
                                                    evidence_[end.link] < options_.min_evidence);
    });
  }

  // Whether a link that was not fitted is determined by the nodes at its ends, or shown by enough
  // views although its edgels lie too near to those of others to be used.
  bool IsInferred(const DrawingLink& link, const ImageEvidence& evidence, int num_free) const {
    if (num_free > 0) return false;
    if (evidence.showing_views >= kMinViews) return true;
    return evidence.footprint > 0 &&
           Length(link.points_in_world) <= topology_.max_short_edge_px * evidence.footprint;
  }

  const DrawingGraph& graph_;
  const std::vector<uint8_t>& fitted_;
  const BeliefOptions& options_;
  const TopologyOptions& topology_;
  std::vector<ImageEvidence> links_;
  std::vector<double> evidence_;
  std::vector<int> views_through_;
  std::vector<uint8_t> stands_still_;
};

// Number and length of the links per doubt.
struct Tally {
  std::array<int64_t, kNumLinkDoubts> links = {};
  std::array<double, kNumLinkDoubts> px = {};
};

StageSummary Summarize(const Tally& tally) {
  StageSummary summary;
  summary.stage = "belief";
  int64_t num_links = 0;
  int64_t length_px = 0;
  for (int d = 0; d < kNumLinkDoubts; ++d) {
    const int64_t px = std::llround(tally.px[d]);
    num_links += tally.links[d];
    length_px += px;
    const bool is_believed = static_cast<LinkDoubt>(d) == LinkDoubt::kNone;
    const std::string reason =
        is_believed ? "" : std::string(": ") + LinkDoubtName(static_cast<LinkDoubt>(d));
    auto& counts = is_believed ? summary.kept : summary.dropped;
    counts.emplace_back((is_believed ? "links" : "tentative links") + reason, tally.links[d]);
    counts.emplace_back((is_believed ? "px of links" : "px of tentative links") + reason, px);
  }
  summary.in = {{"links", num_links}, {"px of links", length_px}};
  return summary;
}

}  // namespace

BeliefResult JudgeLinks(const BeliefInput& input, const BeliefOptions& options,
                        const TopologyOptions& topology, const RunContext& context) {
  options.Check();
  topology.Check();
  BeliefResult result;
  result.graph = input.graph;
  result.summary.stage = "belief";
  for (DrawingLink& link : result.graph.links) link.evidence.reset();
  if (!options.judge) return result;
  const Judge judge(input, options, topology, context);
  std::vector<double> length_px;
  for (size_t l = 0; l < result.graph.links.size(); ++l) {
    result.graph.links[l].doubt = judge.DoubtOf(l);
    result.graph.links[l].evidence = judge.evidence()[l];
    length_px.push_back(judge.LengthPx(l));
  }
  const std::vector<double> angle_deg = TriAnglesDeg(input.graph, input.scene.views, context);
  DoubtUnmeasuredDepth(angle_deg, LeastAngleDeg(angle_deg, options.min_tri_angle_deg),
                       &result.graph);
  Tally tally;
  for (size_t l = 0; l < result.graph.links.size(); ++l) {
    DrawingLink& link = result.graph.links[l];
    link.tentative = link.doubt != LinkDoubt::kNone;
    ++tally.links[static_cast<int>(link.doubt)];
    tally.px[static_cast<int>(link.doubt)] += length_px[l];
  }
  result.summary = Summarize(tally);
  return result;
}

}  // namespace limn
