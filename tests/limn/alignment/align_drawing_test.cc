// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/align_drawing.h"

#include <random>

#include <gtest/gtest.h>

#include "limn/alignment/wire_room.h"
#include "limn/util/angles.h"
#include "support/random_numbers.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::AngleDeg;

// A room as COLMAP might have it, and the truth.
class AlignDrawingTest : public ::testing::Test {
 protected:
  AlignDrawingTest() : graph_(testing::Moved(testing::WireRoom(), model_from_world_)) {
    for (View view : testing::DomeViews(20, 3)) {
      centers_.push_back(view.CenterInWorld());
      view.cam_from_world = CamFromB(view.cam_from_world, model_from_world_);
      views_.push_back(view);
    }
    priors_.resize(views_.size());
  }

  void SetPositions(double noise) {
    std::mt19937 random(1);
    testing::NormalDistribution<double> normal(0, noise);
    for (size_t v = 0; v < views_.size(); ++v) {
      priors_[v].position = centers_[v] + testing::RandomVector(normal, random);
    }
  }

  AlignmentResult Align(WorldFrame world = WorldFrame::kDrawing) const {
    return AlignDrawing({views_, graph_, priors_, lengths_, plan_lines_, world});
  }

  double UpErrorDeg(const AlignmentResult& result) const {
    return AngleDeg(Error(result).col(2), Eigen::Vector3d::UnitZ());
  }
  // To the nearest quarter turn.
  double AxesErrorDeg(const AlignmentResult& result) const {
    const Eigen::Matrix3d error = Error(result);
    return std::abs(std::remainder(std::atan2(error(1, 0), error(0, 0)), M_PI / 2)) / kDeg;
  }
  double ScaleError(const AlignmentResult& result) const {
    return std::abs(result.alignment.world_from_model.scale * model_from_world_.scale - 1);
  }

  Similarity3d model_from_world_ = testing::RandomSimilarity(2.5, 5);
  DrawingGraph graph_;
  std::vector<View> views_;
  std::vector<Eigen::Vector3d> centers_;
  std::vector<ViewPrior> priors_;
  std::vector<KnownLength> lengths_;
  std::vector<PlanLine> plan_lines_;

 private:
  Eigen::Matrix3d Error(const AlignmentResult& result) const {
    return result.alignment.world_from_model.rotation * model_from_world_.rotation;
  }
};

TEST_F(AlignDrawingTest, ByLinesAlone) {
  priors_.clear();
  const AlignmentResult result = Align();
  EXPECT_EQ(result.alignment.up, UpSource::kLines);
  EXPECT_EQ(result.alignment.axes, AxesSource::kLines);
  EXPECT_EQ(result.alignment.scale, ScaleSource::kNone);
  EXPECT_EQ(result.alignment.world_from_model.scale, 1);
  EXPECT_EQ(Validate(result.alignment), "");
  EXPECT_LT(UpErrorDeg(result), 1e-3);
  EXPECT_LT(AxesErrorDeg(result), 1e-3);
}

TEST_F(AlignDrawingTest, PutsTheOriginInTheMiddleOfTheFloor) {
  const AlignmentResult result = Align();
  const Eigen::Vector3d origin =
      result.alignment.world_from_model * (model_from_world_ * Eigen::Vector3d::Zero());
  EXPECT_LT(origin.norm(), 1e-3 * model_from_world_.scale);
}

TEST_F(AlignDrawingTest, ByPositions) {
  SetPositions(0.02);
  const AlignmentResult result = Align();
  EXPECT_EQ(result.alignment.up, UpSource::kPositions);
  EXPECT_EQ(result.alignment.scale, ScaleSource::kPositions);
  EXPECT_LT(UpErrorDeg(result), 0.5);
  EXPECT_LT(AxesErrorDeg(result), 0.5);
  EXPECT_LT(ScaleError(result), 0.01);
  // x is the one near east.
  const Eigen::Vector3d x = result.alignment.world_from_model.rotation.row(0);
  EXPECT_LT(AngleDeg(x, model_from_world_.rotation.col(0)), 1);
}

TEST_F(AlignDrawingTest, RoughPositionsTellOnlyTheScale) {
  SetPositions(0.5);
  const AlignmentResult result = Align();
  EXPECT_EQ(result.alignment.up, UpSource::kLines);
  EXPECT_EQ(result.alignment.scale, ScaleSource::kPositions);
  EXPECT_LT(UpErrorDeg(result), 1e-3);
  EXPECT_LT(ScaleError(result), 3 * result.positions->scale_error);
}

