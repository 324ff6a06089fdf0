// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/to_views.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "colmap_ext/workspace/exif_of_jpeg.h"
#include "colmap_ext/workspace/to_views_fixture.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST_F(ToViewsTest, ViewsAreSortedByNameAndKeepTheirFileOrder) {
  const ViewSet set = Views();
  ASSERT_EQ(set.views.size(), 3u);
  EXPECT_EQ(set.views[0].name, "b.png");
  EXPECT_EQ(set.views[1].name, "c.png");
  EXPECT_EQ(set.views[2].name, "sub/a b.png");
  EXPECT_EQ(set.views[0].model_index, 2);
  EXPECT_EQ(set.views[1].model_index, 0);
  EXPECT_EQ(set.views[2].model_index, 1);
  EXPECT_EQ(set.files[2].image_path, (dir_.path() / "sub/a b.png").string());
  EXPECT_EQ(set.views[1].cam_from_world.translation, model_.images[0].cam_from_world.translation);
  EXPECT_THAT(set.warnings, IsEmpty());
}

TEST_F(ToViewsTest, PrincipalPointMovesByHalfAPixel) {
  const View view =
      Views().views[1];  // camera 3: PINHOLE, principal point at the center (w/2, h/2)
  EXPECT_EQ(view.camera.cx, 800 / 2 - 0.5);
  EXPECT_EQ(view.camera.cy, 600 / 2 - 0.5);
  EXPECT_EQ(view.camera.fx, 503);
  EXPECT_EQ(view.camera.fy, 513);
  EXPECT_EQ(view.camera.width, 800);
  EXPECT_EQ(view.camera.height, 600);
  EXPECT_EQ(view.lens, nullptr);
}

TEST_F(ToViewsTest, LensIsInLimnsPixels) {
  SetCamera3(CameraModelId::kOpencv);
  const View view = Views().views[1];
  ASSERT_NE(view.lens, nullptr);
  EXPECT_EQ(view.camera.fx, 500.5);
  EXPECT_EQ(view.camera.cx, 403.25 - 0.5);
  EXPECT_EQ(view.camera.cy, 297.75 - 0.5);
  // The stored pixel of a ray, in COLMAP's pixels, is the lens's image of the virtual pixel of
  // that ray.
  const CameraProjection projection(IntrinsicsOf(model_.cameras[1]));
  const Eigen::Vector2d ray(0.4, -0.3);
  const Eigen::Vector2d colmap_px = *projection.PixelFromRay(ray);
  const Eigen::Vector2d virtual_px = view.camera.Project({ray.x(), ray.y(), 1});
  const auto stored = view.lens->StoredFromVirtual(virtual_px);
  ASSERT_TRUE(stored);
  EXPECT_LT((*stored - (colmap_px - Eigen::Vector2d(0.5, 0.5))).norm(), 1e-10);
  const auto back = view.lens->VirtualFromStored(*stored);
  ASSERT_TRUE(back);
  EXPECT_LT((*back - virtual_px).norm(), 1e-8);
  EXPECT_GT((*stored - virtual_px).norm(), 1);  // there is distortion to speak of
}

TEST_F(ToViewsTest, ZeroDistortionNeedsNoLensButFisheyesDo) {
  model_.cameras[1] = {3, CameraModelId::kSimpleRadial, 800, 600, {500, 400, 300, 1e-9}};
  EXPECT_EQ(Views().views[1].lens, nullptr);
  model_.cameras[1] = {3, CameraModelId::kSimpleFisheye, 800, 600, {500, 400, 300}};
  EXPECT_NE(Views().views[1].lens, nullptr);
}

TEST_F(ToViewsTest, ImagesOfOneCameraShareItsLens) {
  SetCamera3(CameraModelId::kRadial);
  const ViewSet set = Views();
  EXPECT_EQ(set.views[0].lens, set.views[1].lens);
  EXPECT_EQ(set.views[2].lens, nullptr);
}

TEST_F(ToViewsTest, PointsBecomeHintsInSelectedViews) {
  ViewSet set = Views();
  ASSERT_EQ(set.hints.points.size(), 2u);
  // By id.
  EXPECT_EQ(set.hints.points[0].position_in_world, model_.points[1].position);
  EXPECT_THAT(set.hints.points[0].views, ElementsAre(0));
  EXPECT_THAT(set.hints.points[1].views, ElementsAre(0, 1));
  model_.points[0].track = {{5, 0}, {5, 1}};
  model_.points[1].track = {};
  set = Views();
  ASSERT_EQ(set.hints.points.size(), 1u);
  EXPECT_THAT(set.hints.points[0].views, ElementsAre(0));
  EXPECT_THAT(set.warnings, ElementsAre(HasSubstr("1 3D points are seen by no image")));
}

