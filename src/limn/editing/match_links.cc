// SPDX-License-Identifier: BSD-3-Clause
#include "limn/editing/match_links.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "limn/geometry/angle_between.h"
#include "limn/model/footprint.h"
#include "limn/topology/link_geometry.h"
#include "limn/util/angles.h"
#include "limn/util/name_list.h"
#include "limn/util/sort_unique.h"

namespace limn {
namespace {

// Of both curves, unless that makes more samples than the second number.
constexpr double kSampleSpacingPx = 2;
constexpr double kMaxSamples = 2000;
constexpr double kMaxAngleRad = 30 * kDeg;
// A link that lies along a reference does so with this share of its length.
constexpr double kMinOwnShare = 0.6;
// A longer link has this share of the reference along it.
constexpr double kMinReferenceShare = 0.5;
// Links side by side whose mean distances from the reference differ by less are equally near, px.
constexpr double kTiePx = 0.5;
// Samples of changed links are searched one by one. With more than this factor times the root of
// the samples in the index that is built again, which balances both costs.
constexpr double kMaxChangedOverRoot = 30;
// Share of the bulge of a reference between two of its points by which the curve may be off.
constexpr double kBulgeShare = 0.5;

struct RefSample {
  Eigen::Vector3d position, direction;
  double footprint = 0;
  double bulge = 0;      // how far the smooth curve is from the chord
  double half_step = 0;  // it stands for this length to either side
};

// Points before the first and after the last one, where a smooth curve would have them.
Polyline3d WithNeighbors(const LinkRef& ref) {
  const Polyline3d& points = ref.points;
  const size_t count = points.size();
  const auto beyond = [&](size_t a, size_t b, size_t c) -> Eigen::Vector3d {
    if (count == 2) return 2 * points[a] - points[b];
    return 3 * (points[a] - points[b]) + points[c];
  };
  const bool wraps = ref.closed && count > 2;
  Polyline3d all = {wraps ? points[count - 2] : beyond(0, 1, std::min<size_t>(2, count - 1))};
  all.insert(all.end(), points.begin(), points.end());
  all.push_back(wraps ? points[1]
                      : beyond(count - 1, count - 2, count - std::min<size_t>(3, count)));
  return all;
}

// A smooth curve through the points (Catmull and Rom 1974), sampled.
std::vector<RefSample> SampleReference(const LinkRef& ref, const std::vector<View>& views) {
  const Polyline3d points = WithNeighbors(ref);
  const double length = Length(ref.points);
  std::vector<RefSample> samples;
  for (size_t k = 1; k + 2 < points.size(); ++k) {
    const Eigen::Vector3d chord = points[k + 1] - points[k];
    const Eigen::Vector3d leaving = 0.5 * (points[k + 1] - points[k - 1]);
    const Eigen::Vector3d arriving = 0.5 * (points[k + 2] - points[k]);
    const double footprint = PixelFootprint(views, points[k] + 0.5 * chord);
    const double step = std::max(kSampleSpacingPx * footprint, length / kMaxSamples);
    const int count = std::max(1, static_cast<int>(std::ceil(chord.norm() / step)));
    const double bulge = (leaving - arriving).norm() / 8;
    for (int i = 0; i < count; ++i) {
      const double t = (i + 0.5) / count;
      const Eigen::Vector3d position = points[k] + t * t * (3 - 2 * t) * chord +
                                       t * (1 - t) * (1 - t) * leaving - t * t * (1 - t) * arriving;
      const Eigen::Vector3d slope =
          6 * t * (1 - t) * chord + (1 - t) * (1 - 3 * t) * leaving - t * (2 - 3 * t) * arriving;
      samples.push_back(
          {position, slope.stableNormalized(), footprint, bulge, 0.5 * slope.norm() / count});
    }
  }
  return samples;
}

// A link some of which runs along a reference.
struct Candidate {
  LinkId link = -1;
  std::vector<int> at;   // samples of the reference, ascending
  std::vector<int> own;  // samples of the link
  double distance_px = 0;
  bool has_id = false;
  bool is_longer = false;

