// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cameras/camera_equations.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace limn {
namespace {

// Standard deviations of what is held, px in the images, those of bodies px of the photographs.
// Bodies may be lost: theirs holds as long as they move little (CostOfHold).
constexpr double kBodySigmaPx = 5;
constexpr double kOpticsSigmaPx = 10;
constexpr double kLandmarkSigmaPx = 50;
// Sums are made in parts, whose number depends on the problem alone.
constexpr int kMaxParts = 16;
constexpr double kMaxNumbersInParts = 2e7;

double Square(double x) { return x * x; }

// The Cauchy loss of a motion in standard deviations, all unknowns together.
constexpr double kBodyUnknowns = Vector6d::SizeAtCompileTime;
double CostOfHold(const Vector6d& motion) {
  return kBodyUnknowns * std::log1p(motion.squaredNorm() / kBodyUnknowns);
}
double WeightOfHold(const Vector6d& motion) {
  return 1 / (1 + motion.squaredNorm() / kBodyUnknowns);
}

Vector6d MotionBetween(const Rigid3d& from, const Rigid3d& to) {
  const Rigid3d change = to * Inverse(from);
  const Eigen::AngleAxisd turn(change.rotation);
  Vector6d motion;
  motion << turn.angle() * turn.axis(), change.translation;
  return motion;
}

Rigid3d Moved(const Rigid3d& pose, const Vector6d& motion) {
  const Eigen::Vector3d turn = motion.head<3>();
  const Rigid3d change = {Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())),
                          motion.tail<3>()};
  Rigid3d moved = change * pose;
  moved.rotation.normalize();
  return moved;
}

}  // namespace

// A distance and its derivatives, times the root of its weight.
struct CameraEquations::Row {
  double residual = 0;
  int body_at = -1;    // first unknown of the body; -1: held
  int camera_at = -1;  // of the parameters; -1: fixed
  Vector6d by_body = Vector6d::Zero();
  ParameterRow by_parameters = {};
  Eigen::Vector3d by_landmark = Eigen::Vector3d::Zero();
  // Once the landmark is eliminated: the residual that is left, and L^-1 by_landmark.
  double residual_left = 0;
  Eigen::Vector3d reduced = Eigen::Vector3d::Zero();
};

// The equations of one landmark.
struct CameraEquations::Block {
  std::vector<Row> rows;
  Eigen::Matrix3d normal;
  Eigen::Vector3d gradient;
};

CameraEquations::CameraEquations(const CameraFitInput& input, const RunContext& context,
                                 const std::vector<Landmark>& landmarks)
    : input_(input), context_(context), landmarks_(landmarks) {
  for (const uint8_t held : input.mounts.held) {
    body_at_.push_back(held ? -1 : size_);
    if (!held) size_ += 6;
  }
  for (const auto& [camera, parameters] : input.parameters) {
    camera_at_[camera] = size_;
    size_ += static_cast<int>(parameters.size());
  }
  per_sigma_.resize(body_at_.size());
  for (size_t v = 0; v < input.views.size(); ++v) {
    const int body = input.mounts.of_view[v].body;
    const View& view = input.views[v];
    const double per_sigma = view.camera.MeanFocal() / view.scale / kBodySigmaPx;
    per_sigma_[body] << Eigen::Vector3d::Constant(per_sigma),
        Eigen::Vector3d::Constant(per_sigma / input.distances[body]);
  }
}

Eigen::VectorXd CameraEquations::PerSigma() const {
  Eigen::VectorXd per_sigma = Eigen::VectorXd::Constant(size_, 1 / kOpticsSigmaPx);
  for (size_t b = 0; b < body_at_.size(); ++b) {
    if (body_at_[b] >= 0) per_sigma.segment<6>(body_at_[b]) = per_sigma_[b];
  }
  return per_sigma;
}

Eigen::VectorXd CameraEquations::Holds(const CameraState& state) const {
  Eigen::VectorXd holds = PerSigma().cwiseAbs2();
  for (size_t b = 0; b < body_at_.size(); ++b) {
    if (body_at_[b] >= 0) holds.segment<6>(body_at_[b]) *= WeightOfHold(HeldMotion(state, b));
  }
  return holds;
}

