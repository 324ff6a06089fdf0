// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cameras/gauge.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "limn/util/median.h"

namespace limn {

namespace {

// With three cameras, any two would be a majority.
constexpr size_t kMinCamerasForMajority = 4;
// Pairs of cameras that are tried as those that did not move.
constexpr size_t kMaxPairs = 500;
// A camera was moved far if by more than this, and this many times as far as the median.
constexpr double kMinFarMovePx = 2;
constexpr double kFarMoveOfMedian = 5;

// Places of some cameras.
struct Cameras {
  Eigen::Matrix3Xd centers;
  std::vector<Eigen::Matrix3d> world_from_cam;
};

Cameras CamerasOf(const std::vector<View>& views) {
  Cameras cameras{Eigen::Matrix3Xd(3, views.size()), {}};
  for (size_t v = 0; v < views.size(); ++v) {
    const Rigid3d world_from_cam = Inverse(views[v].cam_from_world);
    cameras.centers.col(v) = world_from_cam.translation;
    cameras.world_from_cam.push_back(world_from_cam.rotation.toRotationMatrix());
  }
  return cameras;
}

// Root of the sum of squared distances from the mean.
double Spread(const Eigen::Matrix3Xd& points) {
  return (points.colwise() - points.rowwise().mean()).norm();
}

// The center of every camera and the points one arm along its axes.
Eigen::Matrix3Xd CentersAndArms(const Cameras& cameras, const std::vector<int>& ids,
                                const Eigen::RowVectorXd& arms) {
  Eigen::Matrix3Xd points(3, 4 * ids.size());
  for (size_t i = 0; i < ids.size(); ++i) {
    auto of_view = points.middleCols<4>(4 * i);
    of_view << Eigen::Vector3d::Zero(), arms[ids[i]] * cameras.world_from_cam[ids[i]];
    of_view.colwise() += cameras.centers.col(ids[i]);
  }
  return points;
}

// Whether centers are one, for views of a scene at these distances.
bool Coincide(const Eigen::Matrix3Xd& centers, const Eigen::RowVectorXd& arms) {
  return Spread(centers) <= 1e-6 * arms.mean();
}

// Finds the similarity. Arms are the distances of the given cameras from the middle of the scene.
class GaugeFinder {
 public:
  GaugeFinder(const std::vector<View>& given, const std::vector<View>& refined,
              const Eigen::Vector3d& middle, const std::vector<ViewId>& held)
      : given_(CamerasOf(given)),
        refined_(CamerasOf(refined)),
        arms_((given_.centers.colwise() - middle).colwise().norm()),
        all_(given.size()),
        held_(held) {
    std::iota(all_.begin(), all_.end(), 0);
    std::ranges::copy_if(all_, std::back_inserter(free_),
                         [&](int v) { return std::ranges::count(held, v) == 0; });
    if (free_.empty()) free_ = all_;
    for (const View& view : given) focals_.push_back(view.camera.MeanFocal());
  }

  Gauge Find() const {
    const std::vector<int> still = all_.size() < kMinCamerasForMajority ? all_ : StillCameras();
    Gauge gauge;
    gauge.given_from_refined = BestFor(still);
    gauge.moves_px = MovesPx(gauge.given_from_refined);
    gauge.typical_move_px = MedianOfFree(gauge.moves_px);
    for (const int v : all_) {
      if (!std::ranges::binary_search(still, v)) gauge.moved_far.push_back({v, gauge.moves_px[v]});
    }
    return gauge;
  }

 private:
  Eigen::Affine3d BestFor(const std::vector<int>& ids) const {
    return held_.empty() ? LeastSquares(ids) : ScaleAboutHeld(ids);
  }

  // That leaves the held cameras where they are.
  Eigen::Affine3d ScaleAboutHeld(const std::vector<int>& ids) const {
    const Eigen::Matrix3Xd held = given_.centers(Eigen::all, held_);
    if (!Coincide(held, arms_(held_))) return Eigen::Affine3d::Identity();
    const Eigen::Vector3d center = held.rowwise().mean();
    const Eigen::Matrix3Xd from = refined_.centers(Eigen::all, ids).colwise() - center;
    const Eigen::Matrix3Xd to = given_.centers(Eigen::all, ids).colwise() - center;
    const double scale = from.cwiseProduct(to).sum() / from.squaredNorm();
    if (!std::isfinite(scale) || scale <= 0) return Eigen::Affine3d::Identity();
    return Eigen::Translation3d(center) * Eigen::Scaling(scale) * Eigen::Translation3d(-center);
  }

