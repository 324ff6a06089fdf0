// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/duplicate_images.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "colmap_ext/temp_dir.h"

namespace limn::colmap_ext {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

// Five cameras in a row, a unit apart, 10 units before a point; all pictures are noise.
class DuplicateImages : public ::testing::Test {
 protected:
  DuplicateImages() {
    Camera camera;
    camera.width = 160;
    camera.height = 120;
    camera.params = {200, 200, 80, 60};
    model_.cameras.push_back(camera);
    model_.points = {{7, {0, 0, 10}, {}, -1, {}}};
    for (int i = 0; i < 5; ++i) {
      ModelImage image;
      image.cam_from_world.translation.x() = i;
      image.observations = {{{80, 60}, 7}};
      model_.images.push_back(image);
      cv::Mat picture(120, 160, CV_8UC1);
      cv::randu(picture, 0, 255);
      Write(i, picture, ".png");
    }
  }

  void Write(int i, const cv::Mat& picture, const std::string& extension) {
    images_.resize(5);
    paths_.resize(5);
    images_[i] = i;
    pictures_[i] = picture;
    paths_[i] = (dir_ / (std::to_string(i) + extension)).string();
    ASSERT_TRUE(cv::imwrite(paths_[i], picture));
  }

  std::vector<std::pair<int, int>> Found() const {
    std::vector<std::pair<int, int>> found;
    for (const DuplicateImage& one : FindDuplicateImages(model_, images_, paths_, {})) {
      found.emplace_back(one.duplicate, one.of);
    }
    return found;
  }

  TempDir dir_;
  SparseModel model_;
  std::vector<int> images_;
  std::vector<std::string> paths_;
  cv::Mat pictures_[5];
};

TEST_F(DuplicateImages, DifferentViewsAreNone) { EXPECT_THAT(Found(), IsEmpty()); }

TEST_F(DuplicateImages, SameBytesAre) {
  Write(3, pictures_[1], ".png");
  Write(4, pictures_[1], ".png");
  EXPECT_THAT(Found(), ElementsAre(Pair(3, 1), Pair(4, 1)));
}

TEST_F(DuplicateImages, NearlySamePictureFromNearlySamePoseIs) {
  Write(3, pictures_[1], ".jpg");
  EXPECT_THAT(Found(), IsEmpty());
  // A quarter of a pixel is 10 / 200 / 4 = 0.0125 units; but not where nothing tells the depth.
  model_.images[3].cam_from_world.translation.x() = 1.0005;
  EXPECT_THAT(Found(), ElementsAre(Pair(3, 1)));
  model_.points.clear();
  EXPECT_THAT(Found(), IsEmpty());
  model_.images[3].cam_from_world.translation.x() = 1;
  EXPECT_THAT(Found(), ElementsAre(Pair(3, 1)));
}

TEST_F(DuplicateImages, PanoramasSeePointsAllAround) {
  // 640 px all around are 100 px per radian; the point is behind the cameras.
  model_.cameras[0] = {0, CameraModelId::kEquirectangular, 640, 320, {640, 320}};
  model_.points[0].position.z() = -10;
  Write(3, pictures_[1], ".jpg");
  model_.images[3].cam_from_world.translation.x() = 1.0005;
  EXPECT_THAT(Found(), ElementsAre(Pair(3, 1)));
}

TEST_F(DuplicateImages, AnotherPictureFromTheSamePoseIsNone) {
  model_.images[3].cam_from_world = model_.images[1].cam_from_world;
  EXPECT_THAT(Found(), IsEmpty());
}

TEST_F(DuplicateImages, ACopyWithAPoseOfItsOwnIs) {
  Write(3, pictures_[1], ".jpg");
  const auto turn = [&](double rad) {
    model_.images[3].cam_from_world = model_.images[1].cam_from_world;
    model_.images[3].cam_from_world.rotation = Eigen::AngleAxisd(rad, Eigen::Vector3d::UnitY());
  };
  turn(0.008);  // 1.6 px
  EXPECT_THAT(Found(), ElementsAre(Pair(3, 1)));
  turn(0.05);
  EXPECT_THAT(Found(), IsEmpty());
}

TEST_F(DuplicateImages, APictureTakenAPixelAsideIsNone) {
  cv::Mat smooth, shifted;
  cv::GaussianBlur(pictures_[1], smooth, {}, 2);
  cv::warpAffine(smooth, shifted, cv::Matx23d(1, 0, 1, 0, 1, 0), smooth.size(), cv::INTER_LINEAR,
                 cv::BORDER_REFLECT);
  Write(1, smooth, ".png");
  Write(3, shifted, ".png");
  model_.images[3].cam_from_world = model_.images[1].cam_from_world;
  model_.images[3].cam_from_world.rotation = Eigen::AngleAxisd(0.005, Eigen::Vector3d::UnitY());
  EXPECT_THAT(Found(), IsEmpty());
}

}  // namespace
}  // namespace limn::colmap_ext
