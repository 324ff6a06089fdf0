// SPDX-License-Identifier: BSD-3-Clause
#include "limn/drawing/retriangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "limn/support/edgel_residual.h"
#include "limn/util/angles.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Most tests look at a wire on the y axis from cameras on an arc around that axis. It is then at
// the same depth over its whole length and seen without foreshortening, so that a pixel is a pixel
// along it in every view.
constexpr double kCameraDistance = 5;
constexpr double kFocal = 600;
constexpr double kPixel = kCameraDistance / kFocal;

std::vector<View> ArcViews(const std::vector<double>& distances) {
  std::vector<View> views;
  for (size_t v = 0; v < distances.size(); ++v) {
    const double angle = 0.15 * static_cast<double>(v);
    views.push_back(testing::LookAt(distances[v] * Vector3d(std::cos(angle), 0, std::sin(angle)),
                                    Vector3d::Zero()));
  }
  return views;
}

std::vector<View> ArcViews(int count) {
  return ArcViews(std::vector<double>(static_cast<size_t>(count), kCameraDistance));
}

// Unit normal of the plane through a camera and the wire.
Vector3d PlaneNormal(const View& view) {
  return Vector3d::UnitY().cross(view.CenterInWorld()).normalized();
}

// A stretch of the wire, ends in pixels.
testing::SceneCurve Wire(double from_px, double to_px) {
  return testing::Segment({0, from_px * kPixel, 0}, {0, to_px * kPixel, 0});
}

std::vector<Vector3d> WirePoints(double from_px, double to_px, double step_px) {
  std::vector<Vector3d> points;
  for (double y = from_px; y <= to_px + 1e-9; y += step_px) points.emplace_back(0, y * kPixel, 0);
  return points;
}

struct OneCurveScene {
  std::vector<View> views;
  std::vector<ImageCurves> curves;

  Edgel& EdgelOf(const EdgelRef& ref) { return curves[ref.view].edge_map.edgels[ref.edgel]; }
};

// Every view sees all of the wire over +-40 px.
OneCurveScene FullScene(int num_views, double noise_px = 0) {
  OneCurveScene scene;
  scene.views = ArcViews(num_views);
  scene.curves = testing::ProjectCurves(scene.views, {Wire(-40, 40)}, noise_px);
  return scene;
}

// The first two views see all of the wire, the others these stretches of it: where there is none,
// two views support a sample.
OneCurveScene PartlySeen(const std::vector<testing::SceneCurve>& stretches) {
  OneCurveScene scene = FullScene(2);
  scene.views = ArcViews(7);
  for (size_t v = 2; v < scene.views.size(); ++v) {
    scene.curves.push_back(testing::ProjectCurves(scene.views[v], stretches));
  }
  return scene;
}

// Nearest linked edgel within 3 px, in the first `num_fragments` fragments.
EdgelId NearestEdgel(const ImageCurves& curves, size_t num_fragments,
                     const Eigen::Vector2d& pixel) {
  EdgelId nearest = kInvalidEdgel;
  double smallest = 3;
  for (size_t f = 0; f < std::min(num_fragments, curves.fragments.size()); ++f) {
    for (const EdgelId id : curves.fragments[f].edgel_ids) {
      const double distance = (curves.edge_map.edgels[id].position_px - pixel).norm();
      if (distance >= smallest) continue;
      smallest = distance;
      nearest = id;
    }
  }
  return nearest;
}

constexpr ViewId kAnchor = 0;

// A curve of the sketch through these points, whose own edgels are those of the anchor's first
// fragment.
Curve3D SketchCurve(const OneCurveScene& scene, const std::vector<Vector3d>& points,
                    bool closed = false) {
  Curve3D curve;
  curve.closed = closed;
  curve.anchor = {kAnchor, 0, 0};
  const size_t size = points.size();
  for (size_t k = 0; k < size; ++k) {
    const size_t before = closed ? (k + size - 1) % size : std::max<size_t>(k, 1) - 1;
    const size_t after = closed ? (k + 1) % size : std::min(k + 1, size - 1);
    curve.points_in_world.push_back(points[k]);
    curve.tangents_in_world.push_back((points[after] - points[before]).normalized());
    std::vector<EdgelRef> support;
    for (size_t v = 0; v < scene.views.size(); ++v) {
      const auto pixel = scene.views[v].Project(points[k]);
      if (!pixel) continue;
      const size_t num_fragments = v == kAnchor ? 1 : scene.curves[v].fragments.size();
      const EdgelId id = NearestEdgel(scene.curves[v], num_fragments, *pixel);
      if (id != kInvalidEdgel) support.push_back({static_cast<ViewId>(v), id});
    }
    curve.support.Append(support);
  }
  curve.depth_sigma.assign(size, std::numeric_limits<double>::infinity());
  curve.certain.assign(size, 1);
  return curve;
}

