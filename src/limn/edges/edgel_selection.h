#pragma once

#include <vector>

#include "limn/model/edgel.h"

namespace limn {

// The edgels found so far in an image, at most one per pixel and none within 0.35 px of another.
class EdgelRaster {
 public:
  EdgelRaster(int width, int height);

  // Whether the edgel's pixel is free and no edgel is within 0.35 px; then it is added.
  bool TryAdd(const Edgel& edgel);

  // Is there an edgel within `radius_px` of (x, y) whose tangent is within `max_angle_rad` of
  // parallel?
  bool HasParallelNear(double x, double y, double tangent_rad, double radius_px,
                       double max_angle_rad) const;

  // All edgels in row-major order of the pixel that holds them.
  std::vector<Edgel> InPixelOrder() const;

 private:
  int width_;
  int height_;
  std::vector<int> index_of_pixel_;  // -1: none
  std::vector<Edgel> edgels_;
};

// Strongest first; ties by position, so that the order depends on nothing else.
void SortByStrength(std::vector<Edgel>* edgels);

}  // namespace limn
