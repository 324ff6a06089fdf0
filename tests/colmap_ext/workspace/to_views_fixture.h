// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "colmap_ext/model/camera_projection.h"
#include "colmap_ext/model/test_model.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/to_views.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {

// A model of three images, whose files are of one color each.
class ToViewsTest : public ::testing::Test {
 protected:
  ToViewsTest() : model_(MakeModel()) {
    model_.folder = "the_model";
    for (const ModelImage& image : model_.images) WriteImage(image.name, 800, 600);
  }

  void WriteImage(const std::string& name, int width, int height) {
    // No two alike.
    Write(name, cv::Mat(height, width, CV_8UC3, cv::Scalar(10, 20, 30 * (name[0] % 7))));
  }
  void Write(const std::string& name, const cv::Mat& image) {
    const std::filesystem::path path = dir_.path() / name;
    std::filesystem::create_directories(path.parent_path());
    ASSERT_TRUE(cv::imwrite(path.string(), image));
  }

  ViewSet Views() const { return ToViews(model_, dir_.path(), options_); }
  std::string ErrorOf() const {
    return ErrorText<IoError>([&] { Views(); });
  }
  // Points that every image sees where its camera projects them.
  void GivePoints(int count) {
    model_.points.clear();
    for (ModelImage& image : model_.images) image.observations.clear();
    for (int i = 0; i < count; ++i) {
      ModelPoint point;
      point.id = 1 + i;
      point.position = {0.3 * std::sin(i), 0.3 * std::cos(2 * i), 1 + 0.02 * i};
      for (ModelImage& image : model_.images) {
        const Intrinsics camera = IntrinsicsOf(model_.CameraOf(image));
        const Eigen::Vector3d ray = image.cam_from_world * point.position;
        point.track.push_back({image.id, static_cast<uint32_t>(i)});
        image.observations.push_back(
            {{camera.fx * ray.x() / ray.z() + camera.cx, camera.fy * ray.y() / ray.z() + camera.cy},
             point.id});
      }
      model_.points.push_back(point);
    }
  }
  void SetCamera3(CameraModelId id) { model_.cameras[1] = MakeCamera(id, 3); }

  TempDir dir_;
  SparseModel model_;
  ViewOptions options_;
};

}  // namespace limn::colmap_ext
