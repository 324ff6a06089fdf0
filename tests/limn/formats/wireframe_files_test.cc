// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/wireframe_files.h"

#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/formats/small_drawing.h"
#include "limn/formats/temporary_folder.h"
#include "limn/formats/write_drawing.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::Pair;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

// With a corner of no edge, a copy of a corner and an edge of no length.
Wireframe OddWireframe() {
  return {{{0, 0, 0}, {1.0 / 3, -2e-17, 5e5}, {7, 8, 9}, {0, 0, 0}}, {{0, 1}, {3, 1}, {1, 1}}};
}

void ExpectSameWireframe(const std::optional<Wireframe>& read, const Wireframe& written) {
  ASSERT_TRUE(read);
  EXPECT_EQ(read->vertices, written.vertices);
  EXPECT_EQ(read->edges, written.edges);
}

TEST(WireframeFiles, ComeBackAsTheyAre) {
  const TemporaryFolder folder;
  for (const Wireframe& wireframe : {OddWireframe(), Wireframe()}) {
    std::ostringstream obj, json;
    WriteWireframeObj(wireframe, {}, {LengthUnit::kMeter, 0.25}, obj);
    WriteWireframeJson(wireframe, {LengthUnit::kMeter, 0.25}, json);
    EXPECT_THAT(obj.str(), StartsWith("# wireframe by limn\n# unit: m\n# tolerance: 0.25\n"));
    EXPECT_THAT(json.str(), StartsWith("{\"format\": \"limn-wireframe\",\n\"unit\": \"m\",\n"
                                       "\"tolerance\": 0.25,\n\"wf_vertices\": ["));
    ExpectSameWireframe(ReadWireframe(folder.Write("w.obj", obj.str())), wireframe);
    ExpectSameWireframe(ReadWireframe(folder.Write("w.json", json.str())), wireframe);
  }
  std::ostringstream bare;
  WriteWireframeObj({}, {}, {}, bare);
  EXPECT_EQ(bare.str(), "# wireframe by limn\n");
}

TEST(WireframeFiles, OfTheChallengeAreRead) {
  const TemporaryFolder folder;
  const Wireframe expected = {{{0, 1, 2}, {3, 4, 5}}, {{0, 1}}};
  const std::string entry =
      R"({"order_id": "abc", "wf_vertices": [[0, 1, 2], [3, 4, 5]], "wf_edges": [[0, 1]],)"
      R"( "wf_classifications": [2]})";
  ExpectSameWireframe(ReadWireframe(folder.Write("a.json", entry)), expected);
  ExpectSameWireframe(ReadWireframe(folder.Write("b.json", "[" + entry + "]")), expected);
  // Building3D's: with comments and further statements.
  ExpectSameWireframe(
      ReadWireframe(folder.Write("c.obj", "# v: vertex\nv 0 1 2\nv 3 4 5\no roof\nl 1 2\n")),
      expected);
}

TEST(WireframeFiles, OtherCurvesAreNone) {
  const TemporaryFolder folder;
  for (const char* name : {"d.obj", "d.json", "d.ply"}) {
    WriteDrawing(folder.Path(name), SmallDrawing(), {{"a.png", "b.png"}});
    EXPECT_FALSE(ReadWireframe(folder.Path(name))) << name;
  }
  EXPECT_FALSE(ReadWireframe(folder.Write("p.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nl 1 2 3\nl 1 2\n")));
  EXPECT_FALSE(ReadWireframe(folder.Path("")));
}

TEST(WireframeFiles, BadOnesAreRefusedWithTheirPlace) {
  const TemporaryFolder folder;
  const auto expect_refused = [&](const std::string& text, const std::string& reason) {
    const std::string path = folder.Write("w.json", text);
    EXPECT_THAT([&] { ReadWireframe(path); },
                ThrowsMessage<IoError>(AllOf(HasSubstr(path), HasSubstr(reason))))
        << text;
  };
  expect_refused(R"({"wf_vertices": [[0, 0, 0], [1, 0, 0]], "wf_edges": [[0, 1], [1, 2]]})",
                 "wf_edges[1][1]: no vertex of this index: there are 2, counted from 0");
  expect_refused(R"({"wf_vertices": [[0, 0, 0]], "wf_edges": [[-1, 0]]})", "wf_edges[0][0]");
  expect_refused(R"({"wf_vertices": [[0, 0, 0]], "wf_edges": [[0, 0, 0]]})", "wf_edges[0]");
  expect_refused(R"({"wf_vertices": [[0, 0]], "wf_edges": []})", "wf_vertices[0]");
  expect_refused(R"({"wf_vertices": []})", "wf_edges");
  expect_refused(R"([{"wf_vertices": [], "wf_edges": []}, {}])",
                 "a list of 2 wireframes: take out the one of this scene");
  const std::string obj = folder.Write("w.obj", "v 0 0 0\nl 1 2\n");
  EXPECT_THAT([&] { ReadWireframe(obj); }, ThrowsMessage<IoError>(HasSubstr("line 2")));
}

