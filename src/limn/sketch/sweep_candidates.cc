#include "limn/sketch/sweep_candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace limn {
namespace {

constexpr double kDeg = M_PI / 180;
constexpr size_t kMaxModes = 8;
// Fewer views that agree are chance.
constexpr size_t kMinVoters = 2;
// A mode is the mean of its voters, who are elected anew about it so often.
constexpr int kRounds = 4;
// Modes this near to a better one, in px of the other views, are the same.
constexpr double kSamePx = 1.0;
// A crossing this near to a mode, as a squared share of its gates, would elect it again.
constexpr double kExplained = .25;
// Cells of depth are about this wide in the view that moves most.
constexpr float kCellPx = 1;
constexpr float kMaxCells = 4096;

double Square(double value) { return value * value; }

DepthPlace PlaceOf(const FusedDepth& depth) {
  return {static_cast<float>(depth.inverse_depth), static_cast<float>(depth.slope_per_px)};
}

}  // namespace

int DepthCells::Cell(float inverse_depth) const {
  const float cell = (inverse_depth - low_) * cells_per_unit_;
  return static_cast<int>(std::clamp(cell, 0.f, last_cell_));
}

void DepthCells::Fill(const std::vector<EpipolarCrossing>& crossings, float gate_px) {
  low_ = std::numeric_limits<float>::infinity();
  float high = -low_;
  float max_speed = 0;
  for (const EpipolarCrossing& crossing : crossings) {
    low_ = std::min(low_, crossing.inverse_depth);
    high = std::max(high, crossing.inverse_depth);
    max_speed = std::max(max_speed, crossing.px_per_inverse_depth);
  }
  const int count = static_cast<int>(std::min((high - low_) * max_speed / kCellPx + 1, kMaxCells));
  cells_per_unit_ = high > low_ ? static_cast<float>(count) / (high - low_) : 0;
  last_cell_ = static_cast<float>(count);
  begin_.assign(count + 2, 0);
  num_views_.assign(count + 1, 0);
  last_view_.assign(count + 1, -1);
  reach_.clear();
  for (const EpipolarCrossing& crossing : crossings) {
    const float reach = gate_px / crossing.across_px_per_inverse_depth;
    const Range range = {Cell(crossing.inverse_depth - reach),
                         Cell(crossing.inverse_depth + reach)};
    reach_.push_back(range);
    for (int cell = range.first; cell <= range.last; ++cell) {
      ++begin_[cell + 1];
      num_views_[cell] += last_view_[cell] != crossing.view;
      last_view_[cell] = crossing.view;
    }
  }
  for (size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  members_.resize(begin_.back());
  next_.assign(begin_.begin(), begin_.end() - 1);
  for (size_t i = 0; i < crossings.size(); ++i) {
    for (int cell = reach_[i].first; cell <= reach_[i].last; ++cell) {
      members_[next_[cell]++] = static_cast<int>(i);
    }
  }
}

DepthElection::DepthElection(double focal_px, const SketchOptions& options)
    : focal_px_(focal_px),
      gate_px_(static_cast<float>(options.max_support_distance_px)),
      per_gate_px_(1 / gate_px_),
      per_gate_rad_(static_cast<float>(1 / (options.max_support_angle_deg * kDeg))),
      sin_low_(static_cast<float>(std::sin(options.min_epipolar_angle_deg * kDeg))),
      sin_high_(static_cast<float>(std::sin(options.max_epipolar_angle_deg * kDeg))),
      min_weight_(static_cast<float>(options.min_tangency_weight)) {}

std::vector<DepthMode> DepthElection::Find(const std::vector<EpipolarCrossing>& crossings) {
  if (crossings.empty()) return {};
  cells_.Fill(crossings, gate_px_);
  SortSeeds(crossings);
  explained_.assign(crossings.size(), 0);
  best_.clear();
  for (const int i : seeds_) {
    const EpipolarCrossing& seed = crossings[i];
    const bool may_be_best =
        best_.size() < kMaxModes || cells_.NumViews(seed.inverse_depth) > best_.back().score;
    if (!may_be_best) break;
    if (explained_[i]) continue;
    auto mode = Vote(crossings, {seed.inverse_depth, seed.slope_per_px});
    for (int round = 1; mode && round < kRounds; ++round)
      mode = Vote(crossings, PlaceOf(mode->depth));
    if (!mode) continue;
    MarkExplained(crossings, mode->depth);
    Offer(*mode);
  }
  return best_;
}

void DepthElection::SortSeeds(const std::vector<EpipolarCrossing>& crossings) {
  // Counting sort: the number of views is small.
  seeds_begin_.clear();
  const auto rank_of = [&](const EpipolarCrossing& crossing) {
    return static_cast<size_t>(cells_.NumViews(crossing.inverse_depth));
  };
  for (const EpipolarCrossing& crossing : crossings) {
    const size_t rank = rank_of(crossing);
    if (rank < kMinVoters) continue;
    if (seeds_begin_.size() <= rank) seeds_begin_.resize(rank + 1, 0);
    ++seeds_begin_[rank];
  }
  int count = 0;
  for (size_t rank = seeds_begin_.size(); rank-- > 0;) {
    count += std::exchange(seeds_begin_[rank], count);
  }
  seeds_.resize(count);
  for (size_t i = 0; i < crossings.size(); ++i) {
    const size_t rank = rank_of(crossings[i]);
    if (rank >= kMinVoters) seeds_[seeds_begin_[rank]++] = static_cast<int>(i);
  }
}

void DepthElection::MarkExplained(const std::vector<EpipolarCrossing>& crossings,
                                  const FusedDepth& mode) {
  const DepthPlace place = PlaceOf(mode);
  for (const int i : cells_.Near(place.inverse_depth)) {
    if (Distance(crossings[i], place) < kExplained) explained_[i] = 1;
  }
}

void DepthElection::Offer(const DepthMode& mode) {
  const auto is_same = [&](const DepthMode& other) {
    return std::abs(other.depth.inverse_depth - mode.depth.inverse_depth) *
               other.depth.px_per_inverse_depth <
           kSamePx;
  };
  const auto worse = std::find_if(best_.begin(), best_.end(),
                                  [&](const DepthMode& other) { return other.score < mode.score; });
  if (std::any_of(best_.begin(), worse, is_same)) return;
  const auto at = worse - best_.begin();
  best_.erase(std::remove_if(worse, best_.end(), is_same), best_.end());
  best_.insert(best_.begin() + at, mode);
  if (best_.size() > kMaxModes) best_.pop_back();
}

float DepthElection::TangencyWeight(const EpipolarCrossing& crossing) const {
  return std::clamp((crossing.EpipolarSine() - sin_low_) / (sin_high_ - sin_low_), min_weight_,
                    1.f);
}

// Squared distance of a crossing from a place in units of its gates.
float DepthElection::Distance(const EpipolarCrossing& crossing, const DepthPlace& place) const {
  const float offset = (crossing.inverse_depth - place.inverse_depth) *
                       crossing.across_px_per_inverse_depth * per_gate_px_;
  const float turn =
      (crossing.slope_per_px - place.slope_per_px) * crossing.rad_per_slope * per_gate_rad_;
  return offset * offset + turn * turn;
}

// The mode that the crossings near a place elect; nothing if too few views vote.
std::optional<DepthMode> DepthElection::Vote(const std::vector<EpipolarCrossing>& crossings,
                                             const DepthPlace& place) const {
  DepthMode mode;
  size_t num_voters = 0;
  double slope_weight = 0;
  double depth_weight = 0;
  const auto near = cells_.Near(place.inverse_depth);
  for (size_t i = 0; i < near.size();) {
    // Crossings are grouped by view: the nearest of each group votes.
    const int view = crossings[near[i]].view;
    const EpipolarCrossing* voter = nullptr;
    float least = 1;
    for (; i < near.size() && crossings[near[i]].view == view; ++i) {
      const float distance = Distance(crossings[near[i]], place);
      if (distance > least || (voter && distance == least)) continue;
      least = distance;
      voter = &crossings[near[i]];
    }
    if (voter == nullptr) continue;
    ++num_voters;
    mode.score += TangencyWeight(*voter) * (1 - 0.5 * least);
    const double w = Square(voter->across_px_per_inverse_depth);
    const double s = Square(voter->rad_per_slope);
    mode.depth.inverse_depth += w * voter->inverse_depth;
    mode.depth.slope_per_px += s * voter->slope_per_px;
    mode.depth.px_per_inverse_depth += voter->px_per_inverse_depth;
    depth_weight += w;
    slope_weight += s;
  }
  if (num_voters < kMinVoters) return std::nullopt;
  mode.depth.has_depth = true;
  mode.depth.inverse_depth /= depth_weight;
  mode.depth.slope_per_px /= slope_weight;
  mode.depth.px_per_inverse_depth /= static_cast<double>(num_voters);
  const double scale = mode.depth.inverse_depth / focal_px_;
  mode.depth.information = depth_weight * scale * scale;
  return mode;
}

}  // namespace limn
