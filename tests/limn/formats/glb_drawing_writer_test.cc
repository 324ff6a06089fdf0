// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/glb_drawing_writer.h"

#include <cstring>
#include <map>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limn/formats/small_drawing.h"
#include "limn/formats/tube_mesh.h"
#include "limn/geometry/polyline.h"
#include "limn/util/errors.h"
#include "support/face_drawing.h"

namespace limn {
namespace {

using Json = nlohmann::json;

// A .glb file taken apart by the words of the specification.
struct Glb {
  Json json;
  std::string bin;
};

uint32_t WordAt(const std::string& bytes, size_t at) {
  uint32_t word = 0;
  EXPECT_LE(at + 4, bytes.size());
  std::memcpy(&word, bytes.data() + at, 4);
  return word;
}

Glb Parse(const std::string& bytes) {
  Glb glb;
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(WordAt(bytes, 4), 2u);
  EXPECT_EQ(WordAt(bytes, 8), bytes.size());
  const uint32_t json_size = WordAt(bytes, 12);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  EXPECT_EQ(json_size % 4, 0u);
  glb.json = Json::parse(bytes.substr(20, json_size));
  const size_t at = 20 + json_size;
  if (at == bytes.size()) return glb;
  EXPECT_EQ(bytes.substr(at + 4, 4), std::string("BIN\0", 4));
  EXPECT_EQ(WordAt(bytes, at) % 4, 0u);
  glb.bin = bytes.substr(at + 8);
  EXPECT_EQ(WordAt(bytes, at), glb.bin.size());
  return glb;
}

GlbOptions LinksAsObjects() {
  GlbOptions options;
  options.objects = GlbObjects::kLink;
  return options;
}

Glb WrittenGlb(const DrawingGraph& graph, const GlbOptions& options = LinksAsObjects()) {
  std::ostringstream out;
  WriteDrawingGlb(graph, options, LengthUnit::kNone, out);
  return Parse(out.str());
}

const Json& NodeNamed(const Glb& glb, const std::string& name) {
  for (const Json& node : glb.json["nodes"]) {
    if (node["name"] == name) return node;
  }
  throw std::runtime_error("no node " + name);
}

const Json& PrimitiveOf(const Glb& glb, const std::string& name) {
  return glb.json["meshes"][NodeNamed(glb, name)["mesh"].get<int>()]["primitives"][0];
}

const char* Element(const Glb& glb, const Json& accessor, size_t index, size_t size) {
  const Json& view = glb.json["bufferViews"][accessor["bufferView"].get<int>()];
  const size_t offset = accessor.value("byteOffset", size_t{0});
  EXPECT_LE(offset + (index + 1) * size, view["byteLength"].get<size_t>());
  return glb.bin.data() + view.value("byteOffset", size_t{0}) + offset + index * size;
}

// The points of a node in the world of the drawing, z up.
std::vector<Eigen::Vector3d> PointsOf(const Glb& glb, const std::string& name) {
  const Json& accessor =
      glb.json["accessors"][PrimitiveOf(glb, name)["attributes"]["POSITION"].get<int>()];
  EXPECT_EQ(accessor["componentType"], 5126);
  EXPECT_EQ(accessor["type"], "VEC3");
  const Json& shift = glb.json["nodes"][0]["translation"];
  std::vector<Eigen::Vector3d> points;
  for (size_t i = 0; i < accessor["count"].get<size_t>(); ++i) {
    float xyz[3];
    std::memcpy(xyz, Element(glb, accessor, i, sizeof(xyz)), sizeof(xyz));
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(xyz[axis], accessor["min"][axis].get<float>());
      EXPECT_LE(xyz[axis], accessor["max"][axis].get<float>());
    }
    points.emplace_back(xyz[0] + shift[0].get<double>(), -(xyz[2] + shift[2].get<double>()),
                        xyz[1] + shift[1].get<double>());
  }
  return points;
}

TEST(WriteDrawingGlb, EveryLinkIsAStripOfItsOwn) {
  const DrawingGraph graph = SmallDrawing();
  const Glb glb = WrittenGlb(graph);
  EXPECT_EQ(glb.json["asset"]["version"], "2.0");
  EXPECT_EQ(glb.json["nodes"][0]["children"].size(), graph.links.size() + 1);
  for (size_t id = 0; id < graph.links.size(); ++id) {
    SCOPED_TRACE(id);
    const std::string name = "link_" + std::to_string(id);
    EXPECT_EQ(PrimitiveOf(glb, name)["mode"], 3);
    EXPECT_EQ(NodeNamed(glb, name)["extras"]["link"], id);
    EXPECT_EQ(NodeNamed(glb, name)["extras"]["views"], 2);
    std::vector<Eigen::Vector3d> expected = graph.links[id].points_in_world;
    if (graph.links[id].closed) expected.pop_back();
    const std::vector<Eigen::Vector3d> points = PointsOf(glb, name);
    ASSERT_EQ(points.size(), expected.size());
    for (size_t i = 0; i < points.size(); ++i) {
      EXPECT_LT((points[i] - expected[i]).norm(), 1e-6);
    }
  }
}

std::vector<uint32_t> IndicesOf(const Glb& glb, const std::string& name) {
  const Json& accessor = glb.json["accessors"][PrimitiveOf(glb, name)["indices"].get<int>()];
  EXPECT_EQ(accessor["componentType"], 5125);
  std::vector<uint32_t> indices(accessor["count"].get<size_t>());
  for (size_t i = 0; i < indices.size(); ++i) {
    std::memcpy(&indices[i], Element(glb, accessor, i, 4), 4);
  }
  return indices;
}

// What the segments of an object say: per link their lengths in total.
std::map<int, double> LengthsByLink(const Glb& glb, const std::string& name) {
  const Json& accessor =
      glb.json["accessors"][PrimitiveOf(glb, name)["attributes"]["_LINK"].get<int>()];
  EXPECT_EQ(accessor["type"], "SCALAR");
  const std::vector<Eigen::Vector3d> points = PointsOf(glb, name);
  const std::vector<uint32_t> indices = IndicesOf(glb, name);
  EXPECT_EQ(accessor["count"], points.size());
  std::map<int, double> lengths;
  for (size_t i = 0; i + 1 < indices.size(); i += 2) {
    float ids[2];
    for (int end = 0; end < 2; ++end) {
      std::memcpy(&ids[end], Element(glb, accessor, indices[i + end], 4), 4);
    }
    EXPECT_EQ(ids[0], ids[1]);
    lengths[static_cast<int>(ids[0])] += (points[indices[i + 1]] - points[indices[i]]).norm();
  }
  return lengths;
}

TEST(WriteDrawingGlb, EveryKindIsAnObject) {
  DrawingGraph graph = SmallDrawing();
  ASSERT_GE(graph.links.size(), 4u);
  for (DrawingLink& link : graph.links) link.kind = LinkKind::kPaint;
  graph.links[1].kind = LinkKind::kEdge;
  graph.links[2].tentative = true;
  const Glb glb = WrittenGlb(graph, {});
  std::map<int, double> lengths;
  for (const char* name : {"paint", "edge", "tentative"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(PrimitiveOf(glb, name)["mode"], 1);
    const std::map<int, double> of_kind = LengthsByLink(glb, name);
    EXPECT_EQ(NodeNamed(glb, name)["extras"]["links"], of_kind.size());
    lengths.insert(of_kind.begin(), of_kind.end());
  }
  EXPECT_EQ(LengthsByLink(glb, "edge").count(1), 1u);
  EXPECT_EQ(LengthsByLink(glb, "tentative").count(2), 1u);
  EXPECT_EQ(glb.json["nodes"].size(), 5u);  // and the drawing and its junctions
  ASSERT_EQ(lengths.size(), graph.links.size());
  for (const auto& [id, length] : lengths) {
    EXPECT_NEAR(length, Length(graph.links[id].points_in_world), 1e-5) << id;
  }
}

TEST(WriteDrawingGlb, AClosedLinkReturnsToItsFirstVertex) {
  const Glb glb = WrittenGlb(SmallDrawing());
  EXPECT_FALSE(PrimitiveOf(glb, "link_0").contains("indices"));
  EXPECT_THAT(IndicesOf(glb, "link_3"), ::testing::ElementsAre(0, 1, 2, 3, 0));
}

TEST(WriteDrawingGlb, JunctionsAndCloudArePoints) {
  GlbOptions options;
  options.cloud = {{{1, 2, 3}, {255, 0, 188}}, {{4, 5, 6}, {0, 0, 0}}};
  const Glb glb = WrittenGlb(SmallDrawing(), options);
  EXPECT_EQ(PrimitiveOf(glb, "junctions")["mode"], 0);
  EXPECT_EQ(NodeNamed(glb, "junctions")["extras"]["nodes"], Json::array({0}));
  EXPECT_THAT(PointsOf(glb, "junctions"), ::testing::SizeIs(1));
  EXPECT_EQ(PrimitiveOf(glb, "cloud")["mode"], 0);
  const std::vector<Eigen::Vector3d> points = PointsOf(glb, "cloud");
  ASSERT_EQ(points.size(), 2u);
  EXPECT_LT((points[1] - Eigen::Vector3d(4, 5, 6)).norm(), 1e-6);
  const Json& accessor =
      glb.json["accessors"][PrimitiveOf(glb, "cloud")["attributes"]["COLOR_0"].get<int>()];
  EXPECT_EQ(accessor["normalized"], true);
  uint16_t rgba[4];
  std::memcpy(rgba, Element(glb, accessor, 0, sizeof(rgba)), sizeof(rgba));
  EXPECT_EQ(rgba[0], 65535);
  EXPECT_EQ(rgba[1], 0);
  EXPECT_NEAR(rgba[2] / 65535.0, 0.5, 0.005);  // sRGB 188 is half the light
  EXPECT_EQ(rgba[3], 65535);

  options = {};
  options.junctions = false;
  EXPECT_THROW(NodeNamed(WrittenGlb(SmallDrawing(), options), "junctions"), std::runtime_error);
}

TEST(WriteDrawingGlb, FarFromTheOriginPlacesKeepTheirDigits) {
  DrawingGraph graph = SmallDrawing();
  const Eigen::Vector3d shift(4'500'000.125, -651'234.375, 120);
  for (DrawingNode& node : graph.nodes) node.position_in_world += shift;
  for (DrawingLink& link : graph.links) {
    for (Eigen::Vector3d& point : link.points_in_world) point += shift;
  }
  const std::vector<Eigen::Vector3d> points = PointsOf(WrittenGlb(graph), "link_1");
  ASSERT_EQ(points.size(), graph.links[1].points_in_world.size());
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_LT((points[i] - graph.links[1].points_in_world[i]).norm(), 1e-6);
  }
}

TEST(WriteDrawingGlb, TellsPrimitiveAndClass) {
  DrawingGraph graph = SmallDrawing();
  graph.links[0].primitive = LinkPrimitive{LineSegment{{0, 0, 0}, {1, 0, 0}}, 0.25, 0.5};
  graph.links[0].dense = LinkDense{.dense_class = DenseClass::kBoundary};
  const Glb glb = WrittenGlb(graph);
  EXPECT_EQ(NodeNamed(glb, "link_0")["extras"]["primitive"], "line");
  EXPECT_EQ(NodeNamed(glb, "link_0")["extras"]["class"], "boundary");
  EXPECT_FALSE(NodeNamed(glb, "link_1")["extras"].contains("primitive"));
}

TEST(WriteDrawingGlb, TellsTheKindOfEdge) {
  DrawingGraph graph = SmallDrawing();
  graph.links[0].kind = LinkKind::kContour;
  graph.links[0].kind_confidence = 0.75;
  graph.links[1].tentative = true;
  const Glb glb = WrittenGlb(graph);
  EXPECT_EQ(NodeNamed(glb, "link_0")["extras"]["kind"], "contour");
  EXPECT_EQ(NodeNamed(glb, "link_0")["extras"]["kind_confidence"], 0.75);
  EXPECT_FALSE(NodeNamed(glb, "link_0")["extras"].contains("tentative"));
  EXPECT_FALSE(NodeNamed(glb, "link_1")["extras"].contains("kind"));
  EXPECT_EQ(NodeNamed(glb, "link_1")["extras"]["tentative"], true);
}

TEST(WriteDrawingGlb, TellsTheRadiiOfRods) {
  DrawingGraph graph = SmallDrawing();
  graph.links[0].kind = LinkKind::kRod;
  graph.links[0].rod_radius = 0.375;
  const Glb glb = WrittenGlb(graph);
  EXPECT_EQ(NodeNamed(glb, "link_0")["extras"]["kind"], "rod");
  EXPECT_EQ(NodeNamed(glb, "link_0")["extras"]["rod_radius"], 0.375);
  EXPECT_EQ(PrimitiveOf(glb, "link_0")["mode"], 3);
  EXPECT_FALSE(NodeNamed(glb, "link_1")["extras"].contains("rod_radius"));
}

std::vector<float> FloatsOf(const Glb& glb, const Json& accessor) {
  std::vector<float> floats(3 * accessor["count"].get<size_t>());
  for (size_t i = 0; i < floats.size() / 3; ++i) {
    std::memcpy(floats.data() + 3 * i, Element(glb, accessor, i, 12), 12);
  }
  return floats;
}

TEST(WriteDrawingGlb, FacesAreTrianglesWithNormals) {
  const DrawingGraph graph = testing::HalfCylinderSide();
  const DrawingFace& face = graph.faces[0];
  GlbOptions options = LinksAsObjects();
  options.cloud = {{{1, 2, 3}, {255, 0, 188}}};
  const Glb glb = WrittenGlb(graph, options);
  const Json primitive = PrimitiveOf(glb, "face_0");
  EXPECT_EQ(primitive["mode"].get<int>(), 4);
  EXPECT_EQ(glb.json["materials"][primitive["material"].get<int>()]["name"], "faces");
  EXPECT_EQ(glb.json["materials"][PrimitiveOf(glb, "link_0")["material"].get<int>()]["name"],
            "curves and points");
  EXPECT_EQ(NodeNamed(glb, "face_0")["extras"]["surface"], "ruled");
  EXPECT_NEAR(NodeNamed(glb, "face_0")["extras"]["area"].get<double>(), 2 * M_PI, 0.01);
  const std::vector<Eigen::Vector3d> points = PointsOf(glb, "face_0");
  ASSERT_EQ(points.size(), face.vertices.size());
  const std::vector<float> normals =
      FloatsOf(glb, glb.json["accessors"][primitive["attributes"]["NORMAL"].get<int>()]);
  for (size_t v = 0; v < points.size(); ++v) {
    EXPECT_LT((points[v] - face.vertices[v]).norm(), 1e-6);
    // Outwards: (x, y, 0), with y up.
    EXPECT_NEAR(normals[3 * v], points[v].x(), 0.03);
    EXPECT_NEAR(normals[3 * v + 1], 0, 1e-6);
    EXPECT_NEAR(normals[3 * v + 2], -points[v].y(), 0.03);
  }
  const Json& accessor = glb.json["accessors"][primitive["indices"].get<int>()];
  ASSERT_EQ(accessor["count"].get<size_t>(), 3 * face.triangles.size());
  for (size_t i = 0; i < 3 * face.triangles.size(); ++i) {
    uint32_t index = 0;
    std::memcpy(&index, Element(glb, accessor, i, 4), 4);
    EXPECT_EQ(static_cast<int>(index), face.triangles[i / 3][i % 3]);
  }
  EXPECT_EQ(PointsOf(glb, "cloud").size(), 1u);
}

TEST(WriteDrawingGlb, RodsCanBeTubes) {
  DrawingGraph graph = testing::HalfCylinderSide();
  graph.links[0].kind = LinkKind::kRod;
  graph.links[0].rod_radius = 0.125;
  GlbOptions options = LinksAsObjects();
  options.rods_as_tubes = true;
  options.cloud = {{{1, 2, 3}, {255, 0, 188}}};
  const Glb glb = WrittenGlb(graph, options);
  const Json primitive = PrimitiveOf(glb, "link_0");
  EXPECT_EQ(primitive["mode"], 4);
  EXPECT_EQ(NodeNamed(glb, "link_0")["extras"]["rod_radius"], 0.125);
  EXPECT_EQ(glb.json["materials"][primitive["material"].get<int>()]["name"], "rods");
  EXPECT_EQ(glb.json["materials"][PrimitiveOf(glb, "face_0")["material"].get<int>()]["name"],
            "faces");
  EXPECT_EQ(PrimitiveOf(glb, "link_1")["mode"], 3);
  const TubeMesh tube = MakeTube(graph.links[0].points_in_world, false, 0.125);
  const std::vector<Eigen::Vector3d> points = PointsOf(glb, "link_0");
  ASSERT_EQ(points.size(), tube.vertices.size());
  const std::vector<float> normals =
      FloatsOf(glb, glb.json["accessors"][primitive["attributes"]["NORMAL"].get<int>()]);
  for (size_t v = 0; v < points.size(); ++v) {
    EXPECT_LT((points[v] - tube.vertices[v]).norm(), 1e-6);
    EXPECT_NEAR(normals[3 * v], tube.normals[v].x(), 1e-6);
    EXPECT_NEAR(normals[3 * v + 1], tube.normals[v].z(), 1e-6);
  }
  const Json& accessor = glb.json["accessors"][primitive["indices"].get<int>()];
  ASSERT_EQ(accessor["count"].get<size_t>(), 3 * tube.triangles.size());
  // What comes after it is where it was.
  const std::vector<Eigen::Vector3d> of_face = PointsOf(glb, "face_0");
  ASSERT_EQ(of_face.size(), graph.faces[0].vertices.size());
  EXPECT_LT((of_face.back() - graph.faces[0].vertices.back()).norm(), 1e-6);
  EXPECT_LT((PointsOf(glb, "cloud")[0] - Eigen::Vector3d(1, 2, 3)).norm(), 1e-6);
}

TEST(WriteDrawingGlb, RefusesCoordinatesBeyondFloat) {
  GlbOptions options;
  options.cloud = {{{1e40, 0, 0}, {}}};
  std::ostringstream out;
  EXPECT_THROW(WriteDrawingGlb(SmallDrawing(), options, LengthUnit::kNone, out), InputError);
}

TEST(WriteDrawingGlb, AnEmptyDrawingIsAFileToo) {
  const Glb glb = WrittenGlb({});
  EXPECT_EQ(glb.json["nodes"].size(), 1u);
  EXPECT_FALSE(glb.json.contains("buffers"));
}

}  // namespace
}  // namespace limn
