// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/rig_fit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include "colmap_ext/model/mounted_images.h"

namespace limn::colmap_ext {
namespace {

// Rotations take a few, unless they are far off; centers one or two.
constexpr int kMaxRigRounds = 50;
// Steps (rad, or relative to the positions) that change nothing.
constexpr double kRigTolerance = 1e-14;

Eigen::Vector3d RotationVector(const Eigen::Quaterniond& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

Eigen::Quaterniond RotationOf(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  if (angle == 0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, vector / angle));
}

// In the axes of the rig, what its frame and its sensor miss of the pose of an image is the sum of
// a step of the frame and one of the sensor: of turns to first order, of centers exactly. Works
// with centers, since a position in the world, unlike the translation of a pose, does not change
// when the rotation does.
class RigFit {
 public:
  RigFit(const std::set<size_t>& images, SparseModel* model) : model_(*model) {
    for (const MountedImage& at : MountedImages(model_)) {
      if (!images.contains(at.image)) continue;
      mounted_.push_back(at);
      world_from_image_.push_back(Inverse(model_.images[at.image].cam_from_world));
      world_from_rig_.emplace(at.frame, Inverse(model_.frames[at.frame].rig_from_world));
      rig_from_sensor_.emplace(SensorKey(at),
                               Inverse(model_.rigs[at.rig].sensors[at.sensor].sensor_from_rig));
    }
    BuildEquations();
  }

  void Fit() {
    if (mounted_.empty()) return;
    Repeat([this](size_t i) { return MissedTurn(i); },
           [](const Eigen::Vector3d& step, Rigid3d* frame) {
             frame->rotation = (frame->rotation * RotationOf(step)).normalized();
           },
           [](const Eigen::Vector3d& step, Rigid3d* sensor) {
             sensor->rotation = (RotationOf(step) * sensor->rotation).normalized();
           },
           1);
    double size = 0;
    for (const Rigid3d& image : world_from_image_) size = std::max(size, image.translation.norm());
    Repeat([this](size_t i) { return MissedShift(i); },
           [](const Eigen::Vector3d& step, Rigid3d* frame) {
             frame->translation += frame->rotation * step;
           },
           [](const Eigen::Vector3d& step, Rigid3d* sensor) { sensor->translation += step; }, size);
    Store();
  }

 private:
  using Key = std::pair<size_t, size_t>;  // rig and sensor

  static Key SensorKey(const MountedImage& at) { return {at.rig, at.sensor}; }

  // A row per image; a column per frame, then one per sensor that is sought.
  void BuildEquations() {
    std::map<size_t, int> column_of_frame;
    for (const auto& [frame, pose] : world_from_rig_) {
      column_of_frame.emplace(frame, static_cast<int>(column_of_frame.size()));
    }
    std::map<Key, int> column_of_sensor;
    for (const auto& [key, pose] : rig_from_sensor_) {
      if (key.second == 0) continue;  // the reference
      const size_t column = column_of_frame.size() + column_of_sensor.size();
      column_of_sensor.emplace(key, static_cast<int>(column));
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (size_t i = 0; i < mounted_.size(); ++i) {
      entries.emplace_back(i, column_of_frame.at(mounted_[i].frame), 1);
      const auto sensor = column_of_sensor.find(SensorKey(mounted_[i]));
      if (sensor != column_of_sensor.end()) entries.emplace_back(i, sensor->second, 1);
    }
    equations_.resize(static_cast<int>(mounted_.size()),
                      static_cast<int>(column_of_frame.size() + column_of_sensor.size()));
    equations_.setFromTriplets(entries.begin(), entries.end());
  }

  template <typename Missed, typename MoveFrame, typename MoveSensor>
  void Repeat(const Missed& missed, const MoveFrame& move_frame, const MoveSensor& move_sensor,
              double scale) {
    // From steps of 0, so that what no image tells stays: the place of sensors that are tied to
    // no reference relative to their frames.
    Eigen::LeastSquaresConjugateGradient<Eigen::SparseMatrix<double>> solver(equations_);
    for (int round = 0; round < kMaxRigRounds; ++round) {
      Eigen::MatrixX3d sums(equations_.rows(), 3);
      for (size_t i = 0; i < mounted_.size(); ++i) sums.row(i) = missed(i).transpose();
      const Eigen::MatrixX3d steps = solver.solve(sums);
      Eigen::Index column = 0;
      for (auto& [frame, pose] : world_from_rig_) move_frame(steps.row(column++), &pose);
      for (auto& [key, pose] : rig_from_sensor_) {
        if (key.second != 0) move_sensor(steps.row(column++), &pose);
      }
      if (steps.cwiseAbs().maxCoeff() <= kRigTolerance * scale) return;
    }
  }

  const Rigid3d& FrameOf(size_t i) const { return world_from_rig_.at(mounted_[i].frame); }
  const Rigid3d& SensorOf(size_t i) const { return rig_from_sensor_.at(SensorKey(mounted_[i])); }

  Eigen::Vector3d MissedTurn(size_t i) const {
    return RotationVector(FrameOf(i).rotation.conjugate() * world_from_image_[i].rotation *
                          SensorOf(i).rotation.conjugate());
  }
  Eigen::Vector3d MissedShift(size_t i) const {
    const Eigen::Vector3d in_world = world_from_image_[i].translation - FrameOf(i).translation;
    return FrameOf(i).rotation.conjugate() * in_world - SensorOf(i).translation;
  }

  void Store() {
    for (const auto& [frame, pose] : world_from_rig_) {
      model_.frames[frame].rig_from_world = Inverse(pose);
    }
    for (const auto& [key, pose] : rig_from_sensor_) {
      if (key.second == 0) continue;
      model_.rigs[key.first].sensors[key.second].sensor_from_rig = Inverse(pose);
    }
    for (const MountedImage& at : MountedImages(model_)) {
      model_.images[at.image].cam_from_world = ComposedPose(model_, at);
    }
  }

  SparseModel& model_;
  std::vector<MountedImage> mounted_;
  std::vector<Rigid3d> world_from_image_;  // of mounted_
  std::map<size_t, Rigid3d> world_from_rig_;
  std::map<Key, Rigid3d> rig_from_sensor_;
  Eigen::SparseMatrix<double> equations_;
};

}  // namespace

void FitRigs(const std::set<size_t>& images, SparseModel* model) { RigFit(images, model).Fit(); }

}  // namespace limn::colmap_ext