// Moves every sample away from the anchor by this many pixel footprints.
void Deepen(const View& anchor, double pixels, Curve3D* curve) {
  for (Vector3d& point : curve->points_in_world) {
    point += pixels * kPixel * (point - anchor.CenterInWorld()).normalized();
  }
}

struct Outcome {
  SampleSet samples;
  RetriangulationStats stats;
};

void ExpectWellFormed(const SampleSet& samples) {
  const size_t count = samples.position.size();
  ASSERT_EQ(samples.curve_begin.size(), samples.origins.size() + 1);
  EXPECT_EQ(samples.curve_begin.front(), 0);
  EXPECT_EQ(samples.curve_begin.back(), samples.NumSamples());
  ASSERT_EQ(samples.curve_of.size(), count);
  ASSERT_EQ(samples.tangent.size(), count);
  EXPECT_EQ(samples.information.size(), count);
  EXPECT_EQ(samples.footprint.size(), count);
  ASSERT_EQ(samples.support.NumSamples(), count);
  for (int c = 0; c < samples.NumCurves(); ++c) {
    EXPECT_GT(samples.Size(c), 0);
    for (int s = samples.curve_begin[c]; s < samples.curve_begin[c + 1]; ++s) {
      EXPECT_EQ(samples.curve_of[s], c);
    }
  }
  for (size_t s = 0; s < count; ++s) {
    EXPECT_NEAR(samples.tangent[s].norm(), 1, 1e-12);
    const auto support = samples.support.Of(s);
    for (size_t i = 1; i < support.size(); ++i) EXPECT_LT(support[i - 1].view, support[i].view);
  }
}

Outcome Retriangulated(const OneCurveScene& scene, const std::vector<Curve3D>& sketch,
                       const DrawingOptions& options = {}, int step = 1) {
  Outcome outcome;
  const auto support = BuildViewEdgels(scene.curves, {});
  const TopologyInput images = {scene.views, scene.curves, support, options.Gate()};
  outcome.samples = Retriangulate({sketch}, step, images, options, {}, &outcome.stats);
  ExpectWellFormed(outcome.samples);
  int64_t samples_in = 0;
  for (const Curve3D& curve : sketch) samples_in += static_cast<int64_t>(curve.size());
  EXPECT_EQ(outcome.stats.samples_in, samples_in);
  int64_t samples_out = outcome.stats.too_few_views + outcome.stats.piece_too_short;
  for (int s = 0; s < outcome.samples.NumSamples(); ++s) {
    samples_out += outcome.samples.InSketch(s).size();
  }
  EXPECT_EQ(samples_out, samples_in);
  return outcome;
}

// Distance from the y axis, px.
double MissPx(const Vector3d& point) { return std::hypot(point.x(), point.z()) / kPixel; }

double RmsMissPx(const SampleSet& samples) {
  double sum = 0;
  for (const Vector3d& point : samples.position) sum += std::pow(MissPx(point), 2);
  return std::sqrt(sum / samples.NumSamples());
}

// What the tangent lines of exact edgels in all views know of a sample of the wire: each view fixes
// the sample's distance from its plane through the wire.
Matrix3d ExpectedInformation(const std::vector<View>& views, double variance_px) {
  Matrix3d information = Matrix3d::Zero();
  for (const View& view : views) {
    const Vector3d normal = PlaneNormal(view);
    information += normal * normal.transpose() / (variance_px * kPixel * kPixel);
  }
  return information;
}

// Per curve: first sample in the sketch, and the number of samples.
std::vector<std::pair<int, int>> Pieces(const SampleSet& samples) {
  std::vector<std::pair<int, int>> pieces;
  for (int c = 0; c < samples.NumCurves(); ++c) {
    pieces.emplace_back(samples.origins[c].begin, samples.Size(c));
  }
  return pieces;
}
using PieceList = std::vector<std::pair<int, int>>;

