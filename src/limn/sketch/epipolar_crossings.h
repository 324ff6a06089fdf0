#pragma once

#include <vector>

#include "limn/geometry/epipolar.h"
#include "limn/model/view.h"
#include "limn/sketch/hypotheses.h"
#include "limn/support/fragment_index.h"

namespace limn {

// An image curve of another view that crosses the epipolar line of a sample: one opinion on the
// sample's depth and on how depth changes along the fragment.
struct EpipolarCrossing {
  // Rank of the view among those asked.
  int view = 0;
  double inverse_depth = 0;
  // Change of inverse depth per px along the primary fragment that the curve's tangent calls for.
  double slope_per_px = 0;
  // By how much the two change when the curve moves by 1 px across itself, or turns by 1 radian:
  // large where it runs along the epipolar line.
  double inverse_depth_per_px = 0;
  double slope_per_rad = 0;
  // Image motion per unit of inverse depth, px.
  double px_per_inverse_depth = 0;
  // Sine of the angle between curve and epipolar line.
  double epipolar_sine = 0;
};

// Finds the crossings of a primary view's samples in one other view.
class CrossingFinder {
 public:
  CrossingFinder(const View& primary, const View& other, const FragmentIndex& fragments);

  // Append the crossings of vertex `vertex` whose inverse depth lies in the range, marked with
  // `rank`. Time: cells along the epipolar segment plus chords in them.
  void Find(const FragmentRays& fragment, size_t vertex, double min_inverse_depth,
            double max_inverse_depth, int rank, std::vector<EpipolarCrossing>* crossings);

 private:
  RelativeProjection relative_;
  const FragmentIndex& fragments_;
  std::vector<LineCrossing> on_line_;
};

}  // namespace limn
