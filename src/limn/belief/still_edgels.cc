// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/still_edgels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "limn/util/angles.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// Fewer views tell nothing.
constexpr double kMinStillViews = 6;
// An edgel stands still if this share of the views has one at its place,
constexpr double kMinStillShare = 0.4;
// and so many times as many as at places beside it: where edges are dense many have one by chance.
constexpr double kOverChance = 1.5;
const std::array<Eigen::Vector2f, 4> kBesidePx = {Eigen::Vector2f(8, 3), Eigen::Vector2f(-3, 8),
                                                  Eigen::Vector2f(-8, -3), Eigen::Vector2f(3, -8)};
// Views that see the middle of the drawing from less different directions are one.
constexpr double kOtherPlaceRad = 3 * kDeg;
// Places are told apart to cells of this size, stored px, and directions to bins.
constexpr float kStillCellPx = 2;
constexpr int kNumDirections = 6;
// How far the edgels of a still edge scatter.
constexpr float kStillGatePx = 0.75F;
constexpr double kStillGateRad = 8 * kDeg;

Eigen::Vector3d MiddleOf(const DrawingGraph& graph) {
  Eigen::Vector3d middle;
  for (int k = 0; k < 3; ++k) {
    std::vector<double> coordinates;
    for (const DrawingNode& node : graph.nodes) coordinates.push_back(node.position_in_world[k]);
    middle[k] = Median(std::move(coordinates));
  }
  return middle;
}

// Those of `ids` that are at different places, seen from the middle.
std::vector<ViewId> AtDifferentPlaces(const std::vector<View>& views,
                                      const std::vector<ViewId>& ids,
                                      const Eigen::Vector3d& middle) {
  std::vector<ViewId> chosen;
  std::vector<Eigen::Vector3d> directions;
  for (const ViewId id : ids) {
    const Eigen::Vector3d direction = (views[id].CenterInWorld() - middle).normalized();
    const auto is_near = [&](const Eigen::Vector3d& other) {
      return direction.dot(other) > std::cos(kOtherPlaceRad);
    };
    if (std::ranges::any_of(directions, is_near)) continue;
    directions.push_back(direction);
    chosen.push_back(id);
  }
  return chosen;
}

// Of images that can be compared, by size: the same part of each photograph, if these have parts at
// the same place (of a panorama).
using ViewGroups = std::map<std::array<int, 3>, std::vector<ViewId>>;

ViewGroups GroupsOf(const std::vector<View>& views, const std::vector<ImageCurves>& curves) {
  std::map<std::array<double, 5>, int> num_at_place;
  ViewGroups groups;
  for (size_t v = 0; v < curves.size(); ++v) {
    const int width = curves[v].edge_map.width;
    const int height = curves[v].edge_map.height;
    const Eigen::Vector3d center = views[v].CenterInWorld();
    const int part =
        num_at_place[{1.0 * width, 1.0 * height, center.x(), center.y(), center.z()}]++;
    groups[{width, height, part}].push_back(static_cast<ViewId>(v));
  }
  return groups;
}

struct PlaceAndAngle {
  Eigen::Vector2f stored_px;
  double angle_rad = 0;
};

PlaceAndAngle Stored(const Edgel& edgel) {
  if (edgel.stored_from_virtual.isIdentity(0)) return {edgel.stored_px, edgel.tangent_rad};
  const Eigen::Vector2f tangent = edgel.stored_from_virtual * edgel.Tangent().cast<float>();
  return {edgel.stored_px, std::atan2(tangent.y(), tangent.x())};
}

// In how many views edgels stand at places and in directions of images of one size.
class StillCounts {
 public:
  StillCounts(int width, int height)
      : cols_(static_cast<int>(width / kStillCellPx) + 1),
        rows_(static_cast<int>(height / kStillCellPx) + 1),
        counts_(static_cast<size_t>(cols_) * rows_ * kNumDirections),
        last_view_(counts_.size()) {}

  void Add(const EdgeMap& edge_map) {
    ++num_views_;
    for (const Edgel& edgel : edge_map.edgels) {
      const PlaceAndAngle at = Stored(edgel);
      for (const float dx : {-kStillGatePx, kStillGatePx}) {
        for (const float dy : {-kStillGatePx, kStillGatePx}) {
          for (const double turn : {-kStillGateRad, kStillGateRad}) {
            Count(CellAt(at.stored_px + Eigen::Vector2f(dx, dy), at.angle_rad + turn));
          }
        }
      }
    }
  }

  bool StandsStill(const Edgel& edgel) const {
    const PlaceAndAngle at = Stored(edgel);
    const int count = counts_[CellAt(at.stored_px, at.angle_rad)];
    if (count < std::max(kMinStillViews, kMinStillShare * num_views_)) return false;
    double by_chance = 0;
    for (const Eigen::Vector2f& beside : kBesidePx) {
      by_chance += counts_[CellAt(at.stored_px + beside, at.angle_rad)];
    }
    return count >= kOverChance * by_chance / static_cast<double>(kBesidePx.size());
  }

 private:
  // Once per view.
  void Count(size_t cell) {
    if (last_view_[cell] == num_views_) return;
    last_view_[cell] = num_views_;
    ++counts_[cell];
  }

  // Of a place, the nearest one in the image, and an undirected angle.
  size_t CellAt(const Eigen::Vector2f& stored_px, double angle_rad) const {
    const int col = std::clamp(static_cast<int>(stored_px.x() / kStillCellPx), 0, cols_ - 1);
    const int row = std::clamp(static_cast<int>(stored_px.y() / kStillCellPx), 0, rows_ - 1);
    const double turns = angle_rad / M_PI;
    const int direction = static_cast<int>((turns - std::floor(turns)) * kNumDirections);
    return (static_cast<size_t>(row) * cols_ + col) * kNumDirections + direction % kNumDirections;
  }

  int cols_;
  int rows_;
  uint16_t num_views_ = 0;  // at different places: some thousands at most
  std::vector<uint16_t> counts_;
  std::vector<uint16_t> last_view_;  // that was counted, from 1
};

}  // namespace

StillEdgels FindStillEdgels(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                            const DrawingGraph& graph) {
  StillEdgels still(curves.size());
  for (size_t v = 0; v < curves.size(); ++v) still[v].resize(curves[v].edge_map.edgels.size());
  if (graph.nodes.empty()) return still;
  const Eigen::Vector3d middle = MiddleOf(graph);
  for (const auto& [size_and_part, ids] : GroupsOf(views, curves)) {
    const std::vector<ViewId> places = AtDifferentPlaces(views, ids, middle);
    if (static_cast<double>(places.size()) < kMinStillViews) continue;
    StillCounts counts(size_and_part[0], size_and_part[1]);
    for (const ViewId id : places) counts.Add(curves[id].edge_map);
    for (const ViewId id : ids) {
      std::ranges::transform(curves[id].edge_map.edgels, still[id].begin(),
                             [&](const Edgel& edgel) { return counts.StandsStill(edgel); });
    }
  }
  return still;
}

double StillShare(const StillEdgels& still) {
  size_t num_still = 0, num_edgels = 0;
  for (const std::vector<uint8_t>& of_view : still) {
    num_still += std::ranges::count(of_view, 1);
    num_edgels += of_view.size();
  }
  return num_edgels > 0 ? static_cast<double>(num_still) / static_cast<double>(num_edgels) : 0;
}

}  // namespace limn
