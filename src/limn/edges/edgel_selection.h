#pragma once

#include <vector>

#include "limn/edges/edge_refinement.h"

namespace limn {

// The edgels found so far in an image, at most one per pixel and none within 0.35 px of another.
class EdgelRaster {
 public:
  EdgelRaster(int width, int height);

  // Add those whose pixel is free and that have no edgel within 0.35 px. The strongest come first,
  // ties by position, so that the result depends on nothing else.
  void AddStrongestFirst(std::vector<RefinedEdgel> edgels);

  // Is there an edgel within `radius_px` of (x, y) whose tangent is within `max_angle_rad` of
  // parallel?
  bool HasParallelNear(double x, double y, double tangent_rad, double radius_px,
                       double max_angle_rad) const;

  // Drop edgels less significant than `strong_ratio` in runs that extend over less than
  // `min_run_px`. A run is a set of edgels connected by steps of at most 2 px that follow the
  // tangents of both.
  void DropWeakShortRuns(double strong_ratio, double min_run_px);

  // All edgels in row-major order of the pixel that holds them.
  std::vector<Edgel> InPixelOrder() const;

 private:
  void TryAdd(const RefinedEdgel& edgel);
  // Visit(index of edgel) for all in pixels overlapping the square of half-size `radius_px`.
  template <typename Visit>
  void VisitSquare(const Eigen::Vector2d& center, double radius_px, const Visit& visit) const;

  int width_;
  int height_;
  std::vector<int> index_of_pixel_;  // -1: none
  std::vector<RefinedEdgel> edgels_;
};

}  // namespace limn
