// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/view_selection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "limn/geometry/angle_between.h"
#include "limn/sketch/view_neighbors.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "limn/util/median.h"

namespace limn {
namespace {

constexpr int kNumDepths = 36;
// Depths tried, in multiples of the median distance between the centers of the camera and its
// neighbors; those of points beyond are tried too.
constexpr double kMinRelativeDepth = 0.05;
constexpr double kMaxRelativeDepth = 100.0;
// A confirmation view needs to discriminate depths only a little, so it may be nearer to the
// primary view than a second view, or farther, degrees.
constexpr double kMinConfirmationAngleDeg = 2;
constexpr double kMaxConfirmationAngleDeg = 70;
// Fewer points than this may miss what is near or far: the depth range is that of the geometry.
constexpr int kMinPointsForDepth = 50;
// Curves are seen beyond the points by up to this factor on either side.
constexpr double kPointsDepthWidening = 2;
// A view whose parallax differs from that of a chosen one by less than this many degrees adds
// little.
constexpr double kSecondSpreadDeg = 8.0;
constexpr double kConfirmationSpreadDeg = 4.0;
// What a chosen view takes from the score of one with the same parallax.
constexpr double kTakenByLikeness = 0.9;
// The best parallaxes, degrees; beyond them scores fall to nothing at the bounds of the options.
constexpr double kBestPairDeg[] = {8, 25};
constexpr double kBestConfirmationDeg[] = {6, 40};
// An added view may show what the others do not. It is sketched if this share of all views alike
// should be, that is, until about twice enough_primary_views views of its places are.
constexpr double kAddedShare = 0.4;

// How the depths of a view are sampled, ascending.
std::vector<double> SampledDepths(double scale, const std::optional<DepthSpan>& span) {
  const double ratio = std::pow(kMaxRelativeDepth / kMinRelativeDepth, 1.0 / (kNumDepths - 1));
  std::vector<double> depths = {kMinRelativeDepth * scale};
  if (span) {
    while (depths.back() > span->near) depths.push_back(depths.back() / ratio);
    std::reverse(depths.begin(), depths.end());
  }
  double depth = depths.back();
  for (int k = 1; k < kNumDepths || (span && depth < span->far); ++k) {
    depths.push_back(depth *= ratio);
  }
  return depths;
}

// Where views see the same at fewer depths than this, as many as kNumDepths are added, from this
// much nearer to this much farther than where their axes meet.
constexpr size_t kFewDepths = 3;
constexpr double kAroundMeeting = 1.25;

std::vector<double> DepthsAround(const std::optional<double>& depth) {
  std::vector<double> depths;
  if (!depth) return depths;
  for (int k = 0; k < kNumDepths; ++k) {
    depths.push_back(*depth * std::pow(kAroundMeeting, 2.0 * k / (kNumDepths - 1) - 1));
  }
  return depths;
}

Eigen::Vector3d AxisInWorld(const View& view) {
  return view.cam_from_world.rotation.inverse() * Eigen::Vector3d::UnitZ();
}

// 0 outside [low, high], 1 on the plateau, linear flanks.
double Trapezoid(double value, double low, double plateau_begin, double plateau_end, double high) {
  if (value <= low || value >= high) return 0;
  if (value < plateau_begin) return (value - low) / (plateau_begin - low);
  if (value > plateau_end) return (high - value) / (high - plateau_end);
  return 1;
}

struct CandidateView {
  ViewId view = -1;
  double common_share = 0;  // of the primary view's places, those that it sees
  double second_score = 0;
  double confirmation_score = 0;
  // Mean parallax of the common samples: angle (degrees) times epipolar direction in the primary
  // view.
  Eigen::Vector2d parallax_deg = Eigen::Vector2d::Zero();
};

// Greedy choice: the best score, discounted by likeness to those chosen already.
std::vector<ViewId> PickSpread(const std::vector<CandidateView>& candidates,
                               double CandidateView::*score, double spread_deg, int max_views) {
  std::vector<double> remaining;
  for (const CandidateView& candidate : candidates) remaining.push_back(candidate.*score);
  std::vector<ViewId> picked;
  while (static_cast<int>(picked.size()) < max_views) {
    const auto best = std::max_element(remaining.begin(), remaining.end());
    if (best == remaining.end() || !(*best > 0)) break;
    const size_t index = best - remaining.begin();
    picked.push_back(candidates[index].view);
    *best = 0;
    for (size_t i = 0; i < candidates.size(); ++i) {
      const double distance =
          (candidates[i].parallax_deg - candidates[index].parallax_deg).norm() / spread_deg;
      remaining[i] *= 1 - kTakenByLikeness * std::exp(-0.5 * distance * distance);
    }
  }
  return picked;
}

std::vector<Eigen::Vector3d> Centers(const std::vector<View>& views) {
  std::vector<Eigen::Vector3d> centers;
  for (const View& view : views) centers.push_back(view.CenterInWorld());
  return centers;
}

// Centers that differ by rounding only are one center.
bool IsExtended(double extent, const std::vector<Eigen::Vector3d>& centers) {
  return extent > 1e-9 * centers.front().norm();
}

// As many sites as there must be where more views than the two of a pair are to confirm a place.
constexpr int kEnoughSites = 4;

// Of the distinct centers, which views of a panorama or from one tripod share; at most `enough`.
int CountSites(const std::vector<Eigen::Vector3d>& centers, int enough = kEnoughSites) {
  std::vector<Eigen::Vector3d> sites;
  for (const Eigen::Vector3d& center : centers) {
    const bool is_known = std::any_of(sites.begin(), sites.end(), [&](const auto& site) {
      return (site - center).norm() <= 1e-9 * center.norm();
    });
    if (!is_known) sites.push_back(center);
    if (std::ssize(sites) == enough) break;
  }
  return static_cast<int>(sites.size());
}

// The places in front of a primary view at which the choice is made, and how its neighbors see
// them.
struct SampledViewField {
  std::vector<double> depths;
  std::vector<Eigen::Vector3d> places;  // in world, pixel by pixel, depths in turn
  std::vector<ViewId> neighbors;
  // By neighbor, then place: angle at the place to the primary view, degrees; negative = not seen.
  std::vector<double> angles_deg;