TEST_F(ToViewsTest, HintsTellWhereViewsSeeThem) {
  WriteImage("c.png", 400, 300);
  const ViewSet set = Views();
  const std::vector<PointPixel>& pixels = set.hints.points[1].pixels;
  ASSERT_EQ(pixels.size(), 2u);
  EXPECT_EQ(pixels[0].view, 0);
  EXPECT_EQ(pixels[1].view, 1);
  EXPECT_LT((pixels[0].position_px - Eigen::Vector2d(32.5, 43.5)).norm(), 1e-12);
  // (10.25, 20.5) in an image of half the size.
  EXPECT_LT((pixels[1].position_px - Eigen::Vector2d(4.625, 9.75)).norm(), 1e-12);
  EXPECT_EQ(set.hints.points[1].model_index, 0);
}

TEST_F(ToViewsTest, HintsDoNotDependOnTheOrderInTheModel) {
  model_.points[0].track = {{9, 0}, {5, 0}, {5, 1}};
  model_.images[2].observations[1].point3D_id = 1000;
  const ViewSet in_order = Views();
  std::reverse(model_.images.begin(), model_.images.end());
  std::reverse(model_.points.begin(), model_.points.end());
  for (ModelPoint& point : model_.points) std::reverse(point.track.begin(), point.track.end());
  const ViewSet reversed = Views();
  ASSERT_EQ(reversed.hints.points.size(), in_order.hints.points.size());
  for (size_t p = 0; p < in_order.hints.points.size(); ++p) {
    const ScenePoint& expected = in_order.hints.points[p];
    const ScenePoint& actual = reversed.hints.points[p];
    EXPECT_EQ(actual.position_in_world, expected.position_in_world);
    EXPECT_EQ(actual.views, expected.views);
    ASSERT_EQ(actual.pixels.size(), expected.pixels.size());
    for (size_t i = 0; i < expected.pixels.size(); ++i) {
      EXPECT_EQ(actual.pixels[i].view, expected.pixels[i].view);
      EXPECT_EQ(actual.pixels[i].position_px, expected.pixels[i].position_px);
    }
  }
}

TEST_F(ToViewsTest, HintsArePixelsOfTheVirtualImage) {
  SetCamera3(CameraModelId::kRadial);
  const ViewSet set = Views();
  const Eigen::Vector2d& pixel = set.hints.points[1].pixels[0].position_px;
  const auto stored = set.views[0].StoredFromVirtual(pixel);
  ASSERT_TRUE(stored);
  EXPECT_LT((*stored - Eigen::Vector2d(32.5, 43.5)).norm(), 1e-6);
  EXPECT_GT((pixel - *stored).norm(), 1);
  const Eigen::Vector2d step(0.1, -0.2);
  const auto ahead = set.views[0].StoredFromVirtual(pixel + step);
  ASSERT_TRUE(ahead);
  const Eigen::Matrix2d& jacobian = set.hints.points[1].pixels[0].stored_from_virtual;
  EXPECT_LT((*ahead - *stored - jacobian * step).norm(), 1e-3);
  EXPECT_GT((*ahead - *stored - step).norm(), 1e-3);
}

TEST_F(ToViewsTest, ObservationsThatAreNotThereGiveNoPixel) {
  model_.points[0].track = {{9, 17}, {5, 0}};
  const ViewSet set = Views();
  EXPECT_THAT(set.hints.points[1].views, ElementsAre(0, 1));
  ASSERT_EQ(set.hints.points[1].pixels.size(), 1u);
  EXPECT_EQ(set.hints.points[1].pixels[0].view, 0);
}

TEST_F(ToViewsTest, ObservationsThatAreNoNumbersGiveNoPixel) {
  model_.images[2].observations[0].position.x() = std::nan("");
  const ViewSet set = Views();
  EXPECT_EQ(set.hints.points[1].pixels.size(), 1u);
}

TEST_F(ToViewsTest, CamerasThatDoNotFitTheirPointsAreNamed) {
  GivePoints(20);
  EXPECT_THAT(Views().warnings, IsEmpty());
  model_.images[1].cam_from_world.translation.x() += 0.1;
  EXPECT_THAT(Views().warnings,
              ElementsAre(AllOf(HasSubstr("miss 1 of 3 images by more than 2 px: sub/a b.png (1"),
                                HasSubstr("; the other 2: "))));
}

