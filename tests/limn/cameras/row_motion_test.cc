// SPDX-License-Identifier: BSD-3-Clause
// Cameras that move while they expose one row after the other, and cameras that do not.
#include "limn/cameras/row_motion.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limn/geometry/median_point.h"
#include "limn/util/median.h"
#include "support/random_numbers.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr int kNumViews = 12;
constexpr int kNumCurves = 60;
constexpr int kNumOnCurve = 10;
constexpr double kEdgelNoisePx = 0.15;  // of each edgel, and of all those of a curve in a view
constexpr double kWeight = 1;
constexpr size_t kMoving = 4;

// A turn and a shift from the first to the last row.
struct Motion {
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
};

const std::vector<View>& Views() {
  static const std::vector<View> views = testing::DomeViews(kNumViews, 4);
  return views;
}

std::vector<Motion> Still() { return std::vector<Motion>(kNumViews); }

// By 3 px or so, another way each.
Motion SomeMotion(size_t view) {
  const auto angle = static_cast<double>(view);
  return {0.003 * Eigen::Vector3d(std::cos(2 * angle), std::sin(3 * angle), std::cos(5 * angle)),
          0.012 * Eigen::Vector3d(std::cos(7 * angle), std::sin(4 * angle), std::cos(angle))};
}

Eigen::Vector3d At(const Motion& motion, double row, const Eigen::Vector3d& in_camera) {
  const Eigen::Vector3d turn = row * motion.turn;
  return Eigen::AngleAxisd(turn.norm(), turn.normalized()) * in_camera + row * motion.shift;
}

Eigen::Vector2d SeenWhileMoving(const View& view, const Motion& motion,
                                const Eigen::Vector3d& in_world) {
  const Eigen::Vector3d in_camera = view.cam_from_world * in_world;
  Eigen::Vector2d px = view.camera.Project(in_camera);
  for (int i = 0; i < 5; ++i) {
    const double row = (px.y() + 0.5) / view.camera.height - 0.5;
    px = view.camera.Project(At(motion, row, in_camera));
  }
  return px;
}

// Points of straight curves and how these cameras, or every `step`-th of them, see them.
class CurvesOnRows {
 public:
  explicit CurvesOnRows(const std::vector<Motion>& motions, int num_curves = kNumCurves,
                        int step = 1)
      : step_(step) {
    for (int curve = 0; curve < num_curves; ++curve) AddCurve(motions, curve);
  }

  const std::vector<Landmark>& landmarks() const { return landmarks_; }

 private:
  void AddCurve(const std::vector<Motion>& motions, int curve) {
    testing::UniformDistribution<double> in_cube(-1.1, 1.1);
    const auto place = [&] { return testing::RandomVector(in_cube, random_); };
    const Eigen::Vector3d from = place();
    const Eigen::Vector3d along = place() - from;
    std::vector<double> offsets_px;
    for (int v = 0; v < kNumViews; ++v) offsets_px.push_back(Noise());
    for (int i = 0; i < kNumOnCurve; ++i) {
      Landmark& landmark = landmarks_.emplace_back();
      landmark.position = from + i / (kNumOnCurve - 1.0) * along;
      landmark.curve = curve;
      landmark.robust_px = 1;
      const Eigen::Vector3d across = along.unitOrthogonal();
      landmark.ways.resize(3, 2);
      landmark.ways << across, along.normalized().cross(across);
      landmark.ways *= 0.01;
      for (int v = 0; v < kNumViews; v += step_) {
        AddLine(v, motions[v], along, offsets_px[v] + Noise(), &landmark);
      }
    }
  }

  static void AddLine(int v, const Motion& motion, const Eigen::Vector3d& along, double noise_px,
                      Landmark* landmark) {
    const View& view = Views()[v];
    if (!view.Project(landmark->position)) return;
    const Eigen::Vector2d px = SeenWhileMoving(view, motion, landmark->position);
    const Eigen::Vector2d beside = SeenWhileMoving(view, motion, landmark->position + 1e-3 * along);
    const Eigen::Vector2d direction = (beside - px).normalized();
    const Eigen::Vector2d across(-direction.y(), direction.x());
    landmark->lines.push_back({v, EdgelLine(px + noise_px * across, across), kWeight});
  }

  double Noise() { return noise_(random_); }

  const int step_;
  std::mt19937 random_{5};
  testing::NormalDistribution<double> noise_{0, kEdgelNoisePx};
  std::vector<Landmark> landmarks_;
};

double TrueSkewPx(const CurvesOnRows& scene, size_t v, const Motion& motion) {
  std::vector<Eigen::Vector3d> places;
  for (const Landmark& landmark : scene.landmarks()) {
    places.push_back(Views()[v].cam_from_world * landmark.position);
  }
  const Eigen::Vector3d middle = MedianPoint(places);
  const PinholeCamera& camera = Views()[v].camera;
  return (camera.Project(At(motion, 0.5, middle)) - camera.Project(At(motion, -0.5, middle)))
      .norm();
}

RowMotion Measure(const CurvesOnRows& scene, const std::vector<View>& views = Views()) {
  return MeasureRowMotion(views, scene.landmarks(), {});
}

