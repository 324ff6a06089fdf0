// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pictures/thumbnail.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "limn/model/toy_lens.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr int kWidth = 400, kHeight = 200;

View MakeView() {
  View view;
  view.name = "a.jpg";
  view.camera = {300, 300, 199.5, 99.5, kWidth, kHeight};
  view.region = MakeImageRegion(view.camera, nullptr, {}, 2);
  return view;
}

// Gray 50 with a bright disc around a stored pixel.
Image Photo(const Eigen::Vector2d& center, int channels) {
  Image photo{kWidth, kHeight, channels, {}, {}};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const float value = (Eigen::Vector2d(x, y) - center).norm() < 16 ? 250.f : 50.f;
      photo.data.insert(photo.data.end(), channels, value);
    }
  }
  return photo;
}

cv::Mat Decoded(const Thumbnail& thumbnail) {
  const cv::Mat bytes(1, static_cast<int>(thumbnail.jpeg.size()), CV_8U,
                      const_cast<char*>(thumbnail.jpeg.data()));
  return cv::imdecode(bytes, cv::IMREAD_GRAYSCALE);
}

// Middle of the bright pixels in virtual pixels, by the rectangle that the thumbnail covers.
Eigen::Vector2d BrightCenter(const Thumbnail& thumbnail) {
  const cv::Mat picture = Decoded(thumbnail);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weight = 0;
  for (int y = 0; y < picture.rows; ++y) {
    for (int x = 0; x < picture.cols; ++x) {
      if (picture.at<uchar>(y, x) < 150) continue;
      sum += Eigen::Vector2d(x + 0.5, y + 0.5);
      weight += 1;
    }
  }
  const Eigen::Vector2d size(picture.cols, picture.rows);
  return thumbnail.min_px +
         (sum / weight).cwiseQuotient(size).cwiseProduct(thumbnail.max_px - thumbnail.min_px);
}

TEST(Thumbnail, CoversThePhotographAndIsOfTheSizeAskedFor) {
  for (const int channels : {1, 3}) {
    const Eigen::Vector2d center(120, 60);
    const Thumbnail thumbnail = MakeThumbnail(Photo(center, channels), MakeView(), {100});
    EXPECT_EQ(thumbnail.min_px, Eigen::Vector2d(-0.5, -0.5));
    EXPECT_EQ(thumbnail.max_px, Eigen::Vector2d(399.5, 199.5));
    EXPECT_EQ(Decoded(thumbnail).size(), cv::Size(100, 50));
    EXPECT_LT((BrightCenter(thumbnail) - center).norm(), 0.7);
  }
}

TEST(Thumbnail, IsNeverEnlarged) {
  const Thumbnail thumbnail = MakeThumbnail(Photo({200, 100}, 3), MakeView(), {4000});
  EXPECT_EQ(Decoded(thumbnail).size(), cv::Size(kWidth, kHeight));
}

// Of noise, which takes many bytes.
Image NoisyPhoto() {
  Image photo{kWidth, kHeight, 3, {}, {}};
  uint32_t state = 1;
  for (int i = 0; i < 3 * kWidth * kHeight; ++i) {
    state = 1664525 * state + 1013904223;
    photo.data.push_back(static_cast<float>(state >> 24));
  }
  return photo;
}

TEST(Thumbnail, IsSmallerWhereItWouldTakeTooManyBytes) {
  const Thumbnail whole = MakeThumbnail(NoisyPhoto(), MakeView(), {400});
  EXPECT_EQ(whole.longer_side, 400);
  ASSERT_GT(whole.jpeg.size(), 40000u);
  const Thumbnail small = MakeThumbnail(NoisyPhoto(), MakeView(), {400, 20000});
  EXPECT_LE(small.jpeg.size(), 20000u);
  EXPECT_GT(small.jpeg.size(), 10000u);
  EXPECT_EQ(Decoded(small).cols, small.longer_side);
  EXPECT_NEAR(Decoded(small).rows, 0.5 * small.longer_side, 1);
  EXPECT_EQ(small.max_px, whole.max_px);
  EXPECT_EQ(MakeThumbnail(NoisyPhoto(), MakeView(), {400, 10}).longer_side, 16);
}

TEST(SmallJpeg, IsThePhotographAsStored) {
  EXPECT_EQ(Decoded({.jpeg = SmallJpeg(Photo({120, 60}, 3), 100)}).size(), cv::Size(100, 50));
  EXPECT_EQ(Decoded({.jpeg = SmallJpeg(Photo({120, 60}, 1), 4000)}).size(),
            cv::Size(kWidth, kHeight));
}

TEST(Thumbnail, UndoesTheLens) {
  View view = MakeView();
  view.lens = std::make_shared<ToyLens>(Eigen::Vector2d(200, 100), 0.8, 0.2, 1000);
  view.region = MakeImageRegion(view.camera, view.lens.get(), {}, 2);
  const Eigen::Vector2d virtual_center(150, 120);
  const Image photo = Photo(*view.StoredFromVirtual(virtual_center), 3);
  const Thumbnail thumbnail = MakeThumbnail(photo, view, {200});
  EXPECT_LT((BrightCenter(thumbnail) - virtual_center).norm(), 1.0);
  // The corners of the turned picture show nothing of the photograph.
  EXPECT_LT(Decoded(thumbnail).at<uchar>(1, 1), 20);
}

TEST(Thumbnail, RefusesAPhotographOfAnotherSize) {
  Image photo = Photo({200, 100}, 3);
  photo.height = 100;
  EXPECT_THROW(MakeThumbnail(photo, MakeView(), {100}), InputError);
}

}  // namespace
}  // namespace limn