  double DepthOf(size_t place) const { return depths[place % depths.size()]; }
  const double* AnglesOf(size_t neighbor) const {
    return angles_deg.data() + neighbor * places.size();
  }
};

class PlanBuilder {
 public:
  PlanBuilder(const std::vector<View>& views, const ViewSelectionOptions& options)
      : views_(views),
        centers_(Centers(views)),
        num_needed_(CountSites(centers_) - 1),
        options_(options),
        finder_(views, std::min(options.min_pair_angle_deg, kMinConfirmationAngleDeg),
                std::max(options.max_pair_angle_deg, kMaxConfirmationAngleDeg)) {}

  struct Choice {
    ViewPlan plan;
    // Of views that see what this one sees, those that suffice to sketch it.
    double primary_share = 1;
    // The next view in the list that sees much of the same; -1 if none does.
    ViewId next = -1;
  };

  // `sketched` are the views that count as primary for its share; null: all may be.
  Choice Build(ViewId primary, const std::optional<DepthSpan>& point_depths,
               const std::vector<uint8_t>* sketched = nullptr) const {
    const std::vector<ViewId> neighbors = finder_.Find(primary, point_depths);
    std::vector<double> depths = SampledDepths(Scale(primary, neighbors), point_depths);
    SampledViewField field = Sample(primary, neighbors, depths);
    std::vector<int> counts = CountViews(field);
    if (CountSeenDepths(field, counts) < kFewDepths) {
      // Long lenses see the same between the depths sampled.
      const auto more = DepthsAround(DepthWhereAxesMeet(primary, neighbors));
      depths.insert(depths.end(), more.begin(), more.end());
      std::ranges::sort(depths);
      field = Sample(primary, neighbors, std::move(depths));
      counts = CountViews(field);
    }
    ViewPlan plan;
    std::vector<double> weights(counts.size(), 0);
    for (size_t i = 0; i < counts.size(); ++i) {
      if (counts[i] < num_needed_) continue;
      const double depth = field.DepthOf(i);
      if (!point_depths || Contains(*point_depths, depth)) weights[i] = counts[i];
      Include({depth, depth}, &plan);
    }
    if (point_depths) Include(*point_depths, &plan);
    const std::vector<CandidateView> candidates = Score(primary, field, weights);
    plan.second_views = PickSpread(candidates, &CandidateView::second_score, kSecondSpreadDeg,
                                   options_.max_second_views);
    plan.confirmation_views = PickSpread(candidates, &CandidateView::confirmation_score,
                                         kConfirmationSpreadDeg, options_.max_confirmation_views);
    const double share = PrimaryShare(sketched ? CountViews(field, sketched) : counts, weights);
    return {std::move(plan), share, NextAlike(primary, candidates)};
  }

