#include "limn/sketch/view_selection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr int kGridCols = 4;
constexpr int kGridRows = 3;
constexpr int kNumDepths = 36;
// Depths tried, in multiples of the median distance between the cameras' centres.
constexpr double kMinRelativeDepth = 0.05;
constexpr double kMaxRelativeDepth = 100.0;
// A view more alike an already chosen one than this many degrees (in parallax) adds little.
constexpr double kSecondSpreadDeg = 8.0;
constexpr double kConfirmationSpreadDeg = 4.0;
constexpr double kDeg = M_PI / 180;

// A point of the sampling grid of a primary view and how the other views see it.
struct GridSample {
  double depth = 0;
  Eigen::Vector3d point_in_world;
};

std::vector<Eigen::Vector2d> GridPixels(const View& view) {
  std::vector<Eigen::Vector2d> pixels;
  const Eigen::Vector2d extent = view.region.max_px - view.region.min_px;
  for (int row = 0; row < kGridRows; ++row) {
    for (int col = 0; col < kGridCols; ++col) {
      const Eigen::Vector2d pixel =
          view.region.min_px +
          extent.cwiseProduct(Eigen::Vector2d((col + 0.5) / kGridCols, (row + 0.5) / kGridRows));
      if (view.region.Contains(pixel)) pixels.push_back(pixel);
    }
  }
  return pixels;
}

double MedianCentreDistance(const std::vector<Eigen::Vector3d>& centres) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& centre : centres) mean += centre / static_cast<double>(centres.size());
  std::vector<double> distances;
  for (const auto& centre : centres) distances.push_back((centre - mean).norm());
  std::nth_element(distances.begin(), distances.begin() + distances.size() / 2, distances.end());
  return 2 * distances[distances.size() / 2];
}

std::vector<GridSample> MakeGrid(const View& view, double scene_scale) {
  std::vector<GridSample> samples;
  const Rigid3d world_from_cam = Inverse(view.cam_from_world);
  const double ratio = std::pow(kMaxRelativeDepth / kMinRelativeDepth, 1.0 / (kNumDepths - 1));
  for (const Eigen::Vector2d& pixel : GridPixels(view)) {
    const Eigen::Vector3d ray = view.camera.RayFromPixel(pixel);
    double depth = kMinRelativeDepth * scene_scale;
    for (int k = 0; k < kNumDepths; ++k, depth *= ratio) {
      samples.push_back({depth, world_from_cam * (depth * ray)});
    }
  }
  return samples;
}

double AngleDeg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) / kDeg;
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
      remaining[i] *= 1 - 0.9 * std::exp(-0.5 * distance * distance);
    }
  }
  return picked;
}

class PlanBuilder {
 public:
  PlanBuilder(const std::vector<View>& views, const std::vector<Eigen::Vector3d>& centres,
              double scene_scale, const ViewSelectionOptions& options)
      : views_(views), centres_(centres), scene_scale_(scene_scale), options_(options) {}

  ViewPlan Build(ViewId primary, std::vector<double> point_depths) const {
    std::vector<GridSample> grid = MakeGrid(views_[primary], scene_scale_);
    const std::vector<int> counts = CountViews(primary, grid);
    ViewPlan plan;
    const int needed = std::min<int>(3, static_cast<int>(views_.size()) - 1);
    std::vector<double> weights(grid.size(), 0);
    for (size_t i = 0; i < grid.size(); ++i) {
      if (counts[i] < needed) continue;
      weights[i] = counts[i];
      if (plan.min_depth > plan.max_depth) plan.min_depth = plan.max_depth = grid[i].depth;
      plan.min_depth = std::min(plan.min_depth, grid[i].depth);
      plan.max_depth = std::max(plan.max_depth, grid[i].depth);
    }
    WidenByPoints(std::move(point_depths), &plan);
    const std::vector<CandidateView> candidates = Score(primary, grid, weights);
    plan.second_views = PickSpread(candidates, &CandidateView::second_score, kSecondSpreadDeg,
                                   options_.max_second_views);
    plan.confirmation_views = PickSpread(candidates, &CandidateView::confirmation_score,
                                         kConfirmationSpreadDeg, options_.max_confirmation_views);
    return plan;
  }

 private:
  // Per sample, the views that contain it under an angle usable for confirmation.
  std::vector<int> CountViews(ViewId primary, const std::vector<GridSample>& grid) const {
    std::vector<int> counts(grid.size(), 0);
    for (size_t v = 0; v < views_.size(); ++v) {
      if (static_cast<ViewId>(v) == primary) continue;
      for (size_t i = 0; i < grid.size(); ++i) {
        if (!views_[v].Project(grid[i].point_in_world)) continue;
        const double angle = AngleDeg(grid[i].point_in_world - centres_[primary],
                                      grid[i].point_in_world - centres_[v]);
        counts[i] += angle >= options_.min_confirmation_angle_deg &&
                     angle <= options_.max_confirmation_angle_deg;
      }
    }
    return counts;
  }

