// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cameras/row_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "limn/cameras/camera_covariance.h"
#include "limn/cameras/pixel_by_point.h"
#include "limn/geometry/median_point.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// Standard deviations of what is held, px in the images.
constexpr double kMotionSigmaPx = 50;
constexpr double kLandmarkSigmaPx = 50;
constexpr int kNumReweightings = 10;
// Less does not determine 12 unknowns.
constexpr size_t kLeastDistances = 24;
constexpr int kLeastCurves = 4;
// Of rows that were exposed one after the other, if it matters (algorithm/cameras.md#rows).
constexpr double kEvidenceOfShutter = 8;
constexpr double kLeastSkewPx = 0.5;

using Vector12d = Eigen::Matrix<double, 12, 1>;
using Matrix12d = Eigen::Matrix<double, 12, 12>;

double Square(double x) { return x * x; }

// A landmark's line as the cameras are, and its derivatives.
struct SeenLine {
  const LandmarkLine* line;
  double distance_px;
  double weight;                // with that of the loss
  Eigen::Vector3d gradient;     // world
  Eigen::Vector3d by_landmark;  // per px along its ways
};

std::vector<SeenLine> SeenLines(const std::vector<View>& views, const Landmark& landmark) {
  std::vector<SeenLine> seen;
  for (const LandmarkLine& line : landmark.lines) {
    const auto distance = ResidualToEdgel(views[line.view], line.line, landmark.position);
    if (!distance) continue;
    Eigen::Vector3d by_landmark = Eigen::Vector3d::Zero();
    by_landmark.head(landmark.ways.cols()) = landmark.ways.transpose() * distance->gradient;
    const double weight = line.weight / (1 + Square(distance->residual_px / landmark.robust_px));
    seen.push_back({&line, distance->residual_px, weight, distance->gradient, by_landmark});
  }
  return seen;
}

// The distance of a landmark's image from its line, with the landmark where other views place it.
struct FreeDistance {
  int curve = -1;  // each landmark on none has a number of its own
  double px = 0;
  double weight = 0;  // 1 / px^2
  double robust_px = 0;
  Eigen::Vector3d place_in_camera = Eigen::Vector3d::Zero();
  Vector6d by_motion = Vector6d::Zero();  // of the camera: a turn about its axes, and a shift
  double row = 0;                         // of the image, -1/2 to 1/2
};

class FreeDistances {
 public:
  explicit FreeDistances(const std::vector<View>& views) : views_(views), of_view_(views.size()) {}

  void Add(const Landmark& landmark, int curve) {
    const std::vector<SeenLine> seen = SeenLines(views_, landmark);
    for (const SeenLine& line : seen) Add(landmark, curve, line, seen);
  }

  const std::vector<FreeDistance>& OfView(size_t view) const { return of_view_[view]; }

 private:
  void Add(const Landmark& landmark, int curve, const SeenLine& line,
           const std::vector<SeenLine>& seen) {
    const ViewId id = line.line->view;
    const View& view = views_[id];
    const auto stored_px = view.StoredFromVirtual(line.line->line.position_px);
    if (!stored_px) return;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Identity() / Square(kLandmarkSigmaPx);
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const SeenLine& other : seen) {
      if (other.line->view == id) continue;
      normal += other.weight * other.by_landmark * other.by_landmark.transpose();
      right -= other.weight * other.distance_px * other.by_landmark;
    }
    const Eigen::LLT<Eigen::Matrix3d> factor(normal);
    const double variance = line.by_landmark.dot(factor.solve(line.by_landmark));
    FreeDistance& distance = of_view_[id].emplace_back();
    distance.curve = curve;
    distance.px = line.distance_px + line.by_landmark.dot(factor.solve(right));
    distance.weight = 1 / (1 / line.line->weight + variance);
    // The noise of where the others place it counts, too.
    distance.robust_px = landmark.robust_px * std::sqrt(1 + line.line->weight * variance);
    distance.place_in_camera = view.cam_from_world * landmark.position;
    const Eigen::Vector3d gradient = view.cam_from_world.rotation * line.gradient;
    distance.by_motion << distance.place_in_camera.cross(gradient), gradient;
    distance.row = (stored_px->y() + 0.5) / view.camera.height - 0.5;
  }

  const std::vector<View>& views_;
  std::vector<std::vector<FreeDistance>> of_view_;
};

FreeDistances MakeDistances(const std::vector<View>& views,
                            const std::vector<Landmark>& landmarks) {
  FreeDistances distances(views);
  for (size_t l = 0; l < landmarks.size(); ++l) {
    const int curve = landmarks[l].curve;
    distances.Add(landmarks[l], curve >= 0 ? curve : -1 - static_cast<int>(l));
  }
  return distances;
}

// Calls visit() with ranges of distances of one curve.
template <typename Visit>
void ForCurves(const std::vector<FreeDistance>& distances, const Visit& visit) {
  for (size_t begin = 0, end = 0; begin < distances.size(); begin = end) {
    while (end < distances.size() && distances[end].curve == distances[begin].curve) ++end;
    visit(begin, end);
  }
}