TEST_F(ToViewsTest, HopelessCamerasAreLeftOutOnRequest) {
  GivePoints(20);
  model_.images[2].cam_from_world.translation.x() += 1;
  options_.max_reprojection_px = 5;
  const ViewSet set = Views();
  ASSERT_EQ(set.views.size(), 2u);
  EXPECT_EQ(set.views[0].name, "c.png");
  EXPECT_EQ(set.files[1].image_path, (dir_.path() / "sub/a b.png").string());
  EXPECT_THAT(set.hints.points[0].views, ElementsAre(0, 1));
  EXPECT_THAT(set.warnings, ElementsAre(AllOf(HasSubstr("left out"), HasSubstr("b.png ("))));
  for (ModelImage& image : model_.images) image.cam_from_world.translation.x() += 2;
  EXPECT_THAT(ErrorText<InputError>([&] { Views(); }), HasSubstr("max_reprojection_px"));
}

TEST_F(ToViewsTest, ViewsKnowTheirCamera) {
  const ViewSet set = Views();
  EXPECT_EQ(set.views[0].camera_index, 1);
  EXPECT_EQ(set.views[1].camera_index, 1);
  EXPECT_EQ(set.views[2].camera_index, 0);
}

TEST_F(ToViewsTest, ResizedImagesRescaleTheIntrinsics) {
  WriteImage("c.png", 400, 300);
  const ViewSet set = Views();
  EXPECT_EQ(set.views[1].camera.fx, 503 / 2.0);
  EXPECT_EQ(set.views[1].camera.cx, 400 / 2.0 - 0.5);
  EXPECT_EQ(set.views[1].camera.width, 400);
  EXPECT_EQ(set.views[0].camera.width, 800);
  EXPECT_THAT(set.warnings, ElementsAre(HasSubstr("1 images differ in size from their camera")));
}

TEST_F(ToViewsTest, RoundedSizesRescalePerAxis) {
  WriteImage("c.png", 267, 200);
  const View view = Views().views[1];
  EXPECT_DOUBLE_EQ(view.camera.fx, 503 * 267 / 800.0);
  EXPECT_DOUBLE_EQ(view.camera.fy, 513 * 200 / 600.0);
}

TEST_F(ToViewsTest, OtherAspectIsRefused) {
  WriteImage("c.png", 600, 800);
  EXPECT_THAT(ErrorOf(), AllOf(HasSubstr("c.png: the image is 600 x 800 pixels"),
                               HasSubstr("camera 3 is 800 x 600")));
  WriteImage("c.png", 800, 598);
  EXPECT_THAT(ErrorOf(), HasSubstr("800 x 598"));
  WriteImage("c.png", 800, 599);
  EXPECT_EQ(ErrorOf(), "");
}

TEST_F(ToViewsTest, MaxImageSizeShrinksImageAndIntrinsicsAlike) {
  // A step between the pixel columns 399 and 400: in Limn's pixels at 399.5, on the optical axis.
  cv::Mat step(600, 800, CV_8UC1, cv::Scalar(0));
  step.colRange(400, 800).setTo(200);
  Write("c.png", step);
  options_.max_image_size = 200;
  const ViewSet set = Views();
  const View& view = set.views[1];
  EXPECT_EQ(view.camera.width, 200);
  EXPECT_EQ(view.camera.height, 150);
  EXPECT_DOUBLE_EQ(view.camera.fx, 503 / 4.0);
  const Image image = ReadViewImage(set, 1);
  ASSERT_EQ(image.width, 200);
  ASSERT_EQ(image.channels, 1);
  EXPECT_EQ(image.data[99], 0);
  EXPECT_EQ(image.data[100], 200);
  EXPECT_EQ(view.camera.cx, 99.5);
}

// A sharp checkerboard, slanted so that its edges have all places between pixels.
cv::Mat Checkerboard(double blur_px) {
  constexpr int kSubpixels = 4;
  cv::Mat board(600 * kSubpixels, 800 * kSubpixels, CV_8UC1);
  for (int y = 0; y < board.rows; ++y) {
    for (int x = 0; x < board.cols; ++x) {
      const double u = (x + 0.2 * y) / kSubpixels;
      const double v = (y - 0.2 * x) / kSubpixels;
      const bool is_bright = (static_cast<int>(u / 40 + 100) + static_cast<int>(v / 40 + 100)) % 2;
      board.at<uchar>(y, x) = is_bright ? 200 : 50;
    }
  }
  if (blur_px > 0) cv::GaussianBlur(board, board, {}, kSubpixels * blur_px);
  cv::Mat small;
  cv::resize(board, small, {800, 600}, 0, 0, cv::INTER_AREA);
  return small;
}

