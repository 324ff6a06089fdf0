#include "limn/refinement/pose_fit.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <ceres/ceres.h>
#include <ceres/normal_prior.h>
#include <ceres/rotation.h>

#include "limn/model/footprint.h"
#include "limn/refinement/curve_terms.h"
#include "limn/refinement/stop_if_cancelled.h"
#include "limn/support/edgel_residual.h"
#include "limn/util/errors.h"
#include "limn/util/median.h"

namespace limn {
namespace {

constexpr int kMaxIterations = 10;
constexpr double kPointSigmaPx = 0.5;
constexpr double kPointRobustSigmas = 2;
// Standard deviation of a camera's change, px in the image of the scene.
constexpr double kCameraSigmaPx = 10;
// Residual of what is behind a camera, stored px: no way to get rid of a residual.
constexpr double kBehindPx = 1e3;
// The rays to a scene point must differ so much from their mean.
constexpr double kMinHalfParallaxDeg = 0.5;

template <typename T>
using Vector2 = Eigen::Matrix<T, 2, 1>;
template <typename T>
using Vector3 = Eigen::Matrix<T, 3, 1>;

// A projection by a corrected camera, differentiable. False behind the camera.
template <typename T>
bool ProjectCorrected(const View& view, const Vector3<T>& point, const T* motion,
                      const T* log_focal, Vector2<T>* pixel) {
  const Vector3<T> given =
      view.cam_from_world.rotation.cast<T>() * point + view.cam_from_world.translation.cast<T>();
  Vector3<T> in_cam;
  ceres::AngleAxisRotatePoint(motion, given.data(), in_cam.data());
  in_cam += Eigen::Map<const Vector3<T>>(motion + 3);
  if (!(in_cam.z() > T(0))) return false;
  const T factor = exp(*log_focal);
  const PinholeCamera& camera = view.camera;
  *pixel = {camera.fx * factor * in_cam.x() / in_cam.z() + camera.cx,
            camera.fy * factor * in_cam.y() / in_cam.z() + camera.cy};
  return true;
}

// Distance across an edgel, stored px, of a place on a segment.
struct PullResidual {
  const View* view;
  EdgelLine line;
  double t;

  template <typename T>
  bool operator()(const T* from, const T* to, const T* motion, const T* log_focal,
                  T* residual) const {
    const Vector3<T> point =
        T(1 - t) * Eigen::Map<const Vector3<T>>(from) + T(t) * Eigen::Map<const Vector3<T>>(to);
    Vector2<T> pixel;
    if (!ProjectCorrected(*view, point, motion, log_focal, &pixel)) {
      *residual = T(kBehindPx);
      return true;
    }
    *residual = line.across.x() * (pixel.x() - line.position_px.x()) +
                line.across.y() * (pixel.y() - line.position_px.y());
    return true;
  }
};

struct PointResidual {
  const View* view;
  const PointPixel* observed;

  template <typename T>
  bool operator()(const T* point, const T* motion, const T* log_focal, T* residual) const {
    Vector2<T> pixel;
    if (!ProjectCorrected(*view, Vector3<T>(Eigen::Map<const Vector3<T>>(point)), motion, log_focal,
                          &pixel)) {
      residual[0] = residual[1] = T(kBehindPx / kPointSigmaPx);
      return true;
    }
    const Eigen::Matrix2d factor = observed->stored_from_virtual / kPointSigmaPx;
    const Vector2<T> offset = pixel - observed->position_px.cast<T>();
    Eigen::Map<Vector2<T>> weighted(residual);
    weighted = factor.cast<T>() * offset;
    return true;
  }
};

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
  PoseProblem(const PoseFitInput& input, const RefinementOptions& options,
              CameraCorrections* corrections, ControlGraph* control,
              std::vector<Eigen::Vector3d>* positions)
      : input_(input),
        options_(options),
        corrections_(corrections),
        control_(control),
        positions_(positions),
        views_(Corrected(input.views, *corrections)),
        footprints_(input.views.size()) {
    AddCurves();
    AddPoints();
    AddCameraHolds();
  }

