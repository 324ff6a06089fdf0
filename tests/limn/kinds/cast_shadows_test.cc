// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/cast_shadows.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "limn/kinds/lights.h"
#include "support/random_numbers.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr int kNumPlates = 9;

const std::vector<View>& DomeOfPlates() {
  static const std::vector<View> views = testing::DomeViews(12, 6);
  return views;
}

// Links without common nodes, seen by all views.
class LinkList {
 public:
  void Add(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    DrawingLink link;
    for (int k = 0; k <= 10; ++k) link.points_in_world.push_back(from + 0.1 * k * (to - from));
    link.points_in_world.back() = to;
    link.sigma.assign(link.points_in_world.size(), 0.0);
    for (NodeId* node : {&link.node0, &link.node1}) {
      *node = static_cast<NodeId>(graph_.nodes.size());
      graph_.nodes.emplace_back();
      graph_.nodes.back().position_in_world = node == &link.node0 ? from : to;
    }
    for (size_t v = 0; v < DomeOfPlates().size(); ++v) {
      link.supporting_views.push_back(static_cast<ViewId>(v));
    }
    graph_.links.push_back(link);
  }

  void AddQuad(const std::array<Eigen::Vector3d, 4>& corners) {
    for (int k = 0; k < 4; ++k) Add(corners[k], corners[(k + 1) % 4]);
  }

  size_t size() const { return graph_.links.size(); }

  DrawingGraph Graph() const {
    DrawingGraph graph = graph_;
    RebuildIncidence(&graph);
    EXPECT_TRUE(Validate(graph).empty());
    return graph;
  }

 private:
  DrawingGraph graph_;
};

// Plates above the ground at various heights and turned differently.
std::vector<std::array<Eigen::Vector3d, 4>> Plates() {
  std::mt19937 random(3);
  testing::UniformDistribution<double> share(0, 1);
  std::vector<std::array<Eigen::Vector3d, 4>> plates;
  for (int p = 0; p < kNumPlates; ++p) {
    const Eigen::Vector3d center(1.1 * (p % 3 - 1), 1.1 * (p / 3 - 1), 0.25 + 0.5 * share(random));
    const double turn = share(random) * std::numbers::pi;
    const Eigen::Vector3d first(0.3 * std::cos(turn), 0.3 * std::sin(turn), 0.1 * share(random));
    const Eigen::Vector3d second(-0.4 * std::sin(turn), 0.4 * std::cos(turn), 0);
    plates.push_back({Eigen::Vector3d(center - first - second), center + first - second,
                      center + first + second, center - first + second});
  }
  return plates;
}

struct LitPlates {
  DrawingGraph graph;
  size_t first_shadow = 0;
  size_t first_mark = 0;
};

// The plates, their shadows on the ground and marks on it. Without `towards_light`, no shadows.
LitPlates PlatesInLight(
    const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& towards_light) {
  LinkList links;
  for (const auto& plate : Plates()) links.AddQuad(plate);
  LitPlates lit;
  lit.first_shadow = links.size();
  if (towards_light) {
    for (auto plate : Plates()) {
      for (Eigen::Vector3d& corner : plate) {
        const Eigen::Vector3d ray = towards_light(corner);
        corner -= corner.z() / ray.z() * ray;
      }
      links.AddQuad(plate);
    }
  }
  lit.first_mark = links.size();
  for (int k = 0; k < 7; ++k) {
    links.Add({-1.6, -1.5 + 0.5 * k, 0}, {1.6, -1.45 + 0.5 * k + 0.1 * (k % 3), 0});
  }
  lit.graph = links.Graph();
  return lit;
}

std::vector<double> SharesOf(const DrawingGraph& graph, int num_threads = 1) {
  RunContext context;
  context.num_threads = num_threads;
  return SharesBehind(graph, DomeOfPlates(), context);
}

void ExpectShadowsOnly(const LitPlates& lit) {
  const std::vector<double> shares = SharesOf(lit.graph);
  int num_found = 0;
  for (size_t l = 0; l < shares.size(); ++l) {
    const bool is_shadow = l >= lit.first_shadow && l < lit.first_mark;
    if (is_shadow) {
      num_found += shares[l] > 0.6 ? 1 : 0;
    } else {
      EXPECT_LT(shares[l], 0.5) << l;
    }
  }
  // Some cross the marks or other shadows; none of those may hide most of them.
  EXPECT_GE(num_found, 0.9 * (lit.first_mark - lit.first_shadow));
}

std::vector<Light> LightsOf(const DrawingGraph& graph) {
  return FindLights(LitSceneOf(PlacesOfLinks(graph, DomeOfPlates(), {})), {});
}

TEST(CastShadowsTest, TheSunIsFoundAndItsShadows) {
  const Eigen::Vector3d sun = Eigen::Vector3d(0.5, -0.4, 0.8).normalized();
  const LitPlates lit = PlatesInLight([&](const Eigen::Vector3d&) { return sun; });
  const std::vector<Light> lights = LightsOf(lit.graph);
  ASSERT_EQ(lights.size(), 1);
  EXPECT_GT(lights[0].direction.dot(sun), std::cos(0.02));
  EXPECT_LT(lights[0].inverse_distance, 0.05);
  ExpectShadowsOnly(lit);
}