TEST_F(ToViewsTest, SharpImagesHaveFinerViews) {
  Write("c.png", Checkerboard(0));
  options_.max_scale = 1.5;
  const ViewSet set = Views();
  const View& view = set.views[1];
  EXPECT_EQ(set.views[1].scale, 1.5);
  EXPECT_EQ(view.camera.width, 1200);
  EXPECT_EQ(view.camera.height, 900);
  EXPECT_DOUBLE_EQ(view.camera.fx, 1.5 * 503);
  EXPECT_FALSE(view.region.Contains({11.9, 400}));
  EXPECT_TRUE(view.region.Contains({12, 400}));
  const Image image = ReadViewImage(set, 1);
  EXPECT_EQ(image.width, 800);
  EXPECT_EQ(image.scale, Eigen::Vector2d(1.5, 1.5));
  EXPECT_EQ(set.ReadSize(1), (ImageSize{800, 600}));
  // Images of one color tell nothing.
  EXPECT_EQ(set.views[2].camera.width, 800);
}

TEST_F(ToViewsTest, BlurredImagesAndLowQualityHaveNone) {
  Write("c.png", Checkerboard(1.2));
  options_.max_scale = 2;
  EXPECT_EQ(Views().views[1].camera.width, 800);
  Write("c.png", Checkerboard(0));
  options_.max_scale = 1;
  EXPECT_EQ(Views().views[1].camera.width, 800);
}

TEST_F(ToViewsTest, MasksOfFinerViews) {
  Write("c.png", Checkerboard(0));
  cv::Mat mask(600, 800, CV_8UC1, cv::Scalar(255));
  mask.colRange(0, 400).setTo(0);
  Write("masks/c.png.png", mask);
  options_.max_scale = 1.5;
  options_.mask_path = (dir_.path() / "masks").string();
  const ViewSet set = Views();
  const auto of_view = ReadViewMask(set, 1);
  ASSERT_EQ(of_view.size(), size_t{1200} * 900);
  EXPECT_EQ(of_view[599], 0);
  EXPECT_NE(of_view[600], 0);
  EXPECT_EQ(ReadViewImage(set, 1).mask.size(), size_t{800} * 600);
  EXPECT_FALSE(set.views[1].region.Contains({590, 450}));
  EXPECT_TRUE(set.views[1].region.Contains({610, 450}));
}

// Of images that are used smaller or larger than they are.
TEST_F(ToViewsTest, TracksAreInPixelsOfTheFile) {
  Write("c.png", Checkerboard(0));
  for (const auto& [max_image_size, max_scale] : {std::pair(-1, 1.5), std::pair(200, 1.0)}) {
    options_.max_image_size = max_image_size;
    options_.max_scale = max_scale;
    const ViewSet set = Views();
    const std::vector<View> stored = InStoredImages(set, set.views);
    ASSERT_NE(set.views[1].camera.width, 800);
    EXPECT_EQ(stored[1].camera.width, 800);
    EXPECT_FALSE(stored[1].lens);
    for (const Eigen::Vector3d& place : {Eigen::Vector3d(0, 0, 5), Eigen::Vector3d(1, -1, 5)}) {
      const Eigen::Vector2d px = *set.views[1].Project(place);
      const double scale = set.views[1].camera.width / 800.0;
      const Eigen::Vector2d expected = ((px.array() + 0.5) / scale - 0.5).matrix();
      EXPECT_LT((*stored[1].Project(place) - expected).norm(), 1e-9);
    }
  }
}

// Errors of points are told in pixels of the images.
TEST_F(ToViewsTest, ErrorsOfPointsDoNotGrowWithTheView) {
  Write("c.png", Checkerboard(0));
  GivePoints(40);
  for (ModelImage& image : model_.images) {
    for (auto& observation : image.observations) observation.position.x() += 1.6;
  }
  options_.max_scale = 1.5;
  const ViewSet set = Views();
  ASSERT_EQ(set.views[1].scale, 1.5);
  EXPECT_THAT(set.warnings, Not(Contains(HasSubstr("points of the sparse model miss"))));
}

TEST(ScaleOf, IsInQuartersAndLimited) {
  EXPECT_EQ(ScaleOf(0, 2), 2);
  EXPECT_EQ(ScaleOf(0.4, 2), 2);
  EXPECT_EQ(ScaleOf(0.45, 2), 1.75);
  EXPECT_EQ(ScaleOf(0.45, 1.5), 1.5);
  EXPECT_EQ(ScaleOf(0.8, 2), 1);
  EXPECT_EQ(ScaleOf(3, 2), 1);
}

TEST_F(ToViewsTest, RegionLeavesAMargin) {
  const View view = Views().views[0];
  EXPECT_TRUE(view.region.Contains({8, 8}));
  EXPECT_FALSE(view.region.Contains({7.9, 100}));
  EXPECT_TRUE(view.region.Contains({791, 591}));
  EXPECT_FALSE(view.region.Contains({100, 591.1}));
}