// The fit of one view: the mean motion, then that from the first to the last row.
class SkewFit {
 public:
  SkewFit(const PinholeCamera& camera, const std::vector<FreeDistance>& distances)
      : camera_(camera), distances_(distances) {
    std::vector<Eigen::Vector3d> places;
    for (const FreeDistance& distance : distances) places.push_back(distance.place_in_camera);
    middle_ = MedianPoint(places);
    const double per_turn = camera.MeanFocal() / kMotionSigmaPx;
    Vector6d per_sigma;
    per_sigma << Eigen::Vector3d::Constant(per_turn),
        Eigen::Vector3d::Constant(per_turn / middle_.z());
    per_sigma_ << per_sigma, per_sigma;
  }

  ViewSkew Run() {
    for (int i = 0; i < kNumReweightings; ++i) {
      const Equations equations = Linearize();
      motion_ -= equations.normal.llt().solve(equations.gradient);
    }
    return Skew(Linearize());
  }

 private:
  struct Equations {
    Matrix12d normal;
    Vector12d gradient;
    CurveScatter scatter;
  };

  Equations Linearize() const {
    const Vector12d holds = per_sigma_.cwiseAbs2();
    Equations equations = {
        holds.asDiagonal(), holds.cwiseProduct(motion_), {Eigen::MatrixXd::Zero(12, 12), 0}};
    ForCurves(distances_, [&](size_t begin, size_t end) {
      Vector12d gradient = Vector12d::Zero();
      for (size_t i = begin; i < end; ++i) AddDistance(distances_[i], &equations.normal, &gradient);
      equations.gradient += gradient;
      equations.scatter.sum += gradient * gradient.transpose();
      ++equations.scatter.num_curves;
    });
    return equations;
  }

  void AddDistance(const FreeDistance& distance, Matrix12d* normal, Vector12d* gradient) const {
    Vector12d row;
    row << distance.by_motion, distance.row * distance.by_motion;
    const double px = distance.px + row.dot(motion_);
    const double weight = distance.weight / (1 + Square(px / distance.robust_px));
    *normal += weight * row * row.transpose();
    *gradient += weight * px * row;
  }

  ViewSkew Skew(const Equations& equations) const {
    const Eigen::Matrix<double, 2, 3> by_point = PixelByPoint(camera_, middle_);
    Eigen::Matrix<double, 2, 12> by_motion = Eigen::Matrix<double, 2, 12>::Zero();
    // A turn t moves the point by t x point.
    by_motion.middleCols<3>(6) = by_point * Eigen::Matrix3d::Identity().colwise().cross(middle_);
    by_motion.rightCols<3>() = by_point;
    const Eigen::LLT<Eigen::MatrixXd, Eigen::Upper> normal(equations.normal);
    const Eigen::MatrixXd project = normal.solve(by_motion.transpose()).transpose();
    const Eigen::Matrix2d covariance =
        project * CovarianceOfGradient(equations.scatter, per_sigma_.cwiseAbs2(), normal) *
        project.transpose();
    const Eigen::Vector2d skew_px = by_motion * motion_;
    return {skew_px.norm(), std::sqrt(covariance.trace() / 2),
            skew_px.dot(covariance.llt().solve(skew_px)) / 2};
  }

  const PinholeCamera& camera_;
  const std::vector<FreeDistance>& distances_;
  Eigen::Vector3d middle_;
  Vector12d per_sigma_;
  Vector12d motion_ = Vector12d::Zero();
};

// Not known without enough data.
ViewSkew SkewOf(const PinholeCamera& camera, const std::vector<FreeDistance>& distances) {
  int num_curves = 0;
  ForCurves(distances, [&](size_t, size_t) { ++num_curves; });
  if (distances.size() < kLeastDistances || num_curves < kLeastCurves) return {};
  const ViewSkew skew = SkewFit(camera, distances).Run();
  return std::isfinite(skew.evidence) ? skew : ViewSkew();
}

void Summarize(RowMotion* motion) {
  std::vector<double> squares;
  double evidence = 0;
  for (const ViewSkew& skew : motion->of_view) {
    if (!(skew.sigma_px > 0)) continue;
    squares.push_back(Square(skew.px) - 2 * Square(skew.sigma_px));
    evidence += skew.evidence;
  }
  if (squares.empty()) return;
  motion->evidence = evidence / static_cast<double>(squares.size());
  motion->skew_px = std::sqrt(std::max(0.0, Median(std::move(squares))));
}

}  // namespace

bool RowMotion::IsRollingShutter() const {
  return evidence > kEvidenceOfShutter && skew_px > kLeastSkewPx;
}

RowMotion MeasureRowMotion(const std::vector<View>& views, const std::vector<Landmark>& landmarks,
                           const RunContext& context) {
  const FreeDistances distances = MakeDistances(views, landmarks);
  RowMotion motion;
  motion.of_view.resize(views.size());
  ParallelFor(context, "cameras", views.size(),
              [&](size_t v) { motion.of_view[v] = SkewOf(views[v].camera, distances.OfView(v)); });
  Summarize(&motion);
  return motion;
}

}  // namespace limn
