// SPDX-License-Identifier: BSD-3-Clause
// What becomes of cameras that the images say little about: nothing gets worse, and the words are
// clear.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/model_folder.h"
#include "end_to_end/run_limn.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using colmap_ext::SparseModel;
using ::testing::AnyOf;
using ::testing::HasSubstr;

constexpr int kWidth = 480;
constexpr int kHeight = 360;
constexpr double kFocal = 375;
// On the plane, 2.5 from the cameras.
constexpr double kThirdOfPixel = 2.5 / kFocal / 3;

// With the center of the first pixel at (0, 0), as OpenCV has it.
const Eigen::Matrix3d& Intrinsics() {
  static const Eigen::Matrix3d k =
      Eigen::Matrix3d{{kFocal, 0, (kWidth - 1) / 2.0}, {0, kFocal, (kHeight - 1) / 2.0}, {0, 0, 1}};
  return k;
}

// A camera at `center` that looks at the origin.
Rigid3d LookingAtOrigin(const Eigen::Vector3d& center) {
  const Eigen::Vector3d forward = -center.normalized();
  const Eigen::Vector3d right = Eigen::Vector3d::UnitY().cross(forward).normalized();
  Eigen::Matrix3d rotation;
  rotation << right.transpose(), forward.cross(right).transpose(), forward.transpose();
  const Eigen::Quaterniond turn(rotation);
  return {turn, -(turn * center)};
}

std::string NameOf(size_t image) { return "view_" + std::to_string(image) + ".png"; }

// A model of these cameras, without points.
SparseModel ModelOf(const std::vector<Rigid3d>& poses) {
  SparseModel model;
  colmap_ext::Camera camera;
  camera.id = 1;
  camera.width = kWidth;
  camera.height = kHeight;
  camera.params = {kFocal, kFocal, kWidth / 2.0, kHeight / 2.0};
  model.cameras.push_back(camera);
  for (size_t i = 0; i < poses.size(); ++i) {
    model.images.push_back({static_cast<uint32_t>(i + 1), poses[i], 1, NameOf(i), {}});
  }
  return model;
}

cv::Mat Photo() { return cv::imread(LIMN_SAMPLE_DIR "/day/images/view_00.jpg"); }

// The photograph warped by a map of its pixels to those of an image, both in homogeneous
// coordinates.
cv::Mat Warped(const cv::Mat& photo, const Eigen::Matrix3d& map) {
  cv::Matx33d of_pixels;
  for (int i = 0; i < 9; ++i) of_pixels(i / 3, i % 3) = map(i / 3, i % 3);
  cv::Mat image;
  cv::warpPerspective(photo, image, of_pixels, {kWidth, kHeight}, cv::INTER_AREA,
                      cv::BORDER_REFLECT);
  return image;
}

// A photograph, 2 wide, on the plane z = 0.
cv::Mat PictureOnPlane(const Rigid3d& pose) {
  const cv::Mat photo = Photo();
  const double size = 2.0 / photo.cols;
  const Eigen::Matrix3d plane_from_photo{
      {size, 0, -1}, {0, size, -0.5 * size * photo.rows}, {0, 0, 1}};
  Eigen::Matrix3d camera_from_plane = pose.rotation.toRotationMatrix();
  camera_from_plane.col(2) = pose.translation;
  return Warped(photo, Intrinsics() * camera_from_plane * plane_from_photo);
}

std::vector<Rigid3d> PosesAroundPlane() {
  std::vector<Rigid3d> poses;
  for (int i = 0; i < 8; ++i) {
    const double angle = 0.25 * M_PI * i;
    poses.push_back(LookingAtOrigin({1.2 * std::cos(angle), 0.9 * std::sin(angle), -2}));
  }
  return poses;
}

std::vector<Rigid3d> Turned(std::vector<Rigid3d> poses, double rad) {
  for (size_t i = 0; i < poses.size(); ++i) {
    Rigid3d turn;
    turn.rotation = Eigen::AngleAxisd(i % 2 == 0 ? rad : -rad, Eigen::Vector3d::UnitX());
    poses[i] = turn * poses[i];
  }
  return poses;
}

