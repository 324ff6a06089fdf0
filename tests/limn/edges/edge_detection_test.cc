#include "limn/edges/edge_detection.h"

#include <cmath>
#include <iostream>
#include <numbers>

#include <gtest/gtest.h>

#include "limn/util/errors.h"
#include "support/synthetic_image.h"

namespace limn {
namespace {

using Eigen::Vector2d;
using testing::AddNoise;
using testing::ConstantImage;
using testing::Disc;
using testing::HalfPlane;
using testing::Paint;
using testing::Quantize;

constexpr double kDegrees = std::numbers::pi / 180;

// Sums of squared errors.
struct ErrorSum {
  double position = 0;
  double position_signed = 0;
  double angle = 0;
  double predicted = 0;
  int count = 0;

  void Add(double offset_px, double angle_rad, double sigma_px) {
    position += offset_px * offset_px;
    position_signed += offset_px;
    angle += angle_rad * angle_rad;
    predicted += sigma_px * sigma_px;
    ++count;
  }
  double PositionRms() const { return std::sqrt(position / count); }
  double PositionMean() const { return position_signed / count; }
  double AngleRmsDeg() const { return std::sqrt(angle / count) / kDegrees; }
  double PredictedRms() const { return std::sqrt(predicted / count); }
};

// Signed angle from `expected` to the edgel's normal.
double NormalError(const Edgel& edgel, const Vector2d& expected) {
  const Vector2d n = edgel.Normal();
  return std::atan2(expected.x() * n.y() - expected.y() * n.x(), expected.dot(n));
}

Image StepImage(int size, const Vector2d& point, const Vector2d& normal, double contrast) {
  Image image = ConstantImage(size, size, {100});
  Paint(HalfPlane(point, normal), {static_cast<float>(100 + contrast)}, &image);
  return image;
}

double ChordLength(int size, double margin, const Vector2d& point, const Vector2d& direction) {
  double length = 0;
  for (double s = -size; s < size; s += 0.05) {
    const Vector2d p = point + s * direction;
    if (p.minCoeff() > margin && p.maxCoeff() < size - 1 - margin) length += 0.05;
  }
  return length;
}

TEST(DetectEdges, StraightStepsAtAllOrientations) {
  double worst_position = 0;
  double worst_angle = 0;
  for (int degrees = 0; degrees < 360; degrees += 5) {
    const Vector2d normal(std::cos(degrees * kDegrees), std::sin(degrees * kDegrees));
    for (const double offset : {0.0, 0.21, 0.5, 0.83}) {
      const Vector2d point = Vector2d(24, 24) + offset * normal;
      const EdgeMap map = DetectEdges(StepImage(48, point, normal, 20), {});
      ErrorSum sum;
      for (const Edgel& edgel : map.edgels) {
        // Includes the polarity: the channel rises along the normal.
        sum.Add((edgel.position_px - point).dot(normal), NormalError(edgel, normal), 0);
      }
      const double chord = ChordLength(48, 8, point, Vector2d(-normal.y(), normal.x()));
      ASSERT_GE(sum.count, 0.9 * chord - 2) << degrees << " degrees, offset " << offset;
      ASSERT_LE(sum.count, 1.5 * chord + 2) << degrees << " degrees, offset " << offset;
      worst_position = std::max(worst_position, sum.PositionRms());
      worst_angle = std::max(worst_angle, sum.AngleRmsDeg());
    }
  }
  std::cout << "straight steps: worst RMS " << worst_position << " px, " << worst_angle
            << " degrees\n";
  // What is left is the skewness of the pixel's box for axis-aligned steps at a quarter pixel.
  EXPECT_LT(worst_position, 0.03);
  EXPECT_LT(worst_angle, 0.5);
}

TEST(DetectEdges, CirclesOfBothPolarities) {
  for (const double radius : {8.0, 12.0, 20.0, 50.0}) {
    for (const float inside : {50.f, 150.f}) {
      const int size = static_cast<int>(2 * radius) + 40;
      const Vector2d center(size / 2 + 0.3, size / 2 - 0.4);
      Image image = ConstantImage(size, size, {100});
      Paint(Disc(center, radius), {inside}, &image);
      const double rise = inside > 100 ? -1 : 1;
      ErrorSum sum;
      for (const Edgel& edgel : DetectEdges(image, {}).edgels) {
        const Vector2d ray = edgel.position_px - center;
        sum.Add(ray.norm() - radius, NormalError(edgel, rise * ray.normalized()), 0);
      }
      ASSERT_GT(sum.count, 2 * std::numbers::pi * radius * 0.9);
      EXPECT_LT(sum.PositionRms(), 0.02) << "radius " << radius;
      EXPECT_LT(std::abs(sum.PositionMean()), 0.01) << "radius " << radius;
      EXPECT_LT(sum.AngleRmsDeg(), 0.5) << "radius " << radius;
    }
  }
}

TEST(DetectEdges, FalseEdgelsInNoise) {
  int64_t edgels = 0;
  double area = 0;
  double noise = 0;
  for (unsigned seed = 0; seed < 4; ++seed) {
    Image image = ConstantImage(256, 256, {128});
    AddNoise(5, seed, &image);
    Quantize(&image);
    const EdgeMap map = DetectEdges(image, {});
    edgels += static_cast<int64_t>(map.edgels.size());
    noise += map.gradient_noise / 4;
    area += 240.0 * 240;
  }
  std::cout << "noise 5: " << 1000 * edgels / area << " false edgels per 1,000 px^2\n";
  EXPECT_LT(1000 * edgels / area, 5);
  EXPECT_NEAR(noise, 5 / (std::sqrt(8 * std::numbers::pi) * 1.5 * 1.5), 0.04);
}

// Errors of the edgels near steps of this contrast in noise 5, and edgels per px of edge.
ErrorSum NoisySteps(double contrast, double* density) {
  ErrorSum sum;
  double length = 0;
  for (int degrees = 0; degrees < 180; degrees += 10) {
    const Vector2d normal(std::cos(degrees * kDegrees), std::sin(degrees * kDegrees));
    const Vector2d point(64.2, 64.4);
    Image image = StepImage(128, point, normal, contrast);
    AddNoise(5, degrees, &image);
    Quantize(&image);
    length += ChordLength(128, 8, point, Vector2d(-normal.y(), normal.x()));
    for (const Edgel& edgel : DetectEdges(image, {}).edgels) {
      const double offset = (edgel.position_px - point).dot(normal);
      if (std::abs(offset) > 2) continue;
      sum.Add(offset, NormalError(edgel, normal), edgel.position_sigma_px);
    }
  }
  *density = sum.count / length;
  return sum;
}

TEST(DetectEdges, AccuracyInNoise) {
  double density = 0;
  const ErrorSum strong = NoisySteps(20, &density);
  std::cout << "contrast 20, noise 5: RMS " << strong.PositionRms() << " px (predicted "
            << strong.PredictedRms() << "), " << strong.AngleRmsDeg() << " degrees, " << density
            << " edgels per px\n";
  EXPECT_LT(strong.PositionRms(), 0.21);
  EXPECT_LT(strong.AngleRmsDeg(), 5);
  EXPECT_GT(density, 1);
  EXPECT_NEAR(strong.PredictedRms() / strong.PositionRms(), 1, 0.15);

  const ErrorSum weak = NoisySteps(8, &density);
  std::cout << "contrast 8, noise 5: RMS " << weak.PositionRms() << " px, " << weak.AngleRmsDeg()
            << " degrees, " << density << " edgels per px\n";
  EXPECT_LT(weak.PositionRms(), 0.6);
  EXPECT_GT(density, 0.95);
}

TEST(DetectEdges, TexturedImageKeepsNoiseLow) {
  // Squares of random brightness all over, on noise 2: edges in every block.
  Image image = ConstantImage(256, 256, {128});
  unsigned state = 1;
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 256; ++x) {
      state = (static_cast<unsigned>(y / 9) * 7919u + static_cast<unsigned>(x / 9)) * 2654435761u;
      image.data[y * 256 + x] = 80 + (state >> 24) / 3.f;
    }
  }
  AddNoise(2, 1, &image);
  const double truth = 2 / (std::sqrt(8 * std::numbers::pi) * 1.5 * 1.5);
  EXPECT_LT(DetectEdges(image, {}).gradient_noise, 2.5 * truth);
}