TEST(RetriangulationTest, SamplesReturnToTheWireAcrossIt) {
  OneCurveScene scene;
  scene.views = testing::DomeViews(12, kCameraDistance);
  const Vector3d from(-0.35, 0.1, 0.05), to(0.3, -0.15, 0.2);
  scene.curves = testing::ProjectCurves(scene.views, {testing::Segment(from, to)});
  const Vector3d direction = (to - from).normalized();
  std::vector<Vector3d> points;
  // Away from its ends, as samples whose depth changes slide along it.
  for (int k = 8; k <= 72; ++k) points.push_back(from + (to - from) * (k / 80.0));
  for (const double depth_px : {-4.0, 4.0}) {
    Curve3D curve = SketchCurve(scene, points);
    Deepen(scene.views[kAnchor], depth_px, &curve);
    const SampleSet samples = Retriangulated(scene, {curve}).samples;
    ASSERT_EQ(Pieces(samples), (PieceList{{0, 65}}));
    for (int s = 0; s < samples.NumSamples(); ++s) {
      const Vector3d offset = samples.position[s] - from;
      EXPECT_LT(offset.cross(direction).norm() / kPixel, 0.01);
      const Vector3d moved = samples.position[s] - curve.points_in_world[s];
      EXPECT_LT(std::abs(moved.dot(direction)) / kPixel, 0.02);
    }
  }
}

// Unsmoothed, the error is that of least squares on edgels with this noise; smoothed, less.
TEST(RetriangulationTest, ErrorIsThatOfTheEdgels) {
  const double noise_px = 0.2;
  const OneCurveScene scene = FullScene(8, noise_px);
  Curve3D curve = SketchCurve(scene, WirePoints(-40, 40, 1));
  Deepen(scene.views[kAnchor], 2, &curve);
  const Matrix3d known = ExpectedInformation(scene.views, noise_px * noise_px);
  Eigen::Matrix2d across;
  across << known(0, 0), known(0, 2), known(2, 0), known(2, 2);
  const double expected_px = std::sqrt(across.inverse().trace()) / kPixel;

  DrawingOptions rough;
  rough.bending_sigma_px = 1e3;
  // The standard deviation of the root mean square over 81 samples is about 8 %.
  EXPECT_NEAR(RmsMissPx(Retriangulated(scene, {curve}, rough).samples), expected_px,
              0.25 * expected_px);
  EXPECT_LT(RmsMissPx(Retriangulated(scene, {curve}).samples), 0.7 * expected_px);
}

TEST(RetriangulationTest, InformationIsThatOfTheEdgelsAndZeroAlongTheCurve) {
  for (const int num_views : {5, 10}) {
    for (const float sigma_px : {0.1f, 0.4f}) {
      OneCurveScene scene = FullScene(num_views);
      for (ImageCurves& of_view : scene.curves) {
        for (Edgel& edgel : of_view.edge_map.edgels) edgel.position_sigma_px = sigma_px;
      }
      const double variance_px = ResidualVariance(scene.curves[0].edge_map.edgels[0]);
      const Matrix3d expected = ExpectedInformation(scene.views, variance_px);
      const SampleSet samples =
          Retriangulated(scene, {SketchCurve(scene, WirePoints(-40, 40, 1))}).samples;
      ASSERT_EQ(samples.NumSamples(), 81);
      for (int s = 0; s < samples.NumSamples(); ++s) {
        EXPECT_LT((samples.information[s] - expected).norm(), 0.01 * expected.norm());
        EXPECT_LT((samples.information[s] * samples.tangent[s]).norm(), 1e-6 * expected.norm());
      }
    }
  }
}

