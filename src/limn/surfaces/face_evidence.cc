// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/face_evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "limn/belief/link_claims.h"
#include "limn/geometry/box_index2d.h"
#include "limn/geometry/polyline.h"
#include "limn/geometry/polyline_position.h"
#include "limn/model/link_selection.h"
#include "limn/model/view_finder.h"
#include "limn/support/view_edgels.h"
#include "limn/surfaces/link_sightings.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// Only links with this evidence show what is seen through others.
constexpr double kSureEvidence = 10;

// A border is shown at a sample if it is at one of the samples so near.
constexpr int kShownReach = 2;

// What lies behind a candidate is this far behind it along the line of sight, and from its plane,
// px, and that far from its border.
constexpr double kMinBehindPx = 8;
constexpr double kMinOffPlanePx = 4;
constexpr double kMinInsidePx = 3;
// Views that see a plane at a smaller angle (sine) tell nothing.
constexpr double kMinSine = 0.1;
// How often a sample is shown that is behind a surface, by accident, and that is not: most of what
// lies behind is hidden by something else.
constexpr double kShownBehind = 0.02;
constexpr double kShownInFront = 0.15;
// Neighboring samples are shown or hidden together: this many count as one. One view's evidence
// from one link is at most that of this many.
constexpr double kSamplesPerUnit = 7;
constexpr double kMaxUnits = 3;
constexpr int kMinSamples = 4;
// Points of the model may be wrong, and so may what matched them.
constexpr double kUnitsPerPoint = 0.5;

// A place of a link on a border, as a sample of its evidence.
struct BorderSample {
  LinkId link = -1;
  int sample = -1;
};

// The border around a place of a candidate.
using Border = std::vector<BorderSample>;

// The sample of a link's evidence at a position on it; the link has these arc lengths.
int SampleAt(const std::vector<double>& lengths, const ImageEvidence& evidence, double position) {
  const double share = LengthAtPosition(lengths, position) / lengths.back();
  const auto size = static_cast<double>(evidence.samples.size());
  return static_cast<int>(std::clamp(share * size, 0.0, size - 1));
}

// Per place of a candidate. `lengths` are the arc lengths of the points of every link.
std::vector<Border> BordersOf(const FaceCandidate& candidate,
                              const std::vector<std::vector<double>>& lengths,
                              const std::vector<ImageEvidence>& links) {
  std::vector<Border> borders;
  for (const CandidatePlace& place : candidate.places) {
    Border border;
    for (const auto& [link, position] : place.border) {
      if (links[link].samples.empty()) continue;
      border.push_back({link, SampleAt(lengths[link], links[link], position)});
    }
    borders.push_back(std::move(border));
  }
  return borders;
}

bool IsShown(const LinkSighting& sighting, int sample) {
  const int last = static_cast<int>(sighting.samples.size()) - 1;
  for (int k = std::max(0, sample - kShownReach); k <= std::min(last, sample + kShownReach); ++k) {
    if (sighting.samples[k] >= Sighting::kOther) return true;
  }
  return false;
}

// What one view says of a candidate.
struct ViewEvidence {
  double seen_through = 0;
  double hidden = 0;
  std::vector<PlaceSight> sights;  // per place; empty if none is seen
};

// Adds the log of the ratio of likelihoods, with and without a surface, that this many of the
// samples behind it are shown.
void AddOcclusion(double num_samples, double num_shown, ViewEvidence* evidence) {
  const double units = std::min(num_samples / kSamplesPerUnit, kMaxUnits);
  const double share = num_shown / num_samples;
  const double sum = share * std::log(kShownBehind / kShownInFront) +
                     (1 - share) * std::log((1 - kShownBehind) / (1 - kShownInFront));
  (sum < 0 ? evidence->seen_through : evidence->hidden) += units * sum;
}

// What one view says of the candidates.
class ViewJudge {
 public:
  ViewJudge(const CurvesScene& scene, const SurfaceOptions& options, ViewId view,
            const std::vector<ImageEvidence>& links, const std::vector<uint8_t>& is_sure)
      : view_(scene.views[view]),
        options_(options),
        eye_(view_.CenterInWorld()),
        links_(links),
        is_sure_(is_sure),
        sightings_(SightingsIn(view_, view, links)) {
    for (const ScenePoint& point : scene.hints.points) {
      if (std::ranges::binary_search(point.views, view)) {
        points_.push_back(point.position_in_world);
      }
    }
    link_index_ = BoxIndex2d(SureExtents());
    point_index_ = BoxIndex2d(PointExtents());
  }

  ViewEvidence Judge(const FaceCandidate& candidate, const std::vector<Border>& borders) const {
    ViewEvidence evidence;
    for (size_t p = 0; p < borders.size(); ++p) {
      evidence.sights.push_back(SightOf(candidate.places[p], borders[p]));
    }
    if (std::ranges::count(evidence.sights, PlaceSight::kSeen) == 0) evidence.sights = {};
    AddOcclusions(candidate, &evidence);
    return evidence;
  }

