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
  void Fill(const std::vector<EpipolarCrossing>& crossings, float gate_px);

  // Crossings that may accept the depth, ascending.
  std::span<const int> Near(float inverse_depth) const {
    const int cell = Cell(inverse_depth);
    return {members_.data() + begin_[cell], members_.data() + begin_[cell + 1]};
  }
  // Views that these belong to.
  int NumViews(float inverse_depth) const { return num_views_[Cell(inverse_depth)]; }

 private:
  struct Range {
    int first;
    int last;
  };
  int Cell(float inverse_depth) const;

  float low_ = 0;
  float cells_per_unit_ = 0;
  float last_cell_ = 0;
  std::vector<Range> reach_;  // per crossing
  std::vector<int> begin_;    // per cell, of its members
  std::vector<int> members_;
  std::vector<int> next_;
  std::vector<int> num_views_;
  std::vector<int> last_view_;
};

// What is elected.
struct DepthPlace {
  float inverse_depth = 0;
  float slope_per_px = 0;
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
  float TangencyWeight(const EpipolarCrossing& crossing) const;
  float Distance(const EpipolarCrossing& crossing, const DepthPlace& place) const;
  std::optional<DepthMode> Vote(const std::vector<EpipolarCrossing>& crossings,
                                const DepthPlace& place) const;
  void SortSeeds(const std::vector<EpipolarCrossing>& crossings);
  void MarkExplained(const std::vector<EpipolarCrossing>& crossings, const FusedDepth& mode);
  void Offer(const DepthMode& mode);

  double focal_px_;
  float gate_px_;
  float per_gate_px_;
  float per_gate_rad_;
  float sin_low_;
  float sin_high_;
  float min_weight_;
  DepthCells cells_;
  // Crossings by the number of views that may agree with them, descending.
  std::vector<int> seeds_;
  std::vector<int> seeds_begin_;
  std::vector<uint8_t> explained_;  // per crossing: would elect a mode that has been found
  std::vector<DepthMode> best_;     // by descending score, no two the same
};

}  // namespace limn
