// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/dense_files/sparse_with_curves.h"

#include <optional>

#include "colmap_ext/workspace/to_views.h"

namespace limn::colmap_ext {
namespace {

std::optional<Eigen::Vector2d> StoredPixel(const View& view, const Eigen::Vector3d& point) {
  const auto pixel = view.Project(point);
  return pixel ? view.StoredFromVirtual(*pixel) : std::nullopt;
}

}  // namespace

SparseModel AddCurvePoints(SparseModel model, const std::vector<CurvePoint>& points,
                           const std::vector<View>& views, int every) {
  uint64_t next_id = NextPointId(model);
  LinkId link = -1;
  int since_last = 0;
  for (const CurvePoint& from : points) {
    if (from.link != link) since_last = every - 1;
    link = from.link;
    if (++since_last < every) continue;
    since_last = 0;
    ModelPoint point;
    point.id = next_id;
    point.position = from.position;
    point.color = from.color;
    point.error = 0;
    std::vector<std::pair<ModelImage*, Eigen::Vector2d>> seen;
    for (const ViewId view : from.views) {
      ModelImage& image = model.images[views[view].model_index];
      const auto stored = StoredPixel(views[view], from.position);
      if (!stored) continue;
      seen.push_back({&image, ModelPixel(views[view], model.CameraOf(image), *stored)});
    }
    if (seen.size() < 2) continue;
    for (const auto& [image, pixel] : seen) {
      point.track.push_back({image->id, static_cast<uint32_t>(image->observations.size())});
      image->observations.push_back({pixel, point.id});
    }
    model.points.push_back(std::move(point));
    ++next_id;
  }
  return model;
}

}  // namespace limn::colmap_ext
