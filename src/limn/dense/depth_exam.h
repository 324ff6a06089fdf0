// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "limn/dense/dense_options.h"
#include "limn/dense/drawing_samples.h"
#include "limn/visibility/depth_image.h"

namespace limn {

// How often depths are those of the drawing, over places of it that views surely see, and the cells
// around these.
struct DepthAgreement {
  size_t num_places = 0;
  size_t num_known = 0;  // of them, with a depth
  // Shares: of the cells that have a depth; of these, at the depth of the drawing; and of those of
  // other places of the same view, which is chance.
  double known = 0;
  double near = 0;
  double chance = 0;

  // 1 if all depths agree, 0 if as many as by chance.
  double BeyondChance() const { return chance < 1 ? (near - chance) / (1 - chance) : 0; }
};

// With fewer, a view is not doubted alone.
constexpr size_t kEnoughPlaces = 50;

// The mean of all, by their numbers of places.
DepthAgreement Pooled(const std::vector<DepthAgreement>& of_views);

// Whether depths are those of the drawing (algorithm/dense.md#trust).
bool FitsOverall(const DepthAgreement& agreement);

// A place of the drawing as a view sees it.
struct SeenPlace {
  Eigen::Vector2d pixel;
  double depth = 0;
};

// Evenly spread, up to so many.
std::vector<SeenPlace> Thinned(const std::vector<SeenPlace>& places, size_t max_count);

// The places that each view surely sees: samples of links that it supports, without tentative ones
// and outlines; up to 1000 a view, evenly spread. Linear time.
class SurelySeen {
 public:
  SurelySeen(const DrawingGraph& graph, const DrawingSamples& samples,
             const std::vector<View>& views);

  std::vector<SeenPlace> In(ViewId view) const;

 private:
  const DrawingSamples& samples_;
  const std::vector<View>& views_;
  std::vector<std::vector<int32_t>> samples_of_view_;
};

// Compares the places of a view with a depth image, of this view or another.
DepthAgreement Agreement(const std::vector<SeenPlace>& places, const View& view,
                         const DepthImage& image, const DenseOptions& options);

}  // namespace limn
