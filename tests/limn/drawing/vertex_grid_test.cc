#include "limn/drawing/vertex_grid.h"

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace limn {
namespace {

struct Vertex {
  Eigen::Vector3d position;
  double footprint;
};

// Vertices in a box whose footprint grows eightfold along x, as with distance from the cameras.
std::vector<Vertex> RandomVertices(int count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Vertex> vertices;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d position(uniform(random), uniform(random) - 0.5, uniform(random) - 0.5);
    vertices.push_back({position, 0.01 * std::pow(8.0, position.x())});
  }
  return vertices;
}

TEST(VertexGridTest, FindsEveryVertexWithinTheCell) {
  const double cell_px = 4;
  const std::vector<Vertex> vertices = RandomVertices(3000);
  VertexGrid grid(cell_px);
  for (size_t v = 0; v < vertices.size(); ++v) {
    grid.Add(static_cast<int>(v), vertices[v].position, vertices[v].footprint);
  }
  int num_near = 0;
  for (size_t q = 0; q < vertices.size(); q += 10) {
    std::set<int> found;
    grid.ForEachNear(vertices[q].position, vertices[q].footprint, [&](int v) { found.insert(v); });
    for (size_t v = 0; v < vertices.size(); ++v) {
      const double footprint = std::min(vertices[v].footprint, vertices[q].footprint);
      const double distance = (vertices[v].position - vertices[q].position).norm();
      if (distance > cell_px * footprint) continue;
      ++num_near;
      EXPECT_TRUE(found.count(static_cast<int>(v))) << "query " << q << " vertex " << v;
    }
  }
  EXPECT_GT(num_near, 1000);
}

TEST(VertexGridTest, LeavesOutWhatIsFar) {
  VertexGrid grid(4);
  grid.Add(0, {0, 0, 0}, 0.01);
  grid.Add(1, {100 * 0.01 * 4, 0, 0}, 0.01);
  std::set<int> found;
  grid.ForEachNear({0, 0, 0}, 0.01, [&](int v) { found.insert(v); });
  EXPECT_EQ(found, std::set<int>({0}));
}

TEST(VertexGridTest, VisitsEveryVertexOnce) {
  VertexGrid grid(2);
  const std::vector<Vertex> vertices = RandomVertices(500);
  for (size_t v = 0; v < vertices.size(); ++v) {
    grid.Add(static_cast<int>(v), vertices[v].position, vertices[v].footprint);
  }
  int num_repeated = 0;
  for (const Vertex& query : vertices) {
    std::set<int> found;
    grid.ForEachNear(query.position, query.footprint,
                     [&](int v) { num_repeated += !found.insert(v).second; });
  }
  EXPECT_EQ(num_repeated, 0);
}

TEST(VertexGridTest, FindsVerticesAddedLater) {
  VertexGrid grid(2);
  std::vector<int> found;
  grid.ForEachNear({1, 2, 3}, 0.5, [&](int v) { found.push_back(v); });
  EXPECT_TRUE(found.empty());
  grid.Add(42, {1.2, 2, 3}, 0.5);
  grid.ForEachNear({1, 2, 3}, 0.5, [&](int v) { found.push_back(v); });
  EXPECT_EQ(found, std::vector<int>({42}));
}

}  // namespace
}  // namespace limn
