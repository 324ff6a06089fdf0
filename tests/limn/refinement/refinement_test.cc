// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/refinement.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "limn/geometry/polyline.h"
#include "limn/model/footprint.h"
#include "limn/refinement/scene_unit.h"
#include "support/random_numbers.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr double kHalfSideOfCube = 0.8;
constexpr int kNumCubeViews = 16;
constexpr double kEdgelNoisePx = 0.2;

const std::vector<View>& ViewsOfCube() {
  static const std::vector<View> views = testing::DomeViews(kNumCubeViews, 5);
  return views;
}

double FootprintAt(const Eigen::Vector3d& point) { return *FootprintIn(ViewsOfCube()[0], point); }

const std::vector<ImageCurves>& CurvesOfCube(double noise_px) {
  static const auto exact =
      testing::ProjectCurves(ViewsOfCube(), testing::CubeEdges(kHalfSideOfCube));
  static const auto noisy =
      testing::ProjectCurves(ViewsOfCube(), testing::CubeEdges(kHalfSideOfCube), kEdgelNoisePx);
  return noise_px > 0 ? noisy : exact;
}

std::vector<ViewId> AllViews() {
  std::vector<ViewId> all;
  for (int v = 0; v < kNumCubeViews; ++v) all.push_back(v);
  return all;
}

DrawingLink MakeLink(const Eigen::Vector3d& from, const Eigen::Vector3d& to, NodeId node0,
                     NodeId node1) {
  DrawingLink link;
  link.points_in_world = ResampleUniform(std::vector<Eigen::Vector3d>{from, to}, 0.01);
  link.sigma.assign(link.points_in_world.size(), 1);
  link.node0 = node0;
  link.node1 = node1;
  link.supporting_views = AllViews();
  return link;
}

// The edges of the cube, meeting at its corners.
DrawingGraph DrawnCube() {
  const std::vector<Eigen::Vector3d> corners = testing::CubeCorners(kHalfSideOfCube);
  DrawingGraph graph;
  for (const Eigen::Vector3d& corner : corners) {
    graph.nodes.emplace_back();
    graph.nodes.back().position_in_world = corner;
  }
  for (int i = 0; i < 8; ++i) {
    for (const int bit : {1, 2, 4}) {
      if (!(i & bit)) graph.links.push_back(MakeLink(corners[i], corners[i | bit], i, i | bit));
    }
  }
  RebuildIncidence(&graph);
  return graph;
}

// Moves every node, and every other point with a wave of its own.
DrawingGraph Perturbed(DrawingGraph graph, double size_px) {
  std::mt19937 random(11);
  testing::UniformDistribution<double> uniform(-1, 1);
  const auto offset = [&](const Eigen::Vector3d& point) {
    const Eigen::Vector3d direction = testing::RandomVector(uniform, random);
    return Eigen::Vector3d(size_px * FootprintAt(point) * direction);
  };
  for (DrawingNode& node : graph.nodes) node.position_in_world += offset(node.position_in_world);
  for (DrawingLink& link : graph.links) {
    std::vector<Eigen::Vector3d>& points = link.points_in_world;
    const Eigen::Vector3d wave = offset(points.front());
    const Eigen::Vector3d ends[2] = {graph.nodes[link.node0].position_in_world - points.front(),
                                     graph.nodes[link.node1].position_in_world - points.back()};
    const size_t last = points.size() - 1;
    for (size_t k = 1; k < last; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(last);
      points[k] += (1 - t) * ends[0] + t * ends[1] + std::sin(4 * M_PI * t) * wave;
    }
    points.front() = graph.nodes[link.node0].position_in_world;
    points.back() = graph.nodes[link.node1].position_in_world;
  }
  return graph;
}

RefinementResult RefineCube(const DrawingGraph& graph, double noise_px, int num_threads = 2) {
  RunContext context;
  context.num_threads = num_threads;
  return RefineDrawing({{ViewsOfCube(), CurvesOfCube(noise_px)}, graph}, {}, {}, context);
}

const DrawingGraph& NoisyResult() {
  static const DrawingGraph graph = RefineCube(Perturbed(DrawnCube(), 0.6), kEdgelNoisePx).graph;
  return graph;
}

