// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/curves_in_model.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/verbs/small_model.h"
#include "limn/formats/colors.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

SparseModel WithCurvesAt(double spacing_px) {
  const SparseModel model = MakeScene();
  return WithCurves(MakeDrawing(), model, ViewsOf(model), spacing_px);
}

// The line from (-1, 0, 0) to (0.5, 0.25, 0) is 19 pixels long in the views, 12.5 per unit.
TEST(CurvesInModel, PointsLieAlongCurves) {
  const SparseModel made = WithCurvesAt(1);
  EXPECT_EQ(made.cameras.size(), 1u);
  ASSERT_EQ(made.images.size(), 3u);
  EXPECT_EQ(made.points[0].id, 41u);
  const Eigen::Vector3d start(-1, 0, 0), end(0.5, 0.25, 0);
  size_t num_on_line = 0;
  for (size_t p = 1; p < made.points.size(); ++p) {
    EXPECT_EQ(made.points[p].id, 41 + p);
    const Eigen::Vector3d from_start = made.points[p].position - start;
    num_on_line += from_start.cross(end - start).norm() < 1e-12;
  }
  EXPECT_NEAR(static_cast<double>(num_on_line), 19, 1);
  EXPECT_GT(made.points.size() - 1 - num_on_line, 5u) << "the bent link";
  EXPECT_NEAR(static_cast<double>(WithCurvesAt(4).points.size()),
              static_cast<double>(made.points.size()) / 4, 3);
}

// COLMAP's viewers hide points of large error and short tracks.
TEST(CurvesInModel, PointsHaveTracksInTheImagesOfTheirLink) {
  const SparseModel made = WithCurvesAt(1);
  for (size_t p = 1; p < made.points.size(); ++p) {
    const ModelPoint& point = made.points[p];
    EXPECT_EQ(point.error, 0);
    // Supported by the drawing's first and third image, the model's second and third.
    ASSERT_EQ(point.track.size(), 2u);
    EXPECT_EQ(point.track[0].image_id, 10u);
    EXPECT_EQ(point.track[1].image_id, 30u);
    for (const size_t i : {1, 2}) {
      const ModelImage& image = made.images[i];
      const TrackElement& element = point.track[i - 1];
      ASSERT_TRUE(image.Shows(point.id, element.observation));
      const Eigen::Vector3d in_camera = image.cam_from_world * point.position;
      const Eigen::Vector2d pixel = 100 * in_camera.hnormalized() + Eigen::Vector2d(100, 50);
      EXPECT_LT((image.observations[element.observation].position - pixel).norm(), 1e-9);
    }
  }
}

TEST(CurvesInModel, PointsHaveTheColorOfTheirCurve) {
  const SparseModel made = WithCurvesAt(1);
  std::set<std::array<uint8_t, 3>> colors;
  for (size_t p = 1; p < made.points.size(); ++p) colors.insert(made.points[p].color);
  const Color first = ColorOfCurve(0);
  EXPECT_TRUE(colors.contains({first.red, first.green, first.blue}));
}

TEST(CurvesInModel, WhatHasNoPlaceInTheModelIsRefused) {
  SparseModel model = MakeScene();
  const std::vector<View> views = ViewsOf(model);
  DrawingFile drawing = MakeDrawing();
  drawing.metadata.view_names[0] = "z.png";
  EXPECT_THAT([&] { WithCurves(drawing, model, views, 1); },
              ThrowsMessage<IoError>(HasSubstr("the model has no image z.png")));
  model.cameras[0].model = CameraModelId::kEquirectangular;
  EXPECT_THAT([&] { WithCurves(MakeDrawing(), model, views, 1); },
              ThrowsMessage<InputError>(HasSubstr("camera 1 is EQUIRECTANGULAR")));
}

}  // namespace
}  // namespace limn::colmap_ext
