// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/pmvs_model.h"

#include <cstdio>
#include <sstream>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "colmap_ext/model/test_model.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/model_folder.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Eigen::Matrix3d Intrinsics3(double fx, double fy, double cx, double cy, double skew = 0) {
  Eigen::Matrix3d k = Eigen::Matrix3d::Identity();
  k << fx, skew, cx, 0, fy, cy, 0, 0, 1;
  return k;
}

ProjectionMatrix Project(const Eigen::Matrix3d& intrinsics, const Rigid3d& pose) {
  ProjectionMatrix p;
  p << pose.rotation.toRotationMatrix(), pose.translation;
  return intrinsics * p;
}

Rigid3d SomePose(double angle_rad) {
  Rigid3d pose;
  pose.rotation = Eigen::AngleAxisd(angle_rad, Eigen::Vector3d(1, -2, 0.5).normalized());
  pose.translation = {0.5, -1, 4};
  return pose;
}

void ExpectNear(const DecomposedProjection& parts, const Eigen::Matrix3d& intrinsics,
                const Rigid3d& pose) {
  EXPECT_LT((parts.intrinsics - intrinsics).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT(parts.cam_from_world.rotation.angularDistance(pose.rotation), 1e-12);
  EXPECT_LT((parts.cam_from_world.translation - pose.translation).norm(), 1e-11);
}

TEST(Decompose, GivesBackCameraAndPoseWhateverTheScale) {
  for (const double angle : {0.0, 0.7, 2.9}) {
    const Eigen::Matrix3d k = Intrinsics3(500, 510, 320, 240, 3);
    for (const double scale : {1.0, -1.0, 1e-7, -3e5}) {
      ExpectNear(Decompose(scale * Project(k, SomePose(angle))), k, SomePose(angle));
    }
  }
}

TEST(Decompose, RefusesWhatIsNoCamera) {
  ProjectionMatrix p = Project(Intrinsics3(500, 500, 320, 240), SomePose(0.3));
  const auto error = [&] { return ErrorText<InputError>([&] { Decompose(p); }); };
  p.row(1) = 2 * p.row(0);
  EXPECT_THAT(error(), HasSubstr("singular"));
  p.setZero();
  EXPECT_THAT(error(), HasSubstr("singular"));
  p(2, 1) = std::nan("");
  EXPECT_THAT(error(), HasSubstr("not finite"));
}

TEST(ReadContour, SaysWhatIsWrong) {
  const auto error = [](const std::string& text) {
    return ErrorText<IoError>([&] {
      std::istringstream in(text);
      ReadContour(in, "p.txt");
    });
  };
  EXPECT_THAT(error(""), HasSubstr("p.txt: line 0: \"CONTOUR\" expected"));
  EXPECT_THAT(error("CONTOUR\n1 2 3 4\n1 2 3\n"), HasSubstr("p.txt: line 3: the line ends"));
  EXPECT_THAT(error("CONTOUR\n1 2 3 4\n"), HasSubstr("the file ends before row 2"));
  EXPECT_THAT(error("CONTOUR\n1 2 x 4\n"), HasSubstr("\"x\" is not a number"));
}

class PmvsModel : public ::testing::Test {
 protected:
  // Four digits behind the point of matrices with elements up to 1000: more than COLMAP's six
  // significant ones. One image of 64 x 48 pixels per matrix.
  void Add(int index, const ProjectionMatrix& p) const {
    char name[32];
    std::snprintf(name, sizeof(name), "%08d", index);
    std::ostringstream text;
    text.precision(6);
    text << "CONTOUR\n" << p << "\n";
    dir_.WriteFile(std::string("txt/") + name + ".txt", text.str());
    std::filesystem::create_directories(dir_ / "visualize");
    cv::imwrite((dir_ / "visualize" / (std::string(name) + ".jpg")).string(),
                cv::Mat(48, 64, CV_8U, cv::Scalar(100)));
  }

  std::string Error() const {
    return ErrorText<IoError>([&] { ReadModel(dir_.path()); });
  }

  TempDir dir_;
  const Eigen::Matrix3d k_ = Intrinsics3(60, 61, 33, 25);
};

TEST_F(PmvsModel, IsReadWithTheOriginalNames) {
  Add(0, Project(k_, SomePose(0.1)));
  Add(1, Project(k_, SomePose(0.2)));
  EXPECT_FALSE(HoldsModel(dir_ / "txt"));
  EXPECT_TRUE(HoldsModel(dir_.path()));
  EXPECT_EQ(CountRegisteredImages(dir_.path()), 2u);
  dir_.WriteFile("bundle.rd.out.list.txt", "sub folder/b 1.png\na.png\r\n\n");
  const SparseModel model = ReadModel(dir_.path());
  ASSERT_EQ(model.images.size(), 2u);
  EXPECT_EQ(model.images[0].name, "sub folder/b 1.png");
  EXPECT_EQ(model.images[0].file, "00000000.jpg");
  EXPECT_EQ(model.images[1].name, "a.png");
  EXPECT_EQ(model.CameraOf(model.images[1]).width, 64u);
  EXPECT_EQ(model.CameraOf(model.images[1]).height, 48u);
  for (int i = 0; i < 2; ++i) {
    const Intrinsics camera = IntrinsicsOf(model.cameras[i]);
    EXPECT_NEAR(camera.fx, 60, 1e-2);
    EXPECT_NEAR(camera.fy, 61, 1e-2);
    EXPECT_NEAR(camera.cx, 33, 1e-2);
    EXPECT_NEAR(camera.cy, 25, 1e-2);
    EXPECT_LT(
        model.images[i].cam_from_world.rotation.angularDistance(SomePose(0.1 * (i + 1)).rotation),
        1e-4);
  }
  EXPECT_TRUE(model.warnings.empty());
}

TEST_F(PmvsModel, PointsOfTheBundleAreRead) {
  Add(0, Project(k_, SomePose(0.1)));
  Add(1, Project(k_, SomePose(0.2)));
  dir_.WriteFile("bundle.rd.out.list.txt", "a.png\nb.png\n");
  std::string bundle = "# Bundle file v0.3\n2 1\n";
  for (int k = 0; k < 10; ++k) bundle += "0 0 0\n";
  const Eigen::Vector3d point(0.1, 0.2, 0.3);
  bundle += "0.1 0.2 0.3\n10 20 30\n2";
  std::vector<Eigen::Vector2d> pixels;
  for (int i = 0; i < 2; ++i) {
    pixels.push_back((k_ * (SomePose(0.1 * (i + 1)) * point)).hnormalized());
    std::ostringstream measurement;
    measurement << ' ' << i << " 7 " << pixels[i].x() - 33 << ' ' << 25 - pixels[i].y();
    bundle += measurement.str();
  }
  dir_.WriteFile("bundle.rd.out", bundle + "\n");
  const SparseModel model = ReadModel(dir_.path());
  ASSERT_EQ(model.points.size(), 1u);
  EXPECT_EQ(model.points[0].position, point);
  EXPECT_THAT(model.points[0].color, ElementsAre(10, 20, 30));
  ASSERT_EQ(model.points[0].track.size(), 2u);
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(model.images[i].Shows(1, model.points[0].track[i].observation));
    EXPECT_LT((model.images[i].observations[0].position - pixels[i]).norm(), 0.02);
  }
  dir_.WriteFile("bundle.rd.out", bundle.substr(0, bundle.rfind(' ')));
  EXPECT_THAT(Error(), HasSubstr("bundle.rd.out: line 15: "));
  dir_.WriteFile("bundle.rd.out", "# Bundle file v0.3\n3 0\n");
  EXPECT_THAT(Error(), HasSubstr("bundle.rd.out: line 2: 3 cameras, but txt/ has 2"));
  dir_.WriteFile("bundle.rd.out", "# Bundle file v0.1\n");
  EXPECT_THAT(Error(), HasSubstr("\"# Bundle file v0.3\" expected"));
}