 private:
  SampledViewField Sample(ViewId primary, std::vector<ViewId> neighbors,
                          std::vector<double> depths) const {
    SampledViewField field;
    field.neighbors = std::move(neighbors);
    field.depths = std::move(depths);
    field.places = PlacesInFront(views_[primary], field.depths);
    for (const ViewId v : field.neighbors) {
      for (const Eigen::Vector3d& place : field.places) {
        const bool seen = views_[v].Project(place).has_value();
        field.angles_deg.push_back(
            seen ? AngleBetween(place - centers_[primary], place - centers_[v]) / kDeg : -1);
      }
    }
    return field;
  }

  // Where the view's axis is nearest to those of its neighbors, median; nothing if none comes near
  // in front of both.
  std::optional<double> DepthWhereAxesMeet(ViewId primary,
                                           const std::vector<ViewId>& neighbors) const {
    std::vector<double> depths;
    const Eigen::Vector3d axis = AxisInWorld(views_[primary]);
    for (const ViewId v : neighbors) {
      const Eigen::Vector3d other = AxisInWorld(views_[v]);
      const Eigen::Vector3d normal = axis.cross(other);
      if (!(normal.norm() > 1e-6)) continue;  // parallel
      const Eigen::Vector3d between = centers_[v] - centers_[primary];
      const double depth = between.cross(other).dot(normal) / normal.squaredNorm();
      const double of_other = between.cross(axis).dot(normal) / normal.squaredNorm();
      if (depth > 0 && of_other > 0) depths.push_back(depth);
    }
    if (depths.empty()) return std::nullopt;
    return Median(std::move(depths));
  }

  // Of the camera and its neighbors; of all cameras where those tell nothing.
  double Scale(ViewId primary, const std::vector<ViewId>& neighbors) const {
    std::vector<Eigen::Vector3d> centers;
    for (const ViewId v : neighbors) centers.push_back(centers_[v]);
    centers.insert(std::lower_bound(neighbors.begin(), neighbors.end(), primary) -
                       neighbors.begin() + centers.begin(),
                   centers_[primary]);
    const double scale = Extent(centers);
    return IsExtended(scale, centers) ? scale : Extent(centers_);
  }

  // Depths at which enough others see a place.
  size_t CountSeenDepths(const SampledViewField& field, const std::vector<int>& counts) const {
    std::set<double> seen;
    for (size_t i = 0; i < counts.size(); ++i) {
      if (counts[i] >= num_needed_) seen.insert(field.DepthOf(i));
    }
    return seen.size();
  }

  // Per place, the views that contain it under an angle usable for confirmation.
  std::vector<int> CountViews(const SampledViewField& field,
                              const std::vector<uint8_t>* only = nullptr) const {
    std::vector<int> counts(field.places.size(), 0);
    for (size_t n = 0; n < field.neighbors.size(); ++n) {
      if (only && !(*only)[field.neighbors[n]]) continue;
      const double* angles = field.AnglesOf(n);
      for (size_t i = 0; i < counts.size(); ++i) {
        counts[i] += angles[i] >= kMinConfirmationAngleDeg && angles[i] <= kMaxConfirmationAngleDeg;
      }
    }
    return counts;
  }

  static ViewId NextAlike(ViewId primary, const std::vector<CandidateView>& candidates) {
    for (const CandidateView& candidate : candidates) {  // ascending
      if (candidate.view > primary && candidate.common_share >= 0.5) return candidate.view;
    }
    return -1;
  }

