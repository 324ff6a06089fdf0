#include "limn/visibility/raster.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

void FillPolygon(const std::vector<Eigen::Vector2d>& corners,
                 const std::function<double(const Eigen::Vector2d&)>& depth_at, DepthImage* image) {
  double top = std::numeric_limits<double>::infinity();
  double bottom = -top;
  for (const Eigen::Vector2d& corner : corners) {
    top = std::min(top, corner.y());
    bottom = std::max(bottom, corner.y());
  }
  if (top > image->height || bottom < 0) return;
  for (int row = FirstIndex(top); row <= LastIndex(bottom, image->height); ++row) {
    Span span;
    for (size_t k = 0; k < corners.size(); ++k) {
      CrossSide(corners[k], corners[(k + 1) % corners.size()], row, &span);
    }
    if (span.first > image->width || !(span.last >= 0)) continue;
    for (int column = FirstIndex(span.first); column <= LastIndex(span.last, image->width);
         ++column) {
      PutNearer(static_cast<float>(depth_at(image->PixelOf(column, row))), column, row, image);
    }
  }
}

void FillDisc(const Eigen::Vector2d& center, double radius, float z, DepthImage* image) {
  if (!(center.x() >= -radius && center.x() <= image->width - 1 + radius && center.y() >= -radius &&
        center.y() <= image->height - 1 + radius)) {
    return;
  }
  for (int row = FirstIndex(center.y() - radius);
       row <= LastIndex(center.y() + radius, image->height); ++row) {
    for (int column = FirstIndex(center.x() - radius);
         column <= LastIndex(center.x() + radius, image->width); ++column) {
      if ((Eigen::Vector2d(column, row) - center).squaredNorm() > radius * radius) continue;
      PutNearer(z, column, row, image);
    }
  }
}

}  // namespace limn
