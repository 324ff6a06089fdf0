// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/intrinsic_extrinsic.h"

#include <fstream>

#include <opencv2/imgcodecs.hpp>

#include "colmap_ext/import/import_test_base.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr char kIntrinsicExtrinsicFormat[] = "intrinsic_extrinsic";

std::string Calibration(double focal_y = 611.5) {
  return "600.25 0 316.25\n0 " + Text(focal_y) + " 250.625\n0 0 1\n";
}

class IntrinsicExtrinsic : public ImportTest {
 protected:
  IntrinsicExtrinsic() {
    dir_.WriteFile("cameras/calib.intrinsic", Calibration());
    for (const ModelImage& image : known_.images) {
      const Rigid3d& pose = image.cam_from_world;
      dir_.WriteFile(
          "cameras/" + fs::path(image.name).stem().string() + ".extrinsic",
          Text(pose.rotation.toRotationMatrix()) + "\n" + Text(Inverse(pose).translation) + "\n");
    }
  }

  const SparseModel known_ = KnownModel();
  const fs::path cameras_ = dir_ / "cameras";
};

TEST_F(IntrinsicExtrinsic, GiveTheSameProjections) {
  const SparseModel model = Import(kIntrinsicExtrinsicFormat, cameras_);
  ExpectSameProjections(model, known_);
  EXPECT_EQ(model.cameras.size(), 1u);
}

TEST_F(IntrinsicExtrinsic, AFrameMayHaveItsOwnCalibration) {
  dir_.WriteFile("cameras/img_2.intrinsic", Calibration(650));
  SparseModel expected = known_;
  expected.cameras.push_back(expected.cameras[0]);
  expected.cameras[1].id = 2;
  expected.cameras[1].params[1] = 650;
  expected.images[1].camera_id = 2;
  const SparseModel model = Import(kIntrinsicExtrinsicFormat, cameras_);
  ExpectSameProjections(model, expected);
  EXPECT_EQ(model.cameras.size(), 2u);
}

TEST_F(IntrinsicExtrinsic, BadOnesAreRefused) {
  const auto error_with = [&](const std::string& name, const std::string& text) {
    const std::string path = dir_.WriteFile("cameras/" + name, text);
    const std::string error = Error(kIntrinsicExtrinsicFormat, cameras_);
    EXPECT_THAT(error, HasSubstr(path));
    return error;
  };
  EXPECT_THAT(error_with("img_2.extrinsic", "1 0 0\n0 1 0\n0 0 1\n0 0\n"),
              HasSubstr("line 5: the file ends before element of a matrix"));
  EXPECT_THAT(error_with("img_2.extrinsic", "1 0 0\n0 1 0\n0 0 1\n0 0 0 0\n"),
              HasSubstr("line 4: more than the 12 numbers"));
  EXPECT_THAT(error_with("img_2.extrinsic", "1 0 0\n0 1 0\n0 0 2\n0 0 0\n"),
              HasSubstr("the rotation matrix is none: its columns"));
  EXPECT_THAT(error_with("img_2.extrinsic", "1 0 0\n0 1 0\n0 0 -1\n0 0 0\n"),
              HasSubstr("the rotation matrix is none: it mirrors"));
  EXPECT_THAT(error_with("img_2.extrinsic", "1 0 0\n0 1 0\n0 0 1\n0 0 inf\n"),
              HasSubstr("line 4: element of a matrix is not finite"));
  dir_.WriteFile("cameras/img_2.extrinsic", "1 0 0\n0 1 0\n0 0 1\n0 0 -6\n");
  EXPECT_THAT(error_with("calib.intrinsic", "600 0 320\n0 -600 240\n0 0 1\n"),
              HasSubstr("focal length that is not positive"));
  EXPECT_THAT(error_with("calib.intrinsic", "600 0 320\n10 600 240\n0 0 1\n"),
              HasSubstr("not upper triangular"));
  EXPECT_THAT(error_with("calib.intrinsic", "600 0 320\n0 600 240\n0 0 0\n"),
              HasSubstr("the last element of the calibration matrix is zero"));
  dir_.WriteFile("cameras/calib.intrinsic", Calibration());
  EXPECT_THAT(error_with("img_2.origin", "10 20\n"), HasSubstr("cropped"));
}

TEST_F(IntrinsicExtrinsic, NeedACalibration) {
  fs::remove(cameras_ / "calib.intrinsic");
  EXPECT_THAT(Error(kIntrinsicExtrinsicFormat, cameras_), HasSubstr("calib.intrinsic"));
}

// A published set with exact projections: data that may be missing. It has no photographs.
TEST_F(IntrinsicExtrinsic, ProjectThePublishedCurvesExactly) {
  const fs::path folder = fs::path(LIMN_DATA_DIR) / "synthcurves" / "turntable20";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
  images_ = dir_ / "blank";
  fs::create_directories(images_);
  for (const fs::path& file : FilesEndingWith(folder, ".extrinsic")) {
    cv::imwrite((images_ / (file.stem().string() + ".png")).string(),
                cv::Mat(400, 500, CV_8UC1, cv::Scalar(0)));
  }
  const SparseModel model = Import(kIntrinsicExtrinsicFormat, folder);
  ASSERT_EQ(model.images.size(), 20u);
  for (const ModelImage& image : model.images) {
    std::ifstream points(folder / "crv-3D-pts.txt");
    std::ifstream pixels(folder / (fs::path(image.name).stem().string() + "-pts-2D.txt"));
    Eigen::Vector3d point;
    Eigen::Vector2d pixel;
    int count = 0;
    while (points >> point.x() >> point.y() >> point.z() && pixels >> pixel.x() >> pixel.y()) {
      if (count++ % 100 != 0) continue;
      const Eigen::Vector2d in_colmap = pixel.array() + 0.5;
      EXPECT_LT((Project(model, image, point) - in_colmap).norm(), 1e-6);
    }
    EXPECT_EQ(count, 5117);
  }
}

}  // namespace
}  // namespace limn::colmap_ext
