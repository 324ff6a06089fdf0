// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <atomic>
#include <barrier>
#include <cmath>
#include <thread>

#include <gmock/gmock.h>

#include "colmap_ext/workspace/to_views_fixture.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A panorama whose columns and rows tell their places, as "b.png".
class PanoramaViewsTest : public ToViewsTest {
 protected:
  PanoramaViewsTest() {
    cv::Mat image(kHeight, kWidth, CV_8UC3);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        // OpenCV's order is blue, green, red.
        image.at<cv::Vec3b>(y, x) = cv::Vec3b(y, x / 256, x % 256);
      }
    }
    Write("b.png", image);
    SetPanorama();
  }

  void ForgetPoints() {
    model_.points.clear();
    for (ModelImage& image : model_.images) image.observations.clear();
  }

  // Points all around this image, up to 60 degrees above and below it, that it sees where they are.
  void AddPanoramaPoints(uint32_t count, int image_index) {
    ModelImage& image = model_.images[image_index];
    for (uint32_t i = 0; i < count; ++i) {
      ModelPoint point;
      point.id = 1 + model_.points.size();
      const Eigen::Vector3d ray(std::sin(i), 0.9 * std::sin(3.0 * i), std::cos(i));
      point.position = Inverse(image.cam_from_world) * (5 * ray);
      const double azimuth = std::atan2(ray.x(), ray.z());
      const double elevation = std::atan2(-ray.y(), std::hypot(ray.x(), ray.z()));
      image.observations.push_back(
          {{(azimuth / (2 * M_PI) + 0.5) * kWidth, (0.5 - elevation / M_PI) * kHeight}, point.id});
      point.track.push_back({image.id, i});
      model_.points.push_back(point);
    }
  }

  void SetPanorama() {
    model_.cameras.push_back(
        {9, CameraModelId::kEquirectangular, kWidth, kHeight, {1.0 * kWidth, 1.0 * kHeight}});
    model_.images[2].camera_id = 9;
    ASSERT_EQ(model_.images[2].name, "b.png");
  }

  static constexpr int kWidth = 480, kHeight = 240;
};

TEST_F(PanoramaViewsTest, EveryPartIsAViewOfItsPixels) {
  const ViewSet set = Views();
  ASSERT_EQ(set.views.size(), 14u);
  EXPECT_TRUE(set.HasPanoramas());
  for (ViewId v = 0; v < kNumPanoramaParts; ++v) {
    const View& view = set.views[v];
    EXPECT_EQ(view.name, "b.png.part" + std::string(v < 10 ? "0" : "") + std::to_string(v));
    ASSERT_TRUE(set.files[v].window);
    EXPECT_EQ(set.files[v].image_name, "b.png");
    EXPECT_EQ(view.model_index, 2);
    EXPECT_LT((view.CenterInWorld() - Inverse(model_.images[2].cam_from_world).translation).norm(),
              1e-12);
    const Image image = ReadViewImage(set, v);
    ASSERT_EQ(image.width, view.camera.width);
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(image.width - 1, image.height - 1)}) {
      const float* pixel = &image.data[3 * (static_cast<size_t>(y) * image.width + x)];
      const int column = static_cast<int>(pixel[0] + 256 * pixel[1]);
      EXPECT_EQ(column, (x + set.files[v].window->x + kWidth) % kWidth);
      EXPECT_EQ(pixel[2], y + set.files[v].window->y);
    }
  }
  EXPECT_EQ(set.views[12].name, "c.png");
  EXPECT_FALSE(set.files[12].window);
}

TEST_F(PanoramaViewsTest, TracksAreInPixelsOfTheImage) {
  const ViewSet set = Views();
  const std::vector<View> whole = InStoredImages(set, set.views);
  ASSERT_EQ(whole.size(), set.views.size());
  for (ViewId v = 0; v < kNumPanoramaParts; ++v) {
    EXPECT_EQ(whole[v].name, "b.png");
    const Eigen::Vector2d center(whole[v].camera.cx, whole[v].camera.cy);
    const Eigen::Vector2d part_px = *set.views[v].StoredFromVirtual(center);
    const Eigen::Vector2d image_px = *whole[v].StoredFromVirtual(center);
    EXPECT_LT((image_px - part_px - Eigen::Vector2d(set.files[v].window->x, set.files[v].window->y))
                  .norm(),
              1e-9);
    EXPECT_LT((*whole[v].lens->VirtualFromStored(image_px) - center).norm(), 1e-7);
  }
  EXPECT_EQ(whole[12].lens, set.views[12].lens);
}

