// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/outline_fit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <Eigen/Dense>

#include "limn/geometry/polyline.h"
#include "limn/geometry/tangent_frame.h"
#include "limn/model/footprint.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

constexpr double kOutlineAngleRad = 15 * kDeg;
constexpr SupportGate kOnLinkGate = {1.0, 1.0, kOutlineAngleRad};
constexpr SupportGate kShownGate = {1.5, 1.0, kOutlineAngleRad};
constexpr SupportGate kFitGates[] = {{3.0, 1.0, kOutlineAngleRad},
                                     {3.0, 1.0, kOutlineAngleRad},
                                     {2.0, 1.0, kOutlineAngleRad},
                                     kShownGate,
                                     kShownGate};
constexpr double kStartRadiiPx[] = {3, -3, 6, -6, 12, -12, 24, -24, 48, -48, 96, -96};
constexpr double kProbeStepPx = 6;
constexpr int kMaxOutlineProbes = 16;
constexpr double kProbeArmPx = 4;
// Views are compared within this angle around the link of those that support it, and not if they
// look along it.
constexpr double kMaxAroundRad = 50 * kDeg;
constexpr double kMinAcross = 0.3;
constexpr int kMinSupporting = 2;
// Of more, every second, third ... one is used.
constexpr size_t kMaxOutlineViews = 40;
// Standard deviations of the axis and the radius about where a step begins, px: they decide only
// what edgels leave open.
constexpr double kAxisPriorPx = 10;
constexpr double kRadiusPriorPx = 20;
// Misfits of places are at most this; a view shows a curve whose mean squared misfit is below that.
constexpr double kMaxMisfitPx = 1;
constexpr double kShownMisfit = 0.4;
constexpr double kMinMovedPx = 1;
// A view that sees less of the link does not tell.
constexpr double kMinProbesShare = 0.3;
constexpr size_t kMinRmsViews = 4;

struct OutlineProbe {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d tangent = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 3, 2> across;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // OutlinePoint's, mean of supporting views
  std::vector<ViewId> views;
};

// Where a view sees the outline, and the unit normal of the body there.
struct OutlinePoint {
  Eigen::Vector3d position;
  Eigen::Vector3d normal;
};

// The line of sight that touches the circle has the distance r from its center: n . (axis - view) =
// -r for its unit normal n. Nothing near the body or inside.
std::optional<OutlinePoint> OutlineFrom(const Eigen::Vector3d& view_center,
                                        const Eigen::Vector3d& tangent, const Eigen::Vector3d& axis,
                                        double radius) {
  Eigen::Vector3d sight = axis - view_center;
  sight -= sight.dot(tangent) * tangent;
  const double distance = sight.norm();
  if (!(distance > 2 * std::abs(radius))) return std::nullopt;
  const Eigen::Vector3d ahead = sight / distance;
  const double sine = -radius / distance;
  const Eigen::Vector3d normal = sine * ahead + std::sqrt(1 - sine * sine) * tangent.cross(ahead);
  return OutlinePoint{axis + radius * normal, normal};
}

// Squared distances, px^2, of what a view shows from a curve, over the probes.
struct Misfit {
  double sum = 0;
  int num_probes = 0;
  double sum_matched = 0;
  int num_matched = 0;

  double Mean() const { return num_probes > 0 ? sum / num_probes : kMaxMisfitPx; }
  bool IsShown() const { return Mean() < kShownMisfit; }
};

using MisfitOfView = std::map<ViewId, Misfit>;

class OutlineFitter {
 public:
  OutlineFitter(const TopologyInput& images, const ViewFinder& finder, const DrawingLink& link)
      : images_(images), footprint_(LinkFootprint(link, images.views)) {
    if (footprint_ > 0) MakeProbes(link, finder.NearAnyOf(link.points_in_world));
  }

