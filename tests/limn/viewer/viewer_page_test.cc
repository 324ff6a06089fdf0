// SPDX-License-Identifier: BSD-3-Clause
#include "limn/viewer/viewer_page.h"

#include <cstdint>
#include <cstring>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <zlib.h>

#include "limn/formats/small_drawing.h"
#include "limn/util/errors.h"
#include "limn/viewer/packing.h"
#include "limn/viewer/payload.h"

namespace limn {
namespace {

ViewerScene SmallScene() {
  ViewerScene scene;
  scene.title = "small";
  scene.graph = SmallDrawing();
  scene.views.resize(2);
  scene.views[0].name = "a.jpg";
  scene.views[1].name = "\xff.jpg";  // no UTF-8
  scene.cloud = {{{0.1, 0.2, 0.3}, {1, 2, 3}}};
  return scene;
}

struct Payload {
  nlohmann::json header;
  std::string data;

  explicit Payload(const std::string& bytes) {
    uint32_t size = 0;
    std::memcpy(&size, bytes.data(), sizeof(size));
    EXPECT_EQ((sizeof(size) + size) % 8, 0u);
    header = nlohmann::json::parse(bytes.substr(sizeof(size), size));
    data = bytes.substr(sizeof(size) + size);
  }

  template <typename T>
  std::vector<T> Array(const std::string& name) const {
    const auto& entry = header["arrays"][name];
    const size_t offset = entry["offset"], length = entry["length"];
    EXPECT_EQ(offset % 8, 0u);
    std::vector<T> values(length);
    auto* to = reinterpret_cast<char*>(values.data());
    for (size_t plane = 0; plane < sizeof(T); ++plane) {
      for (size_t i = 0; i < length; ++i) {
        to[sizeof(T) * i + plane] = data.at(offset + plane * length + i);
      }
    }
    return values;
  }
};

TEST(ViewerPayload, HoldsTheGraphAroundItsCenter) {
  const ViewerScene scene = SmallScene();
  const Payload payload(EncodePayload(scene));
  const auto start = payload.Array<uint32_t>("linkStart");
  const auto points = payload.Array<float>("points");
  ASSERT_EQ(start.size(), scene.graph.links.size() + 1);
  ASSERT_EQ(points.size(), 3u * start.back());
  const auto center = payload.header["center"];
  for (size_t id = 0; id < scene.graph.links.size(); ++id) {
    const auto& link = scene.graph.links[id];
    ASSERT_EQ(start[id + 1] - start[id], link.points_in_world.size());
    for (size_t i = 0; i < link.points_in_world.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        const double told = center[axis].get<double>() + points[3 * (start[id] + i) + axis];
        EXPECT_NEAR(told, link.points_in_world[i][axis], 1e-6);
      }
    }
  }
  EXPECT_EQ(payload.Array<double>("linkLength")[0], 1.0);
  EXPECT_EQ(payload.Array<uint32_t>("linkViews").size(), 2 * scene.graph.links.size());
  EXPECT_FALSE(payload.header["arrays"].contains("denseClass"));
  EXPECT_TRUE(payload.header["report"].is_null());
}

TEST(ViewerPayload, KeepsDigitsFarFromTheOrigin) {
  ViewerScene scene = SmallScene();
  const Eigen::Vector3d far(5e6, -4e6, 1000);
  for (DrawingNode& node : scene.graph.nodes) node.position_in_world += far;
  for (DrawingLink& link : scene.graph.links) {
    for (Eigen::Vector3d& point : link.points_in_world) point += far;
  }
  const Payload payload(EncodePayload(scene));
  const auto nodes = payload.Array<float>("nodePositions");
  for (size_t n = 0; n < scene.graph.nodes.size(); ++n) {
    const double x = payload.header["center"][0].get<double>() + nodes[3 * n];
    EXPECT_NEAR(x, scene.graph.nodes[n].position_in_world.x(), 1e-6);
  }
}

TEST(ViewerPayload, TellsKinds) {
  ViewerScene scene = SmallScene();
  scene.graph.links[1].kind = LinkKind::kShadow;
  scene.graph.links[1].kind_confidence = 0.5;
  scene.graph.links[2].tentative = true;
  scene.graph.links[3].kind = LinkKind::kRod;
  scene.graph.links[3].rod_radius = 0.375;
  scene.graph.links[0].kind = LinkKind::kContour;
  scene.graph.links[0].body = {RoundShape::kSphere, {0, 0, 0}, {0, 0, 0}, 1.5, 1.5, 0.25, 0.5};
  scene.graph.links[2].curve_px = 12.5;
  scene.graph.links[2].confidence = 0.25;
  scene.detail = Detail::kCoarse;
  const Payload payload(EncodePayload(scene));
  EXPECT_EQ(payload.Array<uint8_t>("linkKind"), (std::vector<uint8_t>{4, 3, 0, 5}));
  EXPECT_EQ(payload.Array<double>("rodRadius"), (std::vector<double>{0, 0, 0, 0.375}));
  EXPECT_EQ(payload.Array<uint8_t>("bodyShape"), (std::vector<uint8_t>{3, 0, 0, 0}));
  EXPECT_EQ(payload.Array<double>("bodyRadius"), (std::vector<double>{1.5, 0, 0, 0}));
  EXPECT_EQ(payload.Array<double>("bodyRadiusSigma"), (std::vector<double>{0.25, 0, 0, 0}));
  EXPECT_EQ(payload.Array<float>("kindConfidence")[1], 0.5f);
  EXPECT_EQ(payload.Array<uint8_t>("linkTentative"), (std::vector<uint8_t>{0, 0, 1, 0}));
  EXPECT_EQ(payload.Array<float>("linkCurvePx"), (std::vector<float>{0, 0, 12.5, 0}));
  EXPECT_EQ(payload.Array<float>("linkConfidence"), (std::vector<float>{-1, -1, 0.25, -1}));
  EXPECT_EQ(payload.header["detail"], "coarse");
}

TEST(ViewerPayload, TellsPrimitives) {
  ViewerScene scene = SmallScene();
  CircularArc arc;
  arc.radius = 2.5;
  arc.sweep_rad = 1;
  scene.graph.links[0].primitive = LinkPrimitive{LineSegment{}, 0, 0};
  scene.graph.links[1].primitive = LinkPrimitive{arc, 0.5, 1};
  arc.sweep_rad = 2 * 3.14159265358979323846;
  scene.graph.links[2].primitive = LinkPrimitive{arc, 0, 0};
  scene.graph.links[3].primitive = LinkPrimitive{CubicBSpline{{}, {5, {0, 0, 0}}}, 0, 0};
  const Payload payload(EncodePayload(scene));
  EXPECT_EQ(payload.Array<uint8_t>("primitiveType"), (std::vector<uint8_t>{1, 2, 4, 3}));
  EXPECT_EQ(payload.Array<double>("primitiveRadius")[1], 2.5);
  EXPECT_EQ(payload.Array<float>("primitiveRms")[1], 0.5f);
  EXPECT_EQ(payload.Array<uint32_t>("primitiveControls")[3], 5u);
}

TEST(ViewerPayload, TellsTheWayBackToTheModel) {
  ViewerScene scene = SmallScene();
  EXPECT_EQ(Payload(EncodePayload(scene)).header["unit"], "model units");
  scene.unit = "m";
  scene.shown_from_model.scale = 2;
  scene.shown_from_model.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  scene.shown_from_model.translation = {10, 20, 30};
  const Payload payload(EncodePayload(scene));
  EXPECT_EQ(payload.header["unit"], "m");
  const auto told = payload.header["shownFromModel"];
  EXPECT_EQ(told["scale"], 2.0);
  EXPECT_EQ(told["translation"], (std::vector<double>{10, 20, 30}));
  // Row by row: (1, 2, 3) -> 2 (-2, 1, 3) + (10, 20, 30).
  EXPECT_EQ(told["rotation"], (std::vector<double>{0, -1, 0, 1, 0, 0, 0, 0, 1}));
}

TEST(ViewerPayload, HoldsFacesAndDimensions) {
  ViewerScene scene = SmallScene();
  EXPECT_TRUE(Payload(EncodePayload(scene)).Array<float>("faceVertices").empty());
  DrawingFace square, triangle;
  square.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  triangle.vertices = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  triangle.triangles = {{0, 1, 2}};
  scene.graph.faces = {square, triangle};
  scene.graph.dimensions = {{{1, 2, 3}, {4, 5, 6}, {0, 0, 0.5}}};
  const Payload payload(EncodePayload(scene));
  const auto vertices = payload.Array<float>("faceVertices");
  ASSERT_EQ(vertices.size(), 3u * 7);
  const auto center = payload.header["center"];
  EXPECT_NEAR(center[0].get<double>() + vertices[3 * 5], 1, 1e-6);
  EXPECT_EQ(payload.Array<uint32_t>("faceTriangles"),
            (std::vector<uint32_t>{0, 1, 2, 0, 2, 3, 4, 5, 6}));
  EXPECT_EQ(payload.Array<double>("faceAreas"), (std::vector<double>{4, 0.5}));
  const auto dimension = payload.Array<float>("dimensions");
  ASSERT_EQ(dimension.size(), 9u);
  for (int axis = 0; axis < 3; ++axis) {
    const double middle = center[axis].get<double>();
    EXPECT_NEAR(middle + dimension[axis], 1 + axis, 1e-6);
    EXPECT_NEAR(middle + dimension[3 + axis], 4 + axis, 1e-6);
  }
  EXPECT_EQ(dimension[8], 0.5f);  // a difference, to which no center belongs
}

TEST(ViewerPayload, RefusesWhatDoesNotFitTogether) {
  ViewerScene scene = SmallScene();
  scene.graph.links[2].supporting_views = {2};
  EXPECT_THROW(EncodePayload(scene), InputError);
  scene = SmallScene();
  scene.thumbnails.resize(1);
  EXPECT_THROW(EncodePayload(scene), InputError);
  for (const char* report : {"[]", "7"}) {
    scene = SmallScene();
    scene.report_json = report;
    EXPECT_THROW(EncodePayload(scene), InputError) << report;
  }
  scene.report_json = "{";
  EXPECT_THROW(EncodePayload(scene), IoError);
}

TEST(ViewerPacking, Base64OfTheStandard) {
  const std::vector<std::pair<std::string, std::string>> cases = {{"", ""},
                                                                  {"f", "Zg=="},
                                                                  {"fo", "Zm8="},
                                                                  {"foo", "Zm9v"},
                                                                  {"foob", "Zm9vYg=="},
                                                                  {"fooba", "Zm9vYmE="},
                                                                  {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : cases) EXPECT_EQ(Base64(bytes), text);
  EXPECT_EQ(Base64("\xff\xfe\xfd"), "//79");
}

TEST(ViewerPacking, GzipIsUnpackedByZlib) {
  std::string bytes;
  for (int i = 0; i < 1000000; ++i) bytes += static_cast<char>(int64_t{i} * i >> 7);
  for (const std::string& original : {std::string(), bytes}) {
    const std::string packed = Gzip(original);
    EXPECT_EQ(packed, Gzip(original));
    std::string unpacked(original.size() + 1, '\0');
    z_stream stream = {};
    ASSERT_EQ(inflateInit2(&stream, 15 + 16), Z_OK);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(unpacked.data());
    stream.avail_out = static_cast<uInt>(unpacked.size());
    EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
    unpacked.resize(stream.total_out);
    inflateEnd(&stream);
    EXPECT_EQ(unpacked, original);
  }
}

TEST(ViewerPage, IsTheSameForTheSameSceneAndAsksForNothing) {
  std::ostringstream first, second;
  if (!HasViewerPage()) {
    EXPECT_THROW(WriteViewerPage(SmallScene(), first), InputError);
    GTEST_SKIP() << "built without LIMN_WITH_VIEWER";
  }
  WriteViewerPage(SmallScene(), first);
  WriteViewerPage(SmallScene(), second);
  EXPECT_EQ(first.str(), second.str());
  EXPECT_EQ(first.str().find(" src=\"http"), std::string::npos);
  EXPECT_NE(first.str().find("default-src 'none'"), std::string::npos);
  EXPECT_NE(first.str().find("Permission is hereby granted, free of charge"), std::string::npos);
  EXPECT_NE(first.str().find(Base64(Gzip(EncodePayload(SmallScene())))), std::string::npos);
}

}  // namespace
}  // namespace limn
