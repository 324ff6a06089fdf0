// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "limn/linking/arc_bundle.h"
#include "limn/linking/edgel_grid.h"
#include "limn/linking/linking_options.h"
#include "limn/model/curve_fragment.h"

namespace limn {

// Edgels that lie on one circular arc within the tolerances, ordered along the arc in the direction
// of their tangents.
using Curvelet = std::vector<EdgelId>;

// The curvelets through an edgel (Guo et al. 2014; "CC3D" bundles). The edgel may be off by the
// tolerances, across the curve and in direction; for every such perturbation (a cell of a small
// grid) the neighbors that an arc must pass leave an interval of curvatures, the bundle. Starting
// from each neighbor that is in no curvelet yet, others are added nearest first as long as some
// cell's interval is not empty. Time: neighbors times curvelets.
class CurveletBuilder {
 public:
  // `options` must outlive the builder.
  CurveletBuilder(const std::vector<Edgel>& edgels, const LinkingOptions& options);

  // The result is valid until the next call. Not thread-safe: buffers are reused.
  std::span<const Curvelet> Around(EdgelId anchor);

 private:
  // An edgel in the anchor's frame.
  struct Neighbor {
    EdgelId id;
    double squared_distance;
    Eigen::Vector2f offset;
  };
  static bool Follow(const Neighbor& a, const Neighbor& b);
  // Fills neighbors_ with those that can be in a curvelet with the anchor, nearest first.
  void FindNeighbors(const Neighbor& anchor);
  // Fills bundles_, and drops the neighbors that no arc meets.
  void FindBundles(EdgelId anchor);
  // Fills members_ with the anchor, this neighbor and others that fit, and marks these as grouped.
  void GroupFrom(size_t seed, const Neighbor& anchor);
  // Adds members_ to the curvelets if there are enough.
  void KeepMembers();

  const LinkingOptions& options_;
  EdgelGrid grid_;
  std::vector<ArcSample> samples_;  // by edgel
  std::vector<EdgelId> near_;
  std::vector<Neighbor> neighbors_;
  std::vector<ArcBundle> bundles_;  // of neighbors_
  std::vector<uint8_t> grouped_;    // of neighbors_
  std::vector<Neighbor> members_;
  std::vector<Curvelet> curvelets_;  // the first num_curvelets_ are in use
  size_t num_curvelets_ = 0;
};

}  // namespace limn