  double PrimaryShare(const std::vector<int>& counts, const std::vector<double>& weights) const {
    double sum = 0;
    double enough = 0;
    for (size_t i = 0; i < counts.size(); ++i) {
      sum += weights[i];
      enough += weights[i] * std::min(1.0, options_.enough_primary_views / (1.0 + counts[i]));
    }
    return sum > 0 ? enough / sum : 1;
  }

  static bool Contains(const DepthSpan& span, double depth) {
    return span.near <= depth && depth <= span.far;
  }

  static void Include(const DepthSpan& span, ViewPlan* plan) {
    const bool is_empty = plan->min_depth > plan->max_depth;
    plan->min_depth = is_empty ? span.near : std::min(plan->min_depth, span.near);
    plan->max_depth = is_empty ? span.far : std::max(plan->max_depth, span.far);
  }

  std::vector<CandidateView> Score(ViewId primary, const SampledViewField& field,
                                   const std::vector<double>& weights) const {
    const double total_weight = std::accumulate(weights.begin(), weights.end(), 0.0);
    std::vector<CandidateView> candidates;
    if (!(total_weight > 0)) return candidates;
    const Eigen::Matrix3d cam_from_world =
        views_[primary].cam_from_world.rotation.toRotationMatrix();
    for (size_t n = 0; n < field.neighbors.size(); ++n) {
      CandidateView candidate;
      candidate.view = field.neighbors[n];
      const double* angles = field.AnglesOf(n);
      const Eigen::Vector3d baseline_in_cam =
          cam_from_world * (centers_[candidate.view] - centers_[primary]);
      double common_weight = 0;
      for (size_t i = 0; i < weights.size(); ++i) {
        const double angle = angles[i];
        if (weights[i] == 0 || angle < 0) continue;
        const double w = weights[i] / total_weight;
        candidate.second_score += w * Trapezoid(angle, options_.min_pair_angle_deg, kBestPairDeg[0],
                                                kBestPairDeg[1], options_.max_pair_angle_deg);
        candidate.confirmation_score +=
            w * Trapezoid(angle, kMinConfirmationAngleDeg, kBestConfirmationDeg[0],
                          kBestConfirmationDeg[1], kMaxConfirmationAngleDeg);
        // Epipolar direction at the ray: the baseline without its component along the ray.
        const Eigen::Vector3d ray_in_cam =
            (cam_from_world * (field.places[i] - centers_[primary])).normalized();
        const Eigen::Vector3d lateral =
            baseline_in_cam - baseline_in_cam.dot(ray_in_cam) * ray_in_cam;
        if (lateral.head<2>().norm() > 0) {
          candidate.parallax_deg += w * angle * lateral.head<2>().normalized();
        }
        common_weight += w;
      }
      if (common_weight > 0) candidate.parallax_deg /= common_weight;
      candidate.common_share = common_weight;
      candidates.push_back(candidate);
    }
    return candidates;
  }