 private:
  PlaceSight SightOf(const CandidatePlace& place, const Border& border) const {
    const Eigen::Vector3d sight = (place.position - eye_).normalized();
    if (std::abs(sight.dot(place.normal)) < kMinSine || !view_.Project(place.position)) {
      return PlaceSight::kUnknown;
    }
    int num = 0;
    int num_shown = 0;
    for (const auto& [link, sample] : border) {
      const LinkSighting& sighting = sightings_[link];
      if (sighting.samples.empty() || sighting.samples[sample] == Sighting::kOutside) continue;
      ++num;
      num_shown += IsShown(sighting, sample);
    }
    if (num < place.min_border) return PlaceSight::kUnknown;
    return num_shown >= options_.min_shown_share * num ? PlaceSight::kSeen : PlaceSight::kHidden;
  }

  void AddOcclusions(const FaceCandidate& candidate, ViewEvidence* evidence) const {
    const auto extent = ExtentOf(candidate);
    for (const int l : link_index_.Meeting(extent.value_or(Everywhere()))) {
      AddOcclusionOf(candidate, extent, l, evidence);
    }
    double num_points = 0;
    for (const int p : point_index_.Meeting(extent.value_or(Everywhere()))) {
      num_points += IsBehind(candidate, points_[p]);
    }
    const double units = std::min(kUnitsPerPoint * num_points, kMaxUnits);
    evidence->seen_through += units * std::log(kShownBehind / kShownInFront);
  }

  void AddOcclusionOf(const FaceCandidate& candidate,
                      const std::optional<Eigen::AlignedBox2d>& extent, int l,
                      ViewEvidence* evidence) const {
    const LinkSighting& sighting = sightings_[l];
    int num = 0;
    int num_shown = 0;
    for (size_t k = 0; k < sighting.samples.size(); ++k) {
      if (sighting.samples[k] == Sighting::kOutside) continue;
      if (extent && !extent->contains(sighting.pixels[k])) continue;
      if (!IsBehind(candidate, links_[l].samples[k].position)) continue;
      ++num;
      num_shown += sighting.samples[k] == Sighting::kShown;
    }
    if (num >= kMinSamples) AddOcclusion(num, num_shown, evidence);
  }

  // In the image, of links that are sure; empty for the others.
  std::vector<Eigen::AlignedBox2d> SureExtents() const {
    std::vector<Eigen::AlignedBox2d> extents(links_.size());
    for (size_t l = 0; l < links_.size(); ++l) {
      if (is_sure_[l]) extents[l] = sightings_[l].extent;
    }
    return extents;
  }
  // Empty for points behind the camera.
  std::vector<Eigen::AlignedBox2d> PointExtents() const {
    std::vector<Eigen::AlignedBox2d> extents(points_.size());
    for (size_t p = 0; p < points_.size(); ++p) {
      const Eigen::Vector3d in_cam = view_.cam_from_world * points_[p];
      if (in_cam.z() > 0) extents[p].extend(view_.camera.Project(in_cam));
    }
    return extents;
  }
  static Eigen::AlignedBox2d Everywhere() {
    constexpr double kFar = std::numeric_limits<double>::max();
    return {Eigen::Vector2d(-kFar, -kFar), Eigen::Vector2d(kFar, kFar)};
  }

  // Of the surface in the image; nothing if a part of it is behind the camera.
  std::optional<Eigen::AlignedBox2d> ExtentOf(const FaceCandidate& candidate) const {
    Eigen::AlignedBox2d extent;
    for (const Eigen::Vector3d& vertex : candidate.vertices) {
      const Eigen::Vector3d in_cam = view_.cam_from_world * vertex;
      if (!(in_cam.z() > 0)) return std::nullopt;
      extent.extend(view_.camera.Project(in_cam));
    }
    return extent;
  }

  // Whether the line of sight to a point crosses the inside of the candidate before.
  bool IsBehind(const FaceCandidate& candidate, const Eigen::Vector3d& point) const {
    return candidate.flat ? IsBehind(*candidate.flat, candidate.footprint, point)
                          : IsBehindTriangles(candidate, point);
  }

  bool IsBehind(const FlatRegion& flat, double footprint, const Eigen::Vector3d& point) const {
    const Eigen::Vector3d normal = flat.frame.Normal();
    const double eye_side = normal.dot(eye_ - flat.frame.origin);
    const double point_side = normal.dot(point - flat.frame.origin);
    if (eye_side * point_side >= 0) return false;
    if (std::abs(eye_side) < kMinSine * (eye_ - flat.frame.origin).norm()) return false;
    if (std::abs(point_side) < kMinOffPlanePx * footprint) return false;
    const double t = eye_side / (eye_side - point_side);
    if ((1 - t) * (point - eye_).norm() < kMinBehindPx * footprint) return false;
    const Eigen::Vector2d place = flat.frame.Flat(eye_ + t * (point - eye_));
    return flat.polygon.Contains(place) &&
           flat.polygon.DistanceToOutline(place) >= kMinInsidePx * footprint;
  }