// The drawing's small links are of length 0.3 to 1.
TEST(WireframeFiles, ADrawingIsReducedWithItsTolerance) {
  const TemporaryFolder folder;
  DrawingFormatOptions options;
  options.format = "wireframe";
  options.unit = LengthUnit::kMeter;
  options.wireframe.tolerance = 0.1;
  for (const char* name : {"w.obj", "w.json"}) {
    EXPECT_THAT(WriteDrawing(folder.Path(name), SmallDrawing(), {{"a", "b"}}, options), IsEmpty());
    const auto wireframe = ReadWireframe(folder.Path(name));
    ASSERT_TRUE(wireframe);
    EXPECT_THAT(wireframe->vertices,
                ElementsAre(Eigen::Vector3d(-1, 1e-17, 0), Eigen::Vector3d(0, 0, 0),
                            Eigen::Vector3d(0, 0, 1.0 / 3), Eigen::Vector3d(1, 0, 0),
                            Eigen::Vector3d(5, 5, 5), Eigen::Vector3d(5, 6, 5),
                            Eigen::Vector3d(6, 5, 5), Eigen::Vector3d(6, 6, 5)));
    EXPECT_THAT(wireframe->edges, ElementsAre(Pair(0, 1), Pair(1, 2), Pair(1, 3), Pair(4, 5),
                                              Pair(4, 6), Pair(5, 7), Pair(6, 7)));
    EXPECT_THAT(TemporaryFolder::Read(folder.Path(name)), HasSubstr("tolerance"));
  }
  options.obj.y_up = true;
  WriteDrawing(folder.Path("y.obj"), SmallDrawing(), {{"a", "b"}}, options);
  EXPECT_THAT(TemporaryFolder::Read(folder.Path("y.obj")), HasSubstr("\nv 6 5 -5\n"));
}

TEST(WireframeFiles, NothingIsLeftOfADrawingThatIsSmallerThanTheTolerance) {
  const TemporaryFolder folder;
  DrawingFormatOptions options;
  options.format = "wireframe";
  options.wireframe.tolerance = 20;
  EXPECT_THAT(WriteDrawing(folder.Path("w.obj"), SmallDrawing(), {{"a", "b"}}, options),
              ElementsAre("the wireframe has no edges: all curves are within its tolerance of 20"));
  EXPECT_THAT(TemporaryFolder::Read(folder.Path("w.obj")), Not(HasSubstr("\nl ")));
}

TEST(WireframeFiles, HaveTwoExtensions) {
  DrawingFormatOptions options;
  options.format = "wireframe";
  EXPECT_EQ(DrawingFormatOf("w.OBJ", options), "wireframe");
  EXPECT_THAT([&] { DrawingFormatOf("w.dxf", options); },
              ThrowsMessage<IoError>(HasSubstr("w.dxf: wireframes are written as .obj or .json")));
}

TEST(WireframeFiles, OthersOfTheirExtensionAreNone) {
  const TemporaryFolder folder;
  const auto is_one = [&](const std::string& text) {
    std::ofstream(folder.Path("a.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\n" << text;
    return ReadWireframe(folder.Path("a.obj")).has_value();
  };
  EXPECT_TRUE(is_one("l 1 2\n"));
  EXPECT_FALSE(is_one(""));                  // points
  EXPECT_FALSE(is_one("l 1 2\nf 1 2 3\n"));  // a drawing with faces
  EXPECT_FALSE(is_one("l 1 2\np 3\n"));
  EXPECT_FALSE(is_one("l 1 2 3\n"));
}

TEST(WireframeFiles, TheUnitIsRead) {
  const TemporaryFolder folder;
  const Wireframe wireframe{{{0, 0, 0}, {1, 0, 0}}, {{0, 1}}};
  for (const LengthUnit unit : {LengthUnit::kNone, LengthUnit::kMillimeter, LengthUnit::kFoot}) {
    std::ofstream obj(folder.Path("a.obj"));
    WriteWireframeObj(wireframe, {}, {unit, 0.1}, obj);
    obj.close();
    EXPECT_EQ(ReadWireframe(folder.Path("a.obj"))->unit, unit);
    std::ofstream json(folder.Path("a.json"));
    WriteWireframeJson(wireframe, {unit, 0.1}, json);
    json.close();
    EXPECT_EQ(ReadWireframe(folder.Path("a.json"))->unit, unit);
  }
}

}  // namespace
}  // namespace limn
