#pragma once

#include <vector>

#include "limn/linking/arc_bundle.h"
#include "limn/linking/edgel_grid.h"
#include "limn/linking/linking.h"

namespace limn {

// Edgels that lie on one circular arc within the tolerances, ordered along the arc in the direction
// of their tangents.
using Curvelet = std::vector<EdgelId>;

// The curvelets through an edgel (Guo et al. 2014; "CC3D" bundles). The edgel's position across the
// curve and its direction may be off by the tolerances; for every such perturbation (a cell of a
// small grid) the neighbours that an arc must pass leave an interval of curvatures, the bundle.
// Starting from each neighbour that is in no curvelet yet, others are added nearest first as long
// as some cell's interval is not empty. Time: neighbours times curvelets.
class CurveletBuilder {
 public:
  // `options` must outlive the builder.
  CurveletBuilder(const std::vector<Edgel>& edgels, const LinkingOptions& options);

  std::vector<Curvelet> Around(EdgelId anchor) const;

 private:
  const LinkingOptions& options_;
  EdgelGrid grid_;
  std::vector<ArcSample> samples_;  // by edgel
};

}  // namespace limn
