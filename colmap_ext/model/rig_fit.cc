#include <cmath>

#include <Eigen/SVD>

#include "colmap_ext/model/model.h"
#include "colmap_ext/model/rig.h"

namespace limn::colmap_ext {
namespace {

// Rounds of frames and sensors in turn: one is enough if every sensor has an image in every frame.
constexpr int kMaxRigRounds = 200;
// Change of an entry of a rotation, or of a translation relative to the largest, that is none.
constexpr double kRigTolerance = 1e-14;

// The rotation nearest to a sum of rotations.
Eigen::Quaterniond NearestRotation(const Eigen::Matrix3d& sum) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) *= -1;
  return Eigen::Quaterniond(Eigen::Matrix3d(u * svd.matrixV().transpose())).normalized();
}

// One pose that is sought, with the images that tell it.
struct SoughtPose {
  Rigid3d* pose = nullptr;
  std::vector<size_t> mounted;  // indices
};

class RigFit {
 public:
  explicit RigFit(SparseModel* model) : model_(*model), mounted_(MountedImages(*model)) {
    std::vector<SoughtPose> frames(model_.frames.size());
    std::vector<std::vector<SoughtPose>> sensors(model_.rigs.size());
    for (size_t r = 0; r < sensors.size(); ++r) sensors[r].resize(model_.rigs[r].sensors.size());
    for (size_t i = 0; i < mounted_.size(); ++i) {
      const MountedImage& at = mounted_[i];
      Add(&model_.frames[at.frame].rig_from_world, i, &frames[at.frame]);
      if (at.sensor == 0) continue;  // the reference
      Add(&model_.rigs[at.rig].sensors[at.sensor].sensor_from_rig, i, &sensors[at.rig][at.sensor]);
    }
    Keep(frames, &frames_);
    for (const auto& of_rig : sensors) Keep(of_rig, &sensors_);
  }

  void Fit() {
    Repeat(&RigFit::TurnFrame, &RigFit::TurnSensor);
    Repeat(&RigFit::MoveFrame, &RigFit::MoveSensor);
    for (const MountedImage& at : mounted_) {
      model_.images[at.image].cam_from_world = ComposedPose(model_, at);
    }
  }

 private:
  // Gives a pose a better value; returns how much it changed.
  using Step = double (RigFit::*)(const SoughtPose&);

  static void Add(Rigid3d* pose, size_t mounted, SoughtPose* sought) {
    sought->pose = pose;
    sought->mounted.push_back(mounted);
  }
  static void Keep(const std::vector<SoughtPose>& sought, std::vector<SoughtPose>* kept) {
    for (const SoughtPose& pose : sought) {
      if (pose.pose) kept->push_back(pose);
    }
  }

  void Repeat(Step of_frame, Step of_sensor) {
    for (int round = 0; round < kMaxRigRounds; ++round) {
      double change = 0;
      for (const SoughtPose& frame : frames_) change = std::max(change, (this->*of_frame)(frame));
      for (const SoughtPose& sensor : sensors_) {
        change = std::max(change, (this->*of_sensor)(sensor));
      }
      if (change <= kRigTolerance) return;
    }
  }

  const Rigid3d& Image(size_t i) const { return model_.images[mounted_[i].image].cam_from_world; }
  const Rigid3d& Sensor(size_t i) const {
    return model_.rigs[mounted_[i].rig].sensors[mounted_[i].sensor].sensor_from_rig;
  }
  const Rigid3d& FrameOf(size_t i) const { return model_.frames[mounted_[i].frame].rig_from_world; }

  static double Turn(const Eigen::Matrix3d& sum, Rigid3d* pose) {
    const Eigen::Matrix3d before = pose->rotation.toRotationMatrix();
    pose->rotation = NearestRotation(sum);
    return (pose->rotation.toRotationMatrix() - before).cwiseAbs().maxCoeff();
  }
  double TurnFrame(const SoughtPose& frame) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const size_t i : frame.mounted) {
      sum += (Sensor(i).rotation.conjugate() * Image(i).rotation).toRotationMatrix();
    }
    return Turn(sum, frame.pose);
  }
  double TurnSensor(const SoughtPose& sensor) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const size_t i : sensor.mounted) {
      sum += (Image(i).rotation * FrameOf(i).rotation.conjugate()).toRotationMatrix();
    }
    return Turn(sum, sensor.pose);
  }

  static double Move(const SoughtPose& sought, const Eigen::Vector3d& sum) {
    const Eigen::Vector3d before = sought.pose->translation;
    sought.pose->translation = sum / static_cast<double>(sought.mounted.size());
    const double size = before.norm() + sought.pose->translation.norm();
    return size > 0 ? (sought.pose->translation - before).norm() / size : 0;
  }
  double MoveFrame(const SoughtPose& frame) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const size_t i : frame.mounted) {
      sum += Sensor(i).rotation.conjugate() * (Image(i).translation - Sensor(i).translation);
    }
    return Move(frame, sum);
  }
  double MoveSensor(const SoughtPose& sensor) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const size_t i : sensor.mounted) {
      sum += Image(i).translation - Sensor(i).rotation * FrameOf(i).translation;
    }
    return Move(sensor, sum);
  }

  SparseModel& model_;
  std::vector<MountedImage> mounted_;
  std::vector<SoughtPose> frames_, sensors_;
};

}  // namespace

void FitRigs(SparseModel* model) { RigFit(model).Fit(); }

}  // namespace limn::colmap_ext
