// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/point_frames.h"

#include <cmath>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/model/test_model.h"

namespace limn::colmap_ext {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double kDoubtfulPx = 2;

// MakeModel() with 40 points, seen at stored = scale * pixel + shift by all images, and as a camera
// of another focal length and principal point would see them.
SparseModel ModelWithPoints(const Eigen::Array2d& scale, const Eigen::Array2d& shift,
                            double focal_factor = 1, double center_shift = 0) {
  SparseModel model = MakeModel();
  model.points.clear();
  for (ModelImage& image : model.images) image.observations.clear();
  for (int i = 0; i < 40; ++i) {
    ModelPoint point;
    point.id = 1 + i;
    point.position = {0.5 * std::sin(i), 0.4 * std::cos(2 * i), 1 + 0.02 * i};
    for (ModelImage& image : model.images) {
      const Intrinsics camera = IntrinsicsOf(model.CameraOf(image));
      const Eigen::Vector3d ray = image.cam_from_world * point.position;
      const Eigen::Array2d pixel(
          focal_factor * camera.fx * ray.x() / ray.z() + camera.cx + center_shift,
          focal_factor * camera.fy * ray.y() / ray.z() + camera.cy + center_shift);
      point.track.push_back({image.id, static_cast<uint32_t>(i)});
      // One in five is wrong.
      const double error = i % 5 == 4 ? 37 * std::sin(3 * i) : 0.3 * std::sin(7 * i);
      image.observations.push_back({(scale * (pixel + error) + shift).matrix(), point.id});
    }
    model.points.push_back(point);
  }
  return model;
}

PointFrames FramesOf(const SparseModel& model) {
  std::vector<int> images(model.images.size());
  std::iota(images.begin(), images.end(), 0);
  return FindPointFrames(model, images, kDoubtfulPx);
}

TEST(PointFrames, PointsOfOtherSizesFit) {
  struct Case {
    Eigen::Array2d scale, shift;
  };
  // Padded to a square, shrunk, shrunk to a square without padding, enlarged and cropped.
  for (const auto& [scale, shift] : {Case{{1.28, 1.28}, {0, 128}}, Case{{.13, .13}, {0, 0}},
                                     Case{{.64, .853}, {0, 0}}, Case{{2, 2}, {-300, -100}}}) {
    const SparseModel model = ModelWithPoints(scale, shift);
    const PointFrames frames = FramesOf(model);
    ASSERT_THAT(frames, SizeIs(3)) << scale;
    EXPECT_LT((frames.at(0).scale / scale - 1).abs().maxCoeff(), .01) << scale;
    const Eigen::Vector2d pixel(400, 300);
    const Eigen::Vector2d stored = (scale * pixel.array() + shift).matrix();
    EXPECT_LT((frames.at(0).CameraPixel(stored) - pixel).norm(), 1) << scale;
    EXPECT_THAT(DescribeFrames(frames, model, 3), HasSubstr("the 2D points of 3 of 3 images"));
  }
}

TEST(PointFrames, RightPointsHaveNone) {
  EXPECT_THAT(FramesOf(ModelWithPoints({1, 1}, {0, 0})), IsEmpty());
  EXPECT_THAT(FramesOf(MakeModel()), IsEmpty());
}

TEST(PointFrames, WrongCamerasAreNotExcused) {
  for (const double focal : {.8, .95, 1.1, 1.2}) {
    EXPECT_THAT(FramesOf(ModelWithPoints({1, 1}, {0, 0}, focal)), IsEmpty()) << focal;
  }
  EXPECT_THAT(FramesOf(ModelWithPoints({1, 1}, {0, 0}, 1, 12)), IsEmpty());
}

}  // namespace
}  // namespace limn::colmap_ext
