#include "colmap_ext/workspace/camera_check.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "limn/model/reprojection_errors.h"
#include "limn/util/median.h"
#include "limn/util/name_list.h"

namespace limn::colmap_ext {

CameraCheck CheckCameras(const std::vector<View>& views, const SceneHints& hints, double max_px) {
  CameraCheck check;
  std::vector<double> fits;
  const auto errors = MedianReprojectionErrors(views, hints.points);
  for (size_t v = 0; v < errors.size(); ++v) {
    if (!errors[v]) continue;
    if (*errors[v] > max_px) {
      check.misfits.push_back({static_cast<ViewId>(v), *errors[v]});
    } else {
      fits.push_back(*errors[v]);
    }
  }
  std::ranges::stable_sort(check.misfits, std::greater{}, &Misfit::px);
  check.num_fits = static_cast<int>(fits.size());
  check.fits_px = Median(std::move(fits));
  return check;
}

std::string Describe(const CameraCheck& check, const std::vector<View>& views, double max_px) {
  std::vector<NamedNumber> names;
  for (const Misfit& misfit : check.misfits) names.push_back({views[misfit.view].name, misfit.px});
  std::string text = std::to_string(names.size()) + " of " + std::to_string(views.size()) +
                     " images by more than " + ShortNumber(max_px) +
                     " px: " + ListNumbers(names, "px");
  if (check.num_fits > 0) {
    text +=
        "; the other " + std::to_string(check.num_fits) + ": " + ShortNumber(check.fits_px) + " px";
  }
  return text;
}

}  // namespace limn::colmap_ext
