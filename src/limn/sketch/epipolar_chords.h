#pragma once

#include <vector>

#include "limn/model/curve_fragment.h"
#include "limn/model/view.h"

namespace limn {

// Where an epipolar line meets a curve fragment, interpolated on the fragment.
struct LineCrossing {
  int fragment = -1;
  // Place on the fragment in vertices: vertex floor(parameter) plus the fraction to the next one.
  double parameter = 0;
  Eigen::Vector2d position_px = Eigen::Vector2d::Zero();
  // Unit tangent, interpolated between the two edgels.
  Eigen::Vector2d tangent = Eigen::Vector2d::Zero();
};

// The chords (edgel to next edgel) of the fragments of one view, sorted by their epipolar planes
// with a primary view: a plane is the angle around the baseline at which both views see it. Finding
// what a line meets is then a single look-up, however long the line is.
class EpipolarChords {
 public:
  // Time and memory: linear in the chords, plus the planes that chords near the epipole span.
  EpipolarChords(const View& primary, const View& other, const ImageCurves& curves_of_other);

  // Appends the crossings of the other view's fragments with the half plane of a primary pixel,
  // bounded by the baseline, ascending by fragment and place on it. There are none if the views
  // share a center. Expected time: crossings found.
  void Find(const Eigen::Vector2d& primary_px, std::vector<LineCrossing>* crossings) const;

 private:
  struct Chord {
    int fragment;
    int vertex;
    Eigen::Vector2f begin;
    Eigen::Vector2f end;
    Eigen::Vector2f tangent_begin;
    Eigen::Vector2f tangent_end;  // within 90 degrees of the other
  };
  // A chord between two planes; `begin_rad` and `end_rad` are less than pi apart.
  struct Span {
    float begin_rad;
    float end_rad;
    int chord;
  };
  // Pixels to their offset from the baseline, in two directions across it.
  using OffsetFromPixel = Eigen::Matrix<double, 2, 3>;

  void CollectChords(const ImageCurves& curves);
  std::vector<Span> FindSpans(const ImageCurves& curves) const;
  void SortIntoBins(const std::vector<Span>& spans);
  void SortChordsAsInBins();
  int Bin(float plane_rad) const;

  OffsetFromPixel offset_from_primary_ = OffsetFromPixel::Zero();
  OffsetFromPixel offset_from_other_ = OffsetFromPixel::Zero();
  std::vector<Chord> chords_;
  float low_rad_ = 0;
  float bins_per_rad_ = 0;
  std::vector<int> bin_begin_;
  std::vector<Span> spans_;  // by bin
};

}  // namespace limn