  bool IsBehindTriangles(const FaceCandidate& candidate, const Eigen::Vector3d& point) const {
    const Eigen::Vector3d sight = point - eye_;
    const double margin = kMinBehindPx * candidate.footprint / sight.norm();
    return std::ranges::any_of(candidate.triangles, [&](const auto& triangle) {
      const auto& [i, j, k] = triangle;
      const auto t =
          Crossing(sight, candidate.vertices[i], candidate.vertices[j], candidate.vertices[k]);
      return t && *t > 0 && *t < 1 - margin;
    });
  }

  // Where the line eye + t * sight crosses a triangle.
  std::optional<double> Crossing(const Eigen::Vector3d& sight, const Eigen::Vector3d& a,
                                 const Eigen::Vector3d& b, const Eigen::Vector3d& c) const {
    Eigen::Matrix3d system;
    system << b - a, c - a, -sight;
    const double determinant = system.determinant();
    if (determinant == 0) return std::nullopt;
    const Eigen::Vector3d solution = system.inverse() * (eye_ - a);
    if (solution.x() < 0 || solution.y() < 0 || solution.x() + solution.y() > 1) {
      return std::nullopt;
    }
    return solution.z();
  }

  const View& view_;
  const SurfaceOptions& options_;
  Eigen::Vector3d eye_;
  const std::vector<ImageEvidence>& links_;
  const std::vector<uint8_t>& is_sure_;
  std::vector<LinkSighting> sightings_;
  std::vector<Eigen::Vector3d> points_;  // that the view sees
  BoxIndex2d link_index_{{}};
  BoxIndex2d point_index_{{}};
};

std::vector<ImageEvidence> EvidenceOfLinks(const CurvesScene& scene, const SupportGate& gate,
                                           const DrawingGraph& graph, const RunContext& context) {
  const auto edgels = BuildViewEdgels(scene.curves, context);
  const TopologyInput input = {scene.views, scene.curves, edgels, gate};
  const ViewFinder finder(scene.views);
  std::vector<ImageEvidence> links(graph.links.size());
  ParallelFor(context, "evidence for links", links.size(),
              [&](size_t l) { links[l] = FindEvidence(input, finder, graph.links[l]); });
  FindClaims(input, context, &links);
  return links;
}

FaceEvidence Combined(const std::vector<std::vector<ViewEvidence>>& per_view, size_t candidate) {
  FaceEvidence combined;
  for (size_t v = 0; v < per_view.size(); ++v) {
    const ViewEvidence& evidence = per_view[v][candidate];
    combined.seen_through += evidence.seen_through;
    combined.hidden += evidence.hidden;
    if (!evidence.sights.empty()) combined.sights[static_cast<ViewId>(v)] = evidence.sights;
  }
  return combined;
}

}  // namespace

std::vector<FaceEvidence> FindFaceEvidence(const CurvesScene& scene, const SupportGate& gate,
                                           const DrawingGraph& graph,
                                           const std::vector<FaceCandidate>& candidates,
                                           const SurfaceOptions& options,
                                           const RunContext& context) {
  const std::vector<ImageEvidence> links = EvidenceOfLinks(scene, gate, graph, context);
  const LinkSelection selection = LinkSelection::AsSeen();
  std::vector<uint8_t> is_sure(links.size());
  for (size_t l = 0; l < links.size(); ++l) {
    is_sure[l] = selection.Has(graph.links[l]) && links[l].evidence >= kSureEvidence;
  }
  std::vector<std::vector<double>> lengths;
  for (const DrawingLink& link : graph.links) {
    lengths.push_back(CumulativeLength(link.points_in_world));
  }
  std::vector<std::vector<Border>> borders(candidates.size());
  ParallelFor(context, "borders of faces", candidates.size(),
              [&](size_t c) { borders[c] = BordersOf(candidates[c], lengths, links); });
  std::vector<std::vector<ViewEvidence>> per_view(scene.views.size());
  ParallelFor(context, "faces in views", scene.views.size(), [&](size_t v) {
    const ViewJudge judge(scene, options, static_cast<ViewId>(v), links, is_sure);
    for (size_t c = 0; c < candidates.size(); ++c) {
      per_view[v].push_back(judge.Judge(candidates[c], borders[c]));
    }
  });
  std::vector<FaceEvidence> evidence;
  for (size_t c = 0; c < candidates.size(); ++c) evidence.push_back(Combined(per_view, c));
  return evidence;
}

}  // namespace limn