TEST_F(ToViewsTest, ImageListSelects) {
  options_.image_list_path = dir_.WriteFile("list.txt", "sub/a b.png\r\n\n c.png \n");
  const ViewSet set = Views();
  ASSERT_EQ(set.views.size(), 2u);
  EXPECT_EQ(set.views[0].name, "c.png");
  EXPECT_EQ(set.views[1].name, "sub/a b.png");
  ASSERT_EQ(set.hints.points.size(), 1u);  // image 5 is not selected
  EXPECT_THAT(set.hints.points[0].views, ElementsAre(0));
  EXPECT_THAT(set.warnings, IsEmpty());
}

TEST_F(ToViewsTest, UnknownNamesInTheListAreErrors) {
  options_.image_list_path = dir_.WriteFile("list.txt", "c.png\nd.png\n");
  EXPECT_THAT(ErrorOf(), HasSubstr("list.txt: image \"d.png\" is not registered in the_model"));
  options_.image_list_path = (dir_ / "none.txt").string();
  EXPECT_THAT(ErrorOf(), HasSubstr("none.txt: cannot open"));
}

// "c.png" and "sub/a b.png" are a frame of a rig.
TEST_F(ToViewsTest, HeldImagesHoldWhatMovesWithThem) {
  const auto image = [&](const std::string& name) {
    return *std::ranges::find(model_.images, name, &ModelImage::name);
  };
  const ModelImage left = image("c.png"), right = image("sub/a b.png");
  const SensorId left_sensor = {kCameraSensor, left.camera_id};
  const SensorId right_sensor = {kCameraSensor, right.camera_id};
  model_.rigs = {{1,
                  {{left_sensor, true, {}},
                   {right_sensor, true, right.cam_from_world * Inverse(left.cam_from_world)}}}};
  model_.frames = {{1, 1, left.cam_from_world, {{left_sensor, left.id}, {right_sensor, right.id}}}};
  EXPECT_THAT(HeldViews(Views().mounts), IsEmpty());
  options_.hold_images = dir_.WriteFile("held.txt", "sub/a b.png\n");
  const ViewSet set = Views();
  ASSERT_EQ(set.views.size(), 3u);
  EXPECT_THAT(HeldViews(set.mounts), ElementsAre(1, 2));
  EXPECT_THAT(set.warnings, IsEmpty());
  // An image that is not in use holds nothing.
  options_.image_list_path = dir_.WriteFile("list.txt", "b.png\nc.png\n");
  EXPECT_THAT(HeldViews(Views().mounts), IsEmpty());
  EXPECT_THAT(Views().warnings,
              Contains(HasSubstr("are not in use and hold nothing: sub/a b.png")));
}

TEST_F(ToViewsTest, ListsOfHeldImagesThatMakeNoSenseAreErrors) {
  options_.hold_images = dir_.WriteFile("held.txt", "d.png\n");
  EXPECT_THAT(ErrorText<OptionError>([&] { Views(); }),
              HasSubstr("image \"d.png\" is not registered in the_model: correct its name, or "
                        "remove it from the list"));
  options_.hold_images = dir_.WriteFile("held.txt", "\n");
  EXPECT_THAT(ErrorText<OptionError>([&] { Views(); }), HasSubstr("names no image"));
}

TEST_F(ToViewsTest, CamerasFarOutsideTheSceneAreLeftOutByName) {
  for (const double far : {1e9, 1e45, 1e200, 1e307}) {
    model_.images[0].cam_from_world.translation.setConstant(far);
    const ViewSet set = Views();
    ASSERT_EQ(set.views.size(), 2u) << far;
    EXPECT_THAT(set.warnings, Contains(HasSubstr("1 images are left out, since their cameras are "
                                                 "far outside the scene of the others: " +
                                                 model_.images[0].name)));
    for (const ScenePoint& point : set.hints.points) EXPECT_LT(point.views.back(), 2);
  }
}

TEST_F(ToViewsTest, PointsFarOutsideTheSceneAreLeftOut) {
  const size_t num_points = Views().hints.points.size();
  model_.points.push_back(model_.points[0]);
  model_.points.back().id = 1000;
  model_.points.back().position.x() = 1e200;
  EXPECT_EQ(Views().hints.points.size(), num_points);
  EXPECT_THAT(Views().warnings, Contains(HasSubstr("far outside the scene")));
}

TEST_F(ToViewsTest, NoImageLeftIsAnError) {
  options_.image_list_path = dir_.WriteFile("list.txt", "\n");
  EXPECT_THROW(Views(), InputError);
}

TEST_F(ToViewsTest, MissingImagesAreNamed) {
  fs::remove(dir_ / "c.png");
  EXPECT_THAT(ErrorOf(), AllOf(HasSubstr("c.png: the image is registered"), HasSubstr("missing")));
  fs::remove(dir_ / "b.png");
  EXPECT_THAT(ErrorOf(), AllOf(HasSubstr("b.png: "), HasSubstr("and 1 other images")));
}

