// SPDX-License-Identifier: BSD-3-Clause
// Frames of a video with cameras in the layout of the authors' programs, a stand-in for their
// Capitol High (datasets/README.md): JPEG files, one calib.intrinsic, a .extrinsic per frame, all
// in one folder beside files that are nobody's business. From there to a drawing.
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/model_folder.h"
#include "colmap_ext/workspace/to_views.h"
#include "end_to_end/run_limn.h"
#include "limn/evaluation/evaluate_curves.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/model/curve_set.h"
#include "limn/util/angles.h"
#include "support/synthetic_image.h"
#include "support/synthetic_scene.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr int kNumFrames = 256;
constexpr int kWidth = 320;
constexpr int kHeight = 240;
// Every n-th frame shows the scene; the others only a square that moves.
constexpr int kPictureStride = 22;

using Quad = std::vector<Eigen::Vector3d>;

// A roof with a window in each of its two planes, which every camera sees from above: a color each,
// painted in this order. The planes meet in the ridge, their first edge.
const std::pair<Quad, float> kRoof[] = {
    {{{-1, 0, 0.5}, {1, 0, 0.5}, {1, 0.9, 0}, {-1, 0.9, 0}}, 190.0f},
    {{{-1, 0, 0.5}, {1, 0, 0.5}, {1, -0.9, 0}, {-1, -0.9, 0}}, 80.0f},
    {{{-0.6, 0.27, 0.35}, {0.1, 0.27, 0.35}, {0.1, 0.63, 0.15}, {-0.6, 0.63, 0.15}}, 40.0f},
    {{{-0.2, -0.27, 0.35}, {0.7, -0.27, 0.35}, {0.7, -0.63, 0.15}, {-0.2, -0.63, 0.15}}, 230.0f}};

// The edges of all quads, the ridge once.
std::vector<Polyline3d> TrueCurves() {
  std::vector<Polyline3d> curves = {{kRoof[0].first[0], kRoof[0].first[1]}};
  for (size_t q = 0; q < std::size(kRoof); ++q) {
    const Quad& quad = kRoof[q].first;
    for (size_t i = q < 2 ? 1 : 0; i < 4; ++i) curves.push_back({quad[i], quad[(i + 1) % 4]});
  }
  return curves;
}

// Along an arc of 130 degrees, not all at one height. The principal point is off the middle.
View Frame(int index) {
  const double angle = (-65 + 130.0 * index / (kNumFrames - 1)) * kDeg - 1;
  const double height = 3.2 + 0.6 * std::sin(0.05 * index);
  View view = LookAt({3 * std::cos(angle), 3 * std::sin(angle), height}, {0, 0, 0.2});
  view.camera = {500.25, 499.5, 161.125, 117.75, kWidth, kHeight};
  std::ostringstream name;
  name << "frame_" << std::setw(5) << std::setfill('0') << index + 1;
  view.name = name.str();
  return view;
}

cv::Mat Picture(const View& view) {
  Image image = ConstantImage(kWidth, kHeight, {128});
  for (const auto& [quad, level] : kRoof) {
    std::vector<Eigen::Vector2d> corners;
    for (const Eigen::Vector3d& corner : quad) {
      corners.push_back(view.camera.Project(view.cam_from_world * corner));
    }
    Paint(Polygon(corners), {level}, &image);
  }
  AddNoise(1, 7, &image);
  Quantize(&image);
  cv::Mat pixels;
  cv::Mat(kHeight, kWidth, CV_32FC1, image.data.data()).convertTo(pixels, CV_8U);
  return pixels;
}

cv::Mat OtherPicture(int index) {
  cv::Mat pixels(kHeight, kWidth, CV_8UC1, cv::Scalar(128));
  pixels(cv::Rect(index, 100, 32, 32)) = 200;
  return pixels;
}

class VideoFrames : public ::testing::Test {
 protected:
  VideoFrames() {
    fs::create_directories(folder_);
    for (int i = 0; i < kNumFrames; ++i) {
      frames_.push_back(Frame(i));
      const View& view = frames_.back();
      const bool has_picture = i % kPictureStride == 0;
      WriteImage(view.name, has_picture ? Picture(view) : OtherPicture(i));
      if (has_picture) list_ += view.name + ".jpg\n";
      WriteExtrinsic(view);
    }
    const PinholeCamera& camera = frames_[0].camera;
    std::ofstream(folder_ / "calib.intrinsic")
        << std::setprecision(17) << camera.fx << " 0 " << camera.cx << "\n0 " << camera.fy << " "
        << camera.cy << "\n0 0 1\n";
    for (const char* extra : {"README.txt", "frame_00001.edg.gz", "frame_00001.cemv", "list"}) {
      std::ofstream(folder_ / extra) << "not a camera\n";
    }
  }

