// SPDX-License-Identifier: BSD-3-Clause
// Panoramas of the sample scene against its photographs: each photograph is the only part of a
// panorama that is not masked, at the same pixel footprint, turned so that it lies anywhere in it.
#include <cmath>
#include <filesystem>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/model_folder.h"
#include "colmap_ext/workspace/to_views.h"
#include "end_to_end/run_limn.h"
#include "limn/evaluation/evaluate_curves.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/read_curves.h"
#include "limn/model/link_selection.h"
#include "support/random_numbers.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using colmap_ext::Camera;
using colmap_ext::CameraModelId;
using colmap_ext::SparseModel;
using ::testing::HasSubstr;

// view_00 to view_09 of the 24: enough for a drawing.
constexpr size_t kNumImages = 10;

SparseModel SampleModel() {
  SparseModel model = colmap_ext::ReadModel(LIMN_SAMPLE_DIR "/day/sparse");
  std::erase_if(model.images, [](const auto& image) { return image.name >= "view_10"; });
  model.points.clear();
  for (auto& image : model.images) image.observations.clear();
  return model;
}

// Any azimuth, and up to 25 degrees of tilt.
Eigen::Quaterniond RandomTurn(std::mt19937* random) {
  testing::UniformDistribution<double> uniform(-1, 1);
  const Eigen::AngleAxisd azimuth(M_PI * uniform(*random), Eigen::Vector3d::UnitY());
  const Eigen::AngleAxisd tilt(0.44 * uniform(*random), Eigen::Vector3d::UnitX());
  return Eigen::Quaterniond(azimuth * tilt);
}

// Where the pixels of the panorama are in the photograph; far outside where they are not.
cv::Mat PhotoFromPanorama(const Camera& pinhole, int width, const Eigen::Quaterniond& turn) {
  const Eigen::Matrix3d photo_from_panorama = turn.conjugate().toRotationMatrix();
  cv::Mat map(width / 2, width, CV_32FC2, cv::Scalar(-100, -100));
  for (int y = 0; y < map.rows; ++y) {
    const double elevation = M_PI * (0.5 - (y + 0.5) / map.rows);
    for (int x = 0; x < width; ++x) {
      const double azimuth = 2 * M_PI * ((x + 0.5) / width - 0.5);
      const Eigen::Vector3d ray =
          photo_from_panorama * Eigen::Vector3d(std::cos(elevation) * std::sin(azimuth),
                                                -std::sin(elevation),
                                                std::cos(elevation) * std::cos(azimuth));
      if (ray.z() < 0.1) continue;
      const auto& p = pinhole.params;
      map.at<cv::Vec2f>(y, x) =
          cv::Vec2f(static_cast<float>(p[0] * ray.x() / ray.z() + p[2] - 0.5),
                    static_cast<float>(p[1] * ray.y() / ray.z() + p[3] - 0.5));
    }
  }
  return map;
}

cv::Mat MaskOf(const cv::Mat& map, const Camera& pinhole) {
  cv::Mat mask(map.size(), CV_8UC1, cv::Scalar(0));
  const cv::Rect2f inside(8, 8, static_cast<float>(pinhole.width) - 17,
                          static_cast<float>(pinhole.height) - 17);
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      const cv::Vec2f at = map.at<cv::Vec2f>(y, x);
      if (inside.contains(cv::Point2f(at[0], at[1]))) mask.at<unsigned char>(y, x) = 255;
    }
  }
  return mask;
}

// A workspace of panoramas with masks.
class PanoramaWorkspace {
 public:
  PanoramaWorkspace() {
    SparseModel model = SampleModel();
    const Camera pinhole = model.cameras.front();
    const int width = 8 * static_cast<int>(std::lround(2 * M_PI * pinhole.params[0] / 8));
    model.cameras = {{pinhole.id,
                      CameraModelId::kEquirectangular,
                      static_cast<uint64_t>(width),
                      static_cast<uint64_t>(width / 2),
                      {1.0 * width, 0.5 * width}}};
    for (const char* folder : {"sparse", "images", "masks"}) fs::create_directories(dir_ / folder);
    std::mt19937 random(1);
    for (auto& image : model.images) {
      const Eigen::Quaterniond turn = RandomTurn(&random);
      const cv::Mat map = PhotoFromPanorama(pinhole, width, turn);
      const cv::Mat photo = cv::imread(LIMN_SAMPLE_DIR "/day/images/" + image.name);
      cv::Mat panorama;
      cv::remap(photo, panorama, map, {}, cv::INTER_CUBIC, cv::BORDER_REFLECT);
      image.cam_from_world = Rigid3d{turn, Eigen::Vector3d::Zero()} * image.cam_from_world;
      image.name = fs::path(image.name).replace_extension(".png").string();
      cv::imwrite((dir_ / "images" / image.name).string(), panorama);
      cv::imwrite((dir_ / "masks" / (image.name + ".png")).string(), MaskOf(map, pinhole));
    }
    colmap_ext::WriteModelText(model, dir_ / "sparse");
  }

  LimnRun Draw(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"automatic_drawer",
                                          "--workspace_path",
                                          dir_.path().string(),
                                          "--mask_path",
                                          (dir_ / "masks").string(),
                                          "--page",
                                          "0"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunLimn(arguments);
  }
  const TempDir& dir() const { return dir_; }

 private:
  TempDir dir_;
};

