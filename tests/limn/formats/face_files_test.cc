// SPDX-License-Identifier: BSD-3-Clause
// Faces of a drawing in the files that hold them.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/formats/face_mesh.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/mesh_reader.h"
#include "limn/formats/read_curves.h"
#include "limn/formats/temporary_folder.h"
#include "limn/formats/triangle_parts.h"
#include "limn/formats/write_drawing.h"
#include "limn/util/errors.h"
#include "support/face_drawing.h"

namespace limn {
namespace {

const DrawingMetadata kFaceMetadata = {{"a.png", "b.png"}, "{}"};

std::vector<std::pair<std::string, DrawingGraph>> FaceDrawings() {
  return {{"cube", testing::UnitCube()},
          {"plate", testing::PlateWithHole()},
          {"cylinder", testing::Cylinder()},
          {"cone", testing::Cylinder(0.5)},
          {"half", testing::HalfCylinderSide()},
          {"patch", testing::PentagonPatch()},
          {"squares", testing::TwoSquaresOnOneLine()}};
}

TEST(FaceFiles, TheDrawingsOfTheTestsAreValid) {
  for (const auto& [name, graph] : FaceDrawings()) {
    EXPECT_THAT(Validate(graph), ::testing::IsEmpty()) << name;
  }
  double area = 0;
  for (const DrawingFace& face : testing::UnitCube().faces) area += AreaOf(face);
  EXPECT_NEAR(area, 6, 1e-9);
  EXPECT_NEAR(AreaOf(testing::PlateWithHole().faces[0]), 6 - M_PI / 4, 1e-3);
  EXPECT_NEAR(AreaOf(testing::Cylinder().faces[2]), 4 * M_PI, 0.02);
  EXPECT_NEAR(AreaOf(testing::HalfCylinderSide().faces[0]), 2 * M_PI, 0.01);
}

void ExpectSameFace(const DrawingFace& read, const DrawingFace& face) {
  EXPECT_EQ(read.surface, face.surface);
  ASSERT_EQ(read.loops.size(), face.loops.size());
  for (size_t l = 0; l < face.loops.size(); ++l) {
    ASSERT_EQ(read.loops[l].size(), face.loops[l].size());
    for (size_t e = 0; e < face.loops[l].size(); ++e) {
      EXPECT_EQ(read.loops[l][e].link, face.loops[l][e].link);
      EXPECT_EQ(read.loops[l][e].from, face.loops[l][e].from);
      EXPECT_EQ(read.loops[l][e].to, face.loops[l][e].to);
      EXPECT_EQ(read.loops[l][e].bridge, face.loops[l][e].bridge);
    }
  }
  EXPECT_EQ(read.side_starts, face.side_starts);
  EXPECT_EQ(read.normal, face.normal);
  EXPECT_EQ(read.offset, face.offset);
  EXPECT_EQ(read.vertices, face.vertices);
  EXPECT_EQ(read.triangles, face.triangles);
  EXPECT_EQ(read.confidence, face.confidence);
  EXPECT_EQ(read.views, face.views);
}

TEST(FaceFiles, JsonKeepsTheFaces) {
  const TemporaryFolder folder;
  for (const auto& [name, graph] : FaceDrawings()) {
    SCOPED_TRACE(name);
    WriteDrawing(folder.Path("d.json"), graph, kFaceMetadata);
    const DrawingFile file = ReadDrawingJson(folder.Path("d.json"));
    ASSERT_EQ(file.graph.faces.size(), graph.faces.size());
    for (size_t f = 0; f < graph.faces.size(); ++f) {
      ExpectSameFace(file.graph.faces[f], graph.faces[f]);
    }
    WriteDrawing(folder.Path("again.json"), file.graph, file.metadata);
    EXPECT_EQ(TemporaryFolder::Read(folder.Path("d.json")),
              TemporaryFolder::Read(folder.Path("again.json")));
  }
}

// Every invariant of Validate, and what the reader itself needs.
TEST(FaceFiles, BrokenFacesAreRefused) {
  const TemporaryFolder folder;
  const auto written = [&](const DrawingGraph& graph) {
    WriteDrawing(folder.Path("d.json"), graph, kFaceMetadata);
    return TemporaryFolder::Read(folder.Path("d.json"));
  };
  const std::string plate = written(testing::PlateWithHole());
  const std::string half = written(testing::HalfCylinderSide());
  const std::string patch = written(testing::PentagonPatch());
  const struct {
    const std::string& text;
    std::string from, to, complaint;
  } cases[] = {
      {plate, R"("surface":"plane")", R"("surface":"soap")", "unknown surface of a face"},
      {plate, R"("surface":"plane")", R"("surface":"patch")", "cannot have such loops"},
      {plate, R"("normal":[0.0,0.0,1.0],"offset")", R"("normal":[0.0,0.0,1.1],"offset")",
       "no normal"},
      {plate, R"("offset":1.0)", R"("offset":null)", "offset: a number expected"},
      {plate, R"("views":["a.png","b.png"],"loops")", R"("views":["c.png"],"loops")",
       "views[0]: is not in the list of views"},
      {plate, R"({"link":0,"from":0.0)", R"({"link":77,"from":0.0)",
       "on a link that does not exist"},
      {plate, R"({"link":0,"from":0.0)", R"({"link":0.5,"from":0.0)", "an integer expected"},
      {plate, R"({"link":0,"from":0.0)", R"({"link":0,"from":-0.5)", "not on its link"},
      {plate, R"({"link":0,"from":0.0)", R"({"link":0,"from":1e300)", "from -1e15 to 1e15"},
      {plate, R"({"link":0,"from":0.0)", R"({"link":0,"from":1.0)", "not on its link"},
      {plate, R"({"bridge":[[1.0,0.0,1.0],)", R"({"bridge":[)", "fewer than two points"},
      {plate, R"({"bridge":[[1.0,0.0,1.0],)", R"({"link":0,"from":0,"to":1,"bridge":[)",
       "both a link and a bridge"},
      {plate, R"("triangles":[[)", R"("triangles":[[-1,0,1],[)", "a corner is not a vertex"},
      {plate, R"("triangles":[[)", R"("triangles":[[0,1,100000],[)", "a corner is not a vertex"},
      {plate, R"("triangles":[[)", R"("triangles":[[0,1],[)", "a list of 3 expected"},
      {plate, R"("confidence":0.75,"normal")", R"("confidence":1.75,"normal")", "confidence"},
      {plate, R"("loops":[[)", R"("loops":[[],[)", "a loop has no edges"},
      {plate, R"("loops":[[)", R"("loops":[],"more":[[)", "no border"},
      {plate, R"("surface":"plane",)", "", "surface"},
      {half, R"("side_starts":[0,1,2,3])", R"("side_starts":[0,1,2])", "cannot have such loops"},
      {half, R"("side_starts":[0,1,2,3])", R"("side_starts":[0,2,1,3])", "cannot have such loops"},
      {half, R"("side_starts":[0,1,2,3])", R"("side_starts":[0,1,2,4])", "cannot have such loops"},
      {patch, R"("side_starts":[0,1,2,3,4])", R"("side_starts":[1,2,3,4])",
       "cannot have such loops"},
      {patch, R"("side_starts":[0,1,2,3,4])", R"("side_starts":[0])", "cannot have such loops"},
      {patch, R"("vertices":[[)", R"("vertices":[[0,1],[)", "a list of 3 numbers expected"},
  };
  for (const auto& [text, from, to, complaint] : cases) {
    SCOPED_TRACE(from + " -> " + to);
    const size_t faces = text.find("\"faces\"");
    const size_t at = text.find(from, faces);
    ASSERT_NE(at, std::string::npos);
    const std::string bad = std::string(text).replace(at, from.size(), to);
    const std::string path = folder.Write("bad.json", bad);
    EXPECT_THAT([&] { ReadDrawingJson(path); },
                ::testing::ThrowsMessage<IoError>(::testing::AllOf(
                    ::testing::HasSubstr("bad.json"), ::testing::HasSubstr(complaint))));
  }
}

TEST(FaceFiles, FacesNeedTheNamesOfTheirViews) {
  const TemporaryFolder folder;
  DrawingGraph graph = testing::HalfCylinderSide();
  for (DrawingLink& link : graph.links) link.supporting_views = {0};
  EXPECT_THROW(WriteDrawing(folder.Path("d.json"), graph, {{"only one.png"}, "{}"}), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder.Path("d.json")));
}

// As many triangles, the same area, and normals on the side that is seen.
TEST(FaceFiles, MeshesComeBack) {
  const TemporaryFolder folder;
  DrawingFormatOptions as_faces;
  as_faces.format = "faces";
  for (const auto& [name, graph] : FaceDrawings()) {
    SCOPED_TRACE(name);
    double area = 0;
    size_t num_triangles = 0;
    for (const DrawingFace& face : graph.faces) {
      area += AreaOf(face);
      num_triangles += face.triangles.size();
    }
    WriteDrawing(folder.Path("faces.ply"), graph, kFaceMetadata, as_faces);
    WriteDrawing(folder.Path("d.obj"), graph, kFaceMetadata);
    for (const char* file : {"faces.ply", "d.obj"}) {
      const TriangleMesh mesh = ReadMesh(folder.Path(file));
      EXPECT_EQ(mesh.triangles.size() + mesh.num_degenerate, num_triangles);
      double read_area = 0;
      for (const auto& [a, b, c] : mesh.triangles) {
        read_area +=
            (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
      }
      EXPECT_NEAR(read_area / 2, area, 1e-9);
    }
    const CurveSet curves = ReadCurves(folder.Path("d.obj"));
    ASSERT_EQ(curves.polylines.size(), graph.links.size());
    EXPECT_EQ(curves.polylines.back(), graph.links.back().points_in_world);
  }
  EXPECT_THROW(WriteDrawing(folder.Path("none.ply"), {}, {}, as_faces), InputError);
}

TEST(FaceFiles, NormalsAreOfTheSeenSide) {
  for (const DrawingFace& face : testing::UnitCube().faces) {
    for (const Eigen::Vector3d& normal : VertexNormals(face)) {
      EXPECT_GT(normal.dot(face.vertices.front() - Eigen::Vector3d(0.5, 0.5, 0.5)), 0.4);
    }
  }
  const DrawingGraph half = testing::HalfCylinderSide();
  const std::vector<Eigen::Vector3d> normals = VertexNormals(half.faces[0]);
  for (size_t v = 0; v < normals.size(); ++v) {
    const Eigen::Vector3d& vertex = half.faces[0].vertices[v];
    EXPECT_GT(normals[v].dot(Eigen::Vector3d(vertex.x(), vertex.y(), 0)), 0.999);
  }
  EXPECT_TRUE(std::any_of(normals.begin(), normals.end(), [](const Eigen::Vector3d& normal) {
    return normal.isApprox(Eigen::Vector3d::UnitY(), 0.03);
  }));
}

TEST(FaceFiles, ObjHasAnObjectPerFaceWithNormals) {
  const TemporaryFolder folder;
  WriteDrawing(folder.Path("d.obj"), testing::TwoSquaresOnOneLine(), kFaceMetadata);
  const std::string text = TemporaryFolder::Read(folder.Path("d.obj"));
  EXPECT_THAT(text, ::testing::HasSubstr("o face_0\ng plane\nv "));
  EXPECT_THAT(text, ::testing::HasSubstr("vn 0 0 1\nf 10//4 7//1 8//2\nf 8//2 9//3 10//4\n"));
  EXPECT_THAT(text, ::testing::HasSubstr("o face_1\ng plane\nv "));
  EXPECT_THAT(text, ::testing::HasSubstr("\nf 14//8 11//5 12//6\n"));
}

// Formats with short indices get large faces in parts.
TEST(FaceFiles, PartsHaveAllTrianglesAndKnowTheBorder) {
  constexpr int kCount = 12'001;
  DrawingFace face;
  for (int i = 0; i <= kCount + 1; ++i) face.vertices.emplace_back(i / 2, i % 2, 0);
  for (int i = 0; i < kCount; ++i) {
    face.triangles.push_back(i % 2 == 0 ? std::array{i, i + 2, i + 1}
                                        : std::array{i, i + 1, i + 2});
  }
  const std::vector<TrianglePart> parts = PartsOf(face);
  ASSERT_EQ(parts.size(), 2u);
  int t = 0, num_border = 0;
  for (const TrianglePart& part : parts) {
    EXPECT_LE(part.vertices.size(), 32'767u);
    for (size_t i = 0; i < part.triangles.size(); ++i, ++t) {
      for (int corner = 0; corner < 3; ++corner) {
        num_border += part.is_border[i][corner];
        EXPECT_EQ(part.vertices[part.triangles[i][corner]],
                  face.vertices[face.triangles[t][corner]]);
      }
    }
  }
  EXPECT_EQ(t, kCount);
  EXPECT_EQ(num_border, kCount + 2);
  EXPECT_THAT(PartsOf({}), ::testing::IsEmpty());
}

}  // namespace
}  // namespace limn
