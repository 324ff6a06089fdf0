// SPDX-License-Identifier: BSD-3-Clause
#include "support/synthetic_image.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "support/random_numbers.h"

namespace limn::testing {
namespace {

using Eigen::Vector2d;

double DistanceToSegment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d d = b - a;
  const double t = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
  return (p - a - t * d).norm();
}

// Share of a unit square that lies on the positive side of a line with unit normal n, whose signed
// distance at the center of the square is d.
double SquareCoverage(const Vector2d& n, double d) {
  const double a = std::min(std::abs(n.x()), std::abs(n.y()));
  const double b = std::max(std::abs(n.x()), std::abs(n.y()));
  const double h = std::abs(d);
  double smaller = 0;
  if (h <= 0.5 * (b - a)) {
    smaller = 0.5 - h / b;
  } else if (h < 0.5 * (a + b)) {
    smaller = 0.5 * std::pow(0.5 * (a + b) - h, 2) / (a * b);
  }
  return d >= 0 ? 1 - smaller : smaller;
}

double PixelCoverage(const Shape& shape, const Vector2d& pixel) {
  const double at_center = shape(pixel);
  if (std::abs(at_center) > 1) return at_center > 0 ? 1 : 0;
  constexpr int kSquares = 4;
  constexpr double kSize = 1.0 / kSquares;
  constexpr double kStep = 1e-4;
  double sum = 0;
  for (int j = 0; j < kSquares; ++j) {
    for (int i = 0; i < kSquares; ++i) {
      const Vector2d p = pixel + Vector2d((i + 0.5) * kSize - 0.5, (j + 0.5) * kSize - 0.5);
      Vector2d slope(shape(p + Vector2d(kStep, 0)) - shape(p - Vector2d(kStep, 0)),
                     shape(p + Vector2d(0, kStep)) - shape(p - Vector2d(0, kStep)));
      slope = slope.norm() > 0 ? Vector2d(slope.normalized()) : Vector2d(1, 0);
      sum += SquareCoverage(slope, shape(p) / kSize);
    }
  }
  return sum * kSize * kSize;
}

}  // namespace

Shape HalfPlane(const Vector2d& point, const Vector2d& normal) {
  return [=](const Vector2d& p) { return (p - point).dot(normal); };
}

Shape Disc(const Vector2d& center, double radius) {
  return [=](const Vector2d& p) { return radius - (p - center).norm(); };
}

Shape Stroke(const Vector2d& from, const Vector2d& to, double width) {
  return [=](const Vector2d& p) { return 0.5 * width - DistanceToSegment(p, from, to); };
}

Shape Polygon(const std::vector<Vector2d>& corners) {
  return [=](const Vector2d& p) {
    double distance = std::numeric_limits<double>::max();
    bool inside = false;
    for (size_t i = 0; i < corners.size(); ++i) {
      const Vector2d& a = corners[i];
      const Vector2d& b = corners[(i + 1) % corners.size()];
      distance = std::min(distance, DistanceToSegment(p, a, b));
      if ((a.y() > p.y()) != (b.y() > p.y()) &&
          p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
        inside = !inside;
      }
    }
    return inside ? distance : -distance;
  };
}

Shape Complement(const Shape& a) {
  return [=](const Vector2d& p) { return -a(p); };
}

Image ConstantImage(int width, int height, const std::vector<float>& levels) {
  Image image;
  image.width = width;
  image.height = height;
  image.channels = static_cast<int>(levels.size());
  for (int i = 0; i < width * height; ++i) {
    image.data.insert(image.data.end(), levels.begin(), levels.end());
  }
  return image;
}

void Paint(const Shape& shape, const std::vector<float>& levels, Image* image) {
  for (int y = 0; y < image->height; ++y) {
    for (int x = 0; x < image->width; ++x) {
      const double coverage = PixelCoverage(shape, Vector2d(x, y));
      if (coverage == 0) continue;
      float* values = image->data.data() + (y * image->width + x) * image->channels;
      for (int k = 0; k < image->channels; ++k) {
        values[k] = static_cast<float>((1 - coverage) * values[k] + coverage * levels[k]);
      }
    }
  }
}

void AddNoise(double sigma, unsigned seed, Image* image) {
  std::mt19937 generator(seed);
  testing::NormalDistribution<float> noise(0.f, static_cast<float>(sigma));
  for (float& value : image->data) value += noise(generator);
}

void Quantize(Image* image) {
  for (float& value : image->data) value = std::clamp(std::round(value), 0.f, 255.f);
}

}  // namespace limn::testing
