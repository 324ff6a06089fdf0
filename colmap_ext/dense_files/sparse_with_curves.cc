#include "colmap_ext/dense_files/sparse_with_curves.h"

#include <algorithm>
#include <optional>

namespace limn::colmap_ext {
namespace {

// Where the camera of the model sees a point, COLMAP's pixels. A view may be of a shrunk image.
std::optional<Eigen::Vector2d> ModelPixel(const View& view, const Camera& camera,
                                          const Eigen::Vector3d& point) {
  const auto pixel = view.Project(point);
  const auto stored = pixel ? view.StoredFromVirtual(*pixel) : std::nullopt;
  if (!stored) return std::nullopt;
  return Eigen::Vector2d(
      (stored->x() + 0.5) * static_cast<double>(camera.width) / view.camera.width,
      (stored->y() + 0.5) * static_cast<double>(camera.height) / view.camera.height);
}

uint64_t NextPointId(const SparseModel& model) {
  uint64_t next = 1;
  for (const ModelPoint& point : model.points) next = std::max(next, point.id + 1);
  return next;
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
      const auto pixel = ModelPixel(views[view], model.CameraOf(image), from.position);
      if (pixel) seen.push_back({&image, *pixel});
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
