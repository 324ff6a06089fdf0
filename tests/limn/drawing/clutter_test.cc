// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "limn/drawing/drawing.h"
#include "limn/evaluation/evaluate_curves.h"
#include "limn/refinement/refinement.h"
#include "limn/sketch/sketch.h"
#include "support/random_numbers.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr double kHalfSideOfClutter = 0.8;
constexpr double kDistance = 5;
constexpr double kNoisePx = 0.2;

const std::vector<View>& ViewsOfClutter() {
  static const std::vector<View> views = testing::DomeViews(16, kDistance);
  return views;
}

// Curves that one image shows and that are nowhere in space: every image has its own.
class Clutter {
 public:
  Clutter(const View& view, unsigned seed) : view_(view), random_(seed) {}

  // As long in the image as `length_px`: half of it short curves anywhere, half of it fragments of
  // a texture, which are hatched patches.
  std::vector<testing::SceneCurve> Make(double length_px) {
    while (made_px_ < 0.5 * length_px) AddArc(Place(), Uniform(-M_PI, M_PI), Uniform(12, 45));
    while (made_px_ < length_px) AddPatch();
    return std::move(curves_);
  }

 private:
  double Uniform(double low, double high) {
    return testing::UniformDistribution<double>(low, high)(random_);
  }
  Eigen::Vector2d Place() { return {Uniform(90, 550), Uniform(90, 390)}; }

  void AddPatch() {
    const Eigen::Vector2d corner = Place();
    const double angle = Uniform(-M_PI, M_PI);
    const Eigen::Vector2d across(-std::sin(angle), std::cos(angle));
    const double spacing_px = Uniform(4, 8);
    const int count = static_cast<int>(Uniform(3, 7));
    for (int k = 0; k < count; ++k) {
      AddArc(corner + k * spacing_px * across, angle + Uniform(-0.1, 0.1), Uniform(12, 25));
    }
  }

  // From a point in a direction, somewhat bent.
  void AddArc(Eigen::Vector2d point, double angle, double length_px) {
    const double turn_per_px = Uniform(-0.03, 0.03);
    testing::SceneCurve curve;
    for (int px = 0; px < static_cast<int>(length_px); ++px) {
      curve.points.push_back(InSpace(point));
      point += Eigen::Vector2d(std::cos(angle), std::sin(angle));
      angle += turn_per_px;
    }
    if (curve.points.size() < 2) return;
    made_px_ += static_cast<double>(curve.points.size()) - 1;
    curves_.push_back(std::move(curve));
  }

  Eigen::Vector3d InSpace(const Eigen::Vector2d& pixel) const {
    return Inverse(view_.cam_from_world) * (kDistance * view_.camera.RayFromPixel(pixel));
  }

  const View& view_;
  std::mt19937 random_;
  double made_px_ = 0;
  std::vector<testing::SceneCurve> curves_;
};

double LengthPx(const ImageCurves& curves) {
  size_t num_edgels = 0;
  for (const CurveFragment& fragment : curves.fragments) num_edgels += fragment.edgel_ids.size();
  return static_cast<double>(num_edgels);
}

// A wire cube, and in every image as much clutter as there is of the cube.
std::vector<ImageCurves> CubeInClutter() {
  std::vector<ImageCurves> curves;
  for (size_t v = 0; v < ViewsOfClutter().size(); ++v) {
    const auto seed = static_cast<unsigned>(100 + v);
    auto shown = testing::CubeEdges(kHalfSideOfClutter);
    const double cube_px = LengthPx(testing::ProjectCurves(ViewsOfClutter()[v], shown));
    for (auto& curve : Clutter(ViewsOfClutter()[v], seed).Make(cube_px))
      shown.push_back(std::move(curve));
    curves.push_back(testing::ProjectCurves(ViewsOfClutter()[v], shown, kNoisePx, seed));
    EXPECT_GE(LengthPx(curves.back()), 2 * cube_px);
  }
  return curves;
}

void ExpectCubeAndLittleElse(const DrawingGraph& graph, const std::string& name) {
  EXPECT_TRUE(Validate(graph).empty());
  CurveSet truth;
  truth.polylines = testing::Polylines(testing::CubeEdges(kHalfSideOfClutter));
  EvaluationOptions options;
  options.taus = {2};
  const TauResult row =
      EvaluateCurvesInFootprints(ToCurveSet(graph), truth, ViewsOfClutter(), options).rows.at(0);
  ::testing::Test::RecordProperty(name + "_precision", std::to_string(row.precision.value()));
  ::testing::Test::RecordProperty(name + "_recall", std::to_string(row.recall.value()));
  EXPECT_GE(row.precision.value(), 0.95) << name;
  EXPECT_GE(row.recall.value(), 0.95) << name;
}

TEST(ClutterTest, CubeIsFoundAndLittleElse) {
  const std::vector<ImageCurves> curves = CubeInClutter();
  const CurveSketch sketch =
      BuildSweptSketch({{ViewsOfClutter(), curves}}, SketchOptions(), {}).sketch;
  const DrawingGraph drawn =
      BuildDrawing({{ViewsOfClutter(), curves}, sketch}, DrawingOptions(), {}).graph;
  ExpectCubeAndLittleElse(drawn, "drawn");
  ExpectCubeAndLittleElse(RefineDrawing({{ViewsOfClutter(), curves}, drawn}, {}, {}, {}).graph,
                          "refined");
}

}  // namespace
}  // namespace limn
