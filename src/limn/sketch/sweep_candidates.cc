#include "limn/sketch/sweep_candidates.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace limn {
namespace {

constexpr double kDeg = M_PI / 180;
constexpr size_t kMaxModes = 8;
// Fewer views that agree are chance.
constexpr int kMinVoters = 2;
// Modes this near to a better one, in px of the other views, are the same.
constexpr double kSamePx = 1.0;
// Cells of depth are about this wide in the view that moves most.
constexpr double kCellPx = 1.0;
constexpr int kMaxCells = 4096;

// Which crossings accept which inverse depths: cells of inverse depth with the crossings whose
// tolerance reaches into them.
class DepthCells {
 public:
  DepthCells(const std::vector<EpipolarCrossing>& crossings, double gate_px) {
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
      const double reach = gate_px * crossing.inverse_depth_per_px;
      const int begin = std::max(0, Cell(crossing.inverse_depth - reach));
      const int end = std::min(count, Cell(crossing.inverse_depth + reach));
      for (int cell = begin; cell <= end; ++cell) visit(cell);
    };
    begin_.assign(count + 2, 0);
    views_.assign(count + 1, 0);
    for (const EpipolarCrossing& crossing : crossings) {
      for_each_cell(crossing, [&](int cell) {
        ++begin_[cell + 1];
        views_[cell] |= 1u << crossing.view;
      });
    }
    for (size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    members_.resize(begin_.back());
    std::vector<int> next(begin_.begin(), begin_.end() - 1);
    for (size_t i = 0; i < crossings.size(); ++i) {
      for_each_cell(crossings[i], [&](int cell) { members_[next[cell]++] = static_cast<int>(i); });
    }
  }

  int NumViews(double inverse_depth) const { return std::popcount(views_[Clamped(inverse_depth)]); }

  // Crossings that may accept the depth, ascending.
  std::span<const int> Near(double inverse_depth) const {
    const int cell = Clamped(inverse_depth);
    return {members_.data() + begin_[cell], members_.data() + begin_[cell + 1]};
  }

 private:
  int Cell(double inverse_depth) const {
    return static_cast<int>(std::floor((inverse_depth - low_) * cells_per_unit_));
  }
  int Clamped(double inverse_depth) const {
    return std::clamp(Cell(inverse_depth), 0, static_cast<int>(views_.size()) - 1);
  }

  double low_ = 0;
  double cells_per_unit_ = 0;
  std::vector<int> begin_;
  std::vector<int> members_;
  std::vector<uint32_t> views_;
};

class AgreementFinder {
 public:
  AgreementFinder(const std::vector<EpipolarCrossing>& crossings, double focal_px,
                  const SketchOptions& options)
      : crossings_(crossings),
        cells_(crossings, options.max_support_distance_px),
        focal_px_(focal_px),
        gate_px_(options.max_support_distance_px),
        gate_rad_(options.max_support_angle_deg * kDeg),
        sin_low_(std::sin(options.min_epipolar_angle_deg * kDeg)),
        sin_high_(std::sin(options.max_epipolar_angle_deg * kDeg)),
        min_weight_(options.min_tangency_weight) {}

  std::vector<DepthMode> Find() const {
    std::vector<DepthMode> found;
    for (const EpipolarCrossing& seed : crossings_) {
      if (cells_.NumViews(seed.inverse_depth) < kMinVoters) continue;
      const auto first = Vote(seed.inverse_depth, seed.slope_per_px);
      if (!first) continue;
      const auto second = Vote(first->depth.inverse_depth, first->depth.slope_per_px);
      if (second) found.push_back(*second);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const DepthMode& a, const DepthMode& b) { return a.score > b.score; });
    std::vector<DepthMode> best;
    for (const DepthMode& mode : found) {
      if (best.size() == kMaxModes) break;
      const bool known = std::any_of(best.begin(), best.end(), [&](const DepthMode& other) {
        return std::abs(other.depth.inverse_depth - mode.depth.inverse_depth) *
                   other.depth.px_per_inverse_depth <
               kSamePx;
      });
      if (!known) best.push_back(mode);
    }
    return best;
  }

 private:
  double TangencyWeight(const EpipolarCrossing& crossing) const {
    return std::clamp((crossing.epipolar_sine - sin_low_) / (sin_high_ - sin_low_), min_weight_,
                      1.0);
  }

  // Squared distance of a crossing from a place in units of its gates; infinite outside them.
  double Distance(const EpipolarCrossing& crossing, double inverse_depth,
                  double slope_per_px) const {
    const double offset = std::abs(crossing.inverse_depth - inverse_depth) /
                          (gate_px_ * crossing.inverse_depth_per_px);
    const double turn =
        std::abs(crossing.slope_per_px - slope_per_px) / (gate_rad_ * crossing.slope_per_rad);
    const double distance = offset * offset + turn * turn;
    return distance > 1 ? std::numeric_limits<double>::infinity() : distance;
  }

  // The mode that the crossings near a place elect; nothing if too few views vote.
  std::optional<DepthMode> Vote(double inverse_depth, double slope_per_px) const {
    DepthMode mode;
    int num_voters = 0;
    double slope_weight = 0;
    double depth_weight = 0;
    const auto near = cells_.Near(inverse_depth);
    for (size_t i = 0; i < near.size();) {
      // Crossings are grouped by view: the nearest of each group votes.
      const int view = crossings_[near[i]].view;
      const EpipolarCrossing* voter = nullptr;
      double least = std::numeric_limits<double>::infinity();
      for (; i < near.size() && crossings_[near[i]].view == view; ++i) {
        const double distance = Distance(crossings_[near[i]], inverse_depth, slope_per_px);
        if (distance >= least) continue;
        least = distance;
        voter = &crossings_[near[i]];
      }
      if (voter == nullptr) continue;
      ++num_voters;
      mode.score += TangencyWeight(*voter) * (1 - 0.5 * least);
      const double w = 1 / (voter->inverse_depth_per_px * voter->inverse_depth_per_px);
      const double s = 1 / (voter->slope_per_rad * voter->slope_per_rad);
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

  const std::vector<EpipolarCrossing>& crossings_;
  DepthCells cells_;
  double focal_px_;
  double gate_px_;
  double gate_rad_;
  double sin_low_;
  double sin_high_;
  double min_weight_;
};

}  // namespace

std::vector<DepthMode> FindAgreeingDepths(const std::vector<EpipolarCrossing>& crossings,
                                          double focal_px, const SketchOptions& options) {
  if (crossings.empty()) return {};
  return AgreementFinder(crossings, focal_px, options).Find();
}

}  // namespace limn
