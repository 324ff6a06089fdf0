// Faces of a drawing in the files that hold them.
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/temporary_folder.h"
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
      {plate, R"("offset":1.0)", R"("offset":null)", "must be number"},
      {plate, R"("views":["a.png","b.png"],"loops")", R"("views":["c.png"],"loops")",
       "a view of a face"},
      {plate, R"({"link":0,"from":0.0)", R"({"link":77,"from":0.0)", "no link of an edge"},
      {plate, R"({"link":0,"from":0.0)", R"({"link":0.5,"from":0.0)", "an integer expected"},
      {plate, R"({"link":0,"from":0.0)", R"({"link":0,"from":-0.5)", "not on its link"},
      {plate, R"({"link":0,"from":0.0)", R"({"link":0,"from":1e300)", "not on its link"},
      {plate, R"({"link":0,"from":0.0)", R"({"link":0,"from":1.0)", "not on its link"},
      {plate, R"({"bridge":[[1.0,0.0,1.0],)", R"({"bridge":[)", "fewer than two points"},
      {plate, R"({"bridge":[[1.0,0.0,1.0],)", R"({"link":0,"from":0,"to":1,"bridge":[)",
       "both a link and a bridge"},
      {plate, R"("triangles":[[)", R"("triangles":[[-1,0,1],[)", "a corner is no vertex"},
      {plate, R"("triangles":[[)", R"("triangles":[[0,1,100000],[)", "a corner is no vertex"},
      {plate, R"("triangles":[[)", R"("triangles":[[0,1],[)", "out of range"},
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
      {patch, R"("vertices":[[)", R"("vertices":[[0,1],[)", "out of range"},
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

}  // namespace
}  // namespace limn