TEST_F(PanoramaViewsTest, PointsBelongToThePartsThatShowThem) {
  ForgetPoints();
  AddPanoramaPoints(200, 2);
  options_.border_margin_px = 2;
  const ViewSet set = Views();
  // A few are in the pixel between parts.
  EXPECT_GT(set.hints.points.size(), 180u);
  EXPECT_LT(set.hints.points.size(), 200u);
  EXPECT_THAT(set.warnings, IsEmpty()) << "the panorama shows these, too";
  size_t num_pixels = 0;
  for (const ScenePoint& hint : set.hints.points) {
    ASSERT_EQ(hint.pixels.size(), hint.views.size());
    for (const PointPixel& seen : hint.pixels) {
      const auto pixel = set.views[seen.view].Project(hint.position_in_world);
      ASSERT_TRUE(pixel);
      EXPECT_LT((*pixel - seen.position_px).norm(), 1e-6);
    }
    num_pixels += hint.pixels.size();
  }
  EXPECT_LE(num_pixels, set.hints.points.size() + 3) << "or in that of two";
}

// COLMAP shrinks pictures and observations; the camera's parameters may be beside its size.
TEST_F(PanoramaViewsTest, OfHalfTheSizeAreTheSameViews) {
  ForgetPoints();
  AddPanoramaPoints(200, 2);
  options_.border_margin_px = 2;
  const ViewSet whole = Views();
  Write("b.png", cv::Mat(kHeight / 2, kWidth / 2, CV_8UC3, cv::Scalar(1, 2, 3)));
  model_.cameras.back().width = kWidth / 2;
  model_.cameras.back().height = kHeight / 2;
  model_.cameras.back().params = {std::nextafter(kWidth / 2.0, 1e9), kHeight / 2.0};
  for (Observation& observation : model_.images[2].observations) observation.position /= 2;
  options_.border_margin_px = 1;
  const ViewSet half = Views();
  ASSERT_EQ(half.views.size(), whole.views.size());
  for (ViewId v = 0; v < kNumPanoramaParts; ++v) {
    // Parts are cut at whole pixels.
    EXPECT_LT(half.views[v].cam_from_world.rotation.angularDistance(
                  whole.views[v].cam_from_world.rotation),
              2 * M_PI / kWidth);
    EXPECT_NEAR(2 * half.views[v].camera.fx, whole.views[v].camera.fx, 1e-9);
  }
  EXPECT_GT(half.hints.points.size(), 0.9 * static_cast<double>(whole.hints.points.size()));
  for (const ScenePoint& hint : half.hints.points) {
    const auto pixel = half.views[hint.views[0]].Project(hint.position_in_world);
    ASSERT_TRUE(pixel);
    EXPECT_LT((*pixel - hint.pixels[0].position_px).norm(), 1e-6);
  }
}

// A panorama shows six times as much as a photograph.
TEST_F(PanoramaViewsTest, AreShrunkPerQuarterTurn) {
  options_.border_margin_px = 0;
  options_.max_image_size = kWidth / 4;
  const ViewSet whole = Views();
  EXPECT_EQ(whole.files[0].window->image_width, kWidth);
  EXPECT_EQ(whole.views[12].camera.width, kWidth / 4) << "a photograph";
  options_.max_image_size = kWidth / 8;
  const ViewSet half = Views();
  EXPECT_EQ(half.files[0].window->image_width, kWidth / 2);
  EXPECT_EQ(half.files[0].window->image_height, kHeight / 2);
  EXPECT_EQ(half.MaxFileSize(0), kWidth / 2);
  EXPECT_EQ(half.MaxFileSize(12), kWidth / 8);
  EXPECT_EQ(ReadViewImage(half, 0).width, half.views[0].camera.width);
}

