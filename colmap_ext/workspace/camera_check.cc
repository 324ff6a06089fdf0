// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/camera_check.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "colmap_ext/workspace/view_set.h"
#include "limn/model/reprojection_errors.h"
#include "limn/util/median.h"
#include "limn/util/name_list.h"
#include "limn/util/number_text.h"

namespace limn::colmap_ext {
namespace {

// The images of a set: their names, and by view, which one it is of. Its views are neighbors.
struct Images {
  std::vector<std::string> names;
  std::vector<double> scales;
  std::vector<int> of_view;
};

Images ImagesOf(const ViewSet& set) {
  Images images;
  for (size_t v = 0; v < set.views.size(); ++v) {
    const std::string& name = set.ImageName(static_cast<ViewId>(v));
    if (v == 0 || images.names.back() != name) {
      images.names.push_back(name);
      images.scales.push_back(set.views[v].scale);
    }
    images.of_view.push_back(static_cast<int>(images.names.size()) - 1);
  }
  return images;
}

}  // namespace

CameraCheck CheckCameras(const ViewSet& set, double max_px) {
  const Images images = ImagesOf(set);
  CameraCheck check;
  check.num_images = static_cast<int>(images.names.size());
  const auto errors = MedianReprojectionErrors(set.views, set.hints.points, images.of_view);
  std::vector<double> fits;
  for (size_t i = 0; i < errors.size(); ++i) {
    if (!errors[i]) continue;
    const double px = *errors[i] / images.scales[i];
    if (px > max_px) {
      check.misfits.push_back({images.names[i], px});
    } else {
      fits.push_back(px);
    }
  }
  std::ranges::stable_sort(check.misfits, std::greater{}, &Misfit::px);
  check.num_fits = static_cast<int>(fits.size());
  check.fits_px = Median(std::move(fits));
  return check;
}

std::string Describe(const CameraCheck& check, double max_px) {
  std::vector<NamedNumber> names;
  for (const Misfit& misfit : check.misfits) names.push_back({misfit.image, misfit.px});
  std::string text = std::to_string(names.size()) + " of " + std::to_string(check.num_images) +
                     " images by more than " + ShortNumber(max_px) +
                     " px: " + ListNumbers(names, "px");
  if (check.num_fits > 0) {
    text +=
        "; the other " + std::to_string(check.num_fits) + ": " + ShortNumber(check.fits_px) + " px";
  }
  return text;
}

}  // namespace limn::colmap_ext
