// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/given_curves.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limn/geometry/polyline.h"

namespace limn {
namespace {

using Eigen::Vector2d;

constexpr double kEdgelSpacingPx = 1;
// Neighboring edgels that are further apart belong to two curves.
constexpr double kMaxStepPx = 10;
// Nearer ones are in the same place, and the chord between them has no direction.
constexpr double kMinStepPx = 1e-9;

// Along the fragment at its vertex i: from the neighbor before to that behind.
Vector2d ChordAt(const CurveFragment& fragment, const std::vector<Edgel>& edgels, size_t i) {
  const std::vector<EdgelId>& ids = fragment.edgel_ids;
  const size_t last = ids.size() - 1;
  const size_t before = i > 0 ? i - 1 : fragment.closed ? last : 0;
  const size_t behind = i < last ? i + 1 : fragment.closed ? 0 : last;
  return edgels[ids[behind]].position_px - edgels[ids[before]].position_px;
}

Polyline3d Resampled(const std::vector<Vector2d>& points) {
  Polyline3d in_space;
  for (const Vector2d& point : points) in_space.emplace_back(point.x(), point.y(), 0);
  return ResampleUniform(in_space, kEdgelSpacingPx);
}

void AddPolyline(const std::vector<Vector2d>& points, ImageCurves* curves) {
  std::vector<Edgel>& edgels = curves->edge_map.edgels;
  const Polyline3d samples = Resampled(points);
  CurveFragment fragment;
  fragment.closed = points.front() == points.back() && samples.size() > 3;
  for (size_t i = 0; i < samples.size() - (fragment.closed ? 1 : 0); ++i) {
    Edgel edgel;
    edgel.position_px = samples[i].head<2>();
    edgel.stored_px = edgel.position_px.cast<float>();
    edgel.strength = 1;
    fragment.edgel_ids.push_back(static_cast<EdgelId>(edgels.size()));
    edgels.push_back(edgel);
  }
  for (size_t i = 0; i < fragment.edgel_ids.size(); ++i) {
    const Vector2d chord = ChordAt(fragment, edgels, i);
    edgels[fragment.edgel_ids[i]].tangent_rad = std::atan2(chord.y(), chord.x());
  }
  curves->fragments.push_back(std::move(fragment));
}

// Without edgels that are where the one before them is.
void RemoveCoincident(const std::vector<Edgel>& edgels, CurveFragment* fragment) {
  std::vector<EdgelId>& ids = fragment->edgel_ids;
  const auto coincide = [&](EdgelId a, EdgelId b) {
    return (edgels[a].position_px - edgels[b].position_px).norm() < kMinStepPx;
  };
  ids.erase(std::unique(ids.begin(), ids.end(), coincide), ids.end());
  while (fragment->closed && ids.size() > 1 && coincide(ids.front(), ids.back())) ids.pop_back();
  if (ids.size() < 3) fragment->closed = false;
}

// The parts of a fragment without steps of more than kMaxStepPx, those of one edgel included.
std::vector<CurveFragment> CutAtGaps(const CurveFragment& fragment,
                                     const std::vector<Edgel>& edgels) {
  std::vector<EdgelId> ids = fragment.edgel_ids;
  const auto is_gap = [&](EdgelId a, EdgelId b) {
    return (edgels[b].position_px - edgels[a].position_px).norm() > kMaxStepPx;
  };
  if (fragment.closed) {
    const auto gap = std::adjacent_find(ids.begin(), ids.end(), is_gap);
    if (gap == ids.end() && !is_gap(ids.back(), ids.front())) return {fragment};
    if (gap != ids.end()) std::rotate(ids.begin(), gap + 1, ids.end());
  }
  std::vector<CurveFragment> parts;
  for (size_t i = 0; i < ids.size(); ++i) {
    if (i == 0 || is_gap(ids[i - 1], ids[i])) parts.emplace_back();
    parts.back().edgel_ids.push_back(ids[i]);
  }
  return parts;
}

// Every step between neighbors has a direction, none is a jump, and a fragment has two edgels.
void MakeConnected(ImageCurves* curves) {
  const std::vector<Edgel>& edgels = curves->edge_map.edgels;
  std::vector<CurveFragment> connected;
  for (CurveFragment& fragment : curves->fragments) {
    RemoveCoincident(edgels, &fragment);
    for (CurveFragment& part : CutAtGaps(fragment, edgels)) {
      if (part.edgel_ids.size() >= 2) connected.push_back(std::move(part));
    }
  }
  curves->fragments = std::move(connected);
}

// Every edgel in one fragment, and there once.
void MakeDisjoint(ImageCurves* curves) {
  std::vector<Edgel>& edgels = curves->edge_map.edgels;
  std::vector<bool> used(edgels.size(), false);
  for (CurveFragment& fragment : curves->fragments) {
    for (EdgelId& id : fragment.edgel_ids) {
      if (used[id]) {
        edgels.push_back(edgels[id]);
        used.push_back(false);
        id = static_cast<EdgelId>(edgels.size()) - 1;
      }
      used[id] = true;
    }
  }
}

void DirectAlong(CurveFragment* fragment, std::vector<Edgel>* edgels) {
  const size_t size = fragment->edgel_ids.size();
  double along = 0;
  for (size_t i = 0; i < size; ++i) {
    along += (*edgels)[fragment->edgel_ids[i]].Tangent().dot(ChordAt(*fragment, *edgels, i));
  }
  if (along < 0) std::reverse(fragment->edgel_ids.begin(), fragment->edgel_ids.end());
  for (size_t i = 0; i < size; ++i) {
    Edgel& edgel = (*edgels)[fragment->edgel_ids[i]];
    if (edgel.Tangent().dot(ChordAt(*fragment, *edgels, i)) < 0) edgel.Turn();
  }
}

}  // namespace

ImageCurves CurvesOfPolylines(const std::vector<std::vector<Vector2d>>& polylines, int width,
                              int height) {
  ImageCurves curves;
  curves.edge_map.width = width;
  curves.edge_map.height = height;
  for (const std::vector<Vector2d>& points : polylines) AddPolyline(points, &curves);
  return curves;
}

void TurnAround(CurveFragment* fragment, std::vector<Edgel>* edgels) {
  std::reverse(fragment->edgel_ids.begin(), fragment->edgel_ids.end());
  for (const EdgelId id : fragment->edgel_ids) (*edgels)[id].Turn();
}

void MakeConsistent(ImageCurves* curves) {
  MakeConnected(curves);
  MakeDisjoint(curves);
  for (CurveFragment& fragment : curves->fragments) {
    DirectAlong(&fragment, &curves->edge_map.edgels);
  }
}

}  // namespace limn
