// SPDX-License-Identifier: BSD-3-Clause
// `limn drawing_exporter` to SVG: which picture is made, and what is refused. What is in the
// pictures is tested in limn/formats and scripts/svg_pictures_test.py.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "end_to_end/exported_drawing.h"
#include "support/face_drawing.h"

namespace limn::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kDay[] = LIMN_SAMPLE_DIR "/day";
constexpr char kMesh[] = LIMN_SAMPLE_DIR "/truth/mesh.ply";

// Two lines above and below the sample scene.
DrawingGraph Lines() {
  DrawingGraph graph;
  for (const double z : {1.1, -0.5}) {
    DrawingLink link;
    for (const double x : {-0.5, 0.0, 0.5}) link.points_in_world.push_back({x, 0.6 * x, z});
    for (const Eigen::Vector3d& end : {link.points_in_world.front(), link.points_in_world.back()}) {
      graph.nodes.emplace_back();
      graph.nodes.back().position_in_world = end;
    }
    link.node0 = static_cast<NodeId>(graph.nodes.size()) - 2;
    link.node1 = link.node0 + 1;
    link.sigma.assign(3, 0.01);
    graph.links.push_back(std::move(link));
  }
  RebuildIncidence(&graph);
  return graph;
}

class SvgExport : public ::testing::Test {
 protected:
  std::string Export(const std::vector<std::string>& more) {
    exported_.Export("a.SVG", more);
    return ReadTree(exported_.dir().path()).at("a.SVG");
  }
  void ExpectRefused(const std::vector<std::string>& more, const std::string& text) {
    const LimnRun run = exported_.TryExport("b.svg", more);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, AllOf(::testing::StartsWith("ERROR: "), HasSubstr(text)));
    EXPECT_EQ(ReadTree(exported_.dir().path()).count("b.svg"), 0u);
  }

  ExportedDrawing exported_{Lines()};
};

TEST_F(SvgExport, SheetsToScale) {
  const std::string sheet = Export({"--view", "front", "--sheet_scale", "10", "--unit", "m"});
  EXPECT_THAT(sheet, AllOf(HasSubstr("<svg"), HasSubstr("link_0"), HasSubstr("link_1")));
  EXPECT_THAT(sheet, HasSubstr("1:10"));
  EXPECT_THAT(sheet, HasSubstr("width=\"120mm\""));  // a meter, and two margins of 10 mm
}

TEST_F(SvgExport, WhatAMeshHidesIsRemovedOrDashed) {
  EXPECT_THAT(Export({"--view", "top", "--dense_path", kMesh}),
              AllOf(HasSubstr("link_0"), Not(HasSubstr("link_1"))));
  EXPECT_THAT(Export({"--view", "top", "--dense_path", kMesh, "--hidden", "dashed"}),
              AllOf(HasSubstr("link_0"), HasSubstr("link_1"), HasSubstr("hidden")));
  EXPECT_THAT(Export({"--view", "top", "--dense_path", kMesh, "--show_hidden", "1"}),
              HasSubstr("link_1"));
}

TEST_F(SvgExport, PicturesOfImages) {
  const std::string picture =
      Export({"--view", "view_09.jpg", "--workspace_path", kDay, "--photo", "1"});
  EXPECT_THAT(picture, AllOf(HasSubstr("width=\"640\""), HasSubstr("height=\"480\"")));
  EXPECT_THAT(picture, AllOf(HasSubstr("link_0"), HasSubstr("As seen in view_09.jpg")));
  // The photograph is in the file: "/9j/" begins a JPEG file in base64.
  EXPECT_THAT(picture, HasSubstr("<image href=\"data:image/jpeg;base64,/9j/"));
  EXPECT_GT(picture.size(), 20000u);
}

int CountLinks(const std::string& svg) {
  int count = 0;
  for (size_t at = svg.find("id=\"link_"); at != std::string::npos;
       at = svg.find("id=\"link_", at + 1)) {
    ++count;
  }
  return count;
}

TEST(SvgOfFaces, FacesHideWithoutDenseResults) {
  const ExportedDrawing exported(UnitCube());
  const auto export_to = [&](const std::vector<std::string>& more) {
    exported.Export("a.svg", more);
    return ReadTree(exported.dir().path()).at("a.svg");
  };
  EXPECT_EQ(CountLinks(export_to({})), 9);
  EXPECT_EQ(CountLinks(export_to({"--hidden", "dashed"})), 12);
  EXPECT_THAT(export_to({"--hidden", "dashed"}), HasSubstr("class=\"hidden\""));
  EXPECT_EQ(CountLinks(export_to({"--show_hidden", "1"})), 12);
  // A dense source goes before the faces, unless these are asked for.
  EXPECT_EQ(CountLinks(export_to({"--dense_type", "faces"})), 9);
  EXPECT_EQ(CountLinks(export_to({"--view", "face:2", "--depth_behind", "0.5"})), 4 + 4);
}

TEST_F(SvgExport, Refusals) {
  ExpectRefused({"--view", "view_09.jpg"}, "needs --workspace_path");
  ExpectRefused({"--view", "none.jpg", "--workspace_path", kDay}, "view = none.jpg");
  ExpectRefused({"--view", "view_09.jpg", "--workspace_path", kDay, "--scale", "2"}, "scale");
  ExpectRefused({"--view", "top", "--photo", "1"}, "photo = 1");
  ExpectRefused({"--view", "top", "--dense_path", "nowhere.ply"}, "nowhere.ply");
  ExpectRefused({"--sheet_scale", "-1"}, "scale");
  ExpectRefused({"--view", "top", "--hidden", "removed"}, "neither has the drawing faces");
  ExpectRefused({"--view", "top", "--hidden", "dashed"}, "--dense_path");
  ExpectRefused({"--view", "top", "--dense_type", "faces"}, "drawing_surfacer");
  ExpectRefused({"--dense_type", "faces", "--dense_path", kMesh}, "dense_type = faces");
}

}  // namespace
}  // namespace limn::testing
