// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/area_samples.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "limn/util/errors.h"

namespace limn {
namespace {

const std::vector<Eigen::Vector3d> kCornersOfRectangle = {
    {0, 0, 1}, {4, 0, 1}, {4, 2, 1}, {0, 2, 1}};
const std::vector<std::array<int, 3>> kHalvesOfRectangle = {{0, 1, 2}, {0, 2, 3}};

double UnitOfOne(const Eigen::Vector3d&) { return 1; }

std::vector<AreaSample> SampleRectangle(
    double spacing, const std::function<double(const Eigen::Vector3d&)>& unit_at,
    const std::optional<Eigen::AlignedBox3d>& region = {}, int max_samples = kMaxAreaSamples) {
  return SampleArea(kCornersOfRectangle, kHalvesOfRectangle, spacing, unit_at, region, {},
                    max_samples);
}

double SumOfAreas(const std::vector<AreaSample>& samples) {
  double sum = 0;
  for (const AreaSample& sample : samples) sum += sample.area;
  return sum;
}

TEST(AreaSamples, SumsAreIntegrals) {
  const std::vector<AreaSample> samples = SampleRectangle(0.25, UnitOfOne);
  EXPECT_NEAR(SumOfAreas(samples), 8, 1e-12);
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const AreaSample& sample : samples) moment += sample.area * sample.position;
  EXPECT_TRUE(moment.isApprox(8 * Eigen::Vector3d(2, 1, 1), 1e-12)) << moment.transpose();
  for (const AreaSample& sample : samples) {
    EXPECT_LE(sample.area, 0.25 * 0.25 / 2);
    EXPECT_EQ(sample.triangle, sample.position.y() < sample.position.x() / 2 ? 0 : 1);
    EXPECT_EQ(sample.unit, 1);
  }
}

TEST(AreaSamples, ATriangleThatIsSmallEnoughIsOne) {
  const std::vector<AreaSample> samples = SampleRectangle(10, UnitOfOne);
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_DOUBLE_EQ(samples[1].area, 4);
}

TEST(AreaSamples, AreDenserWhereTheUnitIsSmaller) {
  const auto unit_at = [](const Eigen::Vector3d& point) { return point.x() < 2 ? 0.1 : 0.5; };
  const std::vector<AreaSample> samples = SampleRectangle(1, unit_at);
  const auto num_left = std::count_if(samples.begin(), samples.end(), [](const AreaSample& sample) {
    return sample.position.x() < 2;
  });
  EXPECT_GT(num_left, 10 * (static_cast<int>(samples.size()) - num_left));
  EXPECT_NEAR(SumOfAreas(samples), 8, 1e-12);
}

TEST(AreaSamples, OnlyThoseInTheRegion) {
  const Eigen::AlignedBox3d right_half(Eigen::Vector3d(2, -1, 0), Eigen::Vector3d(9, 9, 2));
  EXPECT_NEAR(SumOfAreas(SampleRectangle(0.05, UnitOfOne, right_half)), 4, 0.1);
  const Eigen::AlignedBox3d above(Eigen::Vector3d(0, 0, 2), Eigen::Vector3d(9, 9, 3));
  EXPECT_TRUE(SampleRectangle(0.05, UnitOfOne, above).empty());
}

TEST(AreaSamples, TooManyAreToldWithTheNumber) {
  const auto count = static_cast<int>(SampleRectangle(2.0, UnitOfOne).size());
  ASSERT_GT(count, 8);
  EXPECT_NO_THROW(SampleRectangle(2.0, UnitOfOne, {}, count));
  try {
    SampleRectangle(2.0, UnitOfOne, {}, count - 1);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(" more than " + std::to_string(count - 1) + " places"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace limn