  void WriteImage(const std::string& name, const cv::Mat& pixels) const {
    ASSERT_TRUE(
        cv::imwrite((folder_ / (name + ".jpg")).string(), pixels, {cv::IMWRITE_JPEG_QUALITY, 97}));
  }

  void WriteExtrinsic(const View& view) const {
    std::ofstream(folder_ / (view.name + ".extrinsic"))
        << std::setprecision(17) << view.cam_from_world.rotation.toRotationMatrix() << "\n"
        << view.CenterInWorld().transpose() << "\n";
  }

  LimnRun Import(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"model_importer", "--input_path", folder_.string(),
                                          "--output_path", model_.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunLimn(arguments);
  }

  std::vector<View> ImportedViews() const {
    return colmap_ext::ToViews(colmap_ext::ReadModel(model_), folder_, {}).views;
  }

  const TempDir dir_;
  const fs::path folder_ = dir_ / "house";
  const fs::path model_ = dir_ / "sparse" / "0";
  std::vector<View> frames_;
  std::string list_;
};

TEST_F(VideoFrames, AllCamerasAreImported) {
  const LimnRun run = Import();
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("Format intrinsic_extrinsic"),
                             HasSubstr("256 of 256 camera files matched to images by name"),
                             HasSubstr("with 1 cameras, 256 images"), Not(HasSubstr("left out"))));
  const std::vector<View> views = ImportedViews();
  ASSERT_EQ(views.size(), frames_.size());
  for (size_t i = 0; i < views.size(); ++i) {
    const View& truth = frames_[i];
    EXPECT_EQ(views[i].name, truth.name + ".jpg");
    EXPECT_EQ(views[i].camera.width, kWidth);
    EXPECT_EQ(views[i].camera.height, kHeight);
    EXPECT_NEAR(views[i].camera.fx, truth.camera.fx, 1e-9);
    EXPECT_NEAR(views[i].camera.fy, truth.camera.fy, 1e-9);
    EXPECT_NEAR(views[i].camera.cx, truth.camera.cx, 1e-9);
    EXPECT_NEAR(views[i].camera.cy, truth.camera.cy, 1e-9);
    EXPECT_LT((views[i].CenterInWorld() - truth.CenterInWorld()).norm(), 1e-9);
    EXPECT_LT((views[i].cam_from_world.rotation.toRotationMatrix() -
               truth.cam_from_world.rotation.toRotationMatrix())
                  .norm(),
              1e-9);
  }
}

TEST_F(VideoFrames, SomeOfThemGiveADrawing) {
  ASSERT_EQ(Import().exit_code, 0);
  const LimnRun run = RunLimn({"automatic_drawer", "--input_path", model_.string(), "--image_path",
                               folder_.string(), "--output_path", (dir_ / "out").string(),
                               "--image_list_path", dir_.WriteFile("list.txt", list_)});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  CurveSet truth;
  truth.polylines = TrueCurves();
  EvaluationOptions options;
  options.taus = {1};
  const DrawingGraph drawing = ReadDrawingJson((dir_ / "out" / "drawing.json").string()).graph;
  const EvaluationReport report =
      EvaluateCurvesInFootprints(ToCurveSet(drawing), truth, ImportedViews(), options);
  EXPECT_GE(report.rows[0].precision.value(), 0.95);
  EXPECT_GE(report.rows[0].recall.value(), 0.9);
}

TEST_F(VideoFrames, FramesWithoutACameraAreLeftOutByName) {
  fs::remove(folder_ / "frame_00007.extrinsic");
  fs::remove(folder_ / "frame_00200.extrinsic");
  const LimnRun run = Import();
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("254 of 254 camera files"), HasSubstr("with 1 cameras, 254 images"),
                    HasSubstr("2 images have no camera and are left out: "
                              "frame_00007.jpg, frame_00200.jpg\n")));
}

TEST_F(VideoFrames, ACameraWithoutAFrameIsAnErrorUnlessSkipped) {
  fs::remove(folder_ / "frame_00007.jpg");
  const LimnRun refused = Import();
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, AllOf(StartsWith("ERROR: "), HasSubstr("frame_00007.extrinsic"),
                                 HasSubstr("--skip_missing_images")));
  EXPECT_FALSE(fs::exists(model_ / "images.bin"));
  const LimnRun run = Import({"--skip_missing_images", "1"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("255 of 256 camera files"), HasSubstr("255 images")));
}

TEST_F(VideoFrames, WithoutTheCalibrationNothingIsImported) {
  fs::remove(folder_ / "calib.intrinsic");
  const LimnRun run = Import();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, AllOf(StartsWith("ERROR: "), HasSubstr("calib.intrinsic")));
}

}  // namespace
}  // namespace limn::testing
