// SPDX-License-Identifier: BSD-3-Clause
// Scenes with little or nothing to draw, too much of it, or what does not fit together: the main
// job ends well, within bounded time and memory. (Too few views and cameras at one center are cases
// of the corpus.)
#include <filesystem>
#include <regex>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/model_folder.h"
#include "end_to_end/run_limn.h"
#include "limn/evaluation/evaluate_curves.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/read_curves.h"
#include "limn/model/curve_set.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using colmap_ext::ModelImage;
using colmap_ext::SparseModel;
using ::testing::Contains;
using ::testing::Not;

// A minute or two on two idle cores; tests may run beside many others.
constexpr double kMaxSeconds = 600;
constexpr int kMaxMemoryMb = 2048;
// Of a pixel of the sample scene, meters.
constexpr double kFootprintM = 0.005;

// A workspace with some views of the sample scene by day, whose photographs can be replaced.
class DegenerateScene : public ::testing::Test {
 protected:
  // Every `stride`-th view.
  void TakeViews(size_t stride) {
    const fs::path day = fs::path(LIMN_SAMPLE_DIR) / "day";
    const SparseModel all = colmap_ext::ReadModel(day / "sparse");
    model_.cameras = all.cameras;
    fs::create_directories(dir_ / "images");
    for (size_t i = 0; i < all.images.size(); i += stride) {
      model_.images.push_back(all.images[i]);
      model_.images.back().observations.clear();
      fs::copy(day / "images" / all.images[i].name, dir_ / "images" / all.images[i].name);
    }
  }

  cv::Mat ReadImage(size_t view) const { return cv::imread(PathOf(view)); }
  void WriteImage(size_t view, const cv::Mat& pixels) {
    ModelImage& image = model_.images[view];
    fs::remove(PathOf(view));
    image.name = fs::path(image.name).replace_extension(".png").string();
    ASSERT_TRUE(cv::imwrite(PathOf(view), pixels));
  }

  // The drawing, which the reader validates.
  DrawingGraph Draw() {
    fs::create_directories(dir_ / "sparse" / "0");
    colmap_ext::WriteModelBinary(model_, dir_ / "sparse" / "0");
    RunConditions conditions;
    conditions.max_seconds = kMaxSeconds;
    conditions.max_memory_mb = kMaxMemoryMb;
    const LimnRun run = RunLimn({"automatic_drawer", "--workspace_path", dir_.path().string(),
                                 "--max_image_size", "-1", "--log_level", "2"},
                                conditions);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    out_ = run.out;
    return ReadDrawingJson((dir_ / "drawing.json").string()).graph;
  }

  std::string PathOf(size_t view) const {
    return (dir_ / "images" / model_.images[view].name).string();
  }

  TempDir dir_;
  SparseModel model_;
  std::string out_;
};

// The first count of edgels that a run prints, "1,234,567  edgels": those that were found.
int NumEdgels(const std::string& out) {
  std::smatch match;
  if (!std::regex_search(out, match, std::regex("([0-9,]+)  edgels\n"))) return 0;
  std::string digits = match[1];
  std::erase(digits, ',');
  return std::stoi(digits);
}

cv::Mat PlainImage(int level) { return {480, 640, CV_8UC3, cv::Scalar(level, level, level)}; }

TEST_F(DegenerateScene, OneImageIsWhite) {
  TakeViews(3);
  WriteImage(4, PlainImage(255));
  const DrawingGraph graph = Draw();
  EXPECT_GT(graph.links.size(), 20u);
  for (const DrawingLink& link : graph.links) {
    EXPECT_THAT(link.supporting_views, Not(Contains(4)));
  }
}

TEST_F(DegenerateScene, NoCurves) {
  TakeViews(3);
  // Files of the same bytes would be one image.
  for (size_t v = 0; v < model_.images.size(); ++v) {
    WriteImage(v, PlainImage(255 - static_cast<int>(v)));
  }
  EXPECT_EQ(Draw().links.size(), 0u);
}

