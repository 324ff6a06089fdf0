#include "limn/support/link_footprint.h"

#include <algorithm>
#include <numeric>

#include "limn/support/edgel_residual.h"

namespace limn {
namespace {

double MedianFootprint(const Eigen::Vector3d& point, const std::vector<ViewId>& ids,
                       const std::vector<View>& views) {
  std::vector<double> footprints;
  for (const ViewId id : ids) {
    if (const auto footprint = Footprint(views[id], point)) footprints.push_back(*footprint);
  }
  if (footprints.empty()) return 0;
  const auto middle = footprints.begin() + static_cast<std::ptrdiff_t>(footprints.size() / 2);
  std::nth_element(footprints.begin(), middle, footprints.end());
  return *middle;
}

}  // namespace

double LinkFootprint(const DrawingLink& link, const Eigen::Vector3d& point,
                     const std::vector<View>& views) {
  const double footprint = MedianFootprint(point, link.supporting_views, views);
  if (footprint > 0) return footprint;
  std::vector<ViewId> all(views.size());
  std::iota(all.begin(), all.end(), 0);
  return MedianFootprint(point, all, views);
}

}  // namespace limn
