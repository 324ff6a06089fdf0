// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/image_places.h"

#include <optional>
#include <string>

#include "limn/util/errors.h"
#include "limn/util/printable.h"

namespace limn::colmap_ext {
namespace {

// In whichever of the views of its photograph (parts of panoramas) it is nearest.
DrawingPlace PlaceInImage(const ImagePoint& point, const ViewSet& set,
                          const std::vector<View>& views, const DrawingGraph& graph) {
  std::optional<DrawingPlace> nearest;
  std::string problem = "no image in use is called " + Printable(point.image);
  for (ViewId v = 0; v < static_cast<ViewId>(views.size()); ++v) {
    if (set.ImageName(v) != point.image) continue;
    try {
      const DrawingPlace place = SnapToDrawing(point, views[v], v, graph);
      if (!nearest || place.distance_px < nearest->distance_px) nearest = place;
    } catch (const InputError& error) {
      problem = error.what();
    }
  }
  if (!nearest) throw InputError(problem);
  return *nearest;
}

}  // namespace

std::vector<DrawingPlace> PlacesOf(const std::vector<ImagePoint>& points, const ViewSet& set,
                                   const std::vector<View>& stored, const DrawingGraph& graph) {
  std::vector<DrawingPlace> places;
  for (const ImagePoint& point : points) places.push_back(PlaceInImage(point, set, stored, graph));
  return places;
}

}  // namespace limn::colmap_ext
