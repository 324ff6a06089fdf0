#pragma once

#include <optional>

#include "limn/edges/gaussian_derivatives.h"
#include "limn/model/edgel.h"

namespace limn {

// What the refinement of a candidate needs to know.
struct RefinementContext {
  double sigma_px = 1.5;
  // Standard deviation of a gradient component.
  double gradient_noise = 0;
  // Weakest edge accepted, grey levels per px.
  double threshold = 0;
};

// The maximum of the gradient magnitude along the gradient near the pixel (x, y), or nothing if
// there is none within 0.7 px (larger coordinate) or it is weaker than the threshold. The tangent
// is directed so that the channel rises along Edgel::Normal().
std::optional<Edgel> RefineEdgel(const SubpixelDerivatives& derivatives, int x, int y,
                                 const RefinementContext& context);

}  // namespace limn