TEST_F(PmvsModel, WithoutTheListNamesAreThoseOfTheFiles) {
  Add(0, Project(k_, SomePose(0.1)));
  const SparseModel model = ReadModel(dir_.path());
  EXPECT_EQ(model.images[0].name, "00000000.jpg");
  EXPECT_THAT(model.warnings, ElementsAre(HasSubstr("bundle.rd.out.list.txt is missing")));
}

TEST_F(PmvsModel, RefusesWhatDoesNotFit) {
  Add(0, Project(k_, SomePose(0.1)));
  dir_.WriteFile("bundle.rd.out.list.txt", "a.png\nb.png\n");
  EXPECT_THAT(Error(), HasSubstr("list.txt: holds the names of 2 images, txt/ has 1"));
  Add(2, Project(k_, SomePose(0.2)));
  EXPECT_THAT(Error(), HasSubstr("00000001.txt: missing, but files of higher numbers exist"));
  Add(1, Project(k_, SomePose(0.3)));
  std::filesystem::remove(dir_ / "visualize/00000001.jpg");
  dir_.WriteFile("bundle.rd.out.list.txt", "a\nb\nc\n");
  EXPECT_THAT(Error(), HasSubstr("00000001.jpg: the image of this number is missing"));
}

TEST_F(PmvsModel, RefusesCamerasThatAreNoneOfColmap) {
  dir_.WriteFile("bundle.rd.out.list.txt", "a.png\n");
  Add(0, Project(Intrinsics3(60, 61, 33, 25, 2), SomePose(0.1)));
  EXPECT_THAT(Error(), HasSubstr("00000000.txt: the camera has skew"));
  Add(0, Project(Intrinsics3(120, 122, 64, 48), SomePose(0.1)));
  EXPECT_THAT(Error(), HasSubstr("the images were shrunk without their matrices"));
  Add(0, ProjectionMatrix::Zero());
  EXPECT_THAT(Error(), HasSubstr("00000000.txt: the projection matrix is singular"));
}

}  // namespace
}  // namespace limn::colmap_ext
