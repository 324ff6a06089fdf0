#pragma once

#include <vector>

#include <ceres/cost_function.h>

#include "limn/model/view.h"
#include "limn/support/edgel_residual.h"

namespace limn {

// A line in the image of a view onto which a place in space should project.
struct LinePull {
  const View* view;
  EdgelLine line;
  double scale;  // k below
};

// The data term of all fits (algorithm/refinement.md#data-term): of curves with fixed cameras, and
// of curves, scene points and cameras together.
//
// Distance. A place x, world units, is the weighted sum of control points: (1 - t) a + t b at t on
// the segment from a to b. A view with given pose (R, s), motion (w, m) and logarithm l of the
// factor on its focal length sees it at the pixel p of the virtual image:
//   z = Exp(w) (R x + s),   y = z + m,   p = o + e^l (fx y_x / y_z, fy y_y / y_z),
// where o is the principal point. Its signed distance from the line, stored px, is
//   d = n . (p - q)
// with a point q of the line and the row n that turns an offset in the virtual image into its part
// across the line in stored pixels (EdgelLine). Fixed cameras have w = m = 0, l = 0.
//
// Loss. An edgel costs k^2 c^2 log(1 + (d / c)^2) (Cauchy): (k d)^2 as long as |d| is small against
// c = robust_px, and growing ever more slowly beyond. k^2 is the weight of the edgel, 1 / px^2
// (EdgelPull). The residual is the signed root of the loss,
//   r = k c sign(d) sqrt(log(1 + u^2)),   u = d / c,
// so that least squares of r minimizes the sum of the losses. A ceres::LossFunction acts on all
// residuals of a block together, whereas here each of a block has its own. c may be infinite: r = k
// d. Behind the camera d is a large constant, so that moving there never lowers the cost.
//
// Derivatives. dr = k h dd with h = |u| / ((1 + u^2) sqrt(log(1 + u^2))), which goes to 1 with
// u -> 0. With g = dd/dy, px / world unit,
//   dd/dx = (Exp(w) R)' g, times the weight of a control point for that point; dd/dm = g;
//   dd/dw = J' (z x g), because Exp(w + e) = Exp(J e) Exp(w) to first order in e, and a small turn
//           J e moves z by (J e) x z. J is the left Jacobian of the rotations:
//           J' v = v - (1 - cos |w|) / |w|^2 w x v + (|w| - sin |w|) / |w|^3 w x (w x v);
//   dd/dl = n . (p - o) = d + n . (q - o), as p - o is proportional to e^l.
class PullCost : public ceres::CostFunction {
 public:
  // One residual per pull. Parameter blocks: as many points as weights; with `cameras_move`, when
  // all pulls are of one view, (w, m) and l, too.
  PullCost(std::vector<LinePull> pulls, std::vector<double> weights, double robust_px,
           bool cameras_move);

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  std::vector<LinePull> pulls_;
  std::vector<double> weights_;  // of the points
  double robust_px_;
  bool cameras_move_;
};

}  // namespace limn