  // False, and nothing changed, if there is no usable solution.
  bool Solve(const RunContext& context) {
    const std::vector<Eigen::Vector3d> before = *positions_;
    ceres::Solver::Options solver;
    solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    // Without BLAS and threads: the same bits whatever runs beside it.
    solver.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
    solver.num_threads = 1;
    solver.max_num_iterations = kMaxIterations;
    solver.function_tolerance = 1e-5;
    // These two know units of length.
    solver.parameter_tolerance = 0;
    solver.gradient_tolerance = 0;
    solver.logging_type = ceres::SILENT;
    StopIfCancelled stop(context);
    solver.callbacks = {&stop};
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem_, &summary);
    if (summary.termination_type == ceres::USER_FAILURE) throw Cancelled();
    if (!summary.IsSolutionUsable()) return false;
    PutBackPointsBehind(before);
    return true;
  }

 private:
  double* Position(int point) { return control_->position[point].data(); }
  double* Motion(ViewId view) { return corrections_->motion[view].data(); }
  double* LogFocal(ViewId view) {
    return &corrections_->log_focal[corrections_->camera_of_view[view]];
  }

  void AddCurves() {
    std::vector<uint8_t> unknown(control_->position.size(), 0);
    for (size_t l = 0; l < control_->links.size(); ++l) {
      if (input_.frozen[l]) continue;
      for (const int point : control_->links[l].points) unknown[point] = 1;
      AddPulls(control_->links[l], input_.matches[l]);
    }
    for (size_t p = 0; p < unknown.size(); ++p) {
      if (unknown[p]) AddHold(static_cast<int>(p), control_, &problem_);
    }
    for (const auto& bend : control_->bends) {
      const bool fitted = unknown[bend[0]] && unknown[bend[1]] && unknown[bend[2]];
      if (fitted) AddBend(bend, options_, control_, &problem_);
    }
  }

  void AddPulls(const ControlLink& link, const LinkMatches& matches) {
    for (const LinkSample& sample : matches) {
      const int from = link.points[sample.segment];
      const int to = link.points[sample.segment + 1];
      const Eigen::Vector3d sample_point =
          (1 - sample.t) * control_->position[from] + sample.t * control_->position[to];
      for (const EdgelPull& pull : sample.pulls) {
        const Edgel& edgel = input_.curves[pull.ref.view].edge_map.edgels[pull.ref.edgel];
        const View& view = input_.views[pull.ref.view];
        if (!IsInFront(views_[pull.ref.view], sample_point)) continue;
        problem_.AddResidualBlock(
            new ceres::AutoDiffCostFunction<PullResidual, 1, 3, 3, 6, 1>(
                new PullResidual{&view, edgel, sample.t}),
            new ceres::ScaledLoss(new ceres::CauchyLoss(input_.robust_px),
                                  pull.weight / ResidualVariance(edgel), ceres::TAKE_OWNERSHIP),
            Position(from), Position(to), Motion(pull.ref.view), LogFocal(pull.ref.view));
        AddFootprint(pull.ref.view, control_->position[from]);
      }
    }
  }

  void AddPoints() {
    for (size_t p = 0; p < input_.points.size(); ++p) {
      std::vector<const PointPixel*> pixels;
      for (const PointPixel& pixel : input_.points[p].pixels) {
        if (IsInFront(views_[pixel.view], (*positions_)[p])) pixels.push_back(&pixel);
      }
      if (pixels.size() < 2) continue;
      if (!HasParallax(input_.views, pixels, input_.points[p].position_in_world)) continue;
      for (const PointPixel* pixel : pixels) {
        problem_.AddResidualBlock(new ceres::AutoDiffCostFunction<PointResidual, 2, 3, 6, 1>(
                                      new PointResidual{&input_.views[pixel->view], pixel}),
                                  new ceres::CauchyLoss(kPointRobustSigmas),
                                  (*positions_)[p].data(), Motion(pixel->view),
                                  LogFocal(pixel->view));
        AddFootprint(pixel->view, (*positions_)[p]);
      }
    }
  }