TEST(DetectEdges, RowMajorOrderAndOnePerPixel) {
  Image image = ConstantImage(96, 80, {100});
  Paint(Disc(Vector2d(40, 40), 21.3), {160}, &image);
  AddNoise(5, 3, &image);
  const EdgeMap map = DetectEdges(image, {});
  ASSERT_GT(map.edgels.size(), 100u);
  EXPECT_EQ(map.width, 96);
  EXPECT_EQ(map.height, 80);
  long last = -1;
  for (const Edgel& edgel : map.edgels) {
    const long pixel = std::lround(edgel.position_px.y()) * 96 + std::lround(edgel.position_px.x());
    EXPECT_GT(pixel, last);
    last = pixel;
    EXPECT_EQ(edgel.stored_px, edgel.position_px.cast<float>());
    EXPECT_EQ(edgel.stored_from_virtual, Eigen::Matrix2f::Identity());
    EXPECT_GE(edgel.position_sigma_px, 0.05f);
  }
  for (size_t i = 0; i < map.edgels.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      ASSERT_GE((map.edgels[i].position_px - map.edgels[j].position_px).norm(), 0.35);
    }
  }
}

TEST(DetectEdges, NothingWhereThereIsNothing) {
  EXPECT_TRUE(DetectEdges(ConstantImage(64, 64, {255}), {}).edgels.empty());
  EXPECT_TRUE(DetectEdges(ConstantImage(64, 64, {0, 128, 255}), {}).edgels.empty());
  // A ramp in 8 bits: steps of one gray level.
  Image ramp = ConstantImage(128, 64, {0});
  for (int i = 0; i < 128 * 64; ++i) ramp.data[i] = 20.f + 0.15f * static_cast<float>(i % 128);
  Quantize(&ramp);
  EXPECT_TRUE(DetectEdges(ramp, {}).edgels.empty());
}

