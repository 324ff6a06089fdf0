// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/spanned_pairs.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "limn/util/map_items.h"
#include "limn/util/sort_unique.h"

namespace limn {
namespace {

// A joint is on a fragment if an edgel of it is this near, px: corners are rounded.
constexpr double kOnFragmentPx = 4;
// Shortest stretch, px, and how far it may be from the line between the joints: px, and share of
// its length. It is tested at this many places.
constexpr double kMinStretchPx = 12;
constexpr double kMaxBendPx = 1;
constexpr double kMaxBendShare = 0.005;
constexpr int kNumBendTests = 15;

struct JointOnFragment {
  int index = -1;  // of the nearest edgel
  int joint = -1;
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

// Per fragment of a view, the joints on it, in its order.
std::vector<std::vector<JointOnFragment>> JointsOnFragments(const TopologyInput& input, ViewId view,
                                                            const std::vector<Joint>& joints) {
  const ImageCurves& curves = input.curves[view];
  const ViewEdgels& edgels = *input.edgels[view];
  std::vector<std::vector<JointOnFragment>> on(curves.fragments.size());
  for (size_t j = 0; j < joints.size(); ++j) {
    const auto pixel =
        joints[j].visible[view] ? input.views[view].Project(joints[j].position) : std::nullopt;
    if (!pixel) continue;
    std::map<int, std::pair<double, int>> nearest;  // per fragment: squared distance, index
    edgels.edgels.ForEachWithin(*pixel, kOnFragmentPx, [&](EdgelId id) {
      const auto& [fragment, index] = edgels.place_of[id];
      const double distance = (curves.edge_map.edgels[id].position_px - *pixel).squaredNorm();
      const auto [it, is_new] = nearest.try_emplace(fragment, distance, index);
      if (!is_new) it->second = std::min(it->second, {distance, index});
    });
    for (const auto& [fragment, place] : nearest) {
      on[fragment].push_back({place.second, static_cast<int>(j), *pixel});
    }
  }
  for (auto& of_fragment : on) {
    std::ranges::stable_sort(of_fragment, {}, &JointOnFragment::index);
  }
  return on;
}

// Returns whether the fragment runs straight from one joint to the other.
bool RunsStraight(const ImageCurves& curves, const CurveFragment& fragment,
                  const JointOnFragment& from, const JointOnFragment& to) {
  const Eigen::Vector2d chord = to.pixel - from.pixel;
  const double length = chord.norm();
  if (length < kMinStretchPx) return false;
  for (int s = 1; s <= kNumBendTests; ++s) {
    const int index = from.index + (to.index - from.index) * s / (kNumBendTests + 1);
    const EdgelId id = fragment.edgel_ids[index];
    const Eigen::Vector2d offset = curves.edge_map.edgels[id].position_px - from.pixel;
    const double bend = std::abs(chord.x() * offset.y() - chord.y() * offset.x()) / length;
    if (bend > kMaxBendPx + kMaxBendShare * length) return false;
  }
  return true;
}

// Of one view, ascending.
std::vector<JointPair> SpannedIn(const TopologyInput& input, ViewId view,
                                 const std::vector<Joint>& joints) {
  const ImageCurves& curves = input.curves[view];
  const auto on = JointsOnFragments(input, view, joints);
  std::vector<JointPair> pairs;
  for (size_t f = 0; f < on.size(); ++f) {
    for (size_t a = 0; a < on[f].size(); ++a) {
      for (size_t b = a + 1; b < on[f].size(); ++b) {
        if (!RunsStraight(curves, curves.fragments[f], on[f][a], on[f][b])) continue;
        const auto [from, to] = std::minmax(on[f][a].joint, on[f][b].joint);
        pairs.push_back({from, to});
      }
    }
  }
  SortUnique(&pairs);
  return pairs;
}

}  // namespace

std::vector<JointPair> FindSpannedPairs(const TopologyInput& input,
                                        const std::vector<Joint>& joints, int min_views,
                                        const RunContext& context) {
  const auto of_view =
      MapItems(context, "curves between joints", input.views.size(),
               [&](size_t v) { return SpannedIn(input, static_cast<ViewId>(v), joints); });
  std::map<JointPair, int> num_views;
  for (const auto& pairs : of_view) {
    for (const JointPair& pair : pairs) ++num_views[pair];
  }
  std::vector<JointPair> spanned;
  for (const auto& [pair, count] : num_views) {
    if (count >= min_views) spanned.push_back(pair);
  }
  return spanned;
}

}  // namespace limn