  void WidenByPoints(std::vector<double> depths, ViewPlan* plan) const {
    if (static_cast<int>(depths.size()) < options_.min_points_for_depth) return;
    std::sort(depths.begin(), depths.end());
    const double near = depths[depths.size() / 100] / options_.points_depth_widening;
    const double far =
        depths[depths.size() - 1 - depths.size() / 100] * options_.points_depth_widening;
    const bool geometry_is_empty = plan->min_depth > plan->max_depth;
    plan->min_depth = geometry_is_empty ? near : std::min(plan->min_depth, near);
    plan->max_depth = geometry_is_empty ? far : std::max(plan->max_depth, far);
  }

  std::vector<CandidateView> Score(ViewId primary, const std::vector<GridSample>& grid,
                                   const std::vector<double>& weights) const {
    const double total_weight = std::accumulate(weights.begin(), weights.end(), 0.0);
    std::vector<CandidateView> candidates;
    if (!(total_weight > 0)) return candidates;
    const Eigen::Matrix3d cam_from_world =
        views_[primary].cam_from_world.rotation.toRotationMatrix();
    for (size_t v = 0; v < views_.size(); ++v) {
      if (static_cast<ViewId>(v) == primary) continue;
      CandidateView candidate;
      candidate.view = static_cast<ViewId>(v);
      const Eigen::Vector3d baseline_in_cam = cam_from_world * (centres_[v] - centres_[primary]);
      double common_weight = 0;
      for (size_t i = 0; i < grid.size(); ++i) {
        if (weights[i] == 0 || !views_[v].Project(grid[i].point_in_world)) continue;
        const Eigen::Vector3d ray = grid[i].point_in_world - centres_[primary];
        const double angle = AngleDeg(ray, grid[i].point_in_world - centres_[v]);
        const double w = weights[i] / total_weight;
        candidate.second_score +=
            w * Trapezoid(angle, options_.min_pair_angle_deg, 8, 25, options_.max_pair_angle_deg);
        candidate.confirmation_score += w * Trapezoid(angle, options_.min_confirmation_angle_deg, 6,
                                                      40, options_.max_confirmation_angle_deg);
        // Epipolar direction at the ray: the baseline without its component along the ray.
        const Eigen::Vector3d ray_in_cam = (cam_from_world * ray).normalized();
        const Eigen::Vector3d lateral =
            baseline_in_cam - baseline_in_cam.dot(ray_in_cam) * ray_in_cam;
        if (lateral.head<2>().norm() > 0) {
          candidate.parallax_deg += w * angle * lateral.head<2>().normalized();
        }
        common_weight += w;
      }
      if (common_weight > 0) candidate.parallax_deg /= common_weight;
      candidates.push_back(candidate);
    }
    return candidates;
  }

  const std::vector<View>& views_;
  const std::vector<Eigen::Vector3d>& centres_;
  double scene_scale_;
  const ViewSelectionOptions& options_;
};

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

std::vector<Eigen::Vector3d> Centres(const std::vector<View>& views) {
  std::vector<Eigen::Vector3d> centres;
  for (const View& view : views) centres.push_back(view.CenterInWorld());
  return centres;
}

}  // namespace

void ViewSelectionOptions::Check() const {
  LIMN_CHECK_OPTION(max_second_views, >= 1);
  LIMN_CHECK_OPTION(max_confirmation_views, >= 1);
  LIMN_CHECK_OPTION(max_confirmation_views, <= 32);
  LIMN_CHECK_OPTION(min_pair_angle_deg, > 0);
  LIMN_CHECK_OPTION(max_pair_angle_deg, > min_pair_angle_deg);
  LIMN_CHECK_OPTION(min_confirmation_angle_deg, > 0);
  LIMN_CHECK_OPTION(max_confirmation_angle_deg, > min_confirmation_angle_deg);
  LIMN_CHECK_OPTION(min_points_for_depth, >= 1);
  LIMN_CHECK_OPTION(points_depth_widening, >= 1);
}

void CheckViews(const std::vector<View>& views) {
  if (views.size() < 3) {
    throw InputError("at least 3 registered images are needed, got " +
                     std::to_string(views.size()));
  }
  const std::vector<Eigen::Vector3d> centres = Centres(views);
  // Centres that differ by rounding only are one centre.
  if (!(MedianCentreDistance(centres) > 1e-9 * centres.front().norm())) {
    throw InputError("the cameras are all at one centre: nothing can be triangulated");
  }
}

std::vector<ViewPlan> SelectViews(const std::vector<View>& views, const SceneHints& hints,
                                  const ViewSelectionOptions& options, const RunContext& context) {
  options.Check();
  CheckViews(views);
  const std::vector<Eigen::Vector3d> centres = Centres(views);
  const double scene_scale = MedianCentreDistance(centres);
  const auto point_depths = PointDepths(views, hints);
  const PlanBuilder builder(views, centres, scene_scale, options);
  std::vector<ViewPlan> plans(views.size());
  ParallelFor(context, "view selection", views.size(),
              [&](size_t v) { plans[v] = builder.Build(static_cast<ViewId>(v), point_depths[v]); });
  return plans;
}

}  // namespace limn
