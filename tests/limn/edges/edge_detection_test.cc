// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/edge_detection.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include <gtest/gtest.h>

#include "limn/util/angles.h"
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
using testing::Polygon;
using testing::Quantize;

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
  double AngleRmsDeg() const { return std::sqrt(angle / count) / kDeg; }
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

EdgeDetectionOptions MainScaleOnly() {
  EdgeDetectionOptions options;
  options.fine_sigma_px = 0;
  return options;
}

// An axis-aligned step that covers this share of a pixel has a gradient, after smoothing, that is
// the sum of two Gaussians a pixel apart, weighted by the share. The distance of its largest value
// from the step.
double PullToPixel(double share, double sigma) {
  const auto slope = [&](double x) {
    const auto of_pixel = [&](double at) {
      return -(x - at) * std::exp(-(x - at) * (x - at) / (2 * sigma * sigma));
    };
    return (1 - share) * of_pixel(0) + share * of_pixel(1);
  };
  double low = 0;
  double high = 1;
  while (high - low > 1e-6) {
    const double middle = (low + high) / 2;
    (slope(middle) > 0 ? low : high) = middle;
  }
  return std::abs(low - share);
}

// The largest for any step.
double LargestPullToPixel(double sigma) {
  double largest = 0;
  for (double share = 0; share < 0.5; share += 0.01) {
    largest = std::max(largest, PullToPixel(share, sigma));
  }
  return largest;
}

struct WorstErrors {
  double position_px = 0;
  double angle_deg = 0;
};

WorstErrors OfStraightSteps(const EdgeDetectionOptions& options) {
  WorstErrors worst;
  for (int degrees = 0; degrees < 360; degrees += 5) {
    const Vector2d normal(std::cos(degrees * kDeg), std::sin(degrees * kDeg));
    for (const double offset : {0.0, 0.21, 0.5, 0.83}) {
      const Vector2d point = Vector2d(24, 24) + offset * normal;
      const EdgeMap map = DetectEdges(StepImage(48, point, normal, 20), options);
      ErrorSum sum;
      for (const Edgel& edgel : map.edgels) {
        // Includes the polarity: the channel rises along the normal.
        sum.Add((edgel.position_px - point).dot(normal), NormalError(edgel, normal), 0);
      }
      const double chord = ChordLength(48, 8, point, Vector2d(-normal.y(), normal.x()));
      EXPECT_GE(sum.count, 0.9 * chord - 2) << degrees << " degrees, offset " << offset;
      EXPECT_LE(sum.count, 1.5 * chord + 2) << degrees << " degrees, offset " << offset;
      worst.position_px = std::max(worst.position_px, sum.PositionRms());
      worst.angle_deg = std::max(worst.angle_deg, sum.AngleRmsDeg());
    }
  }
  std::cout << "straight steps: worst RMS " << worst.position_px << " px, " << worst.angle_deg
            << " degrees\n";
  return worst;
}

TEST(DetectEdges, StraightStepsAtAllOrientations) {
  // What is left is the skewness of the pixel's box, for axis-aligned steps at a quarter pixel; of
  // steps that nearly are, it turns the direction, too.
  const WorstErrors main = OfStraightSteps(MainScaleOnly());
  EXPECT_LT(main.position_px, LargestPullToPixel(1.5) + 0.01);
  EXPECT_LT(main.angle_deg, 0.5);
  const WorstErrors fine = OfStraightSteps({});
  EXPECT_LT(fine.position_px, LargestPullToPixel(1) + 0.01);
  EXPECT_LT(fine.angle_deg, 1.5);
}

// The largest RMS errors are given.
void ExpectGoodCircles(const EdgeDetectionOptions& options, double position_px, double angle_deg) {
  for (const double radius : {8.0, 12.0, 20.0, 50.0}) {
    for (const float inside : {50.f, 150.f}) {
      const int size = static_cast<int>(2 * radius) + 40;
      const Vector2d center(size / 2 + 0.3, size / 2 - 0.4);
      Image image = ConstantImage(size, size, {100});
      Paint(Disc(center, radius), {inside}, &image);
      const double rise = inside > 100 ? -1 : 1;
      ErrorSum sum;
      for (const Edgel& edgel : DetectEdges(image, options).edgels) {
        const Vector2d ray = edgel.position_px - center;
        sum.Add(ray.norm() - radius, NormalError(edgel, rise * ray.normalized()), 0);
      }
      ASSERT_GT(sum.count, 2 * std::numbers::pi * radius * 0.9);
      EXPECT_LT(sum.PositionRms(), position_px) << "radius " << radius;
      EXPECT_LT(std::abs(sum.PositionMean()), 0.01) << "radius " << radius;
      EXPECT_LT(sum.AngleRmsDeg(), angle_deg) << "radius " << radius;
    }
  }
}