TEST_F(AlignDrawingTest, PositionsThatTellNothingAreNotUsed) {
  SetPositions(20);
  const AlignmentResult result = Align();
  EXPECT_EQ(result.alignment.up, UpSource::kLines);
  EXPECT_EQ(result.alignment.scale, ScaleSource::kNone);
}

TEST_F(AlignDrawingTest, ByMeasuredGravity) {
  for (size_t v = 0; v < views_.size(); ++v) {
    const Eigen::Vector3d down = -model_from_world_.rotation.col(2);
    priors_[v].gravity_in_cam = views_[v].cam_from_world.rotation * down;
  }
  graph_ = {};
  const AlignmentResult result = Align();
  EXPECT_EQ(result.alignment.up, UpSource::kGravity);
  EXPECT_EQ(result.alignment.axes, AxesSource::kModel);
  EXPECT_LT(UpErrorDeg(result), 1e-6);
}

TEST_F(AlignDrawingTest, WithoutLinesCamerasTellUpRoughly) {
  graph_ = {};
  const AlignmentResult result = Align();
  EXPECT_EQ(result.alignment.up, UpSource::kCameras);
  EXPECT_LT(UpErrorDeg(result), 2);
  EXPECT_EQ(Validate(result.alignment), "");
}

TEST_F(AlignDrawingTest, KnownLengthsTellTheScaleBetterThanPositions) {
  SetPositions(0.5);
  lengths_ = ParseKnownLengths({"link 0 = 5 m"});
  const AlignmentResult result = Align();
  EXPECT_EQ(result.alignment.scale, ScaleSource::kLengths);
  EXPECT_LT(ScaleError(result), 1e-9);
}

// As in a national grid.
const Eigen::Vector3d kGridShift(2600000, 1200000, 430);

// Link 0 runs along x in the room.
TEST_F(AlignDrawingTest, LinesOfAPlanTellTheAxes) {
  plan_lines_ = ParsePlanLines({"link 0 = 30 deg"});
  SetPositions(0.001);
  const AlignmentResult result = Align();
  EXPECT_EQ(result.alignment.axes, AxesSource::kPlan);
  const DrawingLink& link = graph_.links[0];
  const Eigen::Vector3d along = result.alignment.world_from_model.rotation *
                                (link.points_in_world.back() - link.points_in_world.front());
  EXPECT_NEAR(Degrees(std::atan2(along.y(), along.x())), 30, 1e-6);
}

TEST_F(AlignDrawingTest, TheWorldOfPositionsIsTheirs) {
  for (Eigen::Vector3d& center : centers_) center += kGridShift;
  SetPositions(0);
  priors_[3].position->x() += 50;  // a wrong one has no say
  const AlignmentResult result = Align(WorldFrame::kPositions);
  EXPECT_EQ(result.world, WorldFrame::kPositions);
  EXPECT_EQ(result.alignment.axes, AxesSource::kPositions);
  const Similarity3d moved = result.alignment.world_from_model * model_from_world_;
  EXPECT_NEAR(moved.scale, 1, 1e-9);
  EXPECT_LT((moved.rotation - Eigen::Matrix3d::Identity()).norm(), 1e-8);
  EXPECT_LT((moved.translation - kGridShift).norm(), 1e-6);
}

// A length is better known than the scale of positions; the cameras stay in their middle.
TEST_F(AlignDrawingTest, TheWorldOfPositionsTakesItsScaleFromLengths) {
  for (Eigen::Vector3d& center : centers_) center = 1.05 * center + kGridShift;
  SetPositions(0);
  const DrawingLink& link = graph_.links[0];
  const double length = (link.points_in_world.back() - link.points_in_world.front()).norm();
  lengths_ = {{{0}, length / model_from_world_.scale, "link 0"}};
  const AlignmentResult result = Align(WorldFrame::kPositions);
  const Similarity3d& world_from_model = result.alignment.world_from_model;
  EXPECT_NEAR(world_from_model.scale * model_from_world_.scale, 1, 1e-9);
  Eigen::Vector3d off = Eigen::Vector3d::Zero();
  for (size_t v = 0; v < views_.size(); ++v) {
    off += world_from_model * views_[v].CenterInWorld() - *priors_[v].position;
  }
  EXPECT_LT(off.norm(), 1e-5);
}

TEST_F(AlignDrawingTest, WithoutGoodPositionsTheWorldIsThatOfTheDrawing) {
  EXPECT_EQ(Align(WorldFrame::kPositions).world, WorldFrame::kDrawing);
  SetPositions(20);
  const AlignmentResult noisy = Align(WorldFrame::kPositions);
  EXPECT_EQ(noisy.world, WorldFrame::kDrawing);
  EXPECT_EQ(noisy.alignment.world_from_model.translation,
            Align().alignment.world_from_model.translation);
}

}  // namespace
}  // namespace limn
