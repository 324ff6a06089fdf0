#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "limn/sketch/depth_fusion.h"
#include "limn/sketch/epipolar_crossings.h"

namespace limn {

// Which crossings accept which inverse depths: cells of inverse depth, about 1 px wide in the view
// that moves most, with the crossings whose tolerance reaches into them.
class DepthCells {
 public:
  // `crossings` are grouped by view. Replaces what was there.
  void Fill(const std::vector<EpipolarCrossing>& crossings, double gate_px);

  // Crossings that may accept the depth, ascending.
  std::span<const int> Near(double inverse_depth) const {
    const int cell = Clamped(inverse_depth);
    return {members_.data() + begin_[cell], members_.data() + begin_[cell + 1]};
  }
  // Views that these belong to.
  int NumViews(double inverse_depth) const { return num_views_[Clamped(inverse_depth)]; }

 private:
  int Cell(double inverse_depth) const;
  int Clamped(double inverse_depth) const;

  double low_ = 0;
  double cells_per_unit_ = 0;
  std::vector<int> begin_;
  std::vector<int> members_;
  std::vector<int> next_;
  std::vector<int> num_views_;
  std::vector<int> last_view_;
};

// Elects the depths of a sample on which the image curves of several views agree (algorithm.md 0.2,
// with crossings of epipolar lines in place of sampled depths). Every view has one vote for a
// depth: its crossing with the nearest depth and slope, weighted by tangency. Inverse depth and
// slope of a candidate are the means of its voters by their information.
class DepthElection {
 public:
  // `focal_px` is the primary view's.
  DepthElection(double focal_px, const SketchOptions& options);

  // The candidates with most votes, best first. `crossings` are those of one sample, grouped by
  // view. Starts where most views may agree, and ends when what is left cannot be among the best.
  // Time: crossings, plus candidates times crossings per depth.
  std::vector<DepthMode> Find(const std::vector<EpipolarCrossing>& crossings);

 private:
  double TangencyWeight(const EpipolarCrossing& crossing) const;
  double Distance(const EpipolarCrossing& crossing, double inverse_depth,
                  double slope_per_px) const;
  std::optional<DepthMode> Vote(const std::vector<EpipolarCrossing>& crossings,
                                double inverse_depth, double slope_per_px) const;
  bool IsExplained(const EpipolarCrossing& seed) const;
  void Offer(const DepthMode& mode);

  double focal_px_;
  double per_gate_px_;
  double per_gate_rad_;
  double gate_px_;
  double sin_low_;
  double sin_high_;
  double min_weight_;
  DepthCells cells_;
  // Number of views that may agree with a crossing, and the crossing's index: a heap.
  std::vector<std::pair<int, int>> seeds_;
  std::vector<FusedDepth> found_;  // also what was not good enough
  std::vector<DepthMode> best_;    // by descending score, no two the same
};

}  // namespace limn