  OutlineEvidence Compare() const {
    OutlineEvidence best;
    best.footprint = footprint_;
    if (probes_.empty()) return best;
    const BodyBeside edge = Fit(0);
    const MisfitOfView of_edge = Misfits(edge);
    best.edge_rms_px = RmsOf(of_edge, kMinRmsViews);
    if (NumUnexplained(of_edge) < 2) return best;
    double best_of_side[] = {0, 0};
    for (const double start_px : kStartRadiiPx) {
      OutlineEvidence evidence = best;
      Judge({edge, of_edge}, Fit(start_px), &evidence);
      double& of_side = best_of_side[evidence.body.radius > 0];
      of_side = std::max(of_side, evidence.log_ratio);
      if (evidence.log_ratio > best.log_ratio) best = std::move(evidence);
    }
    best.log_ratio -= best_of_side[!(best.body.radius > 0)];
    return best;
  }

  std::vector<OutlineSight> Sights(const BodyBeside& body) const {
    std::vector<OutlineSight> sights;
    for (size_t k = 0; k < probes_.size(); ++k) {
      for (const ViewId v : probes_[k].views) {
        const auto match = MatchIn(v, k, body, kShownGate);
        if (!match) continue;
        const View& view = images_.views[v];
        const Eigen::Vector3d ray =
            view.camera.RayFromPixel(images_.EdgelOf({v, match->edgel}).position_px);
        OutlineSight& sight = sights.emplace_back();
        sight.view = v;
        sight.center = view.CenterInWorld();
        sight.ray = view.cam_from_world.rotation.conjugate() * ray.normalized();
        sight.px_per_unit = match->residual.gradient.norm();
        sight.axis_point = body.axis[k];
        sight.radius = std::abs(body.radius);
      }
    }
    return sights;
  }

 private:
  struct Match {
    EdgelId edgel;
    EdgelResidual residual;
    Eigen::Vector3d normal;
  };
  struct FittedEdge {
    const BodyBeside& fit;
    const MisfitOfView& misfits;
  };

  void MakeProbes(const DrawingLink& link, const std::vector<ViewId>& near) {
    const std::vector<double> arc = CumulativeLength(link.points_in_world);
    const double length = arc.back();
    const auto count = static_cast<int>(std::clamp(std::floor(length / (kProbeStepPx * footprint_)),
                                                   1.0, double{kMaxOutlineProbes}));
    const auto at = [&](double where) {
      where = std::clamp(where, 0.0, length);
      const auto next = std::upper_bound(arc.begin() + 1, arc.end() - 1, where) - arc.begin();
      const double step = arc[next] - arc[next - 1];
      const double share = step > 0 ? (where - arc[next - 1]) / step : 0;
      const Eigen::Vector3d& from = link.points_in_world[next - 1];
      return Eigen::Vector3d(from + share * (link.points_in_world[next] - from));
    };
    const double arm = kProbeArmPx * footprint_;
    for (int k = 0; k < count; ++k) {
      const double here = (k + 0.5) / count * length;
      OutlineProbe probe;
      probe.position = at(here);
      probe.tangent = (at(here + arm) - at(here - arm)).stableNormalized();
      if (probe.tangent.isZero()) continue;
      probe.across = TangentFrame(probe.tangent);
      if (FindViews(near, &probe)) probes_.push_back(std::move(probe));
    }
    LimitViews();
  }

  void LimitViews() {
    std::set<ViewId> views;
    for (const OutlineProbe& probe : probes_) views.insert(probe.views.begin(), probe.views.end());
    const size_t stride = (views.size() + kMaxOutlineViews - 1) / kMaxOutlineViews;
    if (stride <= 1) return;
    size_t index = 0;
    std::erase_if(views, [&](ViewId) { return index++ % stride != 0; });
    for (OutlineProbe& probe : probes_) {
      std::erase_if(probe.views, [&](ViewId v) { return !views.contains(v); });
    }
  }