TEST(RetriangulationTest, FootprintIsTheMedianOfTheSupportingViews) {
  OneCurveScene scene;
  scene.views = ArcViews({4, 7, kCameraDistance, 6, 4.5, 20, 20, 20, 20});
  for (size_t v = 0; v < scene.views.size(); ++v) {
    const bool sees = v < 5;
    scene.curves.push_back(testing::ProjectCurves(
        scene.views[v], sees ? std::vector{Wire(-40, 40)} : std::vector<testing::SceneCurve>()));
  }
  Curve3D curve = SketchCurve(scene, WirePoints(-40, 40, 1));
  Deepen(scene.views[kAnchor], 2, &curve);
  const SampleSet samples = Retriangulated(scene, {curve}).samples;
  ASSERT_EQ(samples.NumSamples(), 81);
  for (const double footprint : samples.footprint) EXPECT_NEAR(footprint / kPixel, 1, 1e-3);
}

TEST(RetriangulationTest, TangentsFollowTheSamples) {
  const OneCurveScene scene = FullScene(6);
  Curve3D curve = SketchCurve(scene, WirePoints(-40, 40, 1));
  for (Vector3d& tangent : curve.tangents_in_world) {
    tangent = Vector3d(0.05, 1, 0.05).normalized();  // 4 degrees off
  }
  const SampleSet samples = Retriangulated(scene, {curve}).samples;
  ASSERT_EQ(samples.NumSamples(), 81);
  for (const Vector3d& tangent : samples.tangent) {
    EXPECT_LT((tangent - Vector3d::UnitY()).norm(), 0.002);
  }
}

TEST(RetriangulationTest, SupportIsSoughtInAllViewsThatSupportAnyOfTheCurve) {
  const OneCurveScene scene = FullScene(7);
  Curve3D curve = SketchCurve(scene, WirePoints(-40, 40, 1));
  // Even samples know of views 1 and 2, odd ones of 3 and 5, none of 4 and 6.
  SupportLists some;
  for (size_t s = 0; s < curve.size(); ++s) {
    std::vector<EdgelRef> kept;
    for (const EdgelRef& ref : curve.support.Of(s)) {
      const bool known =
          s % 2 == 0 ? ref.view == 1 || ref.view == 2 : ref.view == 3 || ref.view == 5;
      if (ref.view == kAnchor || known) kept.push_back(ref);
    }
    some.Append(kept);
  }
  curve.support = some;
  const SampleSet samples = Retriangulated(scene, {curve}).samples;
  ASSERT_EQ(samples.NumSamples(), 81);
  for (int s = 0; s < samples.NumSamples(); ++s) {
    std::vector<ViewId> views;
    for (const EdgelRef& ref : samples.support.Of(s)) {
      views.push_back(ref.view);
      const Edgel& edgel = scene.curves[ref.view].edge_map.edgels[ref.edgel];
      const auto pixel = scene.views[ref.view].Project(samples.position[s]);
      EXPECT_LT((edgel.position_px - pixel.value()).norm(), 0.6);
    }
    EXPECT_EQ(views, (std::vector<ViewId>{0, 1, 2, 3, 5}));
  }
}

TEST(RetriangulationTest, CurveIsCutWhereTooFewViewsSupportIt) {
  // Samples 10 and 11, at 0 and 4 px, are in a gap.
  const OneCurveScene scene = PartlySeen({Wire(-40, -3), Wire(7, 40)});
  Curve3D curve = SketchCurve(scene, WirePoints(-40, 40, 4));
  const Outcome outcome = Retriangulated(scene, {curve});
  EXPECT_EQ(Pieces(outcome.samples), (PieceList{{0, 10}, {12, 9}}));
  EXPECT_EQ(outcome.stats.too_few_views, 2);
  EXPECT_EQ(outcome.stats.piece_too_short, 0);
  for (int s = 0; s < outcome.samples.NumSamples(); ++s) {
    const int in_sketch = s < 10 ? s : s + 2;
    EXPECT_NEAR(outcome.samples.position[s].y() / kPixel, -40 + 4 * in_sketch, 0.01);
  }
}

TEST(RetriangulationTest, SingleUnsupportedSampleDoesNotCut) {
  // Sample 10 is in a gap.
  const OneCurveScene scene = PartlySeen({Wire(-40, -3), Wire(3, 40)});
  const Outcome outcome = Retriangulated(scene, {SketchCurve(scene, WirePoints(-40, 40, 4))});
  EXPECT_EQ(Pieces(outcome.samples), (PieceList{{0, 21}}));
  EXPECT_EQ(outcome.samples.support.Of(10).size(), 2u);
  EXPECT_EQ(outcome.samples.support.Of(9).size(), 7u);
}