TEST_F(ToViewsTest, MissingImagesAreLeftOutOnRequest) {
  fs::remove(dir_ / "b.png");
  EXPECT_THAT(ErrorOf(), HasSubstr("; --skip_missing_images 1 leaves out what is missing"));
  options_.skip_missing_images = true;
  const ViewSet set = Views();
  ASSERT_EQ(set.views.size(), 2u);
  EXPECT_EQ(set.ImageName(0), "c.png");
  EXPECT_THAT(set.warnings, Contains(AllOf(HasSubstr("1 of 3 images are missing in "),
                                           HasSubstr("(skip_missing_images): b.png"))));
  fs::remove(dir_ / "c.png");
  fs::remove(dir_ / "sub/a b.png");
  EXPECT_THAT(ErrorText<InputError>([&] { Views(); }),
              HasSubstr("none of the 3 images of the model is there: --image_path names"));
  options_.skip_missing_images = false;
  EXPECT_THAT(ErrorOf(), HasSubstr("none of the images is there: --image_path names"));
}

TEST_F(ToViewsTest, MasksCutTheRegionAndComeWithTheImage) {
  cv::Mat mask(600, 800, CV_8UC1, cv::Scalar(255));
  mask.colRange(0, 400).setTo(0);
  Write("masks/sub/a b.png.png", mask);
  options_.mask_path = (dir_ / "masks").string();
  const ViewSet set = Views();
  EXPECT_THAT(set.warnings, ElementsAre(HasSubstr("masks: 2 of 3 images have no mask there")));
  EXPECT_FALSE(set.views[2].region.Contains({300, 300}));
  EXPECT_TRUE(set.views[2].region.Contains({500, 300}));
  EXPECT_TRUE(set.views[0].region.Contains({300, 300}));
  const Image image = ReadViewImage(set, 2);
  ASSERT_EQ(image.mask.size(), 800u * 600u);
  EXPECT_EQ(image.mask[399], 0);
  EXPECT_NE(image.mask[400], 0);
  EXPECT_TRUE(ReadViewImage(set, 0).mask.empty());
}

TEST_F(ToViewsTest, SmallerMasksAreScaled) {
  cv::Mat mask(300, 400, CV_8UC1, cv::Scalar(255));
  mask.colRange(0, 200).setTo(0);
  Write("masks/c.png", mask);
  options_.mask_path = (dir_ / "masks").string();
  const ViewSet set = Views();
  EXPECT_THAT(set.notes,
              ElementsAre(HasSubstr("c.png for c.png"),
                          HasSubstr("1 masks are of another size than their images (400 x 300 for "
                                    "800 x 600), and are scaled")));
  const std::vector<unsigned char> use = ReadViewMask(set, 1);
  ASSERT_EQ(use.size(), 800u * 600u);
  EXPECT_EQ(use[399], 0);
  EXPECT_NE(use[400], 0);
}

// The names of the model in a code page, those of the files composed or not.
TEST_F(ToViewsTest, ImagesAreFoundByTheTextOfTheirNames) {
  fs::rename(dir_ / "c.png", dir_ / "\xE6\x88\xAA.png");
  model_.images[0].name = "\\xBD\\xD8.png";
  model_.images[0].name_bytes = "\xBD\xD8.png";
  fs::rename(dir_ / "b.png", dir_ /
                                 "fac\xCC\xA7"
                                 "ade.png");
  model_.images[2].name =
      "fa\xC3\xA7"
      "ade.png";
  const ViewSet set = Views();
  EXPECT_EQ(set.files[0].image_path, (dir_ / "\xE6\x88\xAA.png").string());
  EXPECT_EQ(set.views[0].name, "\\xBD\\xD8.png");
  EXPECT_EQ(set.files[1].image_path, (dir_ / "fac\xCC\xA7"
                                             "ade.png")
                                         .string());
  EXPECT_THAT(set.notes, ElementsAre(HasSubstr("1 names"), HasSubstr("1 names")));
  // The same bytes.
  fs::rename(dir_ / "\xE6\x88\xAA.png", dir_ / "\xBD\xD8.png");
  EXPECT_EQ(Views().files[0].image_path, (dir_ / "\xBD\xD8.png").string());
}

TEST_F(ToViewsTest, NamesMayBeginWithTheFolderOfImages) {
  const std::string folder = dir_.path().filename().string();
  for (ModelImage& image : model_.images) image.name = folder + "/" + image.name;
  const ViewSet set = Views();
  EXPECT_EQ(set.files[0].image_path, (dir_ / "b.png").string());
  EXPECT_EQ(set.views[0].name, folder + "/b.png");
  EXPECT_THAT(set.notes, ElementsAre(HasSubstr("3 names of images begin with that of the folder")));
}

