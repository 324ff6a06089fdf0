#pragma once

#include <vector>

#include "limn/geometry/epipolar.h"
#include "limn/model/view.h"
#include "limn/sketch/epipolar_chords.h"
#include "limn/sketch/hypotheses.h"

namespace limn {

// An image curve of another view that crosses the epipolar line of a sample: an estimate of the
// sample's depth and of its change along the fragment. Hundreds are compared per sample, so single
// precision is used, which is accurate to 1e-4 px.
struct EpipolarCrossing {
  // Rank of the view among those asked.
  int view = 0;
  float inverse_depth = 0;
  // Change of inverse depth per px along the primary fragment, from the curve's tangent.
  float slope_per_px = 0;
  // By how far the curve must move across itself, px, to change the first by 1, and by how much it
  // must turn, radians, to change the second by 1: small where it runs along the epipolar line.
  float across_px_per_inverse_depth = 0;
  float rad_per_slope = 0;
  // Image motion per unit of inverse depth, px.
  float px_per_inverse_depth = 0;

  // Sine of the angle between curve and epipolar line.
  float EpipolarSine() const { return across_px_per_inverse_depth / px_per_inverse_depth; }
};

// Finds the crossings of a primary view's samples in one other view.
class CrossingFinder {
 public:
  CrossingFinder(const View& primary, const View& other, const ImageCurves& curves_of_other);

  // Appends the crossings of vertex `vertex` whose inverse depth lies in the range, marked with
  // `rank`. Expected time: curves on the epipolar line.
  void Find(const FragmentRays& fragment, size_t vertex, double min_inverse_depth,
            double max_inverse_depth, int rank, std::vector<EpipolarCrossing>* crossings);

 private:
  RelativeProjection relative_;
  EpipolarChords chords_;
  std::vector<LineCrossing> on_line_;
};

}  // namespace limn