// How much of the pixel lies in a disc of the plane z = 0, in 8 x 8 places.
double Coverage(const ModelImage& image, const colmap_ext::Camera& camera, int x, int y,
                double radius) {
  constexpr int kPlaces = 8;
  const Rigid3d world_from_cam = Inverse(image.cam_from_world);
  int inside = 0;
  for (int i = 0; i < kPlaces * kPlaces; ++i) {
    const double u = x + (i % kPlaces + 0.5) / kPlaces, v = y + (i / kPlaces + 0.5) / kPlaces;
    const Eigen::Vector3d ray =
        world_from_cam.rotation * Eigen::Vector3d((u - camera.params[2]) / camera.params[0],
                                                  (v - camera.params[3]) / camera.params[1], 1);
    const Eigen::Vector3d& center = world_from_cam.translation;
    const Eigen::Vector3d hit = center - center.z() / ray.z() * ray;
    inside += ray.z() < 0 && hit.norm() < radius;
  }
  return static_cast<double>(inside) / (kPlaces * kPlaces);
}

TEST_F(DegenerateScene, OneCurve) {
  constexpr double kRadius = 0.4;
  TakeViews(3);
  for (size_t v = 0; v < model_.images.size(); ++v) {
    cv::Mat pixels = PlainImage(255);
    for (int y = 0; y < pixels.rows; ++y) {
      for (int x = 0; x < pixels.cols; ++x) {
        const double dark = Coverage(model_.images[v], model_.cameras[0], x, y, kRadius);
        pixels.at<cv::Vec3b>(y, x) = cv::Vec3b::all(cv::saturate_cast<uint8_t>(255 - 200 * dark));
      }
    }
    WriteImage(v, pixels);
  }
  const DrawingGraph graph = Draw();
  double length = 0;
  for (const DrawingLink& link : graph.links) {
    length += Length(link.points_in_world);
    for (const Eigen::Vector3d& point : link.points_in_world) {
      EXPECT_NEAR(point.head<2>().norm(), kRadius, kFootprintM);
      EXPECT_NEAR(point.z(), 0, kFootprintM);
    }
  }
  EXPECT_NEAR(length, 2 * M_PI * kRadius, 0.05 * 2 * M_PI * kRadius);
}

// Stripes of 8 px in an image of 5 megapixels beside seven ordinary ones.
TEST_F(DegenerateScene, ManyEdgelsInOneView) {
  constexpr int kScale = 4, kStripePx = 8;
  TakeViews(3);
  cv::Mat pixels(480 * kScale, 640 * kScale, CV_8UC3, cv::Scalar(40, 40, 40));
  for (int x = 0; x < pixels.cols; x += 2 * kStripePx) {
    pixels.colRange(x, x + kStripePx) = cv::Scalar(220, 220, 220);
  }
  WriteImage(2, pixels);
  colmap_ext::Camera camera = model_.cameras[0];
  ++camera.id;
  camera.width *= kScale;
  camera.height *= kScale;
  for (double& parameter : camera.params) parameter *= kScale;
  model_.cameras.push_back(camera);
  model_.images[2].camera_id = camera.id;
  EXPECT_GT(Draw().links.size(), 20u);
  // The others have less than 50,000 each.
  EXPECT_GT(NumEdgels(out_), 500000 + 7 * 50000);
}

// Every second photograph is that of another place: mirrored ones are as good as any.
TEST_F(DegenerateScene, HalfTheViewsAreOfAnotherScene) {
  TakeViews(2);
  for (size_t v = 0; v < model_.images.size(); v += 2) {
    cv::Mat mirrored;
    cv::flip(ReadImage(v), mirrored, 1);
    WriteImage(v, mirrored);
  }
  const DrawingGraph graph = Draw();
  EXPECT_GT(graph.links.size(), 20u);
  EvaluationOptions options;
  options.taus = {2 * kFootprintM};
  options.region =
      Eigen::AlignedBox3d(Eigen::Vector3d(-1.25, -0.95, 0.04), Eigen::Vector3d(1.25, 0.95, 1.05));
  const std::string truth = LIMN_SAMPLE_DIR "/truth/";
  const EvaluationReport report =
      EvaluateCurves(ToCurveSet(graph), ReadCurves(truth + "curves-visible.ply"), options,
                     ReadCurves(truth + "dont-care.ply"));
  // More of what is drawn is there than is not.
  EXPECT_GT(report.rows[0].precision.value(), 0.5);
}

}  // namespace
}  // namespace limn::testing
