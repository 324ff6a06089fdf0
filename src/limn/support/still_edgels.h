#pragma once

#include <map>
#include <utility>
#include <vector>

#include "limn/model/curve_fragment.h"
#include "limn/model/view.h"
#include "limn/support/edgel_index.h"
#include "limn/util/parallel.h"

namespace limn {

// Finds edgels that stand still in the image while the camera moves: burnt-in text, dirt on the
// sensor, the background of a turntable. They are no edges of the scene, and match each other in
// all views. An edgel is still if more than half of the other photographs of the same size, at
// least 5 with other poses, have an edgel at the same pixel (0.75 px, 10 degrees). Up to 24
// photographs are compared with (algorithm/linking.md#still-edgels).
class StillEdgels {
 public:
  // The views to compare with, ascending: of each size of photographs up to 24 of different poses.
  // None of a size that has fewer than 6.
  static std::vector<ViewId> ViewsToCompare(const std::vector<View>& views);

  // `as_stored`: per view the curves in stored pixels, at least those of the views to compare with.
  StillEdgels(const std::vector<View>& views, const std::vector<ImageCurves>& as_stored,
              const RunContext& context);

  // Per edgel of the view. Those next to still ones on a fragment are still, too. Time: edgels in
  // fragments times views to compare with.
  std::vector<bool> In(ViewId view, const ImageCurves& as_stored) const;

 private:
  const std::vector<View>& views_;
  double spread_ = 0;  // of the centers
  std::map<std::pair<int, int>, std::vector<ViewId>> compared_;  // by size
  std::vector<EdgelIndex> index_;                                // per view; empty if not compared
};

}  // namespace limn
