#include "limn/drawing/curve_smoothing.h"

#include <algorithm>
#include <cmath>

#include "limn/geometry/banded_cholesky.h"

namespace limn {
namespace {

// Standard deviation of a sample's place along the curve, px, and of its place at all.
constexpr double kAlongSigmaPx = 0.5;
constexpr double kWeakSigmaPx = 300;
constexpr double kFixedSigmaPx = 1e-3;
// Smallest spacing assumed between neighbors, px: the change of direction diverges as it goes to 0.
constexpr double kMinSpacingPx = 0.2;
// Samples of a closed curve that are repeated beyond its ends.
constexpr int kClosedOverlap = 20;

class Smoother {
 public:
  Smoother(const SmoothingInput& input, double bending_sigma_px)
      : input_(input),
        bending_sigma_px_(bending_sigma_px),
        size_(static_cast<int>(input.position.size())),
        extra_(input.closed ? std::min(kClosedOverlap, size_) : 0),
        count_(size_ + 2 * extra_),
        system_(3 * count_, 8) {}

  std::vector<Eigen::Vector3d> Run(bool fixed_ends) {
    for (int k = 0; k < count_; ++k) AddData(k, fixed_ends && (k == 0 || k + 1 == count_));
    for (int k = 1; k + 1 < count_; ++k) AddBending(k);
    std::vector<Eigen::Vector3d> smooth = input_.position;
    // Only numerical overflow makes the system indefinite; the samples then stay.
    if (!system_.Solve()) return smooth;
    for (int s = 0; s < size_; ++s) {
      for (int axis = 0; axis < 3; ++axis)
        smooth[s][axis] += system_.Right(3 * (s + extra_) + axis);
    }
    return smooth;
  }

 private:
  // Unknown k is the displacement of sample Source(k).
  int Source(int k) const { return ((k - extra_) % size_ + size_) % size_; }

  void AddData(int k, bool fixed) {
    const int s = Source(k);
    const double footprint = input_.footprint[s];
    const Eigen::Vector3d& tangent = input_.tangent[s];
    Eigen::Matrix3d weight =
        input_.information[s] +
        tangent * tangent.transpose() / std::pow(kAlongSigmaPx * footprint, 2) +
        Eigen::Matrix3d::Identity() / std::pow(kWeakSigmaPx * footprint, 2);
    if (fixed) weight += Eigen::Matrix3d::Identity() / std::pow(kFixedSigmaPx * footprint, 2);
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b <= a; ++b) system_.Add(3 * k + a, 3 * k + b, weight(a, b));
    }
  }

  void AddBending(int k) {
    const int at = Source(k);
    const double footprint = input_.footprint[at];
    const Eigen::Vector3d first = input_.position[at] - input_.position[Source(k - 1)];
    const Eigen::Vector3d second = input_.position[Source(k + 1)] - input_.position[at];
    const double h0 = std::max(first.norm() / footprint, kMinSpacingPx);
    const double h1 = std::max(second.norm() / footprint, kMinSpacingPx);
    const double coefficient[3] = {1 / h0, -1 / h0 - 1 / h1, 1 / h1};
    const Eigen::Vector3d bend = second / h1 - first / h0;
    const double weight = 1 / std::pow(bending_sigma_px_ * footprint, 2);
    for (int a = 0; a < 3; ++a) {
      for (int axis = 0; axis < 3; ++axis) {
        const int row = 3 * (k - 1 + a) + axis;
        for (int b = 0; b <= a; ++b) {
          system_.Add(row, 3 * (k - 1 + b) + axis, weight * coefficient[a] * coefficient[b]);
        }
        system_.Right(row) -= weight * coefficient[a] * bend[axis];
      }
    }
  }

  const SmoothingInput& input_;
  double bending_sigma_px_;
  int size_;
  int extra_;
  int count_;
  BandedSystem system_;
};

}  // namespace

std::vector<Eigen::Vector3d> SmoothCurve(const SmoothingInput& input, double bending_sigma_px,
                                         bool fixed_ends) {
  if (input.position.size() < 3) return input.position;
  return Smoother(input, bending_sigma_px).Run(fixed_ends);
}

}  // namespace limn