CameraState CameraEquations::Start() const {
  CameraState state;
  state.body_poses = BodyPoses(input_.views, input_.mounts);
  state.parameters = input_.parameters;
  state.landmarks.assign(landmarks_.size(), Eigen::Vector3d::Zero());
  return state;
}

std::vector<Rigid3d> CameraEquations::ViewPoses(const CameraState& state) const {
  std::vector<Rigid3d> poses;
  for (const CameraMount& mount : input_.mounts.of_view) {
    poses.push_back(mount.view_from_body * state.body_poses[mount.body]);
  }
  return poses;
}

int CameraEquations::NumParts() const {
  return std::clamp(static_cast<int>(kMaxNumbersInParts / Square(size_ + 1)), 1, kMaxParts);
}

// Parts have whole curves.
size_t CameraEquations::BeginOfPart(size_t part) const {
  size_t begin = landmarks_.size() * part / NumParts();
  while (begin > 0 && begin < landmarks_.size() && landmarks_[begin].curve >= 0 &&
         landmarks_[begin].curve == landmarks_[begin - 1].curve) {
    ++begin;
  }
  return begin;
}

// visit(part, landmark): in each part one after the other.
template <typename Visit>
void CameraEquations::ForLandmarks(const Visit& visit) const {
  const size_t num_parts = NumParts();
  ParallelFor(context_, "cameras", num_parts, [&](size_t part) {
    const size_t end = BeginOfPart(part + 1);
    for (size_t l = BeginOfPart(part); l < end; ++l) visit(part, l);
  });
}

double CameraEquations::LandmarkCost(const CameraState& state, const std::vector<Rigid3d>& poses,
                                     size_t l) const {
  const Landmark& landmark = landmarks_[l];
  const auto ways = landmark.ways.cols();
  const Eigen::Vector3d place = landmark.position + landmark.ways * state.landmarks[l].head(ways);
  double cost = state.landmarks[l].squaredNorm() / Square(kLandmarkSigmaPx);
  for (const LandmarkLine& line : landmark.lines) {
    const View& view = input_.views[line.view];
    const auto distance = ResidualToEdgel(view.camera, poses[line.view], line.line, place);
    double px = distance ? distance->residual_px : kBehindCameraPx;
    if (const auto change = state.parameters.find(view.camera_index);
        distance && change != state.parameters.end()) {
      px += line.by_parameters * (change->second - input_.parameters.at(view.camera_index));
    }
    cost += line.weight * Square(landmark.robust_px) * std::log1p(Square(px / landmark.robust_px));
  }
  return cost;
}

