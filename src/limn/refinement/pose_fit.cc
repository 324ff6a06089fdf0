#include "limn/refinement/pose_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <ceres/ceres.h>
#include <ceres/normal_prior.h>

#include "limn/model/footprint.h"
#include "limn/refinement/pull_cost.h"
#include "limn/util/angles.h"
#include "limn/util/median.h"

namespace limn {
namespace {

constexpr int kMaxPoseIterations = 10;
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

bool HasParallax(const std::vector<View>& views, const std::vector<PointPixel>& pixels,
                 const Eigen::Vector3d& point) {
  Eigen::Matrix3Xd rays(3, pixels.size());
  for (size_t i = 0; i < pixels.size(); ++i) {
    rays.col(i) = (point - views[pixels[i].view].CenterInWorld()).normalized();
  }
  const Eigen::Vector3d mean = rays.rowwise().sum().normalized();
  return (mean.transpose() * rays).minCoeff() < std::cos(kMinHalfParallaxDeg * kDeg);
}

class PoseFit {
 public:
  PoseFit(const std::vector<View>& views, const std::vector<ScenePoint>& points,
          CameraCorrections* corrections, std::vector<Eigen::Vector3d>* positions)
      : views_(views),
        points_(points),
        corrections_(corrections),
        positions_(positions),
        footprints_(views.size()) {}

  bool Run(const RefinementOptions& options, const RunContext& context, ControlGraph* control) {
    UpdateTangents(control);
    const std::vector<View> views_before = Corrected(views_, *corrections_);
    const std::vector<Eigen::Vector3d> control_before = control->position;
    const std::vector<Eigen::Vector3d> points_before = *positions_;
    for (const Component& component : FindComponents(*control)) {
      AddTerms(views_, options, component, corrections_, control, &problem_);
    }
    AddFootprints(*control);
    for (size_t p = 0; p < points_.size(); ++p) {
      AddPoint(points_[p], views_before, &(*positions_)[p]);
    }
    AddCameraHolds();
    if (!Minimize(kMaxPoseIterations, context, &problem_)) return false;
    PutBackPointsBehind(views_before, points_before);
    FollowNodes(control_before, control);
    return true;
  }

 private:
  void AddFootprints(const ControlGraph& control) {
    for (const ControlLink& link : control.links) {
      if (link.frozen) continue;
      for (const FitSample& sample : link.samples) {
        const Eigen::Vector3d& from = control.position[link.points[sample.segment]];
        for (const EdgelPull& pull : sample.pulls) AddFootprint(pull.ref.view, from);
      }
    }
  }

  void AddFootprint(ViewId view, const Eigen::Vector3d& point) {
    if (const auto footprint = FootprintIn(views_[view], point)) {
      footprints_[view].push_back(*footprint);
    }
  }

  void AddPoint(const ScenePoint& point, const std::vector<View>& corrected,
                Eigen::Vector3d* position) {
    std::vector<PointPixel> pixels = point.pixels;
    std::erase_if(pixels, [&](const PointPixel& pixel) {
      return !FootprintIn(corrected[pixel.view], *position);
    });
    if (pixels.size() < 2 || !HasParallax(views_, pixels, point.position_in_world)) return;
    for (const PointPixel& pixel : pixels) {
      const View& view = views_[pixel.view];
      problem_.AddResidualBlock(
          MakePointCost(view, pixel), new ceres::CauchyLoss(kPointRobustSigmas), position->data(),
          corrections_->motion[pixel.view].data(), &corrections_->log_focal.at(view.camera_index));
      AddFootprint(pixel.view, *position);
    }
  }

  // Cameras without data are not unknowns.
  void AddCameraHolds() {
    int largest_side = 0;
    for (size_t v = 0; v < views_.size(); ++v) {
      if (footprints_[v].empty()) continue;
      const PinholeCamera& camera = views_[v].camera;
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

  // Resets points that have moved behind a view that sees them.
  void PutBackPointsBehind(const std::vector<View>& views_before,
                           const std::vector<Eigen::Vector3d>& points_before) {
    const std::vector<View> views = Corrected(views_, *corrections_);
    for (size_t p = 0; p < points_.size(); ++p) {
      const Eigen::Vector3d moved = (*positions_)[p];
      for (const PointPixel& pixel : points_[p].pixels) {
        if (FootprintIn(views_before[pixel.view], points_before[p]) &&
            !FootprintIn(views[pixel.view], moved)) {
          (*positions_)[p] = points_before[p];
        }
      }
    }
  }

  const std::vector<View>& views_;  // not corrected
  const std::vector<ScenePoint>& points_;
  CameraCorrections* corrections_;
  std::vector<Eigen::Vector3d>* positions_;
  std::vector<std::vector<double>> footprints_;  // per view, of what it shows
  ceres::Problem problem_;
};

}  // namespace

bool FitPoses(const std::vector<View>& views, const std::vector<ScenePoint>& points,
              const RefinementOptions& options, const RunContext& context,
              CameraCorrections* corrections, ControlGraph* control,
              std::vector<Eigen::Vector3d>* positions) {
  return PoseFit(views, points, corrections, positions).Run(options, context, control);
}

}  // namespace limn