TEST(DetectEdges, CirclesOfBothPolarities) {
  ExpectGoodCircles(MainScaleOnly(), 0.02, 0.5);
  // Only where a circle runs along the pixels the fine scale pulls it to them.
  ExpectGoodCircles({}, LargestPullToPixel(1) / 2, 1);
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
ErrorSum NoisySteps(double contrast, const EdgeDetectionOptions& options, double* density) {
  ErrorSum sum;
  double length = 0;
  for (int degrees = 0; degrees < 180; degrees += 10) {
    const Vector2d normal(std::cos(degrees * kDeg), std::sin(degrees * kDeg));
    const Vector2d point(64.2, 64.4);
    Image image = StepImage(128, point, normal, contrast);
    AddNoise(5, degrees, &image);
    Quantize(&image);
    length += ChordLength(128, 8, point, Vector2d(-normal.y(), normal.x()));
    for (const Edgel& edgel : DetectEdges(image, options).edgels) {
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
  const ErrorSum strong = NoisySteps(20, MainScaleOnly(), &density);
  std::cout << "contrast 20, noise 5: RMS " << strong.PositionRms() << " px (predicted "
            << strong.PredictedRms() << "), " << strong.AngleRmsDeg() << " degrees, " << density
            << " edgels per px\n";
  EXPECT_LT(strong.PositionRms(), 0.21);
  EXPECT_LT(strong.AngleRmsDeg(), 5);
  EXPECT_GT(density, 1);
  EXPECT_NEAR(strong.PredictedRms() / strong.PositionRms(), 1, 0.15);

  // At the fine scale the direction of an edgel errs by sqrt(2/3) of noise over gradient, which is
  // at most 1 / fine_noise_factor.
  const EdgeDetectionOptions both;
  const ErrorSum fine = NoisySteps(40, both, &density);
  std::cout << "contrast 40, noise 5: RMS " << fine.PositionRms() << " px (predicted "
            << fine.PredictedRms() << "), " << fine.AngleRmsDeg() << " degrees, " << density
            << " edgels per px\n";
  EXPECT_LT(fine.AngleRmsDeg(), std::sqrt(2. / 3) / both.fine_noise_factor / kDeg);
  EXPECT_GT(density, 1);
  EXPECT_NEAR(fine.PredictedRms() / fine.PositionRms(), 1, 0.2);

  const ErrorSum weak = NoisySteps(8, {}, &density);
  std::cout << "contrast 8, noise 5: RMS " << weak.PositionRms() << " px, " << weak.AngleRmsDeg()
            << " degrees, " << density << " edgels per px\n";
  EXPECT_LT(weak.PositionRms(), 0.6);
  EXPECT_GT(density, 0.95);
}

// Where the gradient of two steps of equal height at +-half, blurred by sigma, is largest: the
// positive zero of its derivative, by bisection.
double PeakOfTwoSteps(double half, double sigma) {
  const auto slope = [&](double x) {
    const auto of_step = [&](double at) {
      return -(x - at) * std::exp(-(x - at) * (x - at) / (2 * sigma * sigma));
    };
    return of_step(-half) + of_step(half);
  };
  double low = 0.1;
  double high = half + sigma;
  while (high - low > 1e-6) {
    const double middle = (low + high) / 2;
    (slope(middle) > 0 ? low : high) = middle;
  }
  return low;
}

// Two steps of 40 gray levels, this far apart, up the same way, along a line at 20 degrees.
Image TwoSteps(double distance_px, const Vector2d& point, const Vector2d& normal) {
  Image image = StepImage(64, point - distance_px / 2 * normal, normal, 40);
  Paint(HalfPlane(point + distance_px / 2 * normal, normal), {180}, &image);
  AddNoise(1, 1, &image);
  Quantize(&image);
  return image;
}

TEST(DetectEdges, FineScaleSeparatesNeighbors) {
  constexpr double kDistancePx = 3;  // below the 2 sigma at which the main scale can
  const Vector2d normal(std::cos(20 * kDeg), std::sin(20 * kDeg));
  const Vector2d point(32.2, 31.7);
  const Image image = TwoSteps(kDistancePx, point, normal);
  const double expected = PeakOfTwoSteps(kDistancePx / 2, std::sqrt(1 + 1. / 12));
  ErrorSum sum;
  int on_one_side = 0;
  for (const Edgel& edgel : DetectEdges(image, {}).edgels) {
    const double offset = (edgel.position_px - point).dot(normal);
    sum.Add(std::abs(offset) - expected, NormalError(edgel, normal), 0);
    on_one_side += offset > 0;
  }
  const double chord = ChordLength(64, 8, point, Vector2d(-normal.y(), normal.x()));
  EXPECT_GE(on_one_side, 0.9 * chord - 2);
  EXPECT_GE(sum.count - on_one_side, 0.9 * chord - 2);
  EXPECT_LT(sum.PositionRms(), 0.1);

  for (const Edgel& edgel : DetectEdges(image, MainScaleOnly()).edgels) {
    EXPECT_LT(std::abs((edgel.position_px - point).dot(normal)), 1);  // one in the middle
  }
}

TEST(DetectEdges, MainScaleAddsNothingToStrongEdges) {
  // It rounds the corners, most of all those of wedges: edgels there would run across them.
  EdgeDetectionOptions fine_only;
  fine_only.noise_factor = 100;
  for (const double half : {4., 5., 6., 7., 8., 12., 30.}) {
    Image image = ConstantImage(128, 96, {100});
    Paint(Polygon({{20.3, 48.2 - half}, {110.1, 48.6}, {20.8, 48.2 + half}}), {180}, &image);
    AddNoise(1, 2, &image);
    Quantize(&image);
    const size_t num_fine = DetectEdges(image, fine_only).edgels.size();
    EXPECT_GT(num_fine, 150u) << half;
    EXPECT_EQ(DetectEdges(image, {}).edgels.size(), num_fine) << half;
  }
}

TEST(DetectEdges, OneStrandWhereTheScaleChanges) {
  // A step whose contrast grows from 16 to 80 gray levels along the edge, in noise 10: at the fine
  // scale its gradient rises to 8 times the noise at 42 levels, in row 103.
  Image image = ConstantImage(64, 256, {100});
  const double edge_x = 32.3;
  Paint(HalfPlane(Vector2d(edge_x, 128), Vector2d(1, 0)), {101}, &image);
  for (int y = 0; y < 256; ++y) {
    const float contrast = 16 + 64 * static_cast<float>(y) / 255;
    for (int x = 0; x < 64; ++x) {
      float& value = image.data[y * 64 + x];
      value = 100 + (value - 100) * contrast;
    }
  }
  AddNoise(10, 7, &image);
  Quantize(&image);
  const auto count = [&](const EdgeDetectionOptions& options, double reach_px, double y0,
                         double y1) {
    const EdgeMap map = DetectEdges(image, options);
    return std::ranges::count_if(map.edgels, [&](const Edgel& edgel) {
      const Vector2d& place = edgel.position_px;
      return place.y() >= y0 && place.y() < y1 && std::abs(place.x() - edge_x) < reach_px;
    });
  };
  EdgeDetectionOptions fine_only;
  fine_only.noise_factor = 100;
  EXPECT_LT(count(fine_only, 1, 8, 40), 0.5 * 32);      // the main scale is needed there,
  EXPECT_GE(count(fine_only, 1, 184, 248), 0.95 * 64);  // and not here
  EXPECT_GE(count({}, 1, 8, 248), 0.95 * 240);
  EXPECT_LE(count({}, 3, 8, 248), 1.05 * 240);
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
  EdgeDetectionOptions joint;
  joint.channel = EdgeChannel::kColor;
  joint.min_strength = 0;
  EXPECT_TRUE(DetectEdges(ConstantImage(64, 64, {0, 128, 255}), joint).edgels.empty());
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
      for (const EdgeChannel channel : {EdgeChannel::kGreen, EdgeChannel::kColor}) {
        EdgeDetectionOptions options;
        options.channel = channel;
        options.margin_px = 0;
        for (const Edgel& edgel : DetectEdges(image, options).edgels) {
          EXPECT_TRUE(edgel.position_px.allFinite());
        }
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
    EXPECT_NEAR(edgel.position_px.x(), 32.3, LargestPullToPixel(1) + 0.01);  // green
  }
}

// A step of luminance, and one of red against it that is blurred as if colors had been stored at a
// fraction of the resolution: the slopes of red beside the step are no edges.
TEST(DetectEdges, BlurredColorsMakeNoEchoes) {
  constexpr double kBlurPx = 2;
  Image image = StepImage(64, Vector2d(32.3, 32), Vector2d(1, 0), 60);
  Image colors = ConstantImage(64, 64, {100, 100, 100});
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const double red = 35 * std::erf((x - 32.3) / (std::numbers::sqrt2 * kBlurPx));
      const size_t pixel = 64 * y + x;
      colors.data[3 * pixel] = image.data[pixel] - red;
      colors.data[3 * pixel + 1] = image.data[pixel] + red / 2;
      colors.data[3 * pixel + 2] = image.data[pixel];
    }
  }
  const EdgeMap map = DetectEdges(colors, {});
  EXPECT_GE(map.edgels.size(), 46u);
  for (const Edgel& edgel : map.edgels) EXPECT_NEAR(edgel.position_px.x(), 32.3, 1);
}

// What is finer than noise would only fill the cache.
TEST(DetectEdges, EdgelsAreToldInFewBits) {
  Image image = ConstantImage(96, 80, {100});
  Paint(Disc(Vector2d(40, 40), 21.3), {160}, &image);
  AddNoise(5, 3, &image);
  const EdgeMap map = DetectEdges(image, {});
  ASSERT_GT(map.edgels.size(), 100u);
  for (const Edgel& edgel : map.edgels) {
    int exponent = 0;
    for (const double told :
         {256 * edgel.position_px.x(), 256 * edgel.position_px.y(), 512 * edgel.tangent_rad,
          128.0 * std::frexp(edgel.strength, &exponent),
          32.0 * std::frexp(edgel.position_sigma_px, &exponent)}) {
      EXPECT_EQ(told, std::round(told));
    }
    EXPECT_LE(std::abs(edgel.tangent_rad), M_PI);
  }
}

TEST(DetectEdges, BadInput) {
  EdgeDetectionOptions options;
  options.sigma_px = 0.1;
  EXPECT_THROW(DetectEdges(ConstantImage(8, 8, {1}), options), OptionError);
  options = {};
  options.noise_factor = 0;
  EXPECT_THROW(DetectEdges(ConstantImage(8, 8, {1}), options), OptionError);
  Image image = ConstantImage(8, 8, {1});
  image.data.pop_back();
  EXPECT_THROW(DetectEdges(image, {}), InputError);
  image = ConstantImage(8, 8, {1, 2});
  EXPECT_THROW(DetectEdges(image, {}), InputError);
  EXPECT_THROW(DetectEdges(Image(), {}), InputError);
}

// At scales that are no whole numbers, too; the border and masks are those of the image.
TEST(DetectEdges, PlacesAreInPixelsOfTheView) {
  const Vector2d normal(std::cos(0.4), std::sin(0.4));
  const Vector2d point(30.2, 33.1);
  for (const double scale : {1.0, 1.25, 1.5, 2.0}) {
    Image image = StepImage(64, point, normal, 100);
    image.mask.assign(64 * 64, 1);
    for (int i = 0; i < 64 * 20; ++i) image.mask[i] = 0;
    image.scale.setConstant(scale);
    const EdgeMap map = DetectEdges(image, {});
    EXPECT_EQ(map.width, static_cast<int>(64 * scale));
    EXPECT_GT(map.edgels.size(), 25 * scale);
    for (const Edgel& edgel : map.edgels) {
      const Vector2d place = image.FromView(edgel.position_px);
      EXPECT_NEAR((place - point).dot(normal), 0, 0.12) << scale;
      EXPECT_NEAR(NormalError(edgel, normal), 0, 0.12) << scale;
      EXPECT_GT(place.y(), 19.5 + 1 / scale);
      EXPECT_LT(place.y(), 56);
    }
  }
}

TEST(DetectEdges, NoMoreFalseEdgelsInFinerViews) {
  Image image = ConstantImage(300, 300, {100});
  AddNoise(5, 3, &image);
  Quantize(&image);
  const size_t as_stored = DetectEdges(image, {}).edgels.size();
  image.scale.setConstant(2);
  // Twice as many for the same length.
  EXPECT_LT(DetectEdges(image, {}).edgels.size(), 2.2 * as_stored);
}

}  // namespace
}  // namespace limn