TEST(RetriangulationTest, UnsupportedEndsAreCutOff) {
  // The first and the last sample are beyond what most views see.
  const OneCurveScene scene = PartlySeen({Wire(-37, 37)});
  const Outcome outcome = Retriangulated(scene, {SketchCurve(scene, WirePoints(-40, 40, 4))});
  EXPECT_EQ(Pieces(outcome.samples), (PieceList{{1, 19}}));
  EXPECT_EQ(outcome.stats.too_few_views, 2);
}

TEST(RetriangulationTest, ShortPiecesAreDroppedAndCounted) {
  // Samples 3 and 4, at -28 and -24 px, are in a gap: the first piece is 8 px long.
  const OneCurveScene scene = PartlySeen({Wire(-40, -31), Wire(-21, 40)});
  const Curve3D curve = SketchCurve(scene, WirePoints(-40, 40, 4));
  DrawingOptions options;
  options.min_piece_length_px = 7.5;
  const Outcome both = Retriangulated(scene, {curve}, options);
  EXPECT_EQ(Pieces(both.samples), (PieceList{{0, 3}, {5, 16}}));
  EXPECT_EQ(both.stats.piece_too_short, 0);
  options.min_piece_length_px = 8.5;
  const Outcome one = Retriangulated(scene, {curve}, options);
  EXPECT_EQ(Pieces(one.samples), (PieceList{{5, 16}}));
  EXPECT_EQ(one.stats.piece_too_short, 3);
  EXPECT_EQ(one.stats.too_few_views, 2);
}

TEST(RetriangulationTest, NoPieceIsEmptyHoweverShortPiecesMayBe) {
  const OneCurveScene scene = PartlySeen({Wire(-40, -3), Wire(11, 37)});
  DrawingOptions options;
  options.min_piece_length_px = 0;
  const Outcome outcome =
      Retriangulated(scene, {SketchCurve(scene, WirePoints(-40, 40, 4))}, options);
  EXPECT_EQ(Pieces(outcome.samples), (PieceList{{0, 10}, {13, 7}}));
}

// Five of twelve views that contain the wire support it.
class RequiredViewsTest : public ::testing::Test {
 protected:
  RequiredViewsTest() : scene_(FullScene(5)) {
    scene_.views = ArcViews(12);
    for (size_t v = 5; v < scene_.views.size(); ++v) {
      scene_.curves.push_back(testing::ProjectCurves(scene_.views[v], {}));
    }
  }

  bool Keeps(double share, int min_views, int max_views) const {
    DrawingOptions options;
    options.supporting_views_share = share;
    options.min_supporting_views = min_views;
    options.max_supporting_views = max_views;
    const Outcome outcome =
        Retriangulated(scene_, {SketchCurve(scene_, WirePoints(-40, 40, 4))}, options);
    EXPECT_TRUE(outcome.samples.NumSamples() == 21 || outcome.stats.too_few_views == 21);
    return outcome.samples.NumSamples() > 0;
  }

  OneCurveScene scene_;
};

TEST_F(RequiredViewsTest, ShareOfTheViewsThatContainIt) {
  EXPECT_TRUE(Keeps(0.42, 2, 12));  // 5 of 12
  EXPECT_FALSE(Keeps(0.5, 2, 12));  // 6 of 12
  for (size_t v = 8; v < scene_.views.size(); ++v) {
    const Vector3d center = scene_.views[v].CenterInWorld();
    scene_.views[v] = testing::LookAt(center, 2 * center);  // turned away
  }
  EXPECT_TRUE(Keeps(0.5, 2, 12));  // 4 of 8
}

TEST_F(RequiredViewsTest, ViewsThatEndAlongTheCurveContainAPartOfIt) {
  // The views that do not support it see it from y = 0 on.
  const Vector3d along = (scene_.views[0].camera.cx - 2) * kPixel * Vector3d::UnitY();
  for (size_t v = 5; v < scene_.views.size(); ++v) {
    scene_.views[v] = testing::LookAt(scene_.views[v].CenterInWorld() + along, along);
  }
  DrawingOptions options;
  options.supporting_views_share = 0.5;
  options.max_supporting_views = 12;
  // Half a step away from where those views end.
  const Outcome outcome =
      Retriangulated(scene_, {SketchCurve(scene_, WirePoints(-38, 38, 4))}, options);
  EXPECT_EQ(Pieces(outcome.samples), (PieceList{{0, 10}}));
}

