#pragma once

#include <memory>
#include <vector>

#include "limn/model/curve_fragment.h"
#include "limn/model/view.h"
#include "limn/support/edgel_index.h"
#include "limn/support/view_edgels.h"

namespace limn {

// The images, as the topology stages see them. `curves[v]` and `edgels[v]` belong to `views[v]`.
struct TopologyInput {
  const std::vector<View>& views;
  const std::vector<ImageCurves>& curves;
  const std::vector<std::unique_ptr<ViewEdgels>>& edgels;
  // How near an edgel must be to a curve to support it.
  SupportGate gate;
};

}  // namespace limn
