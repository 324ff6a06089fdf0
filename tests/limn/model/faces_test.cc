// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/faces.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limn/model/drawing_graph.h"
#include "limn/model/drawing_transform.h"
#include "support/face_drawing.h"

namespace limn {
namespace {

// The first face of a drawing after a change, and what is wrong with it.
template <typename Change>
std::string ProblemAfter(DrawingGraph graph, Change&& change) {
  EXPECT_TRUE(Validate(graph).empty());
  change(&graph.faces.front());
  const std::vector<std::string> problems = Validate(graph);
  return problems.empty() ? "" : problems.front();
}
template <typename Change>
std::string ProblemOfCube(Change&& change) {
  return ProblemAfter(testing::UnitCube(), std::forward<Change>(change));
}

TEST(Faces, WhatIsWrongIsTold) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto edge = [](DrawingFace* face) -> FaceEdge& { return face->loops[0][0]; };
  EXPECT_EQ(ProblemOfCube([](DrawingFace*) {}), "");
  EXPECT_EQ(ProblemOfCube([](DrawingFace* f) { f->loops.clear(); }), "face 0: it has no border");
  EXPECT_EQ(ProblemOfCube([](DrawingFace* f) { f->loops.emplace_back(); }),
            "face 0: a loop has no edges");
  EXPECT_EQ(ProblemOfCube([&](DrawingFace* f) { edge(f).link = 12; }),
            "face 0: an edge is on a link that does not exist");
  for (const auto& [from, to] : {std::pair(0.0, 1.5), {-0.1, 1.0}, {0.5, 0.5}, {kNan, 1.0}}) {
    EXPECT_EQ(ProblemOfCube([&](DrawingFace* f) {
                edge(f).from = from;
                edge(f).to = to;
              }),
              "face 0: an edge is not on its link");
  }
  EXPECT_EQ(ProblemOfCube([&](DrawingFace* f) { edge(f).bridge.resize(2); }),
            "face 0: an edge is both a link and a bridge");
  EXPECT_EQ(ProblemOfCube([&](DrawingFace* f) {
              edge(f) = FaceEdge{-1, 0, 0, {Eigen::Vector3d::Zero()}};
            }),
            "face 0: a bridge has fewer than two points");
  EXPECT_EQ(ProblemOfCube([&](DrawingFace* f) {
              edge(f) = FaceEdge{-1, 0, 0, {{0, 0, 0}, {kNan, 0, 0}}};
            }),
            "face 0: a point of a bridge is not finite");
  EXPECT_EQ(ProblemOfCube([](DrawingFace* f) { f->normal *= 1.1; }),
            "face 0: its plane has no normal or no offset");
  EXPECT_EQ(ProblemOfCube([](DrawingFace* f) { f->offset = kNan; }),
            "face 0: its plane has no normal or no offset");
  EXPECT_EQ(ProblemOfCube([](DrawingFace* f) { f->vertices[0].x() = kNan; }),
            "face 0: a vertex is not finite");
  for (const int corner : {-1, 4}) {
    EXPECT_EQ(ProblemOfCube([&](DrawingFace* f) { f->triangles[0][1] = corner; }),
              "face 0: a corner is not a vertex");
  }
  for (const double confidence : {-0.1, 1.1, kNan}) {
    EXPECT_EQ(ProblemOfCube([&](DrawingFace* f) { f->confidence = confidence; }),
              "face 0: its confidence is not from 0 to 1");
  }
}

TEST(Faces, LoopsAndSidesMustSuitTheSurface) {
  const std::string problem = "face 0: its surface cannot have such loops and sides";
  EXPECT_EQ(ProblemOfCube([](DrawingFace* f) { f->side_starts = {0}; }), problem);
  EXPECT_EQ(ProblemOfCube([](DrawingFace* f) { f->surface = FaceSurface::kRuled; }), problem);
  const auto of_half = [](std::vector<int> starts) {
    return ProblemAfter(testing::HalfCylinderSide(),
                        [&](DrawingFace* f) { f->side_starts = std::move(starts); });
  };
  EXPECT_EQ(of_half({0, 1, 2, 3}), "");
  EXPECT_EQ(of_half({}), problem);
  EXPECT_EQ(of_half({0, 1, 2}), problem);
  EXPECT_EQ(of_half({1, 2, 3, 3}), problem);
  EXPECT_EQ(of_half({0, 2, 1, 3}), problem);
  EXPECT_EQ(of_half({0, 1, 2, 4}), problem);
  EXPECT_EQ(ProblemAfter(testing::PentagonPatch(), [](DrawingFace* f) { f->side_starts = {0}; }),
            problem);
}

TEST(Faces, NamesOfSurfaces) {
  for (int s = 0; s < kNumFaceSurfaces; ++s) {
    const auto surface = static_cast<FaceSurface>(s);
    EXPECT_EQ(FaceSurfaceNamed(FaceSurfaceName(surface)), surface);
  }
  EXPECT_EQ(FaceSurfaceNamed("sphere"), std::nullopt);
}

TEST(Faces, MoveWithTheDrawing) {
  const DrawingGraph plate = testing::PlateWithHole();
  const double scale = 2.5;
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Eigen::Vector3d translation(4, -5, 6);
  const DrawingGraph moved = Transformed(plate, scale, rotation, translation);
  EXPECT_TRUE(Validate(moved).empty());
  ASSERT_EQ(moved.faces.size(), 1u);
  const DrawingFace& face = moved.faces[0];
  EXPECT_NEAR(AreaOf(face), scale * scale * AreaOf(plate.faces[0]), 1e-9);
  for (size_t v = 0; v < face.vertices.size(); ++v) {
    EXPECT_NEAR(face.normal.dot(face.vertices[v]), face.offset, 1e-9);
    const Eigen::Vector3d expected = scale * (rotation * plate.faces[0].vertices[v]) + translation;
    EXPECT_LT((face.vertices[v] - expected).norm(), 1e-12);
  }
  const auto bridge = [](const DrawingFace& of) -> const FaceEdge& {
    return *std::ranges::find_if(of.loops[0], &FaceEdge::IsBridge);
  };
  const Eigen::Vector3d end =
      scale * (rotation * bridge(plate.faces[0]).bridge.back()) + translation;
  EXPECT_LT((bridge(face).bridge.back() - end).norm(), 1e-12);
}

TEST(Faces, AreaOfACube) {
  double area = 0;
  for (const DrawingFace& face : testing::UnitCube().faces) area += AreaOf(face);
  EXPECT_NEAR(area, 6, 1e-12);
}

TEST(Faces, GoWithTheLinksThatBoundThem) {
  DrawingGraph cube = testing::UnitCube();
  std::vector<uint8_t> keep(cube.links.size(), 1);
  keep[0] = 0;
  const std::vector<DrawingFace> before = cube.faces;
  RemoveLinks(keep, &cube);
  EXPECT_TRUE(Validate(cube).empty());
  // Two faces meet in each edge; the others have their links one lower.
  ASSERT_EQ(cube.faces.size(), 4u);
  size_t next = 0;
  for (const DrawingFace& face : before) {
    const bool is_lost =
        std::ranges::any_of(face.loops[0], [](const FaceEdge& edge) { return edge.link == 0; });
    if (is_lost) continue;
    for (size_t e = 0; e < face.loops[0].size(); ++e) {
      EXPECT_EQ(cube.faces[next].loops[0][e].link, face.loops[0][e].link - 1);
    }
    ++next;
  }
}

TEST(Faces, GoWithLinksThatChanged) {
  DrawingGraph cube = testing::UnitCube();
  const std::vector<DrawingFace> before = cube.faces;
  std::vector<uint8_t> changed(cube.links.size(), 0);
  DropFacesOf(changed, &cube);
  EXPECT_EQ(cube.faces.size(), before.size());
  changed[0] = 1;
  DropFacesOf(changed, &cube);
  EXPECT_EQ(cube.faces.size(), before.size() - 2);
  EXPECT_TRUE(Validate(cube).empty());
  DropFacesOf(changed, &cube);
  EXPECT_EQ(cube.faces.size(), before.size() - 2);
}

TEST(Faces, BridgesKeepTheirPlace) {
  DrawingFace face = testing::PlateWithHole().faces[0];
  const std::vector<int> reversed = {9, 8, 7, 6, 5, 4, 3, 2, 1, 0};
  const DrawingFace before = face;
  ASSERT_TRUE(RenameLinks(reversed, &face));
  int num_bridges = 0;
  for (size_t l = 0; l < face.loops.size(); ++l) {
    for (size_t e = 0; e < face.loops[l].size(); ++e) {
      const FaceEdge &edge = face.loops[l][e], &old = before.loops[l][e];
      num_bridges += edge.IsBridge();
      EXPECT_EQ(edge.link, old.IsBridge() ? -1 : reversed[old.link]);
      EXPECT_EQ(edge.bridge, old.bridge);
    }
  }
  EXPECT_EQ(num_bridges, 1);
  EXPECT_FALSE(RenameLinks(std::vector<int>(10, -1), &face));
}

}  // namespace
}  // namespace limn
