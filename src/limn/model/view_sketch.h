#pragma once

#include <vector>

#include "limn/model/curve3d.h"
#include "limn/model/edgel_fate.h"

namespace limn {

// The part of a sketch that comes from one primary view.
struct ViewSketch {
  std::vector<Curve3D> curves;   // anchored in this view, by fragment
  std::vector<EdgelFate> fates;  // per edgel of the view
};

}  // namespace limn
