// SPDX-License-Identifier: BSD-3-Clause
#include "bench/street_scene.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>

#include "limn/geometry/polyline.h"
#include "limn/util/errors.h"
#include "support/random_numbers.h"
#include "support/synthetic_scene.h"

namespace limn::bench {
namespace {

using testing::SceneCurve;

constexpr double kStepM = 0.9;      // between neighboring cameras
constexpr double kDistanceM = 11;   // of the cameras from the middle of the slab
constexpr double kSlabDepthM = 3;   // along y
constexpr double kSlabHeightM = 8;  // along z
constexpr double kMarginM = 9;      // how far the slab extends beyond the first and last camera
constexpr double kReachM = 25;      // no view sees farther along the street
constexpr double kVertexStepM = 0.01;
constexpr double kFocalPx = 3200;
constexpr int kMinViews = 4;

double Uniform(std::mt19937* random, double low, double high) {
  return testing::UniformDistribution<double>(low, high)(*random);
}

Eigen::Vector3d RandomDirection(std::mt19937* random) {
  testing::NormalDistribution<double> gauss(0, 1);
  return testing::RandomVector(gauss, *random).normalized();
}

View MakeView(int index, std::mt19937* random) {
  const Eigen::Vector3d center(kStepM * index + Uniform(random, -0.3, 0.3),
                               -kDistanceM + Uniform(random, -1.5, 1.5), Uniform(random, 1.5, 6));
  const Eigen::Vector3d target(center.x() + Uniform(random, -4, 4), 0, Uniform(random, 3, 5));
  View view = testing::LookAt(center, target);
  view.camera = {kFocalPx, kFocalPx, 1999.5, 1499.5, 4000, 3000};
  view.region = MakeImageRegion(view.camera, nullptr, {}, 2);
  view.model_index = index;
  view.name = "view" + std::to_string(100000 + index);
  return view;
}

// A cubic Bezier curve whose legs turn gently.
SceneCurve MakeCurve(double street_m, std::mt19937* random) {
  const double leg = Uniform(random, 0.7, 2.3) / 3;
  std::array<Eigen::Vector3d, 4> control;
  control[0] = {Uniform(random, -kMarginM, street_m + kMarginM),
                Uniform(random, -kSlabDepthM / 2, kSlabDepthM / 2),
                Uniform(random, 0, kSlabHeightM)};
  Eigen::Vector3d direction = RandomDirection(random);
  for (size_t k = 1; k < control.size(); ++k) {
    control[k] = control[k - 1] + leg * direction;
    direction = (direction + 0.4 * RandomDirection(random)).normalized();
  }
  const int steps = static_cast<int>(std::ceil(3 * leg / kVertexStepM));
  SceneCurve curve;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps, s = 1 - t;
    curve.points.push_back(s * s * s * control[0] + 3 * s * s * t * control[1] +
                           3 * s * t * t * control[2] + t * t * t * control[3]);
  }
  return curve;
}

std::vector<SceneCurve> MakeCurves(double street_m, double curves_per_m, std::mt19937* random) {
  const auto count = static_cast<size_t>(curves_per_m * (street_m + 2 * kMarginM));
  std::vector<SceneCurve> curves;
  for (size_t i = 0; i < count; ++i) curves.push_back(MakeCurve(street_m, random));
  // By place, so that a view finds those in its reach together.
  std::stable_sort(curves.begin(), curves.end(), [](const SceneCurve& a, const SceneCurve& b) {
    return a.points.front().x() < b.points.front().x();
  });
  return curves;
}

// Those that a view may see: `curves` is sorted by the place of the first vertex.
std::vector<SceneCurve> InReach(const View& view, const std::vector<SceneCurve>& curves) {
  const double x = view.CenterInWorld().x();
  const auto is_before = [](const SceneCurve& curve, double place) {
    return curve.points.front().x() < place;
  };
  return {std::lower_bound(curves.begin(), curves.end(), x - kReachM, is_before),
          std::lower_bound(curves.begin(), curves.end(), x + kReachM, is_before)};
}

ImageCurves CurvesOf(const View& view, const std::vector<SceneCurve>& curves,
                     const StreetOptions& options) {
  return testing::ProjectVisibleParts(view, InReach(view, curves), options.noise_px,
                                      static_cast<unsigned>(options.seed + view.model_index));
}

// How many curves a meter of street needs for this many edgels per view: measured on a short one.
double CurvesPerMeter(const StreetOptions& options) {
  constexpr int kNumViews = 40;
  constexpr double kTrial = 20;
  std::mt19937 random(static_cast<unsigned>(options.seed));
  const auto curves = MakeCurves(kStepM * kNumViews, kTrial, &random);
  double edgels = 0;
  for (int i = 0; i < kNumViews; ++i) {
    edgels +=
        static_cast<double>(CurvesOf(MakeView(i, &random), curves, {}).edge_map.edgels.size());
  }
  return kTrial * options.num_edgels * kNumViews / edgels;
}

// Views that may see something at `place`; views are in the order of their places, to about a step.
std::pair<size_t, size_t> ViewsNear(double place, size_t num_views) {
  const auto index = [&](double x) {
    return static_cast<size_t>(std::clamp(x / kStepM, 0.0, static_cast<double>(num_views)));
  };
  return {index(place - kReachM), index(place + kReachM)};
}

std::vector<ViewId> ViewsOf(const Eigen::Vector3d& point, const std::vector<View>& views) {
  std::vector<ViewId> seeing;
  const auto [begin, end] = ViewsNear(point.x(), views.size());
  for (size_t v = begin; v < end; ++v) {
    if (views[v].Project(point)) seeing.push_back(static_cast<ViewId>(v));
  }
  return seeing;
}

std::vector<Polyline3d> SeenParts(const SceneCurve& curve, const std::vector<View>& views) {
  std::vector<Polyline3d> parts;
  bool goes_on = false;
  for (const Eigen::Vector3d& point : curve.points) {
    const bool seen = ViewsOf(point, views).size() >= kMinViews;
    if (seen && !goes_on) parts.emplace_back();
    if (seen) parts.back().push_back(point);
    goes_on = seen;
  }
  std::erase_if(parts, [](const Polyline3d& part) { return part.size() < 2; });
  return parts;
}

void AddHints(const SceneCurve& curve, const std::vector<View>& views, SceneHints* hints) {
  for (const size_t i : {size_t{0}, curve.points.size() / 2, curve.points.size() - 1}) {
    std::vector<ViewId> seeing = ViewsOf(curve.points[i], views);
    if (!seeing.empty()) hints->points.push_back({curve.points[i], std::move(seeing)});
  }
}

}  // namespace

void StreetOptions::Check() const {
  LIMN_CHECK_OPTION(num_views, >= 3);
  LIMN_CHECK_OPTION(num_edgels, >= 100);
  LIMN_CHECK_OPTION(noise_px, >= 0);
}

Street MakeStreet(const StreetOptions& options) {
  options.Check();
  std::mt19937 random(static_cast<unsigned>(options.seed));
  const double street_m = kStepM * options.num_views;
  const auto curves = std::make_shared<const std::vector<SceneCurve>>(
      MakeCurves(street_m, CurvesPerMeter(options), &random));
  Street street;
  street.footprint = kDistanceM / kFocalPx;
  Scene& scene = street.scene;
  for (int i = 0; i < options.num_views; ++i) scene.views.push_back(MakeView(i, &random));
  street.curves_of = [curves, options, views = scene.views](ViewId v) {
    return CurvesOf(views[v], *curves, options);
  };
  for (const SceneCurve& curve : *curves) {
    AddHints(curve, scene.views, &scene.hints);
    for (Polyline3d& part : SeenParts(curve, scene.views)) {
      street.truth.polylines.push_back(std::move(part));
    }
  }
  return street;
}

}  // namespace limn::bench
