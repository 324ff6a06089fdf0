// SPDX-License-Identifier: BSD-3-Clause
#include "limn/visibility/raster.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "limn/util/errors.h"

namespace limn {
namespace {

// Where a row crosses a convex polygon, in columns; empty (first > last) if it does not.
struct Span {
  double first = std::numeric_limits<double>::infinity();
  double last = -std::numeric_limits<double>::infinity();

  void Add(double column) {
    first = std::min(first, column);
    last = std::max(last, column);
  }
};

// The crossing with a side does not depend on the side's direction, to the last bit.
void CrossSide(Eigen::Vector2d a, Eigen::Vector2d b, double row, Span* span) {
  if (b.y() < a.y() || (b.y() == a.y() && b.x() < a.x())) std::swap(a, b);
  if (row < a.y() || row > b.y()) return;
  if (a.y() == b.y()) {
    span->Add(a.x());
    span->Add(b.x());
  } else {
    span->Add(a.x() + (row - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
}

int FirstIndex(double at) { return static_cast<int>(std::max(0.0, std::ceil(at))); }

int LastIndex(double at, int count) {
  return static_cast<int>(std::min(count - 1.0, std::floor(at)));
}

void PutNearer(float z, int column, int row, DepthImage* image) {
  float& depth = image->depth[image->Index(column, row)];
  if (depth == 0 || z < depth) depth = z;
}

}  // namespace

RasterWork::RasterWork(const DepthImage& image, size_t num_items) {
  constexpr size_t kMaxLayers = 100;
  constexpr size_t kLittleWork = 100'000'000;
  constexpr size_t kPixelsOfItem = 50;
  left_ =
      std::max(kLittleWork, kMaxLayers * image.width * image.height) + kPixelsOfItem * num_items;
}

void RasterWork::Add(size_t num_pixels) {
  if (num_pixels > left_) {
    throw InputError(
        "the triangles or points of a surface cover the picture more than a hundred times over: "
        "simplify the surface, or leave it out");
  }
  left_ -= num_pixels;
}

size_t FillPolygon(const std::vector<Eigen::Vector2d>& corners,
                   const std::function<double(const Eigen::Vector2d&)>& depth_at,
                   DepthImage* image) {
  double top = std::numeric_limits<double>::infinity();
  double bottom = -top;
  for (const Eigen::Vector2d& corner : corners) {
    top = std::min(top, corner.y());
    bottom = std::max(bottom, corner.y());
  }
  if (top > image->height || bottom < 0) return 0;
  size_t num_pixels = 0;
  for (int row = FirstIndex(top); row <= LastIndex(bottom, image->height); ++row) {
    Span span;
    for (size_t k = 0; k < corners.size(); ++k) {
      CrossSide(corners[k], corners[(k + 1) % corners.size()], row, &span);
    }
    ++num_pixels;
    if (span.first > image->width || !(span.last >= 0)) continue;
    const int first = FirstIndex(span.first);
    const int last = LastIndex(span.last, image->width);
    for (int column = first; column <= last; ++column) {
      PutNearer(static_cast<float>(depth_at(image->PixelOf(column, row))), column, row, image);
    }
    num_pixels += static_cast<size_t>(std::max(0, last - first + 1));
  }
  return num_pixels;
}

size_t FillDisc(const Eigen::Vector2d& center, double radius, float z, DepthImage* image) {
  if (!(center.x() >= -radius && center.x() <= image->width - 1 + radius && center.y() >= -radius &&
        center.y() <= image->height - 1 + radius)) {
    return 0;
  }
  const int left = FirstIndex(center.x() - radius);
  const int right = LastIndex(center.x() + radius, image->width);
  const int top = FirstIndex(center.y() - radius);
  const int bottom = LastIndex(center.y() + radius, image->height);
  for (int row = top; row <= bottom; ++row) {
    for (int column = left; column <= right; ++column) {
      if ((Eigen::Vector2d(column, row) - center).squaredNorm() > radius * radius) continue;
      PutNearer(z, column, row, image);
    }
  }
  return static_cast<size_t>(std::max(0, bottom - top + 1)) *
         static_cast<size_t>(std::max(0, right - left + 1));
}

}  // namespace limn