  bool FindViews(const std::vector<ViewId>& near, OutlineProbe* probe) {
    std::vector<std::pair<ViewId, Eigen::Vector3d>> all;
    int num_supporting = 0;
    for (const ViewId v : near) {
      const auto sight = See(images_.views[v], probe->position, probe->tangent);
      if (!sight) continue;
      const Eigen::Vector3d ray = probe->position - images_.views[v].CenterInWorld();
      const Eigen::Vector3d normal = probe->tangent.cross(ray);
      if (normal.norm() < kMinAcross * ray.norm()) continue;
      all.emplace_back(v, normal.normalized());
      const auto match =
          images_.edgels[v]->edgels.Best(sight->position_px, sight->direction, kOnLinkGate);
      if (!match) continue;
      polarity_ += Polarity({v, match->edgel}, *sight);
      probe->normal += all.back().second;
      ++num_supporting;
    }
    probe->normal.stableNormalize();
    for (const auto& [v, normal] : all) {
      if (normal.dot(probe->normal) > std::cos(kMaxAroundRad)) probe->views.push_back(v);
    }
    return num_supporting >= kMinSupporting;
  }

  int Polarity(const EdgelRef& edgel, const CurveSight& sight) const {
    return images_.EdgelOf(edgel).Tangent().dot(sight.direction) > 0 ? 1 : -1;
  }

  // With this radius to begin with; 0 stays, which is an edge.
  BodyBeside Fit(double start_px) const {
    BodyBeside body;
    body.radius = start_px * footprint_;
    for (const OutlineProbe& probe : probes_) {
      body.axis.push_back(probe.position - body.radius * probe.normal);
    }
    bool fit_radius = false;
    for (const SupportGate& gate : kFitGates) {
      Step(gate, fit_radius, &body);
      fit_radius = start_px != 0;
    }
    return body;
  }

  std::optional<Match> MatchIn(ViewId v, size_t k, const BodyBeside& body,
                               const SupportGate& gate) const {
    const View& view = images_.views[v];
    const auto outline =
        OutlineFrom(view.CenterInWorld(), probes_[k].tangent, body.axis[k], body.radius);
    if (!outline) return std::nullopt;
    const auto sight = See(view, outline->position, probes_[k].tangent);
    if (!sight) return std::nullopt;
    const Eigen::Vector2d bright_left = polarity_ > 0 ? sight->direction : -sight->direction;
    const auto edgel = images_.edgels[v]->edgels.BestAlong(sight->position_px, bright_left, gate);
    if (!edgel) return std::nullopt;
    const auto residual = images_.Residual({v, edgel->edgel}, outline->position);
    return residual ? std::optional(Match{edgel->edgel, *residual, outline->normal}) : std::nullopt;
  }

  // A robust Gauss-Newton step; the axis points are eliminated for that of the radius.
  void Step(const SupportGate& gate, bool fit_radius, BodyBeside* body) const {
    const size_t count = probes_.size();
    double of_radius = std::pow(kRadiusPriorPx * footprint_, -2);
    double right = 0;
    std::vector<Eigen::Matrix2d> inverse(count);
    std::vector<Eigen::Vector2d> mixed(count, Eigen::Vector2d::Zero());
    std::vector<Eigen::Vector2d> right_axis(count, Eigen::Vector2d::Zero());
    for (size_t k = 0; k < count; ++k) {
      Eigen::Matrix2d of_axis =
          std::pow(kAxisPriorPx * footprint_, -2) * Eigen::Matrix2d::Identity();
      for (const ViewId v : probes_[k].views) {
        const auto match = MatchIn(v, k, *body, gate);
        if (!match) continue;
        const double distance = match->residual.residual_px;
        const double weight = std::min(1.0, kOutlineRobustPx / std::max(std::abs(distance), 1e-12));
        const Eigen::Vector2d by_axis = probes_[k].across.transpose() * match->residual.gradient;
        const double by_radius = match->residual.gradient.dot(match->normal);
        of_axis += weight * by_axis * by_axis.transpose();
        mixed[k] += weight * by_radius * by_axis;
        right_axis[k] -= weight * distance * by_axis;
        of_radius += weight * by_radius * by_radius;
        right -= weight * distance * by_radius;
      }
      inverse[k] = of_axis.inverse();
      of_radius -= mixed[k].dot(inverse[k] * mixed[k]);
      right -= mixed[k].dot(inverse[k] * right_axis[k]);
    }
    const double change = fit_radius ? right / of_radius : 0;
    body->radius += change;
    for (size_t k = 0; k < count; ++k) {
      body->axis[k] += probes_[k].across * (inverse[k] * (right_axis[k] - change * mixed[k]));
    }
  }