  // Points that went behind a view that sees them.
  void PutBackPointsBehind(const std::vector<Eigen::Vector3d>& before) {
    const std::vector<View> views = Corrected(input_.views, *corrections_);
    for (size_t p = 0; p < before.size(); ++p) {
      const std::vector<PointPixel>& pixels = input_.points[p].pixels;
      const bool went_behind =
          std::any_of(pixels.begin(), pixels.end(), [&](const PointPixel& pixel) {
            return IsInFront(views_[pixel.view], before[p]) &&
                   !IsInFront(views[pixel.view], (*positions_)[p]);
          });
      if (went_behind) (*positions_)[p] = before[p];
    }
  }

  // Cameras that nothing is known of are no unknowns.
  void AddCameraHolds() {
    double largest_side = 0;
    for (size_t v = 0; v < input_.views.size(); ++v) {
      if (footprints_[v].empty()) continue;
      const PinholeCamera& camera = input_.views[v].camera;
      const double rotation = camera.MeanFocal() / kCameraSigmaPx;
      const double translation = 1 / (kCameraSigmaPx * Median(footprints_[v]));
      ceres::Vector factors(6);
      factors << rotation, rotation, rotation, translation, translation, translation;
      problem_.AddResidualBlock(
          new ceres::NormalPrior(factors.asDiagonal(), ceres::Vector::Zero(6)), nullptr,
          Motion(static_cast<ViewId>(v)));
      largest_side = std::max<double>(
          {largest_side, static_cast<double>(camera.width), static_cast<double>(camera.height)});
    }
    for (double& log_focal : corrections_->log_focal) {
      if (!problem_.HasParameterBlock(&log_focal)) continue;
      const double factor = 0.5 * largest_side / kCameraSigmaPx;
      problem_.AddResidualBlock(
          new ceres::NormalPrior(ceres::Matrix::Constant(1, 1, factor), ceres::Vector::Zero(1)),
          nullptr, &log_focal);
    }
  }

  void AddFootprint(ViewId view, const Eigen::Vector3d& point) {
    if (const auto footprint = FootprintIn(input_.views[view], point)) {
      footprints_[view].push_back(*footprint);
    }
  }

  const PoseFitInput& input_;
  const RefinementOptions& options_;
  CameraCorrections* corrections_;
  ControlGraph* control_;
  std::vector<Eigen::Vector3d>* positions_;
  std::vector<View> views_;                      // as corrected at the start
  std::vector<std::vector<double>> footprints_;  // per view, of what it shows
  ceres::Problem problem_;
};

}  // namespace

CameraCorrections NoCorrections(const std::vector<View>& views) {
  CameraCorrections corrections;
  corrections.motion.resize(views.size(), {0, 0, 0, 0, 0, 0});
  std::map<int, int> place;
  for (const View& view : views) {
    const auto [it, is_new] = place.emplace(view.camera_index, static_cast<int>(place.size()));
    corrections.camera_of_view.push_back(it->second);
  }
  corrections.log_focal.assign(place.size(), 0);
  return corrections;
}

std::vector<View> Corrected(const std::vector<View>& views, const CameraCorrections& corrections) {
  std::vector<View> corrected = views;
  for (size_t v = 0; v < views.size(); ++v) {
    const Eigen::Map<const Eigen::Matrix<double, 6, 1>> motion(corrections.motion[v].data());
    const double angle = motion.head<3>().norm();
    Rigid3d change;
    if (angle > 0) {
      change.rotation = Eigen::AngleAxisd(angle, Eigen::Vector3d(motion.head<3>() / angle));
    }
    change.translation = motion.tail<3>();
    View& view = corrected[v];
    view.cam_from_world = change * view.cam_from_world;
    view.cam_from_world.rotation.normalize();
    const double factor = std::exp(corrections.log_focal[corrections.camera_of_view[v]]);
    view.camera.fx *= factor;
    view.camera.fy *= factor;
  }
  return corrected;
}

bool FitPoses(const PoseFitInput& input, const RefinementOptions& options,
              const RunContext& context, CameraCorrections* corrections, ControlGraph* control,
              std::vector<Eigen::Vector3d>* positions) {
  const std::vector<Eigen::Vector3d> before = control->position;
  PoseProblem problem(input, options, corrections, control, positions);
  if (!problem.Solve(context)) return false;
  FollowNodes(input.frozen, before, control);
  UpdateTangents(control);
  return true;
}

}  // namespace limn
