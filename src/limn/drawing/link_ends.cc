#include "limn/drawing/link_ends.h"

#include <algorithm>

#include "limn/drawing/vertex_grid.h"

namespace limn {
namespace {

// How far an end may overshoot the meeting point, px: edges are rounded where they meet.
constexpr double kMaxOvershootPx = 6;
// Image curves must come this near to the projected meeting point, px.
constexpr double kEvidenceRadiusPx = 6;
// Stretch of a link that speaks for its end, px.
constexpr double kEndStretchPx = 12;

}  // namespace

std::vector<LinkEnd> LinkEnds::Free() const {
  std::vector<LinkEnd> ends;
  for (size_t i = 0; i < draft_->links.size(); ++i) {
    if (draft_->links[i].closed || draft_->links[i].size() < 2) continue;
    for (const int end : {0, 1}) {
      if (draft_->links[i].node[end] < 0) ends.push_back({static_cast<int>(i), end});
    }
  }
  return ends;
}

double LinkEnds::ReachPx() const { return options_.max_junction_gap_px + kMaxOvershootPx; }

std::vector<std::pair<int, int>> LinkEnds::NearPairs(const std::vector<EndLine>& lines) const {
  const double reach_px = 2 * ReachPx();
  VertexGrid grid(reach_px);
  for (size_t i = 0; i < lines.size(); ++i) {
    grid.Add(static_cast<int>(i), lines[i].point, lines[i].footprint);
  }
  std::vector<std::pair<int, int>> pairs;
  for (size_t i = 0; i < lines.size(); ++i) {
    grid.ForEachNear(lines[i].point, lines[i].footprint, [&](int j) {
      if (j <= static_cast<int>(i)) return;
      if ((lines[i].point - lines[j].point).norm() > reach_px * lines[i].footprint) return;
      pairs.push_back({static_cast<int>(i), j});
    });
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::vector<EndLine> LinkEnds::Lines(const std::vector<LinkEnd>& ends) const {
  std::vector<EndLine> lines;
  for (const LinkEnd& ref : ends) lines.push_back(LineAtEnd(draft_->links[ref.link], ref.end));
  return lines;
}

void LinkEnds::CollectFragments(const DraftLink& link, int k, FragmentsByView* fragments) const {
  for (const int s : link.samples[k]) {
    for (const EdgelRef& ref : samples_.support.Of(s)) {
      (*fragments)[ref.view].insert(evidence_[ref.view]->fragment_of[ref.edgel]);
    }
  }
}

FragmentsByView LinkEnds::FragmentsAround(const DraftLink& link, int index) const {
  FragmentsByView fragments;
  double arc = 0;
  for (int k = index; k >= 0 && arc <= kEndStretchPx; --k) {
    CollectFragments(link, k, &fragments);
    if (k > 0) arc += ArcPx(link, k - 1, k);
  }
  arc = 0;
  for (int k = index + 1; k < link.size() && arc <= kEndStretchPx; ++k) {
    CollectFragments(link, k, &fragments);
    arc += ArcPx(link, k - 1, k);
  }
  return fragments;
}

FragmentsByView LinkEnds::FragmentsAtEnd(const LinkEnd& ref) const {
  const DraftLink& link = draft_->links[ref.link];
  return FragmentsAround(link, ref.end == 0 ? 0 : link.size() - 1);
}

bool LinkEnds::ImagesAgree(const Eigen::Vector3d& point, const FragmentsByView& a,
                           const FragmentsByView& b) const {
  int count = 0;
  for (const auto& [view, fragments_a] : a) {
    const auto found = b.find(view);
    if (found == b.end()) continue;
    const auto pixel = views_[view].Project(point);
    if (!pixel) continue;
    bool near_a = false;
    bool near_b = false;
    evidence_[view]->edgels.ForEachWithin(*pixel, kEvidenceRadiusPx, [&](EdgelId id) {
      const int fragment = evidence_[view]->fragment_of[id];
      near_a |= fragments_a.count(fragment) > 0;
      near_b |= found->second.count(fragment) > 0;
    });
    count += near_a && near_b;
  }
  return count >= options_.min_junction_views;
}

bool LinkEnds::InReach(double along, double footprint) const {
  return along <= options_.max_junction_gap_px * footprint && along >= -kMaxOvershootPx * footprint;
}

void LinkEnds::EndAt(const LinkEnd& ref, int node, const Eigen::Vector3d& point) {
  DraftLink& link = draft_->links[ref.link];
  const auto erase_tip = [&](auto* values) {
    values->erase(ref.end == 0 ? values->begin() : values->end() - 1);
  };
  while (link.size() > 2) {
    const int tip = ref.end == 0 ? 0 : link.size() - 1;
    const int before = ref.end == 0 ? 1 : link.size() - 2;
    const Eigen::Vector3d outward = link.position[tip] - link.position[before];
    if ((point - link.position[tip]).dot(outward) > 0) break;
    auto& kept = link.samples[before];
    kept.insert(kept.end(), link.samples[tip].begin(), link.samples[tip].end());
    erase_tip(&link.position);
    erase_tip(&link.information);
    erase_tip(&link.footprint);
    erase_tip(&link.samples);
  }
  const auto insert_tip = [&](auto* values, const auto& value) {
    auto copy = value;
    values->insert(ref.end == 0 ? values->begin() : values->end(), std::move(copy));
  };
  const int tip = ref.end == 0 ? 0 : link.size() - 1;
  insert_tip(&link.information, link.information[tip]);
  insert_tip(&link.footprint, link.footprint[tip]);
  insert_tip(&link.samples, std::vector<int>());
  insert_tip(&link.position, point);
  link.node[ref.end] = node;
}

}  // namespace limn