  MisfitOfView Misfits(const BodyBeside& body) const {
    MisfitOfView misfits;
    for (size_t k = 0; k < probes_.size(); ++k) {
      for (const ViewId v : probes_[k].views) {
        const auto match = MatchIn(v, k, body, kShownGate);
        const double squared =
            match ? std::pow(std::min(std::abs(match->residual.residual_px), kMaxMisfitPx), 2)
                  : kMaxMisfitPx * kMaxMisfitPx;
        Misfit& misfit = misfits[v];
        misfit.sum += squared;
        ++misfit.num_probes;
        if (!match) continue;
        misfit.sum_matched += squared;
        ++misfit.num_matched;
      }
    }
    const double least = kMinProbesShare * static_cast<double>(probes_.size());
    std::erase_if(misfits, [&](const auto& item) { return item.second.num_probes < least; });
    return misfits;
  }

  static size_t NumUnexplained(const MisfitOfView& misfits) {
    return static_cast<size_t>(
        std::ranges::count_if(misfits, [](const auto& item) { return !item.second.IsShown(); }));
  }

  // Of the views that show the curve, if they are so many.
  static double RmsOf(const MisfitOfView& misfits, size_t min_views) {
    double sum = 0;
    int count = 0;
    size_t num_views = 0;
    for (const auto& [view, misfit] : misfits) {
      if (!misfit.IsShown()) continue;
      sum += misfit.sum_matched;
      count += misfit.num_matched;
      ++num_views;
    }
    return num_views >= min_views && count > 0 ? std::sqrt(sum / count) : 0;
  }

  void Judge(const FittedEdge& edge, BodyBeside body, OutlineEvidence* evidence) const {
    const MisfitOfView misfits = Misfits(body);
    evidence->body_rms_px = RmsOf(misfits, 1);
    evidence->log_ratio = 0;
    for (const auto& [v, misfit] : misfits) {
      const double variance = kAlikePx * kAlikePx;
      const double of_edge = edge.misfits.at(v).Mean();
      evidence->log_ratio += std::log((of_edge + variance) / (misfit.Mean() + variance)) / 2;
      if (ShiftPx(v, edge.fit, body) < kMinMovedPx) continue;
      ++evidence->num_moved;
      evidence->num_moved_shown += misfit.IsShown();
    }
    evidence->body = std::move(body);
  }

  // Mean distance of the outline from the edge in a view.
  double ShiftPx(ViewId v, const BodyBeside& edge, const BodyBeside& body) const {
    const View& view = images_.views[v];
    double sum = 0;
    int count = 0;
    for (size_t k = 0; k < probes_.size(); ++k) {
      const Eigen::Vector3d& tangent = probes_[k].tangent;
      const auto outline = OutlineFrom(view.CenterInWorld(), tangent, body.axis[k], body.radius);
      const auto at = See(view, edge.axis[k], tangent);
      if (!outline || !at) continue;
      const auto moved = See(view, outline->position, tangent);
      if (!moved) continue;
      sum += std::abs((moved->position_px - at->position_px).dot(at->Across()));
      ++count;
    }
    return count > 0 ? sum / count : 0;
  }

  const TopologyInput& images_;
  double footprint_;
  int polarity_ = 0;  // in how many more sights it is brighter to the left than to the right
  std::vector<OutlineProbe> probes_;
};

}  // namespace

OutlineEvidence CompareWithBodies(const TopologyInput& images, const ViewFinder& finder,
                                  const DrawingLink& link) {
  return OutlineFitter(images, finder, link).Compare();
}

std::vector<OutlineSight> SightsOfOutline(const TopologyInput& images, const ViewFinder& finder,
                                          const DrawingLink& link, const BodyBeside& body) {
  return OutlineFitter(images, finder, link).Sights(body);
}

}  // namespace limn
