#pragma once

#include <vector>

#include "limn/model/curve_fragment.h"

namespace limn {

// Where a line meets a curve fragment, interpolated on the fragment.
struct LineCrossing {
  int fragment = -1;
  // Place on the fragment in vertices: vertex floor(parameter) plus the fraction to the next one.
  double parameter = 0;
  Eigen::Vector2d position_px = Eigen::Vector2d::Zero();
  // Unit tangent, interpolated between the two edgels.
  Eigen::Vector2d tangent = Eigen::Vector2d::Zero();
};

// Chords (edgel to next edgel) of the fragments of one view on a grid over the virtual image.
class FragmentIndex {
 public:
  explicit FragmentIndex(const ImageCurves& curves);

  // Append every crossing of the segment from `from` to `to` with a fragment, in the order of the
  // grid walk from `from`. Time: cells along the segment plus chords in them.
  void Crossings(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                 std::vector<LineCrossing>* crossings) const;

 private:
  struct Chord {
    int fragment;
    int vertex;
    Eigen::Vector2f begin;
    Eigen::Vector2f end;
    Eigen::Vector2f tangent_begin;
    Eigen::Vector2f tangent_end;  // less than 90 degrees from the other
  };
  struct Segment {
    Eigen::Vector2f origin;
    Eigen::Vector2f direction;  // unit
    float length;
  };
  void VisitCell(int col, int row, const Segment& segment,
                 std::vector<LineCrossing>* crossings) const;

  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  int cols_ = 0;
  int rows_ = 0;
  std::vector<int> cell_begin_;
  std::vector<Chord> chords_;  // by cell
};

}  // namespace limn