TEST_F(RequiredViewsTest, AtLeastMin) {
  EXPECT_TRUE(Keeps(0, 5, 12));
  EXPECT_FALSE(Keeps(0, 6, 12));
}

TEST_F(RequiredViewsTest, AtMostMax) {
  EXPECT_TRUE(Keeps(1, 2, 5));
  EXPECT_FALSE(Keeps(1, 2, 6));
}

TEST(RetriangulationTest, SupportGateIsRead) {
  DrawingOptions options;
  options.min_supporting_views = options.max_supporting_views = 6;
  const auto num_kept = [&](const OneCurveScene& scene) {
    return Retriangulated(scene, {SketchCurve(scene, WirePoints(-40, 40, 4))}, options)
        .samples.NumSamples();
  };

  OneCurveScene shifted = FullScene(6);
  for (Edgel& edgel : shifted.curves[3].edge_map.edgels) edgel.position_px.y() += 0.8;
  options.max_support_distance_px = 1;
  EXPECT_EQ(num_kept(shifted), 21);
  options.max_support_distance_px = 0.4;  // the five others move the samples by less than that
  EXPECT_EQ(num_kept(shifted), 0);

  options.max_support_distance_px = 1;
  OneCurveScene turned = FullScene(6);
  for (Edgel& edgel : turned.curves[3].edge_map.edgels) edgel.tangent_rad += 10 * kDeg;
  options.max_support_angle_deg = 11;
  EXPECT_EQ(num_kept(turned), 21);
  options.max_support_angle_deg = 9;
  EXPECT_EQ(num_kept(turned), 0);
}

// All edgels of one view are off by 2 px. By least squares they pull with 2 px, by the robust norm
// with robust_residual_px, against the others.
TEST(RetriangulationTest, OutlierPullsNoMoreThanTheRobustNormAllows) {
  const double off_px = 2;
  const ViewId outlier = 3;
  OneCurveScene scene = FullScene(8);
  std::vector<View> others = scene.views;
  others.erase(others.begin() + outlier);
  for (Edgel& edgel : scene.curves[outlier].edge_map.edgels) edgel.position_px.y() += off_px;
  const Vector3d up_in_world =
      scene.views[outlier].cam_from_world.rotation.conjugate() * Vector3d::UnitY();
  ASSERT_NEAR(std::abs(up_in_world.dot(PlaneNormal(scene.views[outlier]))), 1, 1e-9);
  const Curve3D curve = SketchCurve(scene, WirePoints(-40, 40, 1));

  // Displacement across the wire at which the pulls of inliers and outlier cancel.
  const auto balance = [&](Matrix3d information, double pull_px) -> Vector3d {
    information(1, 1) = 1;  // nothing moves along the wire
    return information.inverse() * (pull_px / kPixel * up_in_world);
  };
  const auto expect_displaced = [&](double robust_px, const Vector3d& expected) {
    DrawingOptions options;
    options.max_support_distance_px = 3;
    options.robust_residual_px = robust_px;
    const SampleSet samples = Retriangulated(scene, {curve}, options).samples;
    ASSERT_EQ(samples.NumSamples(), 81);
    for (int s = 0; s < samples.NumSamples(); ++s) {
      Vector3d displaced = samples.position[s];
      displaced.y() = 0;
      EXPECT_LT((displaced - expected).norm() / kPixel, 0.02) << "robust " << robust_px;
    }
  };
  expect_displaced(1e3, balance(ExpectedInformation(scene.views, 1), off_px));
  expect_displaced(0.6, balance(ExpectedInformation(others, 1), 0.6));
  expect_displaced(0.2, balance(ExpectedInformation(others, 1), 0.2));
}

