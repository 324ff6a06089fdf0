// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "limn/geometry/epipolar.h"
#include "limn/model/view.h"
#include "limn/sketch/epipolar_chords.h"
#include "limn/sketch/fragment_rays.h"

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

// A depth of a sample and its change along the fragment.
struct DepthPlace {
  float inverse_depth = 0;
  float slope_per_px = 0;
};

inline DepthPlace PlaceOf(double inverse_depth, double slope_per_px) {
  return {static_cast<float>(inverse_depth), static_cast<float>(slope_per_px)};
}

// Finds the crossings of a primary view's samples in one other view.
class CrossingFinder {
 public:
  // `chords_of_other` must outlive the result.
  CrossingFinder(const View& primary, const View& other, const FragmentChords& chords_of_other);

  // Appends the crossings of vertex `vertex` whose inverse depth lies in the range, marked with
  // `rank`. Expected time: curves on the epipolar line.
  void Find(const FragmentRays& fragment, size_t vertex, const InverseDepthRange& range, int rank,
            std::vector<EpipolarCrossing>* crossings);

  // Those of them on the epipolar line within kNearPx of a place. Of curves that cross the line at
  // a small angle, which say little about depth, some that accept a place are farther away.
  void FindNear(const FragmentRays& fragment, size_t vertex, const InverseDepthRange& range,
                std::span<const DepthPlace> places, int rank,
                std::vector<EpipolarCrossing>* crossings);

  static constexpr double kNearPx = 15;

 private:
  // How a vertex is seen: with w its inverse depth, it projects to (at_infinity + w epipole) up to
  // scale.
  struct SeenVertex {
    Eigen::Vector3d at_infinity;
    InverseDepthRange in_front;  // the part of a range that is in front of the other camera
  };
  SeenVertex See(const FragmentRays& fragment, size_t vertex, const InverseDepthRange& range) const;
  // Appends what on_line_ says.
  void Append(const FragmentRays& fragment, size_t vertex, const SeenVertex& seen, int rank,
              std::vector<EpipolarCrossing>* crossings) const;

  RelativeProjection relative_;
  EpipolarChords chords_;
  std::vector<InverseDepthRange> ranges_;
  std::vector<LineCrossing> on_line_;
};

}  // namespace limn
