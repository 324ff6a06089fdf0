// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/curve_fragment.h"
#include "limn/support/view_edgels.h"

namespace limn {

// The chords (edgel to next edgel) of the fragments of a view, for all epipolar lines in it: one
// after the other along the fragments, so that lines that follow each other find theirs close
// together. 16 bytes per edgel of a fragment.
class FragmentChords {
 public:
  struct End {
    Eigen::Vector2f position_px;
    Eigen::Vector2f tangent;  // unit
  };

  explicit FragmentChords(const ImageCurves& curves);

  // Chord i goes from end i to end i + 1. A closed fragment has its first end once more as its
  // last; the last end of a fragment begins no chord.
  const std::vector<End>& ends() const { return ends_; }

  // Calls visit(chord), ascending: by fragment, and by vertex on it.
  template <typename Visit>
  void ForEach(Visit&& visit) const {
    for (size_t f = 0; f + 1 < first_end_.size(); ++f) {
      for (int chord = first_end_[f]; chord + 1 < first_end_[f + 1]; ++chord) visit(chord);
    }
  }

  // The fragment of a chord and the vertex that it begins at. Time: the logarithm of the number of
  // fragments.
  FragmentPlace PlaceOf(int chord) const;

 private:
  std::vector<End> ends_;
  std::vector<int> first_end_;  // per fragment, and one more
};

}  // namespace limn