TEST(RetriangulationTest, OwnEdgelStaysWhereAnotherOfItsViewIsNearer) {
  OneCurveScene scene = FullScene(8);
  // The anchor's edge, half a pixel off, and an exact one beside it.
  testing::SceneCurve off = Wire(-40, 40);
  const Vector3d shift = 0.5 * kPixel * PlaneNormal(scene.views[kAnchor]);
  for (Vector3d& point : off.points) point += shift;
  scene.curves[kAnchor] = testing::ProjectCurves(scene.views[kAnchor], {off, Wire(-40, 40)});
  const Curve3D curve = SketchCurve(scene, WirePoints(-40, 40, 1));
  const SampleSet samples = Retriangulated(scene, {curve}).samples;
  ASSERT_EQ(samples.NumSamples(), 81);
  for (int s = 0; s < samples.NumSamples(); ++s) {
    EXPECT_EQ(samples.support.Of(s).size(), 8u);
    EXPECT_EQ(samples.support.Of(s)[0], curve.support.Of(s)[0]);
  }
}

TEST(RetriangulationTest, OwnEdgelIsLostWhereItsViewDoesNotAgree) {
  OneCurveScene scene = FullScene(8);
  for (Edgel& edgel : scene.curves[kAnchor].edge_map.edgels) edgel.position_px.y() += 2.5;
  const SampleSet samples =
      Retriangulated(scene, {SketchCurve(scene, WirePoints(-40, 40, 1))}).samples;
  ASSERT_EQ(samples.NumSamples(), 81);
  for (int s = 0; s < samples.NumSamples(); ++s) {
    ASSERT_EQ(samples.support.Of(s).size(), 7u);
    EXPECT_EQ(samples.support.Of(s)[0].view, 1);
  }
}

constexpr double kRadius = 0.5;

std::vector<Vector3d> PointsOfCircle(int count) {
  std::vector<Vector3d> points;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * M_PI * k / count;
    points.push_back(kRadius * Vector3d(std::cos(angle), std::sin(angle), 0));
  }
  return points;
}

TEST(RetriangulationTest, ClosedCurveStaysClosedAndRoundAtItsSeam) {
  OneCurveScene scene;
  scene.views = testing::DomeViews(12, kCameraDistance);
  scene.curves = testing::ProjectCurves(scene.views, {testing::Circle({0, 0, 0}, kRadius)});
  const int count = 180;  // 2 px
  Curve3D curve = SketchCurve(scene, PointsOfCircle(count), true);
  Deepen(scene.views[kAnchor], 2, &curve);
  const SampleSet samples = Retriangulated(scene, {curve}).samples;
  ASSERT_EQ(Pieces(samples), (PieceList{{0, count}}));
  EXPECT_TRUE(samples.origins[0].closed);
  for (int s = 0; s < count; ++s) {
    const Vector3d& point = samples.position[s];
    // An edgel's tangent line leaves the most curved ellipse by 0.02 px over half a pixel.
    EXPECT_LT(std::hypot(point.head<2>().norm() - kRadius, point.z()) / kPixel, 0.05);
    const Vector3d along = Vector3d(-point.y(), point.x(), 0).normalized();
    // A tangent from one side only would be 2 degrees off.
    EXPECT_GT(samples.tangent[s].dot(along), std::cos(0.5 * kDeg)) << s;
  }
}

TEST(RetriangulationTest, ClosedCurveThatIsCutIsOpen) {
  // Half of the circle in all views but two.
  OneCurveScene scene;
  scene.views = testing::DomeViews(8, kCameraDistance);
  const testing::SceneCurve circle = testing::Circle({0, 0, 0}, kRadius);
  testing::SceneCurve half = circle;
  half.closed = false;
  half.points.resize(half.points.size() / 2);
  for (size_t v = 0; v < scene.views.size(); ++v) {
    scene.curves.push_back(testing::ProjectCurves(scene.views[v], {v < 2 ? circle : half}));
  }
  const int count = 360;
  const Outcome outcome = Retriangulated(scene, {SketchCurve(scene, PointsOfCircle(count), true)});
  ASSERT_EQ(outcome.samples.NumCurves(), 1);
  EXPECT_FALSE(outcome.samples.origins[0].closed);
  EXPECT_NEAR(outcome.samples.NumSamples(), count / 2, 4);  // the gate is 1 px long at either end
}

