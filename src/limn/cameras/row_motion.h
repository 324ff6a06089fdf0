// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/cameras/camera_problem.h"
#include "limn/util/parallel.h"

namespace limn {

// How far the image of the middle of what a view sees moves between the exposures of its first and
// its last row.
struct ViewSkew {
  double px = 0;
  double sigma_px = 0;  // standard deviation, root of the mean over two directions; 0 = not known
  // Mean square of the two components in terms of their covariance (Wald 1943): 1 by chance alone.
  double evidence = 0;
};

struct RowMotion {
  std::vector<ViewSkew> of_view;
  // Of the views whose skew is known: that of the median one, without what chance adds, and the
  // mean of the evidence.
  double skew_px = 0;
  double evidence = 0;

  // Whether rows were exposed one after the other, and it matters.
  bool IsRollingShutter() const;
};

// Measures the motion of each camera while its image was exposed (algorithm/cameras.md#rows), taken
// as even: at a row s, -1/2 for the first and 1/2 for the last one, the camera has turned about its
// axes and shifted by s times six unknowns. Six more, for the mean pose, take what a wrong pose
// explains. The data are the distances of landmarks from their lines in this view, with landmarks
// where the other views place them: no structure bends to fit the view. Least squares, reweighted
// for the Cauchy loss of the landmarks; the covariance has curves as independent samples. The skew
// of a view with few lines or curves is not known. The other views count as still: where they
// move, too, skews are underestimated, and so are their standard deviations. Images scanned along
// columns, and wrong optics, look much the same. Precondition: landmarks of one curve follow one
// another. Time: linear in the number of lines, quadratic in those of one landmark.
RowMotion MeasureRowMotion(const std::vector<View>& views, const std::vector<Landmark>& landmarks,
                           const RunContext& context);

}  // namespace limn