// At this many footprints of the photographs, for both kinds alike.
TauResult Judge(const fs::path& drawing, double tau = 2) {
  EvaluationOptions options;
  options.taus = {tau};
  options.find_duplicates = false;
  options.region =
      Eigen::AlignedBox3d(Eigen::Vector3d(-1.25, -0.95, 0.04), Eigen::Vector3d(1.25, 0.95, 1.05));
  const auto views = colmap_ext::ToViews(SampleModel(), LIMN_SAMPLE_DIR "/day/images", {}).views;
  const DrawingGraph graph =
      Selected(ReadDrawingJson(drawing.string()).graph, LinkSelection::AsSeen());
  return EvaluateCurvesInFootprints(ToCurveSet(graph),
                                    ReadCurves(LIMN_SAMPLE_DIR "/truth/curves-visible.ply"), views,
                                    options, ReadCurves(LIMN_SAMPLE_DIR "/truth/dont-care.ply"))
      .rows.front();
}

TEST(Panoramas, AreDrawnAsWellAsPhotographs) {
  const PanoramaWorkspace workspace;
  const LimnRun run = workspace.Draw();
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, ::testing::Not(HasSubstr("next to no"))) << "most parts show nothing";
  const TempDir photographs;
  std::string names;
  for (size_t i = 0; i < kNumImages; ++i) names += "view_0" + std::to_string(i) + ".jpg\n";
  const LimnRun plain = RunLimn({"automatic_drawer", "--workspace_path", LIMN_SAMPLE_DIR "/day",
                                 "--image_list_path", photographs.WriteFile("list.txt", names),
                                 "--output_path", (photographs / "out").string(), "--page", "0"});
  ASSERT_EQ(plain.exit_code, 0) << plain.err;
  const TauResult of_panoramas = Judge(workspace.dir() / "drawing.json");
  const TauResult of_photographs = Judge(photographs / "out/drawing.json");
  std::printf("P / R / F of panoramas %.3f / %.3f / %.3f, of photographs %.3f / %.3f / %.3f\n",
              *of_panoramas.precision, *of_panoramas.recall, *of_panoramas.f,
              *of_photographs.precision, *of_photographs.recall, *of_photographs.f);
  EXPECT_GT(*of_panoramas.f, *of_photographs.f - 0.05);

  const LimnRun posed = workspace.Draw({"--refine_cameras", "1"});
  EXPECT_EQ(posed.exit_code, 1);
  EXPECT_THAT(posed.err, HasSubstr("ERROR: refine_cameras = 1: not with EQUIRECTANGULAR images"));
  const LimnRun given = workspace.Draw({"--edges_path", workspace.dir().path().string()});
  EXPECT_EQ(given.exit_code, 1);
  EXPECT_THAT(given.err, HasSubstr("ERROR: edges_path"));
}

// However many parts they have.
TEST(Panoramas, OfTwoPlacesAreTooFew) {
  const PanoramaWorkspace workspace;
  const LimnRun run = workspace.Draw(
      {"--image_list_path", workspace.dir().WriteFile("two.txt", "view_00.png\nview_01.png\n")});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.out, HasSubstr("2 images (in 24 views: panoramas in parts)"));
  EXPECT_THAT(run.err, HasSubstr("at 3 places at least, but all are at 2"));
}

TEST(Panoramas, ThatColmapShrankAreDrawnInDense) {
  constexpr int kWidth = 1000;
  const PanoramaWorkspace workspace;
  const fs::path dense = workspace.dir() / "dense/0";
  fs::create_directories(dense);
  fs::rename(workspace.dir() / "images", dense / "images");
  const fs::path masks = workspace.dir() / "masks";
  SparseModel model = colmap_ext::ReadModel(workspace.dir() / "sparse");
  // Of a product, the parameters are beside the size.
  const double width = std::nextafter(kWidth, 2.0 * kWidth);
  const double reduction = static_cast<double>(model.cameras.front().width) / kWidth;
  model.cameras.front().width = kWidth;
  model.cameras.front().height = kWidth / 2;
  model.cameras.front().params = {width, width / 2};
  colmap_ext::WriteModelBinary(model, dense / "sparse");
  for (const auto& image : model.images) {
    const std::string path = (dense / "images" / image.name).string();
    cv::Mat shrunk;
    cv::resize(cv::imread(path), shrunk, {kWidth, kWidth / 2}, 0, 0, cv::INTER_AREA);
    cv::imwrite(path, shrunk);
    const std::string mask_path = (masks / (image.name + ".png")).string();
    const cv::Mat mask = cv::imread(mask_path, cv::IMREAD_GRAYSCALE);
    cv::Mat shrunk_mask;
    cv::resize(mask, shrunk_mask, {kWidth, kWidth / 2}, 0, 0, cv::INTER_NEAREST);
    cv::imwrite(mask_path, shrunk_mask);
  }
  const LimnRun run = workspace.Draw();
  ASSERT_EQ(run.exit_code, 0) << run.err;
  // At two pixels of theirs.
  const TauResult result = Judge(dense / "drawing.json", 2 * reduction);
  std::printf("P / R of shrunk panoramas %.3f / %.3f\n", *result.precision, *result.recall);
  EXPECT_GT(*result.precision, 0.8);
  EXPECT_GT(*result.recall, 0.05);
  for (const char* part : {"00", "11"}) {
    EXPECT_TRUE(fs::exists(dense / "curves/cache/fragments" /
                           (model.images.front().name + ".part" + part + ".bin")));
  }
}

}  // namespace
}  // namespace limn::testing
