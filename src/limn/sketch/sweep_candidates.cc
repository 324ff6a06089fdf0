#include "limn/sketch/sweep_candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

constexpr double kDeg = M_PI / 180;
constexpr size_t kMaxModes = 8;
// Fewer views that agree are chance.
constexpr int kMinVoters = 2;
// Modes this near to a better one, in px of the other views, are the same.
constexpr double kSamePx = 1.0;
// A crossing this near to a mode, as a squared share of its gates, would elect it again.
constexpr double kExplained = 0.25;
// Cells of depth are about this wide in the view that moves most.
constexpr double kCellPx = 1.0;
constexpr int kMaxCells = 4096;

}  // namespace

int DepthCells::Cell(double inverse_depth) const {
  return static_cast<int>(std::floor((inverse_depth - low_) * cells_per_unit_));
}

int DepthCells::Clamped(double inverse_depth) const {
  return std::clamp(Cell(inverse_depth), 0, static_cast<int>(num_views_.size()) - 1);
}

void DepthCells::Fill(const std::vector<EpipolarCrossing>& crossings, double gate_px) {
  low_ = std::numeric_limits<double>::infinity();
  double high = -low_;
  double max_speed = 0;
  for (const EpipolarCrossing& crossing : crossings) {
    low_ = std::min(low_, crossing.inverse_depth);
    high = std::max(high, crossing.inverse_depth);
    max_speed = std::max(max_speed, crossing.px_per_inverse_depth);
  }
  const double num_cells = (high - low_) * max_speed / kCellPx + 1;
  const int count = static_cast<int>(std::min<double>(num_cells, kMaxCells));
  cells_per_unit_ = high > low_ ? count / (high - low_) : 0;
  const auto for_each_cell = [&](const EpipolarCrossing& crossing, auto&& visit) {
    const double reach = gate_px / crossing.across_px_per_inverse_depth;
    const int begin = std::max(0, Cell(crossing.inverse_depth - reach));
    const int end = std::min(count, Cell(crossing.inverse_depth + reach));
    for (int cell = begin; cell <= end; ++cell) visit(cell);
  };
  begin_.assign(count + 2, 0);
  num_views_.assign(count + 1, 0);
  last_view_.assign(count + 1, -1);
  for (const EpipolarCrossing& crossing : crossings) {
    for_each_cell(crossing, [&](int cell) {
      ++begin_[cell + 1];
      num_views_[cell] += last_view_[cell] != crossing.view;
      last_view_[cell] = crossing.view;
    });
  }
  for (size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  members_.resize(begin_.back());
  next_.assign(begin_.begin(), begin_.end() - 1);
  for (size_t i = 0; i < crossings.size(); ++i) {
    for_each_cell(crossings[i], [&](int cell) { members_[next_[cell]++] = static_cast<int>(i); });
  }
}

DepthElection::DepthElection(double focal_px, const SketchOptions& options)
    : focal_px_(focal_px),
      per_gate_px_(1 / options.max_support_distance_px),
      per_gate_rad_(1 / (options.max_support_angle_deg * kDeg)),
      gate_px_(options.max_support_distance_px),
      sin_low_(std::sin(options.min_epipolar_angle_deg * kDeg)),
      sin_high_(std::sin(options.max_epipolar_angle_deg * kDeg)),
      min_weight_(options.min_tangency_weight) {}

std::vector<DepthMode> DepthElection::Find(const std::vector<EpipolarCrossing>& crossings) {
  if (crossings.empty()) return {};
  cells_.Fill(crossings, gate_px_);
  seeds_.clear();
  for (size_t i = 0; i < crossings.size(); ++i) {
    const int num_views = cells_.NumViews(crossings[i].inverse_depth);
    if (num_views >= kMinVoters) seeds_.emplace_back(num_views, -static_cast<int>(i));
  }
  std::make_heap(seeds_.begin(), seeds_.end());
  found_.clear();
  best_.clear();
  const auto least_score = [&] { return best_.size() < kMaxModes ? 0 : best_.back().score; };
  while (!seeds_.empty() && seeds_.front().first > least_score()) {
    const EpipolarCrossing& seed = crossings[-seeds_.front().second];
    std::pop_heap(seeds_.begin(), seeds_.end());
    seeds_.pop_back();
    if (IsExplained(seed)) continue;
    const auto first = Vote(crossings, seed.inverse_depth, seed.slope_per_px);
    if (!first) continue;
    const auto second = Vote(crossings, first->depth.inverse_depth, first->depth.slope_per_px);
    if (second) Offer(*second);
  }
  return best_;
}

bool DepthElection::IsExplained(const EpipolarCrossing& seed) const {
  return std::any_of(found_.begin(), found_.end(), [&](const FusedDepth& mode) {
    return Distance(seed, mode.inverse_depth, mode.slope_per_px) < kExplained;
  });
}

void DepthElection::Offer(const DepthMode& mode) {
  found_.push_back(mode.depth);
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

double DepthElection::TangencyWeight(const EpipolarCrossing& crossing) const {
  return std::clamp((crossing.epipolar_sine - sin_low_) / (sin_high_ - sin_low_), min_weight_, 1.0);
}

// Squared distance of a crossing from a place in units of its gates.
double DepthElection::Distance(const EpipolarCrossing& crossing, double inverse_depth,
                               double slope_per_px) const {
  const double offset = (crossing.inverse_depth - inverse_depth) *
                        crossing.across_px_per_inverse_depth * per_gate_px_;
  const double turn =
      (crossing.slope_per_px - slope_per_px) * crossing.rad_per_slope * per_gate_rad_;
  return offset * offset + turn * turn;
}

// The mode that the crossings near a place elect; nothing if too few views vote.
std::optional<DepthMode> DepthElection::Vote(const std::vector<EpipolarCrossing>& crossings,
                                             double inverse_depth, double slope_per_px) const {
  DepthMode mode;
  int num_voters = 0;
  double slope_weight = 0;
  double depth_weight = 0;
  const auto near = cells_.Near(inverse_depth);
  for (size_t i = 0; i < near.size();) {
    // Crossings are grouped by view: the nearest of each group votes.
    const int view = crossings[near[i]].view;
    const EpipolarCrossing* voter = nullptr;
    double least = 1;
    for (; i < near.size() && crossings[near[i]].view == view; ++i) {
      const double distance = Distance(crossings[near[i]], inverse_depth, slope_per_px);
      if (distance > least || (voter && distance == least)) continue;
      least = distance;
      voter = &crossings[near[i]];
    }
    if (voter == nullptr) continue;
    ++num_voters;
    mode.score += TangencyWeight(*voter) * (1 - 0.5 * least);
    const double w = voter->across_px_per_inverse_depth * voter->across_px_per_inverse_depth;
    const double s = voter->rad_per_slope * voter->rad_per_slope;
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
  mode.depth.px_per_inverse_depth /= num_voters;
  const double scale = mode.depth.inverse_depth / focal_px_;
  mode.depth.information = depth_weight * scale * scale;
  return mode;
}

}  // namespace limn
