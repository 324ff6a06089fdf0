#include <algorithm>
#include <cmath>

#include <Eigen/SVD>

#include "colmap_ext/model/model.h"
#include "colmap_ext/model/rig.h"

namespace limn::colmap_ext {
namespace {

// Rounds of frames and sensors in turn: one is enough if every sensor has an image in every frame.
constexpr int kMaxRigRounds = 200;
// Change of an entry of a rotation, or of a position relative to the farthest, that is none.
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

// Works with centers: a position in the world, unlike the translation of a pose, does not change
// when its rotation does.
class RigFit {
 public:
  RigFit(const std::set<size_t>& images, SparseModel* model) : model_(*model) {
    for (const MountedImage& at : MountedImages(model_)) {
      if (!images.contains(at.image)) continue;
      mounted_.push_back(at);
      world_from_image_.push_back(Inverse(model_.images[at.image].cam_from_world));
    }
    for (const Frame& frame : model_.frames) {
      world_from_rig_.push_back(Inverse(frame.rig_from_world));
    }
    for (const Rig& rig : model_.rigs) {
      rig_from_sensor_.emplace_back();
      for (const RigSensor& sensor : rig.sensors) {
        rig_from_sensor_.back().push_back(Inverse(sensor.sensor_from_rig));
      }
    }
    FindSought();
  }

  void Fit() {
    Repeat(&RigFit::TurnFrame, &RigFit::TurnSensor, kRigTolerance);
    const Eigen::Vector3d origin = MoveToOrigin();
    double size = 0;
    for (const Rigid3d& image : world_from_image_) size = std::max(size, image.translation.norm());
    Repeat(&RigFit::MoveFrame, &RigFit::MoveSensor, kRigTolerance * size);
    for (const SoughtPose& frame : frames_) frame.pose->translation += origin;
    StoreFit();
  }

 private:
  // Gives a pose a better value; returns how much it changed.
  using Step = double (RigFit::*)(const SoughtPose&);

  void FindSought() {
    std::vector<SoughtPose> frames(model_.frames.size());
    std::vector<std::vector<SoughtPose>> sensors(model_.rigs.size());
    for (size_t r = 0; r < sensors.size(); ++r) sensors[r].resize(model_.rigs[r].sensors.size());
    for (size_t i = 0; i < mounted_.size(); ++i) {
      const MountedImage& at = mounted_[i];
      Add(&world_from_rig_[at.frame], i, &frames[at.frame]);
      if (at.sensor == 0) continue;  // the reference
      Add(&rig_from_sensor_[at.rig][at.sensor], i, &sensors[at.rig][at.sensor]);
    }
    Keep(frames, &frames_);
    for (const auto& of_rig : sensors) Keep(of_rig, &sensors_);
  }

  static void Add(Rigid3d* pose, size_t mounted, SoughtPose* sought) {
    sought->pose = pose;
    sought->mounted.push_back(mounted);
  }
  static void Keep(const std::vector<SoughtPose>& sought, std::vector<SoughtPose>* kept) {
    for (const SoughtPose& pose : sought) {
      if (pose.pose) kept->push_back(pose);
    }
  }

  void Repeat(Step of_frame, Step of_sensor, double tolerance) {
    for (int round = 0; round < kMaxRigRounds; ++round) {
      double change = 0;
      for (const SoughtPose& frame : frames_) change = std::max(change, (this->*of_frame)(frame));
      for (const SoughtPose& sensor : sensors_) {
        change = std::max(change, (this->*of_sensor)(sensor));
      }
      if (change <= tolerance) return;
    }
  }

  const Rigid3d& Image(size_t i) const { return world_from_image_[i]; }
  const Rigid3d& Sensor(size_t i) const {
    return rig_from_sensor_[mounted_[i].rig][mounted_[i].sensor];
  }
  const Rigid3d& FrameOf(size_t i) const { return world_from_rig_[mounted_[i].frame]; }

  // Far from the origin of the world digits would be lost. Returns where the new one is.
  Eigen::Vector3d MoveToOrigin() {
    if (mounted_.empty()) return Eigen::Vector3d::Zero();
    const Eigen::Vector3d origin = world_from_image_.front().translation;
    for (Rigid3d& image : world_from_image_) image.translation -= origin;
    for (const SoughtPose& frame : frames_) frame.pose->translation -= origin;
    return origin;
  }

  static double Turn(const Eigen::Matrix3d& sum, Rigid3d* pose) {
    const Eigen::Matrix3d before = pose->rotation.toRotationMatrix();
    pose->rotation = NearestRotation(sum);
    return (pose->rotation.toRotationMatrix() - before).cwiseAbs().maxCoeff();
  }
  double TurnFrame(const SoughtPose& frame) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const size_t i : frame.mounted) {
      sum += (Image(i).rotation * Sensor(i).rotation.conjugate()).toRotationMatrix();
    }
    return Turn(sum, frame.pose);
  }
  double TurnSensor(const SoughtPose& sensor) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const size_t i : sensor.mounted) {
      sum += (FrameOf(i).rotation.conjugate() * Image(i).rotation).toRotationMatrix();
    }
    return Turn(sum, sensor.pose);
  }

  static double Move(const SoughtPose& sought, const Eigen::Vector3d& sum) {
    const Eigen::Vector3d before = sought.pose->translation;
    sought.pose->translation = sum / static_cast<double>(sought.mounted.size());
    return (sought.pose->translation - before).norm();
  }
  double MoveFrame(const SoughtPose& frame) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const size_t i : frame.mounted) {
      sum += Image(i).translation - FrameOf(i).rotation * Sensor(i).translation;
    }
    return Move(frame, sum);
  }
  double MoveSensor(const SoughtPose& sensor) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const size_t i : sensor.mounted) {
      sum += FrameOf(i).rotation.conjugate() * (Image(i).translation - FrameOf(i).translation);
    }
    return Move(sensor, sum);
  }

  void StoreFit() {
    for (size_t i = 0; i < mounted_.size(); ++i) {
      const MountedImage& at = mounted_[i];
      model_.frames[at.frame].rig_from_world = Inverse(FrameOf(i));
      if (at.sensor == 0) continue;
      model_.rigs[at.rig].sensors[at.sensor].sensor_from_rig = Inverse(Sensor(i));
    }
    for (const MountedImage& at : MountedImages(model_)) {
      model_.images[at.image].cam_from_world = ComposedPose(model_, at);
    }
  }

  SparseModel& model_;
  std::vector<MountedImage> mounted_;
  std::vector<Rigid3d> world_from_image_;              // of mounted_
  std::vector<Rigid3d> world_from_rig_;                // by frame
  std::vector<std::vector<Rigid3d>> rig_from_sensor_;  // by rig
  std::vector<SoughtPose> frames_, sensors_;
};

}  // namespace

void FitRigs(const std::set<size_t>& images, SparseModel* model) { RigFit(images, model).Fit(); }

}  // namespace limn::colmap_ext
