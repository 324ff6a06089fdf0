// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/refined_model.h"

#include <gtest/gtest.h>

#include "colmap_ext/model/camera_calibration.h"
#include "colmap_ext/model/test_model.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

// The views of MakeModel() in another order than its images; "c.png" and "b.png" share a camera.
std::vector<View> ViewsOf(const SparseModel& model) {
  std::vector<View> views;
  for (const int index : {2, 0, 1}) {
    View view;
    view.model_index = index;
    view.name = model.images[index].name;
    view.camera_index = index == 1 ? 0 : 1;
    view.camera.fx = 250;  // the images are shrunk
    view.camera.fy = 255;
    view.cam_from_world = model.images[index].cam_from_world;
    views.push_back(view);
  }
  return views;
}

TEST(RefinedModel, NothingRefinedLeavesTheModel) {
  const SparseModel given = MakeModel();
  const std::vector<View> views = ViewsOf(given);
  SparseModel model = given;
  ApplyRefinement(views, {}, &model);
  ExpectSameModel(model, given);
}

TEST(RefinedModel, PosesParametersAndPointsAreReplaced) {
  const SparseModel given = MakeModel();
  const std::vector<View> views = ViewsOf(given);
  std::vector<View> refined = views;
  refined[0].cam_from_world.translation = {7, 8, 9};
  Camera other = given.cameras[1];
  for (double& parameter : other.params) parameter *= 1.01;
  for (const int v : {0, 1}) refined[v].calibration = MakeOptics(other, 100, 100).calibration;
  SceneHints hints;
  hints.points.resize(1);
  hints.points[0] = {Eigen::Vector3d(1, 2, 3), {}, {}, 1};
  SparseModel model = given;
  ApplyRefinement(refined, hints, &model);

  SparseModel expected = given;
  expected.images[2].cam_from_world.translation = {7, 8, 9};
  expected.points[1].position = {1, 2, 3};
  expected.points[1].error = -1;
  expected.cameras[1].params = other.params;
  ExpectSameModel(model, expected);
}

TEST(RefinedModel, AModelThatChangedMeanwhileIsRefused) {
  const SparseModel given = MakeModel();
  const std::vector<View> views = ViewsOf(given);
  SceneHints hints;
  hints.points.resize(1);
  SparseModel model = given;
  ApplyRefinement(views, hints, &model);  // a point of no model
  ExpectSameModel(model, given);
  hints.points[0].model_index = static_cast<int>(given.points.size());
  EXPECT_THROW(ApplyRefinement(views, hints, &model), IoError);
  model.images.pop_back();
  EXPECT_THROW(ApplyRefinement(views, {}, &model), IoError);
  model = given;
  std::swap(model.images[0].name, model.images[1].name);
  EXPECT_THROW(ApplyRefinement(views, {}, &model), IoError);
}

}  // namespace
}  // namespace limn::colmap_ext