  Eigen::Affine3d LeastSquares(const std::vector<int>& ids) const {
    const Eigen::Matrix3Xd centers = given_.centers(Eigen::all, ids);
    // Coinciding centers determine no scale.
    const double scale = Coincide(centers, arms_(ids))
                             ? 1
                             : Spread(refined_.centers(Eigen::all, ids)) / Spread(centers);
    const Eigen::Matrix4d similarity = Eigen::umeyama(CentersAndArms(refined_, ids, scale * arms_),
                                                      CentersAndArms(given_, ids, arms_), true);
    return similarity.allFinite() ? Eigen::Affine3d(similarity) : Eigen::Affine3d::Identity();
  }

  // Held cameras do not move at all.
  double MedianOfFree(const std::vector<double>& moves) const {
    std::vector<double> of_free;
    for (const int v : free_) of_free.push_back(moves[v]);
    return Median(std::move(of_free));
  }

  // Per camera, how far it is from the given one after the similarity, px in the image of the
  // scene.
  std::vector<double> MovesPx(const Eigen::Affine3d& similarity) const {
    const double scale = std::cbrt(similarity.linear().determinant());
    const Eigen::Matrix3Xd refined = similarity * CentersAndArms(refined_, all_, arms_ / scale);
    const Eigen::Matrix3Xd shifts = refined - CentersAndArms(given_, all_, arms_);
    std::vector<double> moves;
    for (const int v : all_) {
      moves.push_back(focals_[v] / arms_[v] * shifts.middleCols<4>(4 * v).norm() / 2);
    }
    return moves;
  }

  // The cameras, ascending, that most others agree with: least median over pairs, then improved.
  std::vector<int> StillCameras() const {
    std::vector<double> best;
    const size_t count = all_.size();
    const size_t stride = (count + kMaxPairs - 1) / kMaxPairs;
    for (size_t i = 0; i < count; i += stride) {
      const int other = static_cast<int>((i + count / 2) % count);
      std::vector<double> moves = MovesPx(BestFor({static_cast<int>(i), other}));
      if (best.empty() || MedianOfFree(moves) < MedianOfFree(best)) best = std::move(moves);
    }
    std::vector<int> majority = all_;
    const auto middle = majority.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::ranges::nth_element(majority, middle, {}, [&](int v) { return best[v]; });
    majority.erase(middle + 1, majority.end());
    const std::vector<double> moves = MovesPx(BestFor(majority));
    const double far = std::max(kMinFarMovePx, kFarMoveOfMedian * MedianOfFree(moves));
    std::vector<int> still = all_;
    std::erase_if(still, [&](int v) { return moves[v] > far; });
    return still;
  }

  Cameras given_;
  Cameras refined_;
  Eigen::RowVectorXd arms_;
  std::vector<double> focals_;
  std::vector<int> all_;
  std::vector<int> free_;  // not held, unless all are
  std::vector<ViewId> held_;
};

}  // namespace

Gauge FindGauge(const std::vector<View>& given, const std::vector<View>& refined,
                const Eigen::Vector3d& middle, const std::vector<ViewId>& held) {
  return GaugeFinder(given, refined, middle, held).Find();
}

std::vector<View> Moved(const std::vector<View>& views, const Eigen::Affine3d& similarity) {
  const double scale = std::cbrt(similarity.linear().determinant());
  const Eigen::Quaterniond turn(Eigen::Matrix3d(similarity.linear() / scale));
  std::vector<View> moved = views;
  for (View& view : moved) {
    const Eigen::Vector3d center = similarity * view.CenterInWorld();
    view.cam_from_world.rotation = (view.cam_from_world.rotation * turn.conjugate()).normalized();
    view.cam_from_world.translation = -(view.cam_from_world.rotation * center);
  }
  return moved;
}

std::vector<View> InGivenFrame(const std::vector<View>& given, const std::vector<View>& refined,
                               const Gauge& gauge, const std::vector<ViewId>& held) {
  std::vector<View> views = Moved(refined, gauge.given_from_refined);
  for (const ViewId view : held) views[view].cam_from_world = given[view].cam_from_world;
  return views;
}

}  // namespace limn
