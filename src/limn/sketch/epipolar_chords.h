// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "limn/model/view.h"
#include "limn/sketch/fragment_chords.h"

namespace limn {

// Where an epipolar line meets a chord.
struct LineCrossing {
  int chord = -1;
  // Share of the chord before the crossing.
  double fraction = 0;
  Eigen::Vector2d position_px = Eigen::Vector2d::Zero();
  // Unit tangent, interpolated between the two edgels.
  Eigen::Vector2d tangent = Eigen::Vector2d::Zero();
};

// Inverse depths, 1 / world units along the optical axis; from < to.
struct InverseDepthRange {
  double from = 0;
  double to = 0;
};

// The chords of one view sorted by their epipolar planes with a primary view. A plane is where it
// is around the baseline, which both views see; a point in it is where its ray to the other camera
// is between the directions of the baseline. Finding what a part of a line meets is then a single
// look-up, however long the line is.
class EpipolarChords {
 public:
  // `chords_of_other` must outlive the result. Time and memory: linear in the chords, plus the
  // planes that chords near the epipole span.
  EpipolarChords(const View& primary, const View& other, const FragmentChords& chords_of_other);

  const FragmentChords& chords() const { return chords_; }

  // Appends the crossings of chords with the half plane of a primary pixel, bounded by the
  // baseline, ascending by chord. There are none if the views share a center. Expected time: chords
  // on the line.
  void Find(const Eigen::Vector2d& primary_px, std::vector<LineCrossing>* crossings) const;

  // Those of chords of which a part is seen at an inverse depth, of the primary view, in any of the
  // ranges.
  void Find(const Eigen::Vector2d& primary_px, std::span<const InverseDepthRange> ranges,
            std::vector<LineCrossing>* crossings) const;

 private:
  // Where an end of a chord is seen.
  struct Sight {
    // Grows with the angle around the baseline; from -2 to 2.
    float plane;
    // Cotangent of the angle to the baseline: linear in the inverse depth along a primary ray.
    float along;
  };
  // Chords between two planes that are less than 2 apart, as arrays of their parts, padded for
  // batches.
  struct Spans {
    std::vector<float> begin_plane;
    std::vector<float> end_plane;
    std::vector<float> low_along;
    std::vector<float> high_along;
    std::vector<int> chord;
  };
  // The half plane of a primary pixel, and how inverse depths in it are seen.
  struct Line;

  Line LineOf(const Eigen::Vector2d& primary_px) const;
  std::vector<Sight> FindSights() const;
  void SortIntoBins(const std::vector<Sight>& sights);
  // Calls visit(sight of the begin, sight of the end, chord) for all chords, twice where planes
  // jump by a turn.
  template <typename Visit>
  void ForEachSpan(const std::vector<Sight>& sights, const Visit& visit) const;
  int Bin(float plane) const;
  LineCrossing Cross(const Line& line, int chord) const;

  const FragmentChords& chords_;
  double baseline_ = 0;
  // Pixels to directions in the world: across the baseline in the first two rows, along it in the
  // third.
  Eigen::Matrix3d frame_from_primary_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d frame_from_other_ = Eigen::Matrix3d::Zero();
  float low_plane_ = 0;
  float bins_per_plane_ = 0;
  std::vector<int> bin_begin_;
  Spans spans_;  // by bin
};

}  // namespace limn
