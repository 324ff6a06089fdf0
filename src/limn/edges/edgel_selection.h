// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/edges/edge_refinement.h"
#include "limn/util/union_find.h"

namespace limn {

// What decides whether edgels are near and continue each other.
struct EdgelPlace {
  Eigen::Vector2d position;
  Eigen::Vector2d tangent;
};

// The edgels found so far in an image, at most one per pixel and none within 0.35 px of another.
class EdgelRaster {
 public:
  EdgelRaster(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  // Adds the edgels whose pixel is free and that have no other within 0.35 px, strongest first,
  // ties in the given order. No strength may be below 0.
  void AddStrongestFirst(const std::vector<RefinedEdgel>& edgels);

  // Whether an edgel within `radius_px` of a position has a tangent whose undirected angle to
  // `direction`, of any length, has a cosine of at least `min_cosine`.
  bool HasParallelNear(const Eigen::Vector2d& position, const Eigen::Vector2d& direction,
                       double radius_px, double min_cosine) const;

  // Whether an edgel within `radius_px` of this one is at least `min_ratio` times as strong and has
  // a tangent whose angle to the opposite of its own has a cosine of at least `min_cosine`.
  bool HasOppositeNear(const Edgel& edgel, double radius_px, double min_cosine,
                       double min_ratio) const;

  // Drops edgels less significant than `strong_ratio` in runs that extend over less than
  // `min_run_px`. A run is a set of edgels connected by steps of at most 2 px that follow the
  // tangent of either.
  void DropWeakShortRuns(double strong_ratio, double min_run_px);

  // Those of dense texture, as indices into Edgels() (FindDenseTexture); none if min_density is 0.
  std::vector<EdgelId> Texture(double min_density) const;

  // All edgels in row-major order of the pixel that holds them.
  std::vector<Edgel> Edgels() const;

 private:
  // Assigns the edgel of this index to its pixel if that is free and no other edgel is too near.
  void TryHold(int index);
  // Removes edgels without a pixel and sorts the others in row-major order.
  void Compact();
  // Whether `test(index of an edgel)` holds for any in pixels overlapping the square of half-size
  // `radius_px`.
  template <typename Test>
  bool AnyInSquare(const Eigen::Vector2d& center, double radius_px, const Test& test) const;
  // The connected runs, as sets of indices of edgels.
  UnionFind Runs() const;
  // Over how much the run of an edgel extends, px, by index; 0 for those without a pixel.
  std::vector<double> RunLengths() const;

  int width_;
  int height_;
  std::vector<int> index_of_pixel_;  // -1: none
  // Includes some edgels without a pixel. Roughly in row-major order, for locality of look-ups.
  std::vector<RefinedEdgel> edgels_;
  std::vector<EdgelPlace> places_;  // of edgels_
};

}  // namespace limn
