#include "limn/refinement/pose_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <ceres/ceres.h>
#include <ceres/normal_prior.h>

#include "limn/model/footprint.h"
#include "limn/refinement/least_squares.h"
#include "limn/refinement/pull_cost.h"
#include "limn/util/median.h"

namespace limn {
namespace {

constexpr int kMaxIterations = 10;
constexpr double kPointSigmaPx = 0.5;
constexpr double kPointRobustSigmas = 2;
// Standard deviation of a camera's change, px in the image of the scene.
constexpr double kCameraSigmaPx = 10;
// Some ray to a scene point must differ from the mean ray by this angle.
constexpr double kMinHalfParallaxDeg = 0.5;

// A pixel pulls by two lines with one loss for both distances.
ceres::CostFunction* MakePointCost(const View& view, const PointPixel& pixel) {
  std::vector<LinePull> pulls;
  for (const int axis : {0, 1}) {
    const EdgelLine line(pixel.position_px, pixel.stored_from_virtual.row(axis).transpose());
    pulls.push_back({&view, line, 1 / kPointSigmaPx});
  }
  return new PullCost(std::move(pulls), {1}, std::numeric_limits<double>::infinity(), true);
}

bool IsInFront(const View& view, const Eigen::Vector3d& point) {
  return (view.cam_from_world * point).z() > 0;
}

bool HasParallax(const std::vector<View>& views, const std::vector<const PointPixel*>& pixels,
                 const Eigen::Vector3d& point) {
  const auto ray = [&](const PointPixel* pixel) -> Eigen::Vector3d {
    return (point - views[pixel->view].CenterInWorld()).normalized();
  };
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const PointPixel* pixel : pixels) mean += ray(pixel);
  mean.normalize();
  return std::any_of(pixels.begin(), pixels.end(), [&](const PointPixel* pixel) {
    return ray(pixel).dot(mean) < std::cos(kMinHalfParallaxDeg * M_PI / 180);
  });
}

class PoseProblem {
 public:
  PoseProblem(const FitInput& input, const std::vector<ScenePoint>& points,
              const RefinementOptions& options, CameraCorrections* corrections,
              ControlGraph* control, std::vector<Eigen::Vector3d>* positions)
      : input_(input),
        points_(points),
        corrections_(corrections),
        positions_(positions),
        views_(Corrected(input.views, *corrections)),
        footprints_(input.views.size()) {
    for (const Component& component : FindComponents(input.frozen, *control)) {
      AddTerms(input, options, component, corrections, control, &problem_);
      for (const int link : component.links) AddFootprints(link, *control);
    }
    AddPoints();
    AddCameraHolds();
  }

  // False, and nothing changed, if there is no usable solution.
  bool Solve(const RunContext& context) {
    const std::vector<Eigen::Vector3d> before = *positions_;
    if (!Minimize(kMaxIterations, context, &problem_)) return false;
    PutBackPointsBehind(before);
    return true;
  }

 private:
  void AddFootprints(int link, const ControlGraph& control) {
    for (const LinkSample& sample : input_.matches[link]) {
      const Eigen::Vector3d& from = control.position[control.links[link].points[sample.segment]];
      for (const EdgelPull& pull : sample.pulls) AddFootprint(pull.ref.view, from);
    }
  }

  void AddPoints() {
    for (size_t p = 0; p < points_.size(); ++p) {
      std::vector<const PointPixel*> pixels;
      for (const PointPixel& pixel : points_[p].pixels) {
        if (IsInFront(views_[pixel.view], (*positions_)[p])) pixels.push_back(&pixel);
      }
      if (pixels.size() < 2) continue;
      if (!HasParallax(input_.views, pixels, points_[p].position_in_world)) continue;
      for (const PointPixel* pixel : pixels) {
        const View& view = input_.views[pixel->view];
        problem_.AddResidualBlock(MakePointCost(view, *pixel),
                                  new ceres::CauchyLoss(kPointRobustSigmas),
                                  (*positions_)[p].data(), corrections_->motion[pixel->view].data(),
                                  &corrections_->log_focal.at(view.camera_index));
        AddFootprint(pixel->view, (*positions_)[p]);
      }
    }
  }

  // Resets points that have moved behind a view that sees them.
  void PutBackPointsBehind(const std::vector<Eigen::Vector3d>& before) {
    const std::vector<View> views = Corrected(input_.views, *corrections_);
    for (size_t p = 0; p < before.size(); ++p) {
      const std::vector<PointPixel>& pixels = points_[p].pixels;
      const bool went_behind =
          std::any_of(pixels.begin(), pixels.end(), [&](const PointPixel& pixel) {
            return IsInFront(views_[pixel.view], before[p]) &&
                   !IsInFront(views[pixel.view], (*positions_)[p]);
          });
      if (went_behind) (*positions_)[p] = before[p];
    }
  }

  // Cameras without data are not unknowns.
  void AddCameraHolds() {
    int largest_side = 0;
    for (size_t v = 0; v < input_.views.size(); ++v) {
      if (footprints_[v].empty()) continue;
      const PinholeCamera& camera = input_.views[v].camera;
      ceres::Vector px_per_unit(6);
      px_per_unit << Eigen::Vector3d::Constant(camera.MeanFocal()),
          Eigen::Vector3d::Constant(1 / Median(footprints_[v]));
      Hold(px_per_unit, corrections_->motion[v].data());
      largest_side = std::max({largest_side, camera.width, camera.height});
    }
    for (auto& [camera_index, log_focal] : corrections_->log_focal) {
      if (!problem_.HasParameterBlock(&log_focal)) continue;
      Hold(ceres::Vector::Constant(1, 0.5 * largest_side), &log_focal);
    }
  }

  // Holds unknowns weakly at 0, weighted by their effect in the image.
  void Hold(const ceres::Vector& px_per_unit, double* unknowns) {
    const ceres::Matrix factors = (px_per_unit / kCameraSigmaPx).asDiagonal();
    const ceres::Vector zero = ceres::Vector::Zero(px_per_unit.size());
    problem_.AddResidualBlock(new ceres::NormalPrior(factors, zero), nullptr, unknowns);
  }

  void AddFootprint(ViewId view, const Eigen::Vector3d& point) {
    if (const auto footprint = FootprintIn(input_.views[view], point)) {
      footprints_[view].push_back(*footprint);
    }
  }

  const FitInput& input_;
  const std::vector<ScenePoint>& points_;
  CameraCorrections* corrections_;
  std::vector<Eigen::Vector3d>* positions_;
  std::vector<View> views_;                      // as corrected at the start
  std::vector<std::vector<double>> footprints_;  // per view, of what it shows
  ceres::Problem problem_;
};

}  // namespace

bool FitPoses(const FitInput& input, const std::vector<ScenePoint>& points,
              const RefinementOptions& options, const RunContext& context,
              CameraCorrections* corrections, ControlGraph* control,
              std::vector<Eigen::Vector3d>* positions) {
  UpdateTangents(control);
  const std::vector<Eigen::Vector3d> before = control->position;
  PoseProblem problem(input, points, options, corrections, control, positions);
  if (!problem.Solve(context)) return false;
  FollowNodes(input.frozen, before, control);
  return true;
}

}  // namespace limn