class CameraRefiner : public ::testing::Test {
 protected:
  void Store(const SparseModel& model, const std::function<cv::Mat(size_t)>& image) const {
    fs::create_directories(dir_ / "sparse");
    fs::create_directories(dir_ / "images");
    colmap_ext::WriteModelBinary(model, dir_ / "sparse");
    for (size_t i = 0; i < model.images.size(); ++i) {
      cv::imwrite((dir_ / "images" / NameOf(i)).string(), image(i));
    }
  }

  std::string Refine(const std::string& how) const {
    const LimnRun run =
        RunLimn({"camera_refiner", "--workspace_path", dir_.path().string(), "--output_path",
                 (dir_ / "out").string(), "--refine_cameras", how, "--overwrite", "1"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.out;
  }

  SparseModel Refined() const { return colmap_ext::ReadModel(dir_ / "out/refined"); }

  void ExpectLeft(const std::vector<Rigid3d>& given) const {
    const SparseModel left = Refined();
    ASSERT_EQ(left.images.size(), given.size());
    for (size_t i = 0; i < given.size(); ++i) {
      EXPECT_EQ(left.images[i].cam_from_world.translation, given[i].translation) << i;
    }
  }

  TempDir dir_;
};

// The point nearest to the rays of its pixels.
Eigen::Vector3d Triangulated(const SparseModel& model, const std::vector<Eigen::Vector2d>& pixels) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
  const std::vector<double>& k = model.cameras[0].params;
  for (size_t i = 0; i < pixels.size(); ++i) {
    const Rigid3d world_from_cam = Inverse(model.images[i].cam_from_world);
    const Eigen::Vector3d in_camera((pixels[i].x() - k[2]) / k[0], (pixels[i].y() - k[3]) / k[1],
                                    1);
    const Eigen::Vector3d ray = (world_from_cam.rotation * in_camera).normalized();
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - ray * ray.transpose();
    sum += across;
    weighted += across * world_from_cam.translation;
  }
  return sum.ldlt().solve(weighted);
}

// How far points of the plane, 1 wide, end from where they are, when the cameras of a model see
// their true pixels: root mean square after the best similarity.
double SceneError(const SparseModel& model, const std::vector<Rigid3d>& truth,
                  const std::vector<size_t>& images) {
  constexpr int kSteps = 6;
  Eigen::Matrix3Xd points(3, kSteps * kSteps), seen(3, kSteps * kSteps);
  SparseModel chosen = model;
  chosen.images.clear();
  for (const size_t i : images) chosen.images.push_back(model.images[i]);
  for (int p = 0; p < kSteps * kSteps; ++p) {
    points.col(p) << 0.2 * (p % kSteps) - 0.5, 0.2 * (p / kSteps) - 0.5, 0;
    std::vector<Eigen::Vector2d> pixels;
    for (const size_t i : images) {
      const Eigen::Vector2d at = (Intrinsics() * (truth[i] * points.col(p))).hnormalized();
      pixels.push_back(at.array() + 0.5);
    }
    seen.col(p) = Triangulated(chosen, pixels);
  }
  const Eigen::Affine3d similarity(Eigen::umeyama(seen, points, true));
  return std::sqrt((similarity * seen - points).colwise().squaredNorm().mean());
}

TEST_F(CameraRefiner, PlanarScene) {
  const std::vector<Rigid3d> truth = PosesAroundPlane();
  const SparseModel given = ModelOf(Turned(truth, 0.002));
  Store(given, [&](size_t i) { return PictureOnPlane(truth[i]); });
  EXPECT_THAT(Refine("auto"), HasSubstr("Cameras refined: "));
  const std::vector<size_t> all = {0, 1, 2, 3, 4, 5, 6, 7};
  EXPECT_LT(SceneError(Refined(), truth, all), kThirdOfPixel);
}

// With views from straight ahead to 50 degrees aside: a plane that all see at one angle would leave
// the focal length open.
TEST_F(CameraRefiner, WrongFocalLength) {
  std::vector<Rigid3d> truth;
  for (int i = 0; i < 12; ++i) {
    const double angle = 2.4 * i;
    const double aside = 0.9 * i / 11;
    truth.push_back(LookingAtOrigin(2.3 * Eigen::Vector3d(std::sin(aside) * std::cos(angle),
                                                          std::sin(aside) * std::sin(angle),
                                                          -std::cos(aside))));
  }
  SparseModel given = ModelOf(truth);
  given.cameras[0].params[0] *= 1.03;
  given.cameras[0].params[1] *= 1.03;
  Store(given, [&](size_t i) { return PictureOnPlane(truth[i]); });
  EXPECT_THAT(Refine("auto"), HasSubstr("Focal lengths changed by up to "));
  EXPECT_NEAR(Refined().cameras[0].params[0], kFocal, 0.005 * kFocal);
}

TEST_F(CameraRefiner, OneImageSeesNothing) {
  const std::vector<Rigid3d> truth = PosesAroundPlane();
  const SparseModel given = ModelOf(Turned(truth, 0.002));
  Store(given, [&](size_t i) {
    return i == 3 ? cv::Mat(kHeight, kWidth, CV_8UC3, cv::Scalar(90, 90, 90))
                  : PictureOnPlane(truth[i]);
  });
  EXPECT_THAT(Refine("auto"), HasSubstr("1 of 8 images show no curve that others show"));
  const std::vector<size_t> others = {0, 1, 2, 4, 5, 6, 7};
  EXPECT_LT(SceneError(Refined(), truth, others), kThirdOfPixel);
  // It stays about where it was.
  EXPECT_LT(Refined().images[3].cam_from_world.rotation.angularDistance(
                given.images[3].cam_from_world.rotation),
            0.002);
}

TEST_F(CameraRefiner, NoCurves) {
  const std::vector<Rigid3d> given = PosesAroundPlane();
  Store(ModelOf(given),
        [](size_t i) { return cv::Mat(kHeight, kWidth, CV_8UC3, cv::Scalar::all(90.0 + i)); });
  EXPECT_THAT(Refine("auto"), HasSubstr("Cameras are left as they are"));
  EXPECT_THAT(Refine("1"), HasSubstr("the images show too few curves"));
  ExpectLeft(given);
}

// All but the same center: curves have no depth.
TEST_F(CameraRefiner, PureRotation) {
  std::vector<Rigid3d> truth;
  for (int i = 0; i < 6; ++i) {
    Rigid3d pose;
    pose.rotation = Eigen::AngleAxisd(0.04 * i, Eigen::Vector3d(0.3, 1, 0).normalized());
    pose.translation.x() = 1e-4 * i;
    truth.push_back(pose);
  }
  const std::vector<Rigid3d> given = Turned(truth, 0.002);
  const Eigen::Matrix3d center{{1, 0, -100}, {0, 1, 0}, {0, 0, 1}};
  Store(ModelOf(given), [&](size_t i) {
    const Eigen::Matrix3d turn = truth[i].rotation.toRotationMatrix();
    return Warped(Photo(), Intrinsics() * turn * Intrinsics().inverse() * center);
  });
  EXPECT_THAT(Refine("1"), HasSubstr("the images show too few curves"));
  ExpectLeft(given);
}

TEST_F(CameraRefiner, FewImages) {
  for (const size_t count : {3, 4}) {
    std::vector<Rigid3d> truth = PosesAroundPlane();
    truth.resize(count);
    const SparseModel given = ModelOf(Turned(truth, 0.002));
    fs::remove_all(dir_.path() / "images");
    Store(given, [&](size_t i) { return PictureOnPlane(truth[i]); });
    EXPECT_THAT(Refine("auto"),
                AnyOf(HasSubstr("Cameras refined: "), HasSubstr("Cameras are left as they are")));
    std::vector<size_t> all(count);
    std::iota(all.begin(), all.end(), 0);
    const double before = SceneError(given, truth, all);
    EXPECT_LE(SceneError(Refined(), truth, all), std::max(1.001 * before, kThirdOfPixel)) << count;
  }
}

}  // namespace
}  // namespace limn::testing
