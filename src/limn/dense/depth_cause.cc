// SPDX-License-Identifier: BSD-3-Clause
#include "limn/dense/depth_cause.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "limn/dense/depth_tolerance.h"
#include "limn/util/median.h"

namespace limn {
namespace {

using Kind = DepthCause::Kind;

constexpr size_t kMaxExamined = 6, kMaxPlacesOfEach = 300;
// Shifts are tried in so many steps either way, each this share of the image's width.
constexpr int kShiftSteps = 10;
constexpr double kShiftStep = 0.03;

struct Examined {
  ViewId view = -1;
  DepthImage image;
  std::vector<SeenPlace> places;
};

std::vector<Examined> Examine(const std::vector<ViewId>& unfit, const SurelySeen& seen,
                              const DepthSource& depths) {
  std::vector<Examined> examined;
  std::vector<ViewId> with_places;
  for (const ViewId view : unfit) {
    if (seen.In(view).size() >= kEnoughPlaces) with_places.push_back(view);
  }
  const size_t every = (with_places.size() + kMaxExamined - 1) / kMaxExamined;
  for (size_t u = 0; u < with_places.size(); u += every) {
    auto image = depths(with_places[u]);
    if (!image) continue;
    examined.push_back(
        {with_places[u], std::move(*image), Thinned(seen.In(with_places[u]), kMaxPlacesOfEach)});
  }
  return examined;
}

// The places as depths would have them that were changed in some way.
using Change = std::function<SeenPlace(const SeenPlace&, const View&, const DepthImage&)>;

class Trial {
 public:
  Trial(const std::vector<Examined>& examined, const std::vector<View>& views,
        const DenseOptions& options)
      : examined_(examined), views_(views), options_(options) {}

  // Keeps the cause if the depths fit with this change, and better than before.
  void Try(const DepthCause& cause, const Change& change) {
    std::vector<DepthAgreement> agreements;
    for (const Examined& of_view : examined_) {
      const View& view = views_[of_view.view];
      std::vector<SeenPlace> places;
      for (const SeenPlace& place : of_view.places) {
        places.push_back(change(place, view, of_view.image));
      }
      agreements.push_back(Agreement(places, view, of_view.image, options_));
    }
    const DepthAgreement all = Pooled(agreements);
    if (!FitsOverall(all) || all.BeyondChance() <= best_) return;
    best_ = all.BeyondChance();
    found_ = cause;
  }
  const DepthCause& found() const { return found_; }

 private:
  const std::vector<Examined>& examined_;
  const std::vector<View>& views_;
  const DenseOptions& options_;
  DepthCause found_;
  double best_ = 0;
};

// The median depth around each place whose depth is known, and the place's own.
std::vector<std::pair<double, double>> DepthPairs(const std::vector<Examined>& examined) {
  std::vector<std::pair<double, double>> pairs;
  for (const Examined& of_view : examined) {
    for (const SeenPlace& place : of_view.places) {
      const Eigen::Vector2i cell = of_view.image.CellAt(place.pixel);
      std::vector<double> known;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const double depth = of_view.image.DepthOr0(cell.x() + dx, cell.y() + dy);
          if (depth > 0) known.push_back(depth);
        }
      }
      if (!known.empty()) pairs.emplace_back(Median(known), place.depth);
    }
  }
  return pairs;
}

// The median in the window of this width that holds most of the values.
double Mode(std::vector<double> values, double width) {
  std::sort(values.begin(), values.end());
  size_t begin = 0, most = 0;
  double mode = 0;
  for (size_t end = 0; end < values.size(); ++end) {
    while (values[end] - values[begin] > width) ++begin;
    if (end - begin + 1 <= most) continue;
    most = end - begin + 1;
    mode = values[(begin + end) / 2];
  }
  return mode;
}

// Of depths, relative.
double RelativeTolerance(const std::vector<Examined>& examined, const std::vector<View>& views,
                         const DenseOptions& options) {
  const Examined& first = examined.front();
  return DepthTolerancePx(options.depth_tolerance_px, first.image.cell_px.maxCoeff()) /
         views[first.view].camera.MeanFocal();
}

void TryDepths(const std::vector<Examined>& examined, const std::vector<View>& views,
               const DenseOptions& options, Trial* trial) {
  std::vector<double> log_ratios, log_products;
  for (const auto& [depth, of_place] : DepthPairs(examined)) {
    log_ratios.push_back(std::log(depth / of_place));
    log_products.push_back(std::log(depth * of_place));
  }
  const double width = 2 * RelativeTolerance(examined, views, options);
  const double factor = std::exp(Mode(log_ratios, width));
  trial->Try({.kind = Kind::kFactor, .factor = factor},
             [=](const SeenPlace& place, const View&, const DepthImage&) {
               return SeenPlace{place.pixel, factor * place.depth};
             });
  const double product = std::exp(Mode(log_products, width));
  trial->Try({.kind = Kind::kInverse}, [=](const SeenPlace& place, const View&, const DepthImage&) {
    return SeenPlace{place.pixel, product / place.depth};
  });
  trial->Try(
      {.kind = Kind::kRays}, [](const SeenPlace& place, const View& view, const DepthImage&) {
        return SeenPlace{place.pixel, place.depth * view.camera.RayFromPixel(place.pixel).norm()};
      });
}

struct Mirroring {
  bool left_right = false;
  bool up_down = false;
};

SeenPlace MirroredIn(const SeenPlace& place, const DepthImage& image, const Mirroring& mirroring) {
  const Eigen::Vector2d last = image.PixelOf(image.width - 1, image.height - 1);
  SeenPlace mirrored = place;
  if (mirroring.left_right) mirrored.pixel.x() = image.origin_px.x() + last.x() - place.pixel.x();
  if (mirroring.up_down) mirrored.pixel.y() = image.origin_px.y() + last.y() - place.pixel.y();
  return mirrored;
}

void TryPixels(Trial* trial) {
  for (const Mirroring& mirroring : {Mirroring{true, false}, {false, true}, {true, true}}) {
    trial->Try({.kind = Kind::kMirrored},
               [=](const SeenPlace& place, const View&, const DepthImage& image) {
                 return MirroredIn(place, image, mirroring);
               });
  }
  for (int dy = -kShiftSteps; dy <= kShiftSteps; ++dy) {
    for (int dx = -kShiftSteps; dx <= kShiftSteps; ++dx) {
      if (dx == 0 && dy == 0) continue;
      const Eigen::Vector2d share = kShiftStep * Eigen::Vector2d(dx, dy);
      trial->Try({.kind = Kind::kShifted, .shift_px = share},
                 [=](const SeenPlace& place, const View& view, const DepthImage&) {
                   return SeenPlace{place.pixel + view.camera.width * share, place.depth};
                 });
    }
  }
}

}  // namespace

DepthCause FindDepthCause(const std::vector<ViewId>& unfit, const SurelySeen& seen,
                          const std::vector<View>& views, const DepthSource& depths,
                          const DenseOptions& options) {
  if (unfit.empty()) return {};
  const std::vector<Examined> examined = Examine(unfit, seen, depths);
  if (examined.empty()) return {};
  Trial trial(examined, views, options);
  TryDepths(examined, views, options, &trial);
  TryPixels(&trial);
  DepthCause cause = trial.found();
  if (cause.kind == Kind::kShifted) {
    cause.shift_px *= views[examined.front().view].camera.width;
  }
  return cause;
}

}  // namespace limn