TEST(RetriangulationTest, CurvesKeepTheirOrderAndTheirOrigins) {
  OneCurveScene scene = PartlySeen({Wire(-20, 40)});
  const Curve3D unseen = SketchCurve(scene, WirePoints(-40, -24, 4));
  Curve3D first = SketchCurve(scene, WirePoints(-8, 8, 4));
  Curve3D second = SketchCurve(scene, WirePoints(12, 32, 4));
  first.anchor.view = 1;
  second.anchor.view = 4;
  const Outcome outcome = Retriangulated(scene, {unseen, first, second});
  ASSERT_EQ(Pieces(outcome.samples), (PieceList{{0, 5}, {0, 6}}));
  EXPECT_EQ(outcome.samples.origins[0].sketch_curve, 1);
  EXPECT_EQ(outcome.samples.origins[1].sketch_curve, 2);
  EXPECT_EQ(outcome.samples.origins[0].primary_view, 1);
  EXPECT_EQ(outcome.samples.origins[1].primary_view, 4);
  EXPECT_EQ(outcome.stats.too_few_views, 5);
}

// The first sample that a sample stands for, and one past the last.
std::pair<int, int> InSketch(const SampleSet& samples, int s) {
  const LinkMember run = samples.InSketch(s);
  return {run.begin, run.end};
}

TEST(RetriangulationTest, EverySecondSampleStandsForTheNext) {
  const OneCurveScene scene = FullScene(8, 0.2);
  const Curve3D curve = SketchCurve(scene, WirePoints(-40, 40, 1));
  const SampleSet samples = Retriangulated(scene, {curve}, {}, 2).samples;
  ASSERT_EQ(Pieces(samples), (PieceList{{0, 41}}));
  for (int s = 0; s < 41; ++s) {
    EXPECT_NEAR(samples.position[s].y() / kPixel, -40 + 2 * s, 0.5);
    EXPECT_EQ(InSketch(samples, s), (std::pair{2 * s, std::min(2 * s + 2, 81)}));
    const auto own = std::ranges::find(samples.support.Of(s), kAnchor, &EdgelRef::view);
    const auto before = std::ranges::find(curve.support.Of(2 * s), kAnchor, &EdgelRef::view);
    EXPECT_EQ(own->edgel, before->edgel);
  }
}

// Bending is that of neighbors in the sketch: a curve that is already thin needs twice as much.
TEST(RetriangulationTest, ThinnedCurvesAreSmoothedAsMuch) {
  const OneCurveScene scene = FullScene(8, 0.2);
  const SampleSet samples =
      Retriangulated(scene, {SketchCurve(scene, WirePoints(-40, 40, 1))}, {}, 2).samples;
  DrawingOptions twice;
  twice.bending_sigma_px *= 2;
  const SampleSet thin =
      Retriangulated(scene, {SketchCurve(scene, WirePoints(-40, 40, 2))}, twice).samples;
  ASSERT_EQ(samples.NumSamples(), thin.NumSamples());
  for (int s = 0; s < thin.NumSamples(); ++s) {
    EXPECT_LT((samples.position[s] - thin.position[s]).norm() / kPixel, 0.05);
  }
}

TEST(RetriangulationTest, PiecesOfThinnedCurvesAreCountedInTheSketch) {
  // Samples 40 to 47, at 0 to 7 px, are in a gap.
  const OneCurveScene scene = PartlySeen({Wire(-40, -1.5), Wire(8.5, 40)});
  const Curve3D curve = SketchCurve(scene, WirePoints(-40, 40, 1));
  const Outcome outcome = Retriangulated(scene, {curve}, {}, 2);
  ASSERT_EQ(outcome.samples.NumCurves(), 2);
  const CurveOrigin& second = outcome.samples.origins[1];
  EXPECT_EQ(second.begin % 2, 0);
  EXPECT_EQ(second.end, 81);
  EXPECT_EQ(outcome.samples.origins[0].end + outcome.stats.too_few_views, second.begin);
  DrawingOptions options;
  options.min_piece_length_px = 35;  // the second piece has less
  const Outcome first_only = Retriangulated(scene, {curve}, options, 2);
  ASSERT_EQ(first_only.samples.NumCurves(), 1);
  EXPECT_EQ(first_only.stats.piece_too_short, 81 - second.begin);
}

TEST(RetriangulationTest, NothingOfNothing) {
  EXPECT_EQ(Retriangulated(FullScene(3), {}).samples.NumCurves(), 0);
}

}  // namespace
}  // namespace limn
