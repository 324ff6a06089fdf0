#include "limn/support/still_edgels.h"

#include <algorithm>
#include <cstdint>

#include <Eigen/Geometry>

#include "limn/util/angles.h"
#include "limn/util/median.h"

namespace limn {
namespace {

constexpr SupportGate kSamePlace = {0.75, 0.75, 10 * kDeg};
constexpr size_t kMaxCompared = 24;
constexpr size_t kMinCompared = 6;
// Candidates for them: some are of the same pose, as in sets of several lights.
constexpr size_t kMaxCandidates = 72;
// Two views have the same pose if they differ by less: in rotation, and of the centers' median
// distance from their mean.
constexpr double kSameRotation = 0.1 * kDeg;
constexpr double kSameCenterShare = 1e-3;
constexpr double kStillShare = 0.5;
// Every so manyth edgel of a fragment is asked. Each is decided by those within this many edgels.
constexpr int kStride = 3;
constexpr int kHalfWindow = 6;

using Size = std::pair<int, int>;

Size SizeOf(const View& view) { return {view.camera.width, view.camera.height}; }

double SpreadOfCenters(const std::vector<View>& views) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const View& view : views) mean += view.CenterInWorld() / static_cast<double>(views.size());
  std::vector<double> distances;
  for (const View& view : views) distances.push_back((view.CenterInWorld() - mean).norm());
  return Median(std::move(distances));
}

bool HaveSamePose(const View& a, const View& b, double spread) {
  return a.cam_from_world.rotation.angularDistance(b.cam_from_world.rotation) < kSameRotation &&
         (a.CenterInWorld() - b.CenterInWorld()).norm() <= kSameCenterShare * spread;
}

// Up to kMaxCompared of different poses.
std::vector<ViewId> OfDifferentPoses(const std::vector<View>& views,
                                     const std::vector<ViewId>& candidates, double spread) {
  std::vector<ViewId> kept;
  const size_t count = std::min(candidates.size(), kMaxCandidates);
  for (size_t i = 0; i < count && kept.size() < kMaxCompared; ++i) {
    const ViewId id = candidates[i * candidates.size() / count];
    const bool is_new = std::ranges::none_of(
        kept, [&](ViewId other) { return HaveSamePose(views[id], views[other], spread); });
    if (is_new) kept.push_back(id);
  }
  return kept;
}

std::map<Size, std::vector<ViewId>> ComparedBySize(const std::vector<View>& views) {
  std::map<Size, std::vector<ViewId>> by_size;
  for (size_t v = 0; v < views.size(); ++v) {
    by_size[SizeOf(views[v])].push_back(static_cast<ViewId>(v));
  }
  const double spread = SpreadOfCenters(views);
  for (auto& [size, ids] : by_size) ids = OfDifferentPoses(views, ids, spread);
  std::erase_if(by_size, [](const auto& of_size) { return of_size.second.size() < kMinCompared; });
  return by_size;
}

// Whether most of the views have an edgel at the same place.
bool MostHave(const Edgel& edgel, const std::vector<const EdgelIndex*>& others) {
  const double needed = kStillShare * static_cast<double>(others.size());
  double num_same = 0;
  auto num_left = static_cast<double>(others.size());
  for (const EdgelIndex* other : others) {
    if (num_same + num_left <= needed) return false;
    num_same += other->Best(edgel.position_px, edgel.Tangent(), kSamePlace).has_value();
    num_left -= 1;
  }
  return num_same > needed;
}

// Of some edgels of a fragment it is asked; each is decided by the majority within the window.
void MarkStill(const CurveFragment& fragment, const std::vector<Edgel>& edgels,
               const std::vector<const EdgelIndex*>& others, std::vector<bool>* still) {
  const int size = static_cast<int>(fragment.edgel_ids.size());
  std::vector<uint8_t> asked;
  for (int k = 0; k < size; k += kStride) {
    asked.push_back(MostHave(edgels[fragment.edgel_ids[k]], others));
  }
  for (int k = 0; k < size; ++k) {
    const int begin = std::max(0, (k - kHalfWindow + kStride - 1) / kStride);
    const int end = std::min(static_cast<int>(asked.size()), (k + kHalfWindow) / kStride + 1);
    const auto num_still = std::count(asked.begin() + begin, asked.begin() + end, 1);
    (*still)[fragment.edgel_ids[k]] = 2 * num_still > end - begin;
  }
}

}  // namespace

std::vector<ViewId> StillEdgels::ViewsToCompare(const std::vector<View>& views) {
  std::vector<ViewId> all;
  for (const auto& [size, ids] : ComparedBySize(views)) {
    all.insert(all.end(), ids.begin(), ids.end());
  }
  std::ranges::sort(all);
  return all;
}

StillEdgels::StillEdgels(const std::vector<View>& views, const std::vector<ImageCurves>& as_stored,
                         const RunContext& context)
    : views_(views),
      spread_(SpreadOfCenters(views)),
      compared_(ComparedBySize(views)),
      index_(views.size()) {
  const std::vector<ViewId> ids = ViewsToCompare(views);
  ParallelFor(context, "still edges", ids.size(), [&](size_t i) {
    const ImageCurves& curves = as_stored[ids[i]];
    index_[ids[i]] = EdgelIndex(curves.edge_map, LinkedEdgels(curves));
  });
}

std::vector<bool> StillEdgels::In(ViewId view, const ImageCurves& as_stored) const {
  const auto& edgels = as_stored.edge_map.edgels;
  std::vector<bool> still(edgels.size(), false);
  const auto compared = compared_.find(SizeOf(views_[view]));
  if (compared == compared_.end()) return still;
  std::vector<const EdgelIndex*> others;
  for (const ViewId other : compared->second) {
    if (other == view || HaveSamePose(views_[view], views_[other], spread_)) continue;
    others.push_back(&index_[other]);
  }
  if (others.size() + 1 < kMinCompared) return still;
  for (const CurveFragment& fragment : as_stored.fragments) {
    MarkStill(fragment, edgels, others, &still);
  }
  return still;
}

}  // namespace limn