  // For the choice between links side by side.
  double Rank() const { return distance_px - (has_id ? kTiePx : 0); }
};

// Whether two links lie along the same part of the reference.
bool LieSideBySide(const Candidate& a, const Candidate& b) {
  std::vector<int> common;
  std::set_intersection(a.at.begin(), a.at.end(), b.at.begin(), b.at.end(),
                        std::back_inserter(common));
  return 2 * common.size() > std::min(a.at.size(), b.at.size());
}

// Leaves the nearest of links side by side.
std::vector<Candidate> Nearest(std::vector<Candidate> candidates, LinkMatch* match) {
  std::ranges::stable_sort(candidates, {}, &Candidate::Rank);
  std::vector<Candidate> kept;
  for (Candidate& candidate : candidates) {
    const auto beside = std::ranges::find_if(
        kept, [&](const Candidate& nearer) { return LieSideBySide(candidate, nearer); });
    if (beside == kept.end()) {
      kept.push_back(std::move(candidate));
    } else if (candidate.Rank() < beside->Rank() + kTiePx && !beside->has_id) {
      match->tied.insert(match->tied.end(), {beside->link, candidate.link});
    }
  }
  SortUnique(&match->tied);
  return kept;
}

std::string LinkNames(const std::vector<LinkId>& links) {
  std::vector<std::string> names;
  for (const LinkId id : links) names.push_back(std::to_string(id));
  return (links.size() == 1 ? "link " : "links ") + ListNames(names);
}

}  // namespace

std::optional<LinkId> LinkMatch::Single() const {
  return !IsAmbiguous() && along.size() == 1 ? std::optional(along.front()) : std::nullopt;
}

std::string LinkMatch::Problem() const {
  if (IsAmbiguous()) return LinkNames(tied) + " are equally near";
  if (along.size() > 1) return "it is in pieces now: " + LinkNames(along);
  if (!longer.empty()) return LinkNames(longer) + " runs along it, but extends much farther";
  return "no link runs along it";
}

LinkMatcher::LinkMatcher(const DrawingGraph& graph, const std::vector<View>& views)
    : graph_(graph), views_(views) {
  Rebuild();
}

double LinkMatcher::FootprintAt(const Eigen::Vector3d& place) const {
  return PixelFootprint(views_, place);
}

void LinkMatcher::AddSamples(LinkId id, std::vector<Sample>* samples) {
  num_samples_[id] = 0;
  const DrawingLink& link = graph_.links[id];
  if (link.node0 < 0) return;  // removed
  const double length = Length(link.points_in_world);
  const double step = std::max(kSampleSpacingPx * FootprintOfCurve(views_, link.points_in_world),
                               length / kMaxSamples);
  const Polyline3d points = ResampleUniform(link.points_in_world, step);
  for (size_t k = 0; k + 1 < points.size(); ++k) {
    const Eigen::Vector3d chord = points[k + 1] - points[k];
    samples->push_back({id, num_samples_[id]++, points[k] + 0.5 * chord, chord.stableNormalized(),
                        0.5 * chord.norm()});
    longest_half_step_ = std::max(longest_half_step_, samples->back().half_step);
  }
}

void LinkMatcher::Rebuild() {
  samples_.clear();
  changed_samples_.clear();
  is_changed_.assign(graph_.links.size(), 0);
  num_samples_.assign(graph_.links.size(), 0);
  std::vector<Eigen::Vector3d> positions;
  for (LinkId id = 0; id < static_cast<LinkId>(graph_.links.size()); ++id)
    AddSamples(id, &samples_);
  for (const Sample& sample : samples_) positions.push_back(sample.position);
  index_.emplace(positions);
}

void LinkMatcher::Update(LinkId id) {
  const auto num_changed = static_cast<double>(changed_samples_.size());
  if (num_changed > kMaxChangedOverRoot * std::sqrt(samples_.size() + 1.0)) return Rebuild();
  is_changed_.resize(graph_.links.size(), 1);
  num_samples_.resize(graph_.links.size(), 0);
  is_changed_[id] = 1;
  std::erase_if(changed_samples_, [&](const Sample& sample) { return sample.link == id; });
  AddSamples(id, &changed_samples_);
}

void LinkMatcher::ForEachWithin(const Eigen::Vector3d& place, double radius,
                                const std::function<void(const Sample&)>& visit) const {
  std::vector<SpatialIndex::Neighbor> near;
  if (index_->size() > 0) index_->FindWithin(place, radius, &near);
  for (const SpatialIndex::Neighbor& neighbor : near) {
    const Sample& sample = samples_[neighbor.index];
    if (!is_changed_[sample.link]) visit(sample);
  }
  for (const Sample& sample : changed_samples_) {
    if ((sample.position - place).squaredNorm() < radius * radius) visit(sample);
  }
}

LinkMatch LinkMatcher::Match(const LinkRef& ref) const {
  const std::vector<RefSample> samples = SampleReference(ref, views_);
  std::map<LinkId, Candidate> by_link;
  for (size_t r = 0; r < samples.size(); ++r) {
    const RefSample& at = samples[r];
    const double reach = kMatchPx * at.footprint + kBulgeShare * at.bulge;
    std::map<LinkId, double> nearest;  // px
    const double radius = std::hypot(reach, at.half_step + longest_half_step_);
    ForEachWithin(at.position, radius, [&](const Sample& sample) {
      const Eigen::Vector3d offset = at.position - sample.position;
      const double along = offset.dot(sample.direction);
      const double across = (offset - along * sample.direction).norm();
      if (!(across <= reach) || !(std::abs(along) <= at.half_step + sample.half_step)) return;
      if (LineAngleBetween(at.direction, sample.direction) > kMaxAngleRad) return;
      by_link[sample.link].own.push_back(sample.number);
      const auto [found, is_new] = nearest.emplace(sample.link, across / at.footprint);
      if (!is_new) found->second = std::min(found->second, across / at.footprint);
    });
    for (const auto& [link, px] : nearest) {
      by_link[link].at.push_back(static_cast<int>(r));
      by_link[link].distance_px += px;
    }
  }
  std::vector<Candidate> candidates;
  for (auto& [link, candidate] : by_link) {
    candidate.link = link;
    candidate.has_id = link == ref.id;
    candidate.distance_px /= static_cast<double>(candidate.at.size());
    SortUnique(&candidate.own);
    candidate.is_longer =
        static_cast<double>(candidate.own.size()) < kMinOwnShare * num_samples_[link];
    const double share =
        static_cast<double>(candidate.at.size()) / static_cast<double>(samples.size());
    if (!candidate.is_longer || share >= kMinReferenceShare) {
      candidates.push_back(std::move(candidate));
    }
  }
  LinkMatch match;
  std::vector<int> covered;
  for (const Candidate& candidate : Nearest(std::move(candidates), &match)) {
    (candidate.is_longer ? match.longer : match.along).push_back(candidate.link);
    if (!candidate.is_longer) {
      covered.insert(covered.end(), candidate.at.begin(), candidate.at.end());
    }
  }
  std::ranges::sort(match.along);
  std::ranges::sort(match.longer);
  SortUnique(&covered);
  match.covered = static_cast<double>(covered.size()) / static_cast<double>(samples.size());
  return match;
}

}  // namespace limn