  const std::vector<View>& views_;
  const std::vector<Eigen::Vector3d> centers_;
  const int num_needed_;  // other views that must see a place
  const ViewSelectionOptions& options_;
  const NeighborFinder finder_;
};

// Views are primary as often as their shares say, evenly spread: what a view is more or less than
// its share goes to the next that sees the same.
std::vector<ViewPlan> WithPrimaries(std::vector<PlanBuilder::Choice> choices) {
  std::vector<ViewPlan> plans;
  std::vector<double> owed(choices.size(), 0);
  for (PlanBuilder::Choice& choice : choices) {
    const double share = owed[plans.size()] + choice.primary_share;
    choice.plan.is_primary = share >= 0.5;
    if (choice.next >= 0) owed[choice.next] += share - choice.plan.is_primary;
    plans.push_back(std::move(choice.plan));
  }
  return plans;
}

std::vector<std::vector<double>> PointDepths(const std::vector<View>& views,
                                             const SceneHints& hints) {
  std::vector<std::vector<double>> depths(views.size());
  for (const ScenePoint& point : hints.points) {
    for (const ViewId v : point.views) {
      const double depth = (views[v].cam_from_world * point.position_in_world).z();
      if (depth > 0) depths[v].push_back(depth);
    }
  }
  return depths;
}

// Depth range of the points of a view, widened; empty if they are too few.
std::optional<DepthSpan> SpanOfPoints(std::vector<double> depths) {
  if (static_cast<int>(depths.size()) < kMinPointsForDepth) return std::nullopt;
  std::sort(depths.begin(), depths.end());
  const size_t outliers = depths.size() / 100;  // at either end
  return DepthSpan{depths[outliers] / kPointsDepthWidening,
                   depths[depths.size() - 1 - outliers] * kPointsDepthWidening};
}

}  // namespace

void ViewSelectionOptions::Check() const {
  CheckFields(*this);
  LIMN_CHECK_OPTION(max_pair_angle_deg, > min_pair_angle_deg);
}

std::string WhyNothingIsTriangulated(const std::vector<View>& views) {
  if (views.size() < 3) {
    return "at least 3 registered images are needed, got " + std::to_string(views.size());
  }
  const std::vector<Eigen::Vector3d> centers = Centers(views);
  if (!IsExtended(Extent(centers), centers)) {
    return "the cameras are all at one center: nothing can be triangulated. Take photographs from "
           "other places";
  }
  if (const int num_sites = CountSites(centers); num_sites < 3) {
    return "the cameras must be at 3 places at least, but all are at " + std::to_string(num_sites);
  }
  return "";
}

int CountOtherPlaces(const std::vector<View>& views, int enough) {
  return std::max(1, CountSites(Centers(views), enough + 1) - 1);
}

void CheckViews(const std::vector<View>& views) {
  const std::string reason = WhyNothingIsTriangulated(views);
  if (!reason.empty()) throw InputError(reason);
}

std::vector<ViewPlan> SelectViews(const std::vector<View>& views, const SceneHints& hints,
                                  const ViewSelectionOptions& options, const RunContext& context) {
  options.Check();
  CheckViews(views);
  const auto point_depths = PointDepths(views, hints);
  const PlanBuilder builder(views, options);
  std::vector<PlanBuilder::Choice> choices(views.size());
  ParallelFor(context, "view selection", views.size(), [&](size_t v) {
    choices[v] = builder.Build(static_cast<ViewId>(v), SpanOfPoints(point_depths[v]));
  });
  return WithPrimaries(std::move(choices));
}

std::vector<ViewPlan> PlanAddedViews(const std::vector<View>& views, const SceneHints& hints,
                                     const std::vector<ViewId>& added,
                                     const std::vector<uint8_t>& is_sketched,
                                     const ViewSelectionOptions& options,
                                     const RunContext& context) {
  options.Check();
  CheckViews(views);
  const auto point_depths = PointDepths(views, hints);
  const PlanBuilder builder(views, options);
  ViewPlan confirms_only;
  confirms_only.is_primary = false;
  std::vector<ViewPlan> plans(views.size(), confirms_only);
  ParallelFor(context, "view selection", added.size(), [&](size_t i) {
    const ViewId v = added[i];
    PlanBuilder::Choice choice = builder.Build(v, SpanOfPoints(point_depths[v]), &is_sketched);
    plans[v] = std::move(choice.plan);
    plans[v].is_primary = choice.primary_share > kAddedShare;
  });
  return plans;
}

std::vector<ViewId> PartnersIn(const ViewPlan& plan) {
  std::set<ViewId> all(plan.second_views.begin(), plan.second_views.end());
  all.insert(plan.confirmation_views.begin(), plan.confirmation_views.end());
  return {all.begin(), all.end()};
}

std::vector<ViewId> WithPartners(const std::vector<ViewId>& views,
                                 const std::vector<ViewPlan>& plans) {
  std::set<ViewId> all(views.begin(), views.end());
  for (const ViewId v : views) {
    if (!plans[v].is_primary) continue;
    const std::vector<ViewId> partners = PartnersIn(plans[v]);
    all.insert(partners.begin(), partners.end());
  }
  return {all.begin(), all.end()};
}

}  // namespace limn