TEST(DetectEdges, TinyImages) {
  for (int width = 1; width < 20; ++width) {
    for (const int height : {1, 2, 17}) {
      Image image = ConstantImage(width, height, {100, 100, 100});
      AddNoise(30, width, &image);
      EdgeDetectionOptions options;
      options.margin_px = 0;
      for (const Edgel& edgel : DetectEdges(image, options).edgels) {
        EXPECT_TRUE(edgel.position_px.allFinite());
      }
      EXPECT_EQ(DetectEdges(image, {}).width, width);
    }
  }
}

TEST(DetectEdges, MaskAndMargin) {
  Image image = StepImage(64, Vector2d(32.2, 32), Vector2d(1, 0), 50);
  image.mask.assign(64 * 64, 255);
  for (int y = 20; y < 40; ++y) std::fill_n(image.mask.begin() + y * 64, 64, 0);
  EdgeDetectionOptions options;
  options.margin_px = 5;
  const EdgeMap map = DetectEdges(image, options);
  int above = 0;
  int below = 0;
  for (const Edgel& edgel : map.edgels) {
    const double y = edgel.position_px.y();
    EXPECT_TRUE(y < 19.5 || y > 39.5) << y;
    EXPECT_GT(y, 4.4);
    EXPECT_LT(y, 58.6);
    ++(y < 30 ? above : below);
  }
  EXPECT_GE(above, 11);
  EXPECT_GE(below, 15);
}

TEST(DetectEdges, IsoluminantEdge) {
  Image image = ConstantImage(64, 64, {150, 100, 60});
  Paint(HalfPlane(Vector2d(32.3, 32), Vector2d(1, 0)), {60, 100, 150}, &image);
  EdgeDetectionOptions options;
  const EdgeMap map = DetectEdges(image, options);
  EXPECT_GE(map.edgels.size(), 46u);
  EXPECT_LE(map.edgels.size(), 50u);
  for (const Edgel& edgel : map.edgels) EXPECT_NEAR(edgel.position_px.x(), 32.3, 0.03);
  options.find_isoluminant = false;
  EXPECT_TRUE(DetectEdges(image, options).edgels.empty());
}

TEST(DetectEdges, DispersedColorsMakeOneStrand) {
  Image image = ConstantImage(64, 64, {100, 100, 100});
  for (int channel = 0; channel < 3; ++channel) {
    Image plane = StepImage(64, Vector2d(32.3 + 0.9 * (channel - 1), 32), Vector2d(1, 0), 40);
    for (int i = 0; i < 64 * 64; ++i) image.data[3 * i + channel] = plane.data[i];
  }
  for (const Edgel& edgel : DetectEdges(image, {}).edgels) {
    EXPECT_NEAR(edgel.position_px.x(), 32.3, 0.03);  // green
  }
}

TEST(DetectEdges, BadInput) {
  EdgeDetectionOptions options;
  options.sigma_px = 0.1;
  EXPECT_THROW(DetectEdges(ConstantImage(8, 8, {1}), options), OptionError);
  options = {};
  options.channel = "red";
  EXPECT_THROW(DetectEdges(ConstantImage(8, 8, {1}), options), OptionError);
  Image image = ConstantImage(8, 8, {1});
  image.data.pop_back();
  EXPECT_THROW(DetectEdges(image, {}), InputError);
  image = ConstantImage(8, 8, {1, 2});
  EXPECT_THROW(DetectEdges(image, {}), InputError);
  EXPECT_THROW(DetectEdges(Image(), {}), InputError);
}

}  // namespace
}  // namespace limn