TEST_F(ToViewsTest, AlphaIsAMask) {
  cv::Mat pixels(600, 800, CV_8UC4, cv::Scalar(10, 20, 30, 255));
  for (int x = 0; x < 400; ++x) {
    for (int y = 0; y < 600; ++y) pixels.at<cv::Vec4b>(y, x)[3] = 0;
  }
  Write("c.png", pixels);
  cv::Mat mask(600, 800, CV_8UC1, cv::Scalar(255));
  mask.rowRange(0, 300).setTo(0);
  const ViewSet set = Views();
  EXPECT_THAT(set.notes,
              ElementsAre(AllOf(HasSubstr("1 images have an alpha channel"), HasSubstr("c.png"))));
  EXPECT_FALSE(set.views[1].region.Contains({300, 400}));
  EXPECT_TRUE(set.views[1].region.Contains({500, 200}));
  // Together with another mask.
  Write("masks/c.png", mask);
  options_.mask_path = (dir_ / "masks").string();
  const std::vector<unsigned char> use = ReadViewMask(Views(), 1);
  EXPECT_EQ(use[100 * 800 + 600], 0);
  EXPECT_EQ(use[400 * 800 + 200], 0);
  EXPECT_NE(use[400 * 800 + 600], 0);
}

TEST_F(ToViewsTest, PartsOfTheRangeOfSixteenBitsAreStretched) {
  for (const char* name : {"b.png", "c.png"}) {
    cv::Mat pixels(600, 800, CV_16UC1);
    cv::randu(pixels, 0, name[0] == 'b' ? 1000 : 4090);
    pixels.row(0).setTo(500);
    Write(name, pixels);
  }
  const ViewSet set = Views();
  EXPECT_THAT(set.notes, ElementsAre(AllOf(HasSubstr("2 images of 16 bits use values from"),
                                           HasSubstr("of 65535 only"))));
  // By the range of both.
  EXPECT_FLOAT_EQ(ReadViewImage(set, 0).data[0], 255 * 500 / 4096.f);
  EXPECT_EQ(set.files[2].form, ImageForm());
}

// Of a model of upright pictures.
TEST_F(ToViewsTest, ExifTurnsPicturesIfTheirCamerasSaySo) {
  const auto write_turned = [&](const std::string& name, int width, int height, char orientation) {
    cv::Mat pixels(height, width, CV_8UC3, cv::Scalar(10, 20, 30 * (name[0] % 7)));
    pixels.colRange(0, width / 2).setTo(200);
    std::vector<uchar> jpeg;
    ASSERT_TRUE(cv::imencode(".jpg", pixels, jpeg));
    dir_.WriteFile(name, WithOrientation({jpeg.begin(), jpeg.end()}, orientation));
  };
  write_turned("c.png", 600, 800, 6);
  write_turned("b.png", 800, 600, 3);  // as the other one, though its size does not tell
  ViewSet set = Views();
  EXPECT_THAT(set.notes,
              ElementsAre(AllOf(HasSubstr("2 images are turned"), HasSubstr("b.png, c.png"))));
  EXPECT_EQ(set.files[1].stored_size, (ImageSize{800, 600}));
  const Image upright = ReadViewImage(set, 1);
  EXPECT_EQ(upright.width, 800);
  EXPECT_NEAR(upright.data[3 * 400], 200, 5);  // the left half is on top
  EXPECT_LT(upright.data[3 * (599 * 800 + 400) + 2], 100);
  EXPECT_LT(ReadViewImage(set, 0).data[2], 100);
  // Without such a picture they stay as they are.
  write_turned("c.png", 800, 600, 1);
  set = Views();
  EXPECT_THAT(set.notes, IsEmpty());
  EXPECT_EQ(set.files[0].form, ImageForm());
  WriteImage("c.png", 600, 800);
  EXPECT_THAT(ErrorOf(), HasSubstr("is one of them turned?"));
}

TEST_F(ToViewsTest, PointsOfPicturesOfAnotherSizeAreNoMisfits) {
  GivePoints(20);
  for (ModelImage& image : model_.images) {
    for (Observation& observation : image.observations) {
      observation.position = 1.28 * observation.position + Eigen::Vector2d(0, 128);
    }
  }
  options_.max_reprojection_px = 5;
  const ViewSet set = Views();
  EXPECT_THAT(set.warnings, IsEmpty());
  EXPECT_THAT(set.notes, ElementsAre(HasSubstr("the 2D points of 3 of 3 images are pixels of "
                                               "pictures of another size")));
  EXPECT_EQ(set.views.size(), 3u);
  const PointPixel& pixel = set.hints.points[0].pixels[0];
  const View& view = set.views[pixel.view];
  EXPECT_LT((*view.Project(set.hints.points[0].position_in_world) - pixel.position_px).norm(), .1);
}

