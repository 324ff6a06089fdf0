// SPDX-License-Identifier: BSD-3-Clause
// OBJ and PLY files, imported into Blender. Blender is large and not in scripts/setup.sh: skipped
// where it is missing.
#include <cmath>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "end_to_end/exported_drawing.h"
#include "limn/formats/primitive_drawing.h"
#include "limn/geometry/polyline.h"
#include "limn/model/drawing_transform.h"

namespace limn::testing {
namespace {

using nlohmann::json;

// Blender's coordinates are single precision.
constexpr double kRelative = 1e-5;

class DrawingExporterBlender : public ::testing::Test {
 protected:
  void SetUp() override {
    if (RunProgram("blender", {"--version"}).exit_code != 0) {
      GTEST_SKIP() << "blender is not installed";
    }
  }

  json ExportAndImport(const std::string& name) {
    const ExportedDrawing exported(PrimitiveDrawing());
    exported.Export(name, {"--scale", "2.5", "--up_axis", "-y"});
    return exported.ReadInBlender("read_in_blender.py", name);
  }

  const DrawingGraph graph_ =
      Transformed(PrimitiveDrawing(), 2.5, ZUpFrom(SignedAxis::kMinusY), Eigen::Vector3d::Zero());
};

void ExpectSameBounds(const json& read, const DrawingGraph& graph) {
  Eigen::AlignedBox3d box;
  for (const DrawingLink& link : graph.links) {
    for (const Eigen::Vector3d& point : link.points_in_world) box.extend(point);
  }
  const double size = box.diagonal().norm();
  EXPECT_LT((ToPoint(read.at("low")) - box.min()).norm(), kRelative * size);
  EXPECT_LT((ToPoint(read.at("high")) - box.max()).norm(), kRelative * size);
}

TEST_F(DrawingExporterBlender, PlyIsOneMeshOfEdgesThatShareNodes) {
  const json read = ExportAndImport("d.ply");
  ASSERT_EQ(read.at("objects").size(), 1u);
  size_t num_vertices = graph_.nodes.size(), num_edges = 0;
  double length = 0;
  for (const DrawingLink& link : graph_.links) {
    num_vertices += link.points_in_world.size() - 2;
    num_edges += link.points_in_world.size() - 1;
    length += Length(link.points_in_world);
  }
  const json& mesh = read.at("objects")[0];
  EXPECT_EQ(mesh.at("vertices"), num_vertices);
  EXPECT_EQ(mesh.at("used_vertices"), num_vertices);
  EXPECT_EQ(mesh.at("edges"), num_edges);
  EXPECT_EQ(mesh.at("faces"), 0);
  EXPECT_NEAR(mesh.at("length").get<double>() / length, 1, kRelative);
  ExpectSameBounds(read, graph_);
}

TEST_F(DrawingExporterBlender, ObjIsAPolylinePerLink) {
  const json read = ExportAndImport("d.obj");
  ASSERT_EQ(read.at("objects").size(), graph_.links.size());
  std::map<std::string, json> objects;
  for (const json& object : read.at("objects")) objects[object.at("name")] = object;
  for (size_t l = 0; l < graph_.links.size(); ++l) {
    SCOPED_TRACE("link " + std::to_string(l));
    const DrawingLink& link = graph_.links[l];
    const json object = objects["link_" + std::to_string(l)];
    ASSERT_TRUE(object.is_object());
    const size_t num_points = link.points_in_world.size();
    EXPECT_EQ(object.at("vertices"), link.closed ? num_points - 1 : num_points);
    EXPECT_EQ(object.at("edges"), num_points - 1);
    EXPECT_EQ(object.at("faces"), 0);
    EXPECT_NEAR(object.at("length").get<double>() / Length(link.points_in_world), 1, kRelative);
  }
  ExpectSameBounds(read, graph_);
}

}  // namespace
}  // namespace limn::testing