TEST(RowMotion, StillCamerasHaveNoSkewButByChance) {
  const RowMotion rows = Measure(CurvesOnRows(Still()));
  ASSERT_EQ(rows.of_view.size(), kNumViews);
  double squares = 0;
  for (const ViewSkew& skew : rows.of_view) {
    ASSERT_GT(skew.sigma_px, 0);
    squares += skew.px * skew.px / (2 * skew.sigma_px * skew.sigma_px);
  }
  // 24 components: the mean square of their standard scores is 1 +- 0.3.
  EXPECT_GT(squares / kNumViews, 0.3);
  EXPECT_LT(squares / kNumViews, 2);
  EXPECT_GT(rows.evidence, 0.3);
  EXPECT_LT(rows.evidence, 2);
  EXPECT_FALSE(rows.IsRollingShutter());
}

TEST(RowMotion, TheSkewOfOneViewIsFound) {
  std::vector<Motion> motions = Still();
  motions[kMoving] = SomeMotion(kMoving);
  const CurvesOnRows scene(motions);
  const RowMotion rows = Measure(scene);
  const ViewSkew& skew = rows.of_view[kMoving];
  const double truth_px = TrueSkewPx(scene, kMoving, motions[kMoving]);
  EXPECT_GT(truth_px, 1);
  EXPECT_NEAR(skew.px, truth_px, 3 * skew.sigma_px);
  EXPECT_LT(skew.sigma_px, 0.2 * truth_px);
  EXPECT_GT(skew.evidence, 50);
  EXPECT_FALSE(rows.IsRollingShutter()) << "one view of many";
}

// Curves that three views place could bend to fit the one that moves.
TEST(RowMotion, CurvesDoNotBendToFitTheView) {
  std::vector<Motion> motions = Still();
  motions[kMoving] = SomeMotion(kMoving);
  const CurvesOnRows scene(motions, kNumCurves, 4);
  const ViewSkew skew = Measure(scene).of_view[kMoving];
  const double truth_px = TrueSkewPx(scene, kMoving, motions[kMoving]);
  EXPECT_NEAR(skew.px, truth_px, 3 * skew.sigma_px);
  EXPECT_LT(skew.sigma_px, 0.15 * truth_px);
}

TEST(RowMotion, ViewsThatAllMoveAreTold) {
  std::vector<Motion> motions;
  for (size_t v = 0; v < kNumViews; ++v) motions.push_back(SomeMotion(v));
  const CurvesOnRows scene(motions);
  const RowMotion rows = Measure(scene);
  EXPECT_TRUE(rows.IsRollingShutter());
  std::vector<double> truths_px;
  for (size_t v = 0; v < kNumViews; ++v) truths_px.push_back(TrueSkewPx(scene, v, motions[v]));
  // Each is measured against the curves that the others bend.
  EXPECT_NEAR(rows.skew_px, Median(truths_px), 0.3 * Median(truths_px));
}

TEST(RowMotion, SkewsThatDoNotMatterAreNotTold) {
  std::vector<Motion> motions;
  for (size_t v = 0; v < kNumViews; ++v) {
    const Motion motion = SomeMotion(v);
    motions.push_back({motion.turn / 8, motion.shift / 8});
  }
  const RowMotion rows = Measure(CurvesOnRows(motions, 10 * kNumCurves));
  EXPECT_GT(rows.evidence, 10);
  EXPECT_FALSE(rows.IsRollingShutter());
}

TEST(RowMotion, AWrongPoseIsNoSkew) {
  std::vector<View> views = Views();
  views[kMoving].cam_from_world.translation += Eigen::Vector3d(0.006, -0.01, 0.01);
  const CurvesOnRows scene(Still());
  const ViewSkew right = Measure(scene).of_view[kMoving];
  const ViewSkew wrong = Measure(scene, views).of_view[kMoving];
  EXPECT_NEAR(wrong.px, right.px, right.sigma_px);
  EXPECT_LT(wrong.evidence, 5);
}

TEST(RowMotion, WithoutEnoughCurvesItIsNotKnown) {
  std::vector<Motion> motions = Still();
  motions[kMoving] = SomeMotion(kMoving);
  for (const int num_curves : {0, 3}) {
    const RowMotion rows = Measure(CurvesOnRows(motions, num_curves));
    ASSERT_EQ(rows.of_view.size(), kNumViews);
    for (const ViewSkew& skew : rows.of_view) {
      EXPECT_EQ(skew.px, 0);
      EXPECT_EQ(skew.sigma_px, 0);
    }
    EXPECT_EQ(rows.evidence, 0);
    EXPECT_FALSE(rows.IsRollingShutter());
  }
}

TEST(RowMotion, AViewThatSeesNothingDoesNotCount) {
  const CurvesOnRows scene(Still());
  std::vector<View> views = Views();
  views.push_back(views[0]);
  const RowMotion with = Measure(scene, views);
  EXPECT_EQ(with.of_view[kNumViews].sigma_px, 0);
  EXPECT_EQ(with.evidence, Measure(scene).evidence);
}

}  // namespace
}  // namespace limn