TEST(CastShadowsTest, ALampIsFoundAndItsShadows) {
  const Eigen::Vector3d lamp(0.8, 0.6, 3);
  const LitPlates lit =
      PlatesInLight([&](const Eigen::Vector3d& place) { return Eigen::Vector3d(lamp - place); });
  const LitScene scene = LitSceneOf(PlacesOfLinks(lit.graph, DomeOfPlates(), {}));
  const std::vector<Light> lights = FindLights(scene, {});
  ASSERT_EQ(lights.size(), 1);
  const Eigen::Vector3d found =
      scene.center + scene.radius / lights[0].inverse_distance * lights[0].direction;
  EXPECT_LT((found - lamp).norm(), 0.2);
  ExpectShadowsOnly(lit);
}

TEST(CastShadowsTest, WithoutShadowsThereIsNoLight) {
  const LitPlates lit = PlatesInLight(nullptr);
  EXPECT_TRUE(LightsOf(lit.graph).empty());
  EXPECT_EQ(SharesOf(lit.graph), std::vector<double>(lit.graph.links.size(), 0.0));
  EXPECT_TRUE(SharesOf({}).empty());
}

DrawingGraph Prisms(bool with_vertical_edges) {
  LinkList links;
  for (auto plate : Plates()) {
    for (Eigen::Vector3d& corner : plate) corner.z() = 0.6;
    links.AddQuad(plate);
    for (Eigen::Vector3d& corner : plate) {
      if (with_vertical_edges) links.Add(corner, {corner.x(), corner.y(), 0});
      corner.z() = 0;
    }
    links.AddQuad(plate);
  }
  return links.Graph();
}

TEST(CastShadowsTest, PrismsAreNotLitInTheDirectionOfTheirEdges) {
  EXPECT_TRUE(LightsOf(Prisms(true)).empty());
  EXPECT_EQ(LightsOf(Prisms(false)).size(), 1);
}

TEST(LightViewTest, TangentsAreThoseOfThePositions) {
  LitScene scene;
  scene.radius = 2;
  const Light lamp = {Eigen::Vector3d(0.3, -0.2, 0.9).normalized(), 0.8};
  LitPlace place;
  place.footprint = 0.01;
  place.position_in_world = {0.7, 0.4, 0.5};
  place.tangent = Eigen::Vector3d(0.3, 0.5, 0.8).normalized();
  const auto seen = LightView(lamp, scene).See(place);
  ASSERT_TRUE(seen);
  place.position_in_world += 1e-5 * place.tangent;
  const auto ahead = LightView(lamp, scene).See(place);
  ASSERT_TRUE(ahead);
  EXPECT_LT(((ahead->position - seen->position).normalized() - seen->tangent).norm(), 1e-3);
  // Nearer to the light, pixels are larger for it.
  EXPECT_GT(seen->height, 0);
  EXPECT_GT(seen->footprint, place.footprint);
  // Along the ray there is no direction.
  place.tangent = (2.5 * lamp.direction - place.position_in_world).normalized();
  EXPECT_FALSE(LightView(lamp, scene).See(place));
}

TEST(PlacesOfLinksTest, SurfacesFaceTheViewsAndTentativeLinksAreLeftOut) {
  DrawingGraph graph = PlatesInLight(nullptr).graph;
  const size_t num_links = graph.links.size();
  graph.links[0].tentative = true;
  const std::vector<LitPlace> places = PlacesOfLinks(graph, DomeOfPlates(), {});
  size_t num_on_plane = 0;
  size_t num_upwards = 0;
  for (const LitPlace& place : places) {
    EXPECT_NE(place.link, 0);
    if (!place.on_plane) continue;
    ++num_on_plane;
    num_upwards += place.normal.z() > 0.5 ? 1 : 0;
  }
  EXPECT_GT(num_upwards, 0.9 * static_cast<double>(num_on_plane));
  EXPECT_GT(num_on_plane, places.size() / 4);
  EXPECT_EQ(places.back().link, static_cast<LinkId>(num_links - 1));
}

// Tilted plates whose shadows fall on the ground are lit from above: seen from below, the plates
// would lie behind their shadows, on the side that no view sees.
TEST(CastShadowsTest, LightFallsOnTheSideThatTheViewsSee) {
  const Eigen::Vector3d sun = Eigen::Vector3d(-0.3, 0.3, 0.9).normalized();
  const LitPlates lit = PlatesInLight([&](const Eigen::Vector3d&) { return sun; });
  const std::vector<Light> lights = LightsOf(lit.graph);
  ASSERT_FALSE(lights.empty());
  for (const Light& light : lights) EXPECT_GT(light.direction.z(), 0);
}

TEST(CastShadowsTest, ThreadsDoNotMatter) {
  const Eigen::Vector3d sun = Eigen::Vector3d(0.5, -0.4, 0.8).normalized();
  const LitPlates lit = PlatesInLight([&](const Eigen::Vector3d&) { return sun; });
  const std::vector<double> shares = SharesOf(lit.graph, 1);
  EXPECT_GT(shares[lit.first_shadow], 0.6);
  EXPECT_EQ(shares, SharesOf(lit.graph, 3));
}

}  // namespace
}  // namespace limn
