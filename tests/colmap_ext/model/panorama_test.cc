// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/panorama.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "limn/model/view.h"
#include "limn/util/angles.h"
#include "support/random_numbers.h"

namespace limn::colmap_ext {
namespace {

constexpr int kWidth = 960, kHeight = 480, kMargin = 8;

// COLMAP's projection, in its pixels.
Eigen::Vector2d PixelOf(const Eigen::Vector3d& ray) {
  const double azimuth = std::atan2(ray.x(), ray.z());
  const double elevation = std::atan2(-ray.y(), std::hypot(ray.x(), ray.z()));
  return {(azimuth / (2 * M_PI) + 0.5) * kWidth, (0.5 - elevation / M_PI) * kHeight};
}

Eigen::Vector3d RandomRay(std::mt19937* random) {
  testing::NormalDistribution<double> normal;
  return testing::RandomVector(normal, *random).normalized();
}

// Where a direction is in the pinhole image of a part, if the part shows it.
std::optional<Eigen::Vector2d> VirtualPixel(const PanoramaPart& part, const ImageRegion& region,
                                            const Eigen::Vector3d& ray) {
  const Eigen::Vector3d in_part = part.part_from_image * ray;
  if (in_part.z() <= 0) return std::nullopt;
  const Eigen::Vector2d pixel = part.camera.Project(in_part);
  if (!region.Contains(pixel)) return std::nullopt;
  return pixel;
}

std::vector<ImageRegion> RegionsOf(const std::vector<PanoramaPart>& parts) {
  std::vector<ImageRegion> regions;
  for (const PanoramaPart& part : parts) {
    regions.push_back(MakeImageRegion(part.camera, part.lens.get(), {}, kMargin));
  }
  return regions;
}

TEST(Panorama, EveryPartProjectsAsColmapDoes) {
  const std::vector<PanoramaPart> parts = PanoramaParts(kWidth, kHeight, kMargin);
  const std::vector<ImageRegion> regions = RegionsOf(parts);
  ASSERT_EQ(parts.size(), static_cast<size_t>(kNumPanoramaParts));
  std::mt19937 random(1);
  std::vector<int> shown(parts.size());
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d ray = RandomRay(&random);
    for (size_t p = 0; p < parts.size(); ++p) {
      const auto pixel = VirtualPixel(parts[p], regions[p], ray);
      if (!pixel) continue;
      ++shown[p];
      const auto stored = parts[p].lens->StoredFromVirtual(*pixel);
      ASSERT_TRUE(stored);
      const Eigen::Vector2d expected =
          parts[p].window.WindowFromImage(PixelOf(ray) - Eigen::Vector2d(0.5, 0.5));
      ASSERT_LT((*stored - expected).norm(), 1e-8);
      const auto back = parts[p].lens->VirtualFromStored(*stored);
      ASSERT_TRUE(back);
      ASSERT_LT((*back - *pixel).norm(), 1e-7);
    }
  }
  for (size_t p = 0; p < parts.size(); ++p) EXPECT_GT(shown[p], 500) << p;
}

TEST(Panorama, PartsShowEveryDirectionOnceButThePoles) {
  const std::vector<PanoramaPart> parts = PanoramaParts(kWidth, kHeight, kMargin);
  const std::vector<ImageRegion> regions = RegionsOf(parts);
  std::mt19937 random(2);
  int num_rays = 0, num_shown = 0, num_twice = 0;
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d ray = RandomRay(&random);
    int count = 0;
    for (size_t p = 0; p < parts.size(); ++p)
      count += VirtualPixel(parts[p], regions[p], ray) ? 1 : 0;
    if (std::abs(ray.y()) > std::sin(80.5 * kDeg)) {
      EXPECT_EQ(count, 0);
    } else if (std::abs(ray.y()) < std::sin(79.5 * kDeg)) {
      ++num_rays;
      num_shown += count > 0;
      num_twice += count > 1;
    }
  }
  // The borders of regions are cells of a few pixels.
  EXPECT_GT(num_shown, 0.97 * num_rays);
  EXPECT_LT(num_twice, 0.03 * num_rays);
}

TEST(Panorama, WindowsCrossTheBorderOfTheImage) {
  const std::vector<PanoramaPart> parts = PanoramaParts(kWidth, kHeight, kMargin);
  const ImageWindow& first = parts[0].window;
  EXPECT_EQ(first.x, -kWidth / 8 - kMargin);
  EXPECT_LT(
      (first.WindowFromImage({kWidth - 1.0, 100}) - Eigen::Vector2d(-1 - first.x, 100 - first.y))
          .norm(),
      1e-9);
  std::vector<int> columns(static_cast<size_t>(kWidth) * kHeight);
  for (size_t i = 0; i < columns.size(); ++i) columns[i] = static_cast<int>(i) % kWidth;
  const std::vector<int> cut = CutPixels(columns, first, 1);
  ASSERT_EQ(cut.size(), static_cast<size_t>(first.width) * first.height);
  EXPECT_EQ(cut.front(), kWidth + first.x);
  EXPECT_EQ(cut[-first.x - 1], kWidth - 1);
  EXPECT_EQ(cut[-first.x], 0);
}

}  // namespace
}  // namespace limn::colmap_ext