// Of those that count.
template <typename Counts>
double CameraEquations::LandmarksCost(const CameraState& state, const Counts& counts) const {
  const std::vector<Rigid3d> poses = ViewPoses(state);
  std::vector<double> parts(NumParts(), 0);
  ForLandmarks([&](size_t part, size_t l) {
    if (counts(landmarks_[l])) parts[part] += LandmarkCost(state, poses, l);
  });
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

double CameraEquations::CurveCost(const CameraState& state) const {
  return LandmarksCost(state, [](const Landmark& landmark) { return landmark.curve >= 0; });
}

double CameraEquations::Cost(const CameraState& state) const {
  double sum = LandmarksCost(state, [](const Landmark&) { return true; });
  for (size_t b = 0; b < body_at_.size(); ++b) {
    if (body_at_[b] >= 0) sum += CostOfHold(HeldMotion(state, b));
  }
  for (const auto& [camera, parameters] : state.parameters) {
    sum += (parameters / kOpticsSigmaPx).squaredNorm();
  }
  return sum;
}

Vector6d CameraEquations::MotionFromGiven(const CameraState& state, size_t body) const {
  return MotionBetween(input_.given_poses[body], state.body_poses[body]);
}

Vector6d CameraEquations::HeldMotion(const CameraState& state, size_t body) const {
  return MotionFromGiven(state, body).cwiseProduct(per_sigma_[body]);
}

void CameraEquations::FillBlock(const CameraState& state, const std::vector<Rigid3d>& poses,
                                size_t l, Block* block) const {
  const Landmark& landmark = landmarks_[l];
  const auto num_ways = landmark.ways.cols();
  const Eigen::Vector3d& at = state.landmarks[l];
  const Eigen::Vector3d place = landmark.position + landmark.ways * at.head(num_ways);
  const double hold = 1 / Square(kLandmarkSigmaPx);
  block->normal = hold * Eigen::Matrix3d::Identity();
  block->gradient = hold * at;
  block->rows.clear();
  for (const LandmarkLine& line : landmark.lines) {
    const View& view = input_.views[line.view];
    const auto distance = ResidualToEdgel(view.camera, poses[line.view], line.line, place);
    if (!distance) continue;
    const CameraMount& mount = input_.mounts.of_view[line.view];
    const Rigid3d& body = state.body_poses[mount.body];
    Row& row = block->rows.emplace_back();
    row.residual = distance->residual_px;
    row.body_at = body_at_[mount.body];
    const Eigen::Vector3d gradient = body.rotation * distance->gradient;
    row.by_body << (body * place).cross(gradient), gradient;
    if (const auto change = state.parameters.find(view.camera_index);
        change != state.parameters.end()) {
      row.camera_at = camera_at_.at(view.camera_index);
      row.by_parameters = line.by_parameters;
      row.residual +=
          line.by_parameters * (change->second - input_.parameters.at(view.camera_index));
    }
    row.by_landmark.head(num_ways) = landmark.ways.transpose() * distance->gradient;
    const double factor = std::sqrt(line.weight / (1 + Square(row.residual / landmark.robust_px)));
    row.residual *= factor;
    row.by_body *= factor;
    row.by_parameters *= factor;
    row.by_landmark *= factor;
    block->normal += row.by_landmark * row.by_landmark.transpose();
    block->gradient += row.by_landmark * row.residual;
  }
}

// With the Cholesky factor L of the landmark's own equations, rows lose the part that its motion
// explains: row_i - sum_j (L^-1 l_i) . (L^-1 l_j) row_j.
void CameraEquations::Eliminate(Block* block) {
  const Eigen::LLT<Eigen::Matrix3d> factor(block->normal);
  const Eigen::Vector3d gradient = factor.matrixL().solve(block->gradient);
  for (Row& row : block->rows) {
    row.reduced = factor.matrixL().solve(row.by_landmark);
    row.residual_left = row.residual - row.reduced.dot(gradient);
  }
}

void CameraEquations::AddGradient(const Block& block, Eigen::VectorXd* gradient) {
  for (const Row& row : block.rows) {
    if (row.body_at >= 0) gradient->segment<6>(row.body_at) += row.residual_left * row.by_body;
    if (row.camera_at < 0) continue;
    gradient->segment(row.camera_at, row.by_parameters.size()) +=
        row.residual_left * row.by_parameters.transpose();
  }
}

void CameraEquations::AddNormal(const Block& block, Eigen::MatrixXd* normal) {
  for (size_t i = 0; i < block.rows.size(); ++i) {
    for (size_t j = 0; j < block.rows.size(); ++j) {
      const double product = (i == j ? 1 : 0) - block.rows[i].reduced.dot(block.rows[j].reduced);
      AddProduct(product, block.rows[i], block.rows[j], normal);
    }
  }
}

void CameraEquations::AddProduct(double factor, const Row& a, const Row& b,
                                 Eigen::MatrixXd* normal) {
  if (a.body_at >= 0 && b.body_at >= 0 && a.body_at <= b.body_at) {
    normal->block<6, 6>(a.body_at, b.body_at) += (factor * a.by_body) * b.by_body.transpose();
  }
  if (b.camera_at < 0) return;
  const auto size = b.by_parameters.size();
  if (a.body_at >= 0) {
    normal->block(a.body_at, b.camera_at, 6, size) += (factor * a.by_body) * b.by_parameters;
  }
  if (a.camera_at >= 0 && a.camera_at <= b.camera_at) {
    normal->block(a.camera_at, b.camera_at, a.by_parameters.size(), size) +=
        (factor * a.by_parameters).transpose() * b.by_parameters;
  }
}

void CameraEquations::AddHolds(const CameraState& state, CameraSystem* system) const {
  const Eigen::VectorXd holds = Holds(state);
  system->normal.diagonal() += holds;
  for (size_t b = 0; b < body_at_.size(); ++b) {
    const int at = body_at_[b];
    if (at < 0) continue;
    system->gradient.segment<6>(at) += holds.segment<6>(at).cwiseProduct(MotionFromGiven(state, b));
  }
  for (const auto& [camera, at] : camera_at_) {
    const Eigen::VectorXd& parameters = state.parameters.at(camera);
    system->gradient.segment(at, parameters.size()) +=
        holds.segment(at, parameters.size()).cwiseProduct(parameters);
  }
}

CameraSystem CameraEquations::Linearize(const CameraState& state) const {
  const std::vector<Rigid3d> poses = ViewPoses(state);
  const CameraSystem empty = {Eigen::MatrixXd::Zero(size_, size_), Eigen::VectorXd::Zero(size_)};
  std::vector<CameraSystem> parts(NumParts(), empty);
  std::vector<Block> blocks(parts.size());
  ForLandmarks([&](size_t part, size_t l) {
    FillBlock(state, poses, l, &blocks[part]);
    Eliminate(&blocks[part]);
    AddGradient(blocks[part], &parts[part].gradient);
    AddNormal(blocks[part], &parts[part].normal);
  });
  CameraSystem system = std::move(parts.front());
  for (size_t part = 1; part < parts.size(); ++part) {
    system.normal += parts[part].normal;
    system.gradient += parts[part].gradient;
  }
  AddHolds(state, &system);
  return system;
}

CurveScatter CameraEquations::Scatter(const CameraState& state) const {
  struct Part {
    Block block;
    int curve = -1;
    Eigen::VectorXd gradient;  // of the curve so far
    CurveScatter scatter;
    // Points move few unknowns.
    void EndCurve() {
      std::vector<Eigen::Index> moved;
      for (Eigen::Index i = 0; i < gradient.size(); ++i) {
        if (gradient[i] != 0) moved.push_back(i);
      }
      for (size_t j = 0; j < moved.size(); ++j) {
        for (size_t i = 0; i <= j; ++i) {
          scatter.sum(moved[i], moved[j]) += gradient[moved[i]] * gradient[moved[j]];
        }
      }
      scatter.num_curves += moved.empty() ? 0 : 1;
      gradient.setZero();
    }
  };
  const std::vector<Rigid3d> poses = ViewPoses(state);
  std::vector<Part> parts(NumParts());
  for (Part& part : parts) {
    part.gradient.setZero(size_);
    part.scatter.sum.setZero(size_, size_);
  }
  ForLandmarks([&](size_t p, size_t l) {
    Part& part = parts[p];
    if (const int curve = landmarks_[l].curve; curve < 0 || curve != part.curve) {
      part.EndCurve();
      part.curve = curve;
    }
    FillBlock(state, poses, l, &part.block);
    Eliminate(&part.block);
    AddGradient(part.block, &part.gradient);
  });
  CurveScatter scatter = {Eigen::MatrixXd::Zero(size_, size_), 0};
  for (Part& part : parts) {
    part.EndCurve();
    scatter.sum += part.scatter.sum;
    scatter.num_curves += part.scatter.num_curves;
  }
  return scatter;
}

CameraState CameraEquations::After(const CameraState& state, const Eigen::VectorXd& step) const {
  CameraState next = state;
  for (size_t b = 0; b < body_at_.size(); ++b) {
    if (body_at_[b] < 0) continue;
    next.body_poses[b] = Moved(state.body_poses[b], step.segment<6>(body_at_[b]));
  }
  for (auto& [camera, parameters] : next.parameters) {
    parameters += step.segment(camera_at_.at(camera), parameters.size());
  }
  const std::vector<Rigid3d> poses = ViewPoses(state);
  std::vector<Block> blocks(NumParts());
  ForLandmarks([&](size_t part, size_t l) {
    Block& block = blocks[part];
    FillBlock(state, poses, l, &block);
    Eigen::Vector3d right = block.gradient;
    for (const Row& row : block.rows) {
      double change = 0;
      if (row.body_at >= 0) change += row.by_body.dot(step.segment<6>(row.body_at));
      if (row.camera_at >= 0) {
        change += row.by_parameters * step.segment(row.camera_at, row.by_parameters.size());
      }
      right += change * row.by_landmark;
    }
    next.landmarks[l] -= block.normal.llt().solve(right);
  });
  return next;
}

}  // namespace limn
