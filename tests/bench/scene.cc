#include "bench/scene.h"

namespace limn::bench {
namespace {

constexpr ViewId kHeldOutPeriod = 10;
constexpr ViewId kFirstHeldOut = 5;

}  // namespace

bool IsHeldOut(ViewId view) { return view % kHeldOutPeriod == kFirstHeldOut; }

Scene PartOf(const Scene& scene, bool held_out) {
  Scene part;
  std::vector<ViewId> new_id(scene.views.size(), -1);
  for (size_t v = 0; v < scene.views.size(); ++v) {
    if (IsHeldOut(static_cast<ViewId>(v)) != held_out) continue;
    new_id[v] = static_cast<ViewId>(part.views.size());
    part.views.push_back(scene.views[v]);
    part.curves.push_back(scene.curves[v]);
  }
  for (const ScenePoint& point : scene.hints.points) {
    ScenePoint kept{point.position_in_world, {}, {}, point.model_index};
    for (const ViewId view : point.views) {
      if (new_id[view] >= 0) kept.views.push_back(new_id[view]);
    }
    for (const PointPixel& pixel : point.pixels) {
      if (new_id[pixel.view] < 0) continue;
      kept.pixels.push_back(pixel);
      kept.pixels.back().view = new_id[pixel.view];
    }
    if (!kept.views.empty()) part.hints.points.push_back(std::move(kept));
  }
  return part;
}

}  // namespace limn::bench
