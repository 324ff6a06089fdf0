#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "limn/model/curve_fragment.h"
#include "limn/model/view.h"
#include "limn/support/edgel_index.h"

namespace limn {

// The edgels of every view that are asked.
using EdgelIndexes = std::vector<const EdgelIndex*>;

// How the images speak for a straight edge in space.
struct SegmentSupport {
  // Views in which edgels run along the segment.
  std::vector<ViewId> seen_in;
  // Views that were asked: both ends are in the image and the segment is not seen end on.
  int num_views = 0;
  // Chance that edgels run along a segment like this in one view: the share of copies of it,
  // shifted sideways, along which they do.
  double background = 0;
};

// Edgels run along a projected segment when at least `kMinCoveredShare` of its points, one per
// pixel and without the last 1.5 px at the ends, where edges are rounded, have one within the gate.
// Views with visible[v] = 0 are not asked.
SegmentSupport FindSegmentSupport(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                  const std::vector<uint8_t>& visible,
                                  const std::vector<View>& views, const EdgelIndexes& edgels,
                                  const SupportGate& gate);

// Whether edgels run along the segment in this view, as above: false if an end is outside the image
// or it is seen end on.
bool ShowsSegment(const View& view, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                  const EdgelIndex& edgels, const SupportGate& gate);

// Whether edgels run along the segment in any of the views asked, as above.
bool IsSeen(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
            const std::vector<uint8_t>& visible, const std::vector<View>& views,
            const EdgelIndexes& edgels, const SupportGate& gate);

// Bound (Hoeffding) on the natural logarithm of the chance that k or more of n views show by
// accident what each of them shows with probability p. 0 when that is what one expects.
// Neighboring views are no independent trials, an accident lasts while the camera moves on:
// whatever their number, they say no more than kIndependentViews would with the same share of k.
constexpr int kIndependentViews = 18;
double LogChance(int k, int n, double p);

}  // namespace limn