TEST_F(PanoramaViewsTest, AreLeftOutAsAWhole) {
  model_.images[0].camera_id = 9;
  Write("c.png", cv::Mat(kHeight, kWidth, CV_8UC3, cv::Scalar(9, 9, 9)));
  ForgetPoints();
  for (const int image : {0, 2}) AddPanoramaPoints(400, image);
  options_.max_reprojection_px = 5;
  EXPECT_EQ(Views().views.size(), 25u);
  // Most of what each of a few parts shows misses, but not most of what the image shows.
  std::vector<Observation>& seen = model_.images[2].observations;
  for (size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].position.x() < 0.3 * kWidth) seen[i].position.y() += 20;
  }
  const ViewSet all = Views();
  EXPECT_EQ(all.views.size(), 25u);
  EXPECT_THAT(all.warnings, IsEmpty());
  for (Observation& observation : seen) {
    if (observation.position.x() < 0.9 * kWidth) observation.position.y() += 20;
  }
  const ViewSet fewer = Views();
  EXPECT_EQ(fewer.views.size(), 13u);
  for (ViewId v = 0; v < 13; ++v) EXPECT_NE(fewer.ImageName(v), "b.png");
  EXPECT_EQ(fewer.files.size(), 13u);
  ASSERT_THAT(fewer.warnings, Contains(HasSubstr("left out")));
  EXPECT_THAT(fewer.warnings, Contains(HasSubstr("miss 1 of 3 images by more than 5 px: b.png (")));
}

TEST_F(PanoramaViewsTest, PartsCountAsOneImage) {
  const ViewSet set = Views();
  EXPECT_EQ(set.CountImages({}), 0u);
  EXPECT_EQ(set.CountImages({0, 5, 11}), 1u);
  EXPECT_EQ(set.CountImages({3, 4, 12, 13}), 3u);
}

TEST_F(PanoramaViewsTest, ThreadsThatLiveOnKeepNothingAfterRelease) {
  Write("masks/b.png.png", cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(255)));
  options_.mask_path = (dir_ / "masks").string();
  const ViewSet set = Views();
  constexpr int kNumThreads = 4;
  std::barrier all_have(kNumThreads + 1), released(kNumThreads + 1);
  std::atomic<int> num_kept = 0;
  std::vector<std::thread> threads;
  for (ViewId v = 0; v < kNumThreads; ++v) {
    threads.emplace_back([&, v] {
      ReadViewImage(set, v);
      all_have.arrive_and_wait();
      released.arrive_and_wait();
      try {
        ReadViewImage(set, v);
        ++num_kept;
      } catch (const IoError&) {
        // As it should be: the file is gone.
      }
    });
  }
  all_have.arrive_and_wait();
  fs::remove(set.files[0].image_path);
  ReleaseDecoded(set);
  released.arrive_and_wait();
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(num_kept, 0);
}

TEST_F(PanoramaViewsTest, MasksAreNotKeptAfterTheViewsAreMade) {
  Write("masks/b.png.png", cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(255)));
  options_.mask_path = (dir_ / "masks").string();
  const ViewSet set = Views();
  fs::remove(set.files[0].mask_path);
  for (int round = 0; round < 20; ++round) {
    ParallelFor({}, "masks", kNumPanoramaParts, [&](size_t v) {
      EXPECT_THROW(ReadViewMask(set, static_cast<ViewId>(v)), IoError);
    });
  }
}

TEST_F(PanoramaViewsTest, FilesAreDecodedOnceForAllParts) {
  Write("masks/b.png.png", cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(255)));
  options_.mask_path = (dir_ / "masks").string();
  const ViewSet set = Views();
  ReadViewImage(set, 0);
  for (const std::string& path : {set.files[0].image_path, set.files[0].mask_path})
    fs::remove(path);
  for (ViewId v = 1; v < kNumPanoramaParts; ++v) {
    const Image part = ReadViewImage(set, v);
    EXPECT_EQ(part.mask.size(), static_cast<size_t>(part.width) * part.height);
  }
  // Nothing is kept after the last part.
  EXPECT_THROW(ReadViewImage(set, 0), IoError);
}

TEST_F(PanoramaViewsTest, MasksAreCutAlike) {
  cv::Mat mask(kHeight, kWidth, CV_8UC1, cv::Scalar(255));
  mask(cv::Rect(0, 0, kWidth, kHeight / 2)).setTo(0);
  Write("masks/b.png.png", mask);
  options_.mask_path = (dir_ / "masks").string();
  const ViewSet set = Views();
  const auto upper = ReadViewMask(set, 0), lower = ReadViewMask(set, 11);
  EXPECT_TRUE(std::all_of(upper.begin(), upper.end(), [](unsigned char m) { return m == 0; }));
  EXPECT_TRUE(std::all_of(lower.begin(), lower.end(), [](unsigned char m) { return m != 0; }));
  EXPECT_FALSE(set.views[0].Project(set.views[0].CenterInWorld() +
                                    set.views[0].cam_from_world.rotation.conjugate() *
                                        Eigen::Vector3d::UnitZ()));
}

}  // namespace
}  // namespace limn::colmap_ext