// Root mean square over all points of their distance from the true edges, px.
double RmsErrorPx(const DrawingGraph& graph) {
  double sum = 0;
  int count = 0;
  for (size_t l = 0; l < graph.links.size(); ++l) {
    const Polyline3d truth = testing::CubeEdges(kHalfSideOfCube)[l].points;
    for (const Eigen::Vector3d& point : graph.links[l].points_in_world) {
      sum += ClosestPoint(truth, point).squared_distance / std::pow(FootprintAt(point), 2);
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

void ExpectSame(const DrawingGraph& a, const DrawingGraph& b) {
  ASSERT_EQ(a.links.size(), b.links.size());
  for (size_t l = 0; l < a.links.size(); ++l) {
    EXPECT_EQ(a.links[l].points_in_world, b.links[l].points_in_world) << "link " << l;
    EXPECT_EQ(a.links[l].sigma, b.links[l].sigma) << "link " << l;
    EXPECT_EQ(a.links[l].supporting_views, b.links[l].supporting_views) << "link " << l;
  }
}

TEST(Refinement, PerturbedCubeComesBack) {
  const DrawingGraph perturbed = Perturbed(DrawnCube(), 0.6);
  const DrawingGraph graph = RefineCube(perturbed, 0).graph;
  EXPECT_TRUE(Validate(graph).empty());
  EXPECT_GT(RmsErrorPx(perturbed), 0.3);
  EXPECT_LT(RmsErrorPx(graph), 0.05);
}

TEST(Refinement, NoisyCubeComesBackToATenthOfAPixel) {
  EXPECT_TRUE(Validate(NoisyResult()).empty());
  EXPECT_LT(RmsErrorPx(NoisyResult()), 0.1);
}

TEST(Refinement, CornersAreFoundAndShared) {
  const std::vector<Eigen::Vector3d> corners = testing::CubeCorners(kHalfSideOfCube);
  ASSERT_EQ(NoisyResult().nodes.size(), corners.size());
  for (size_t n = 0; n < corners.size(); ++n) {
    const DrawingNode& node = NoisyResult().nodes[n];
    EXPECT_EQ(node.Degree(), 3);
    const DrawingLink& arm = NoisyResult().links[node.incident[0].link];
    const double sigma = node.incident[0].end == 0 ? arm.sigma.front() : arm.sigma.back();
    EXPECT_LT((node.position_in_world - corners[n]).norm(), 4 * sigma);
    EXPECT_LT((node.position_in_world - corners[n]).norm(), FootprintAt(corners[n]));
  }
}

// Mean over all vertices of the squared error over that of two sigmas.
double MeanNormalizedSquare(const DrawingGraph& graph) {
  double sum = 0;
  int count = 0;
  for (size_t l = 0; l < graph.links.size(); ++l) {
    const Polyline3d truth = testing::CubeEdges(kHalfSideOfCube)[l].points;
    const DrawingLink& link = graph.links[l];
    for (size_t k = 0; k < link.points_in_world.size(); ++k) {
      const double squared = ClosestPoint(truth, link.points_in_world[k]).squared_distance;
      sum += squared / (2 * std::pow(link.sigma[k], 2));
      ++count;
    }
  }
  return sum / count;
}

// A sigma is of one direction across the curve: two of them make the squared distance.
TEST(Refinement, NormalizedErrorsHaveUnitVariance) {
  const double mean = MeanNormalizedSquare(NoisyResult());
  RecordProperty("variance", std::to_string(mean));
  // The cube's edgels err independently, but are taken for partly dependent and for less exact than
  // they are: the sigmas are on the safe side here.
  EXPECT_LT(mean, 1.5);
  EXPECT_GT(mean, 0.1);
}

// The cube's curves with an offset of its own for every edge in every image, as light and blur make
// them: hundreds of edgels say the same wrong thing.
std::vector<ImageCurves> CurvesWithOffsets(double offset_px) {
  std::mt19937 random(5);
  testing::NormalDistribution<double> gauss(0, offset_px);
  std::vector<ImageCurves> curves = CurvesOfCube(kEdgelNoisePx);
  for (ImageCurves& of_view : curves) {
    for (const CurveFragment& fragment : of_view.fragments) {
      const double offset = gauss(random);
      for (const EdgelId id : fragment.edgel_ids) {
        Edgel& edgel = of_view.edge_map.edgels[id];
        edgel.position_px += offset * edgel.Normal();
        edgel.stored_px = edgel.position_px.cast<float>();
      }
    }
  }
  return curves;
}

TEST(Refinement, SigmasKnowThatViewsErrAsAWhole) {
  const std::vector<ImageCurves> curves = CurvesWithOffsets(0.5);
  const DrawingGraph graph =
      RefineDrawing({{ViewsOfCube(), curves}, DrawnCube()}, {}, {}, {}).graph;
  const double mean = MeanNormalizedSquare(graph);
  RecordProperty("variance", std::to_string(mean));
  EXPECT_LT(mean, 1.5);
  EXPECT_GT(mean, 1 / 1.5);
}

TEST(Refinement, ResultDoesNotDependOnThreads) {
  ExpectSame(RefineCube(Perturbed(DrawnCube(), 0.6), kEdgelNoisePx, 1).graph, NoisyResult());
}

// Powers of two: only tolerances could differ.
class RefinementOfScaled : public ::testing::TestWithParam<double> {};

TEST_P(RefinementOfScaled, GivesTheScaledDrawing) {
  DrawingGraph expected = NoisyResult();
  for (DrawingLink& link : expected.links) {
    for (Eigen::Vector3d& point : link.points_in_world) point *= GetParam();
    for (double& sigma : link.sigma) sigma *= GetParam();
  }
  const std::vector<View> views = testing::Scaled(ViewsOfCube(), GetParam());
  const DrawingGraph scaled = Scaled(Perturbed(DrawnCube(), 0.6), GetParam());
  ExpectSame(RefineDrawing({{views, CurvesOfCube(kEdgelNoisePx)}, scaled}, {}, {}, {}).graph,
             expected);
}

INSTANTIATE_TEST_SUITE_P(Scales, RefinementOfScaled,
                         ::testing::Values(std::exp2(-50), std::exp2(10), std::exp2(50)));

TEST(Refinement, EmptyGraphStaysEmpty) {
  const RefinementResult result = RefineCube(DrawingGraph(), 0);
  EXPECT_TRUE(result.graph.links.empty());
  EXPECT_TRUE(result.graph.nodes.empty());
}

TEST(Refinement, LinkThatNoViewShowsStaysWhereItWas) {
  DrawingGraph graph;
  graph.nodes.resize(2);
  graph.nodes[0].position_in_world = {-0.3, 0.1, 0.1};
  graph.nodes[1].position_in_world = {0.3, 0.12, 0.05};
  graph.links.push_back(
      MakeLink(graph.nodes[0].position_in_world, graph.nodes[1].position_in_world, 0, 1));
  RebuildIncidence(&graph);
  const DrawingGraph result = RefineCube(graph, 0).graph;
  EXPECT_TRUE(Validate(result).empty());
  EXPECT_EQ(result.links[0].points_in_world, graph.links[0].points_in_world);
  EXPECT_EQ(result.links[0].sigma, graph.links[0].sigma);
}

TEST(Refinement, TwoViewsAreTooFew) {
  DrawingGraph graph = Perturbed(DrawnCube(), 0.6);
  for (DrawingLink& link : graph.links) link.supporting_views = {0, 5};
  const DrawingGraph result = RefineCube(graph, 0).graph;
  for (size_t l = 0; l < graph.links.size(); ++l) {
    EXPECT_EQ(result.links[l].points_in_world, graph.links[l].points_in_world) << "link " << l;
  }
}

TEST(Refinement, NoRoundsChangeNothing) {
  RefinementOptions options;
  options.num_rounds = 0;
  const DrawingGraph graph = Perturbed(DrawnCube(), 0.6);
  ExpectSame(RefineDrawing({{ViewsOfCube(), CurvesOfCube(0)}, graph}, options, {}, {}).graph,
             graph);
}

}  // namespace
}  // namespace limn