TEST_F(ToViewsTest, MasksOfAnotherSizeAndMissingMaskFoldersAreErrors) {
  Write("masks/c.png.png", cv::Mat(300, 500, CV_8UC1, cv::Scalar(255)));
  options_.mask_path = (dir_ / "masks").string();
  EXPECT_THAT(ErrorOf(), HasSubstr("the mask is 500 x 300 pixels, its image 800 x 600"));
  options_.mask_path = (dir_ / "nowhere").string();
  EXPECT_THAT(ErrorOf(), HasSubstr("nowhere: no such folder (mask_path)"));
}

TEST_F(ToViewsTest, DamagedImagesCountAsMasked) {
  cv::Mat noise(600, 800, CV_8UC3);
  cv::randu(noise, 0, 255);
  ASSERT_TRUE(cv::imwrite((dir_ / "whole.jpg").string(), noise));
  const auto half = static_cast<std::streamsize>(fs::file_size(dir_ / "whole.jpg") / 2);
  std::string bytes(half, 0);
  std::ifstream(dir_ / "whole.jpg", std::ios::binary).read(bytes.data(), half);
  dir_.WriteFile("c.png", bytes + "\xFF\xD9");
  const ViewSet set = Views();
  EXPECT_THAT(set.warnings, ElementsAre(AllOf(HasSubstr("c.png: Corrupt JPEG data"),
                                              HasSubstr("the whole image counts as masked"))));
  EXPECT_FALSE(set.views[1].region.Contains({300, 300}));
  EXPECT_TRUE(set.views[0].region.Contains({300, 300}));
  const Image image = ReadViewImage(set, 1);
  EXPECT_EQ(image.width, 800);
  EXPECT_THAT(image.mask, ::testing::AllOf(::testing::SizeIs(800 * 600), ::testing::Each(0)));
}

TEST_F(ToViewsTest, DuplicatesAreLeftOutWithOneWarning) {
  for (const char* name : {"./b.png", "copy.png"}) {
    model_.images.push_back(model_.images[0]);
    model_.images.back().id = static_cast<uint32_t>(model_.images.size() + 100);
    model_.images.back().name = name;
  }
  fs::copy_file(dir_ / "c.png", dir_ / "copy.png");
  model_.images.back().observations.push_back({});  // one more than c.png
  const ViewSet set = Views();
  ASSERT_EQ(set.views.size(), 3u);
  EXPECT_EQ(set.views[0].name, "./b.png");
  EXPECT_EQ(set.views[1].name, "copy.png");
  EXPECT_EQ(set.files.size(), 3u);
  EXPECT_THAT(set.warnings,
              ElementsAre("2 of 5 images are duplicates, by their bytes or by pose and picture, "
                          "and are left out: b.png (of ./b.png), c.png (of copy.png)"));
}

TEST_F(ToViewsTest, MasksThatMatchNoImageAreAnError) {
  Write("masks/d.png.png", cv::Mat(600, 800, CV_8UC1, cv::Scalar(255)));
  options_.mask_path = (dir_ / "masks").string();
  EXPECT_THAT(ErrorOf(), HasSubstr("masks: has a mask for none of the 3 images"));
  for (const char* name : {"c.png.png", "b.png.png", "sub/a b.png.png"}) {
    Write(std::string("masks/") + name, cv::Mat(600, 800, CV_8UC1, cv::Scalar(255)));
  }
  EXPECT_THAT(Views().warnings, IsEmpty());
}

TEST_F(ToViewsTest, OptionsAreChecked) {
  options_.max_image_size = 0;
  EXPECT_THAT(ErrorText<OptionError>([&] { Views(); }), HasSubstr("max_image_size = 0"));
  options_.max_image_size = -1;
  options_.border_margin_px = -1;
  EXPECT_THAT(ErrorText<OptionError>([&] { Views(); }), HasSubstr("border_margin_px = -1"));
}

TEST_F(ToViewsTest, ThreadsDoNotMatter) {
  SetCamera3(CameraModelId::kRadial);
  RunContext one;
  one.num_threads = 1;
  const ViewSet a = ToViews(model_, dir_.path(), options_, one);
  const ViewSet b = Views();
  ASSERT_EQ(a.views.size(), b.views.size());
  for (size_t i = 0; i < a.views.size(); ++i) {
    EXPECT_EQ(a.views[i].name, b.views[i].name);
    EXPECT_EQ(a.views[i].region.min_px, b.views[i].region.min_px);
    EXPECT_EQ(a.views[i].region.valid, b.views[i].region.valid);
  }
}

}  // namespace
}  // namespace limn::colmap_ext
