// SPDX-License-Identifier: BSD-3-Clause
// DXF files, read and audited by ezdxf.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "end_to_end/exported_drawing.h"
#include "limn/formats/primitive_drawing.h"
#include "limn/geometry/polyline.h"
#include "limn/model/drawing_transform.h"
#include "support/face_drawing.h"

namespace limn::testing {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::Pair;

void ExpectSoundFile(const json& read) {
  EXPECT_EQ(read.at("version"), "AC1015");
  EXPECT_EQ(read.at("errors"), json::array());
  EXPECT_EQ(read.at("fixes"), json::array());
  std::set<int> handles;
  EXPECT_EQ(read.at("plot_styles"), json::array({read.at("default_plot_style")}));
  for (const int handle : read.at("handles")) {
    EXPECT_TRUE(handles.insert(handle).second) << "handle " << handle << " is not unique";
    EXPECT_LT(handle, read.at("seed").get<int>());
  }
}

std::string EntityType(const DrawingLink& link) {
  static const std::map<std::string, std::string> types = {
      {"line", "LINE"}, {"arc", "ARC"}, {"circle", "CIRCLE"}, {"spline", "SPLINE"}};
  return link.primitive ? types.at(ShapeName(link.primitive->shape)) : "POLYLINE";
}

// The entities of links by link id.
std::map<int, json> LinkEntities(const json& read) {
  std::map<int, json> entities;
  for (const json& entity : read.at("entities")) {
    if (entity.at("type") == "POINT" || entity.at("type") == "FACE") continue;
    EXPECT_TRUE(entities.emplace(entity.at("id"), entity).second);
    EXPECT_EQ(entity.at("owner"), read.at("entities")[0].at("owner"));
  }
  return entities;
}

// ezdxf's points lie on the link's curve, in its order from end to end.
void ExpectSameCurve(const json& entity, const DrawingLink& link, double size) {
  const Polyline3d curve = link.primitive ? SampleShape(link.primitive->shape, 1e-8 * size)
                                          : Polyline3d(link.points_in_world);
  const json& samples = entity.at("samples");
  const bool circle = entity.at("type") == "CIRCLE";  // has no start
  if (!circle) {
    EXPECT_LT((ToPoint(samples.front()) - curve.front()).norm(), 1e-12 * size);
    EXPECT_LT((ToPoint(samples.back()) - curve.back()).norm(), 1e-12 * size);
  }
  const std::vector<double> arc_length = CumulativeLength(curve);
  double previous = -1;
  for (size_t i = 0; i < samples.size(); ++i) {
    const PolylinePoint closest = ClosestPoint(curve, ToPoint(samples[i]));
    EXPECT_LT(std::sqrt(closest.squared_distance), 2e-8 * size);
    const double place =
        arc_length[closest.segment] +
        closest.t * (arc_length[closest.segment + 1] - arc_length[closest.segment]);
    const bool may_be_either_end = circle || i == 0 || i + 1 == samples.size();
    if (!may_be_either_end) {
      EXPECT_GT(place, previous);
      previous = place;
    }
  }
  EXPECT_NEAR(entity.at("length").get<double>() / ShapeLength(link), 1, 1e-7);
}

void ExpectSameDrawing(const json& read, const DrawingGraph& graph, double size) {
  ExpectSoundFile(read);
  const std::map<int, json> entities = LinkEntities(read);
  ASSERT_EQ(entities.size(), graph.links.size());
  for (const auto& [id, entity] : entities) {
    SCOPED_TRACE("link " + std::to_string(id));
    const DrawingLink& link = graph.links.at(id);
    ASSERT_EQ(entity.at("type"), EntityType(link));
    ExpectSameCurve(entity, link, size);
  }
}

TEST(DrawingExporterDxf, EveryLinkIsOneEntityWithItsShape) {
  const DrawingGraph graph = PrimitiveDrawing();
  const ExportedDrawing exported(graph);
  exported.Export("d.dxf");
  const json read = exported.Read("read_dxf.py", "d.dxf");
  ExpectSameDrawing(read, graph, 60);
  EXPECT_EQ(read.at("unit"), 0);
  const std::map<int, json> entities = LinkEntities(read);
  for (const int id : {1, 5, 7, 10, 11}) {
    const auto& arc = std::get<CircularArc>(graph.links[id].primitive->shape);
    EXPECT_EQ(entities.at(id).at("radius"), arc.radius);
    EXPECT_LT((ToPoint(entities.at(id).at("center")) - arc.center).norm(), 1e-12);
  }
  for (const int id : {2, 9}) {
    const auto& spline = std::get<CubicBSpline>(graph.links[id].primitive->shape);
    EXPECT_EQ(entities.at(id).at("degree"), 3);
    EXPECT_EQ(entities.at(id).at("knots"), json(spline.knots));
    ASSERT_EQ(entities.at(id).at("control_points").size(), spline.control_points.size());
    for (size_t i = 0; i < spline.control_points.size(); ++i) {
      EXPECT_EQ(ToPoint(entities.at(id).at("control_points")[i]), spline.control_points[i]);
    }
  }
  for (const int id : {4, 6, 8}) {
    EXPECT_TRUE(entities.at(id).at("is_3d"));
    EXPECT_EQ(entities.at(id).at("closed"), graph.links[id].closed);
    EXPECT_EQ(entities.at(id).at("points").size(),
              graph.links[id].points_in_world.size() - (graph.links[id].closed ? 1 : 0));
  }
}

TEST(DrawingExporterDxf, CurvesMayBeThePolylinesOfTheirPoints) {
  DrawingGraph graph = PrimitiveDrawing();
  const ExportedDrawing exported(graph);
  exported.Export("d.dxf", {"--segments", "1"});
  for (DrawingLink& link : graph.links) {
    const bool is_line =
        link.primitive && std::holds_alternative<LineSegment>(link.primitive->shape);
    if (!is_line) link.primitive.reset();
  }
  ExpectSameDrawing(exported.Read("read_dxf.py", "d.dxf"), graph, 60);
}

TEST(DrawingExporterDxf, ScaledAndTurnedArcsToo) {
  const ExportedDrawing exported(PrimitiveDrawing());
  for (const auto& [name, axis] :
       {std::pair("-y", SignedAxis::kMinusY), std::pair("x", SignedAxis::kX),
        std::pair("-z", SignedAxis::kMinusZ)}) {
    SCOPED_TRACE(name);
    exported.Export("d.dxf", {"--scale", "1000", "--up_axis", name, "--unit", "mm"});
    const json read = exported.Read("read_dxf.py", "d.dxf");
    ExpectSameDrawing(
        read, Transformed(PrimitiveDrawing(), 1000, ZUpFrom(axis), Eigen::Vector3d::Zero()), 60000);
    EXPECT_EQ(read.at("unit"), 4);
  }
}

TEST(DrawingExporterDxf, RodsHaveTheirRadius) {
  DrawingGraph graph = PrimitiveDrawing();
  for (const int id : {0, 1, 2, 4}) {
    graph.links[id].kind = LinkKind::kRod;
    graph.links[id].rod_radius = 0.125 * (id + 1);
  }
  const ExportedDrawing exported(graph);
  exported.Export("d.dxf", {"--scale", "1000", "--layers", "kind"});
  const json read = exported.Read("read_dxf.py", "d.dxf");
  ExpectSoundFile(read);
  EXPECT_TRUE(read.at("layers").contains("rod"));
  for (const auto& [id, entity] : LinkEntities(read)) {
    const double radius = graph.links[id].rod_radius;
    EXPECT_EQ(entity.at("rod_radius"), radius > 0 ? json(1000 * radius) : json());
    EXPECT_EQ(entity.at("layer"), radius > 0 ? "rod" : "unknown");
  }
}

std::map<std::string, int> CountsByLayer(const json& read) {
  std::map<std::string, int> counts;
  for (const json& entity : read.at("entities")) ++counts[entity.at("layer")];
  return counts;
}

TEST(DrawingExporterDxf, LayersByClass) {
  const ExportedDrawing exported(PrimitiveDrawing());
  exported.Export("d.dxf", {"--layers", "class"});
  const json read = exported.Read("read_dxf.py", "d.dxf");
  EXPECT_THAT(CountsByLayer(read),
              ElementsAre(Pair("arc", 4), Pair("circle", 1), Pair("junctions", 1), Pair("line", 1),
                          Pair("line_boundary", 1), Pair("polyline", 2),
                          Pair("polyline_surface", 1), Pair("spline", 2)));
  std::set<int> colors;
  for (const auto& [layer, count] : CountsByLayer(read)) {
    colors.insert(read.at("layers").at(layer).get<int>());
  }
  EXPECT_EQ(colors.size(), 8u);
}

TEST(DrawingExporterDxf, LayersByComponentAndNone) {
  const ExportedDrawing exported(PrimitiveDrawing());
  exported.Export("d.dxf", {"--layers", "component", "--junctions", "0"});
  const json read = exported.Read("read_dxf.py", "d.dxf");
  std::map<int, std::string> layers;
  for (const auto& [id, entity] : LinkEntities(read)) layers[id] = entity.at("layer");
  const std::set<std::string> names = [&] {
    std::set<std::string> all;
    for (const auto& [id, layer] : layers) all.insert(layer);
    return all;
  }();
  EXPECT_THAT(names, ElementsAre("component_1", "component_2", "component_3", "component_4",
                                 "component_5", "component_6", "component_7"));
  for (const int id : {1, 2, 3, 4}) EXPECT_EQ(layers.at(id), layers.at(0));
  EXPECT_EQ(layers.at(5), layers.at(6));
  EXPECT_EQ(layers.at(7), "component_1");  // the longest
  EXPECT_EQ(CountsByLayer(read).count("junctions"), 0u);

  exported.Export("s.dxf", {"--layers", "single"});
  EXPECT_THAT(CountsByLayer(exported.Read("read_dxf.py", "s.dxf")),
              ElementsAre(Pair("drawing", 12), Pair("junctions", 1)));
}

TEST(DrawingExporterDxf, LayersByKindHaveLineTypesAndWeights) {
  DrawingGraph graph = PrimitiveDrawing();
  graph.links[0].kind = LinkKind::kEdge;
  graph.links[1].kind = LinkKind::kPaint;
  graph.links[2].kind = LinkKind::kShadow;
  graph.links[3].kind = LinkKind::kRod;
  graph.links[3].rod_radius = 0.1;
  const ExportedDrawing exported(graph);
  exported.Export("d.dxf");
  const json read = exported.Read("read_dxf.py", "d.dxf");
  ExpectSoundFile(read);
  EXPECT_EQ(read.at("line_types").at("edge"), "Continuous");
  EXPECT_EQ(read.at("line_types").at("shadow"), "DOT");
  EXPECT_EQ(read.at("line_types").at("rod"), "CENTER");
  const json& weights = read.at("line_weights");
  EXPECT_EQ(weights.at("edge"), 35);
  EXPECT_LT(weights.at("paint"), weights.at("edge"));
  EXPECT_EQ(read.at("sheet"), json());
}

// As in the page and drawing.json, although others are left out.
TEST(DrawingExporterDxf, LinksAndNodesKeepTheirNumbers) {
  DrawingGraph graph = PrimitiveDrawing();
  graph.links[0].tentative = true;
  const ExportedDrawing exported(graph);
  exported.Export("d.dxf");
  const json read = exported.Read("read_dxf.py", "d.dxf");
  for (const json& entity : read.at("entities")) {
    if (entity.at("type") != "POINT") continue;
    EXPECT_EQ(ToPoint(entity.at("location")),
              graph.nodes.at(entity.at("id").get<int>()).position_in_world);
  }
  const std::map<int, json> entities = LinkEntities(read);
  ASSERT_EQ(entities.size(), graph.links.size() - 1);
  EXPECT_FALSE(entities.contains(0));
  EXPECT_EQ(entities.at(11).at("radius"),
            std::get<CircularArc>(graph.links[11].primitive->shape).radius);
}

TEST(DrawingExporterDxf, JunctionsArePoints) {
  const DrawingGraph graph = PrimitiveDrawing();
  const ExportedDrawing exported(graph);
  exported.Export("d.dxf");
  const json read = exported.Read("read_dxf.py", "d.dxf");
  int num_points = 0;
  for (const json& entity : read.at("entities")) {
    if (entity.at("type") != "POINT") continue;
    ++num_points;
    EXPECT_EQ(entity.at("layer"), "junctions");
    const DrawingNode& node = graph.nodes.at(entity.at("id").get<int>());
    EXPECT_EQ(node.kind, NodeKind::kJunction);
    EXPECT_EQ(ToPoint(entity.at("location")), node.position_in_world);
  }
  EXPECT_EQ(num_points, 1);
}

TEST(DrawingExporterDxf, ExtentHoldsAllAndNoMore) {
  const DrawingGraph graph = PrimitiveDrawing();
  Eigen::AlignedBox3d box;
  for (const DrawingLink& link : graph.links) {
    for (const Eigen::Vector3d& point : link.points_in_world) box.extend(point);
  }
  const ExportedDrawing exported(graph);
  exported.Export("d.dxf");
  const json extent = exported.Read("read_dxf.py", "d.dxf").at("extent");
  EXPECT_LT((ToPoint(extent[0]) - box.min()).norm(), 1e-3);
  EXPECT_LT((ToPoint(extent[1]) - box.max()).norm(), 1e-3);
}

TEST(DrawingExporterDxf, FacesAreMeshesWhoseBordersAreVisible) {
  for (const DrawingGraph& graph : {UnitCube(), HalfCylinderSide()}) {
    const ExportedDrawing exported(graph);
    exported.Export("d.dxf");
    const json read = exported.Read("read_dxf.py", "d.dxf");
    ExpectSameDrawing(read, graph, 3);
    size_t num_faces = 0;
    for (const json& entity : read.at("entities")) {
      if (entity.at("type") != "FACE") continue;
      EXPECT_EQ(entity.at("layer"), "faces");
      ASSERT_EQ(entity.at("id"), num_faces);
      const DrawingFace& face = graph.faces.at(num_faces++);
      const json& triangles = entity.at("triangles");
      ASSERT_EQ(triangles.size(), face.triangles.size());
      double border = 0, expected = 0;
      for (size_t t = 0; t < triangles.size(); ++t) {
        for (int c = 0; c < 3; ++c) {
          const json& corners = triangles[t].at("corners");
          const Eigen::Vector3d from = ToPoint(corners[c]), to = ToPoint(corners[(c + 1) % 3]);
          EXPECT_EQ(from, face.vertices[face.triangles[t][c]]);
          if (triangles[t].at("visible")[c]) border += (to - from).norm();
        }
      }
      for (const FaceLoop& loop : face.loops) {
        for (const FaceEdge& edge : loop) {
          expected += edge.IsBridge() ? Length(edge.bridge)
                                      : Length(graph.links[edge.link].points_in_world);
        }
      }
      // Curved borders are resampled for the mesh.
      EXPECT_NEAR(border, expected, 0.01);
    }
    EXPECT_EQ(num_faces, graph.faces.size());
  }
}

TEST(DrawingExporterDxf, LayersByFace) {
  DrawingGraph graph = Cylinder();
  const DrawingGraph far = Transformed(UnitCube(), 1, Eigen::Matrix3d::Identity(), {9, 0, 0});
  const int num_nodes = static_cast<int>(graph.nodes.size());
  for (DrawingLink link : far.links) {
    link.node0 += num_nodes;
    link.node1 += num_nodes;
    graph.links.push_back(link);
  }
  graph.nodes.insert(graph.nodes.end(), far.nodes.begin(), far.nodes.end());
  RebuildIncidence(&graph);
  const ExportedDrawing exported(graph);
  exported.Export("d.dxf", {"--layers", "face", "--junctions", "0"});
  const json read = exported.Read("read_dxf.py", "d.dxf");
  ExpectSoundFile(read);
  // Both circles are with the side, the largest of their faces.
  EXPECT_THAT(CountsByLayer(read), ElementsAre(Pair("face_0", 1), Pair("face_1", 1),
                                               Pair("face_2", 3), Pair("no_face", 12)));
}

// A cube with two dimensions; in the world 2 m to the side, standing on z = 1.
DrawingGraph MeasuredCube() {
  DrawingGraph graph = UnitCube();
  graph.dimensions = {{{0, 0, 0}, {1, 0, 0}, {0, -0.2, 0}}, {{0, 0, 0}, {0, 0, 1}, {-0.2, 0, 0}}};
  return graph;
}

std::vector<json> EntitiesOn(const json& read, const std::string& layer) {
  std::vector<json> found;
  for (const json& entity : read.at("entities")) {
    if (entity.at("layer") == layer) found.push_back(entity);
  }
  return found;
}

TEST(DrawingExporterDxf, DimensionsAreDimensions) {
  const DrawingGraph graph = MeasuredCube();
  const ExportedDrawing exported(graph);
  exported.Export("d.dxf", {"--scale", "1000", "--unit", "mm"});
  const json read = exported.Read("read_dxf.py", "d.dxf");
  ExpectSoundFile(read);
  const std::vector<json> dimensions = EntitiesOn(read, "dimensions");
  ASSERT_EQ(dimensions.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(dimensions[i].at("type"), "DIMENSION");
    EXPECT_EQ(dimensions[i].at("id"), i);
    EXPECT_EQ(dimensions[i].at("text"), "1000 mm");
    EXPECT_NEAR(dimensions[i].at("measured").get<double>(), 1000, 1e-9);
    EXPECT_EQ(dimensions[i].at("texts"), json({"1000 mm"}));
    EXPECT_EQ(dimensions[i].at("picture").size(), 6u);
    const DrawingDimension& dimension = graph.dimensions[i];
    EXPECT_LT((ToPoint(dimensions[i].at("places")[0]) - 1000 * dimension.from).norm(), 1e-9);
    EXPECT_LT((ToPoint(dimensions[i].at("places")[1]) - 1000 * dimension.to).norm(), 1e-9);
    EXPECT_LT(
        (ToPoint(dimensions[i].at("places")[2]) - 1000 * (dimension.to + dimension.shift)).norm(),
        1e-9);
  }
}

double LengthOn(const json& read, const std::string& layer) {
  double length = 0;
  for (const json& entity : EntitiesOn(read, layer)) length += entity.at("length").get<double>();
  return length;
}

TEST(DrawingExporterDxf, DimensionsTellTheirStandardDeviation) {
  DrawingGraph graph = MeasuredCube();
  for (DrawingNode& node : graph.nodes) {
    node.covariance = 0.002 * 0.002 * Eigen::Matrix3d::Identity();
  }
  const ExportedDrawing exported(graph);
  exported.Export("d.dxf", {"--sigmas", "1", "--scale", "1000", "--unit", "mm"});
  const json read = exported.Read("read_dxf.py", "d.dxf");
  ExpectSoundFile(read);
  for (const json& dimension : EntitiesOn(read, "dimensions")) {
    EXPECT_EQ(dimension.at("text"), "1000 \u00b1 2.8 mm");
  }
}

TEST(DrawingExporterDxf, APlanIsOnASheetToScale) {
  Alignment alignment;
  alignment.world_from_model = {2, Eigen::Matrix3d::Identity(), {0, 0, 1}};
  alignment.scale = ScaleSource::kLengths;
  const ExportedDrawing exported(MeasuredCube(), alignment);
  exported.Export("d.dxf", {"--view", "top", "--aligned", "1", "--sheet_scale", "20"});
  const json read = exported.Read("read_dxf.py", "d.dxf");
  ExpectSoundFile(read);
  const json& sheet = read.at("sheet");
  EXPECT_EQ(sheet.at("size"), json({420, 297}));
  EXPECT_EQ(sheet.at("frames"), 1);
  EXPECT_EQ(sheet.at("layers"), json({"sheet"}));
  EXPECT_TRUE(read.at("layers").contains("sheet"));
  ASSERT_EQ(sheet.at("units_per_mm").size(), 1u);
  EXPECT_NEAR(sheet.at("units_per_mm")[0].get<double>(), 0.02, 1e-12);  // 1 m is 50 mm
  const json& extent = read.at("extent");
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_NEAR(sheet.at("center")[0][axis].get<double>(),
                (extent[0][axis].get<double>() + extent[1][axis].get<double>()) / 2, 1e-9);
  }
  EXPECT_THAT(sheet.at("texts").get<std::vector<std::string>>(),
              ElementsAre(::testing::HasSubstr("top"), "1:20", "y"));
  EXPECT_NEAR(read.at("line_type_scale").get<double>(), 0.02, 1e-12);
  // Larger paper for what A3 does not hold.
  exported.Export("e.dxf", {"--view", "top", "--aligned", "1", "--sheet_scale", "2"});
  EXPECT_GT(exported.Read("read_dxf.py", "e.dxf").at("sheet").at("size")[1], 1000);
  exported.Export("f.dxf", {"--view", "top", "--aligned", "1", "--paper_space", "0"});
  const json without = exported.Read("read_dxf.py", "f.dxf");
  ExpectSoundFile(without);
  EXPECT_TRUE(without.at("sheet").is_null());
  EXPECT_FALSE(without.at("layers").contains("sheet"));
}

TEST(DrawingExporterDxf, CirclesSeenAtAnAngleAreEllipses) {
  const ExportedDrawing exported(Cylinder());
  exported.Export("d.dxf", {"--view", "axonometric", "--show_hidden", "1"});
  const json read = exported.Read("read_dxf.py", "d.dxf");
  ExpectSoundFile(read);
  const std::vector<json> ellipses = EntitiesOn(read, "unknown");
  ASSERT_EQ(ellipses.size(), 2u);
  for (const json& ellipse : ellipses) {
    EXPECT_EQ(ellipse.at("type"), "ELLIPSE");
    // Of half axes 1 and the root of a third, isometric.
    EXPECT_NEAR(ellipse.at("length").get<double>(), 5.0447, 0.001);
  }
}

TEST(DrawingExporterDxf, AViewAlongAFaceIsFlat) {
  const ExportedDrawing exported(MeasuredCube());
  exported.Export("d.dxf", {"--view", "face:2", "--up_axis", "z", "--hidden", "dashed"});
  const json read = exported.Read("read_dxf.py", "d.dxf");
  ExpectSoundFile(read);
  // The edges behind are on the outline, where nothing is hidden; those between have no length.
  EXPECT_EQ(EntitiesOn(read, "unknown").size(), 2u);
  EXPECT_EQ(EntitiesOn(read, "hidden").size(), 0u);
  for (const json& entity : EntitiesOn(read, "unknown")) {
    EXPECT_EQ(entity.at("type"), "LWPOLYLINE");
    EXPECT_TRUE(entity.at("closed"));
    EXPECT_EQ(entity.at("ids").size(), 4u);
    EXPECT_NEAR(entity.at("length").get<double>(), 4, 0.04);
    for (const json& point : entity.at("samples")) EXPECT_EQ(point[2], 0);
  }
  EXPECT_EQ(EntitiesOn(read, "dimensions").size(), 2u);
  exported.Export("a.dxf", {"--view", "axonometric", "--hidden", "dashed"});
  const json aslant = exported.Read("read_dxf.py", "a.dxf");
  EXPECT_THAT(LengthOn(aslant, "unknown"), ::testing::DoubleNear(9 * std::sqrt(2.0 / 3), 0.03));
  EXPECT_THAT(LengthOn(aslant, "hidden"), ::testing::DoubleNear(3 * std::sqrt(2.0 / 3), 0.03));
  EXPECT_EQ(aslant.at("line_types").at("hidden"), "HIDDEN");
  // Shown shorter, but measured as they are.
  const std::vector<json> dimensions = EntitiesOn(aslant, "dimensions");
  ASSERT_EQ(dimensions.size(), 2u);
  for (const json& dimension : dimensions) {
    EXPECT_NEAR(dimension.at("measured").get<double>(), 1, 1e-9);
    EXPECT_NEAR(dimension.at("remeasured").get<double>(), 1, 1e-9);
  }
  exported.Export("b.dxf", {"--view", "axonometric"});
  EXPECT_EQ(EntitiesOn(exported.Read("read_dxf.py", "b.dxf"), "hidden").size(), 0u);
}

TEST(DrawingExporterDxf, DepthsAlongAFace) {
  const ExportedDrawing exported(UnitCube());
  const auto count = [&](const std::vector<std::string>& more) {
    std::vector<std::string> options = {"--view", "face:2", "--show_hidden", "1"};
    options.insert(options.end(), more.begin(), more.end());
    exported.Export("d.dxf", options);
    return EntitiesOn(exported.Read("read_dxf.py", "d.dxf"), "unknown").size();
  };
  // Squares.
  EXPECT_EQ(count({}), 2u);
  EXPECT_EQ(count({"--depth_behind", "0.5"}), 1u);
  EXPECT_EQ(count({"--depth_before", "0"}), 2u);
}

TEST(DrawingExporterDxf, ASectionIsAClosedLine) {
  Alignment alignment;
  alignment.world_from_model = {2, Eigen::Matrix3d::Identity(), {0, 0, 1}};
  alignment.scale = ScaleSource::kLengths;
  const ExportedDrawing exported(MeasuredCube(), alignment);
  // The middle of the cube, in centimeters.
  exported.Export("d.dxf", {"--section", "2", "--scale", "100", "--unit", "cm"});
  const json read = exported.Read("read_dxf.py", "d.dxf");
  ExpectSoundFile(read);
  const std::vector<json> lines = EntitiesOn(read, "section");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].at("closed"));
  EXPECT_NEAR(lines[0].at("length").get<double>(), 800, 1e-9);
  EXPECT_EQ(EntitiesOn(read, "section_points").size(), 4u);
  EXPECT_NEAR(LengthOn(read, "unknown"), 800, 1e-9);
  ASSERT_EQ(EntitiesOn(read, "dimensions").size(), 1u);  // the other one is cut
  EXPECT_EQ(EntitiesOn(read, "dimensions")[0].at("text"), "200 cm");
  exported.Export("c.dxf", {"--section", "2", "--section_below", "0"});
  const json cut = exported.Read("read_dxf.py", "c.dxf");
  EXPECT_EQ(EntitiesOn(cut, "section").size(), 1u);
  EXPECT_EQ(EntitiesOn(cut, "unknown").size(), 0u);
}

TEST(DrawingExporterDxf, ASectionWithoutFacesIsWarnedOf) {
  Alignment alignment;
  DrawingGraph graph = UnitCube();
  const std::string warning = "WARNING: the drawing has no faces to cut";
  const ExportedDrawing with_faces(graph, alignment);
  EXPECT_THAT(with_faces.TryExport("d.dxf", {"--section", "0.5"}).out,
              ::testing::Not(::testing::HasSubstr(warning)));
  graph.faces.clear();
  const ExportedDrawing without(graph, alignment);
  EXPECT_THAT(without.TryExport("d.dxf", {"--section", "0.5"}).out, ::testing::HasSubstr(warning));
}

TEST(DrawingExporterDxf, PlansRefused) {
  const ExportedDrawing exported(HalfCylinderSide());
  const auto expect_refused = [&](const std::vector<std::string>& more, const std::string& text) {
    const LimnRun run = exported.TryExport("r.dxf", more);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err,
                ::testing::AllOf(::testing::StartsWith("ERROR: "), ::testing::HasSubstr(text)));
    EXPECT_FALSE(std::filesystem::exists(exported.Path("r.dxf")));
  };
  expect_refused({"--view", "face:0"}, "view = face:0: the face is not flat");
  expect_refused({"--view", "face:7"}, "view = face:7: the drawing has 1 faces");
  expect_refused({"--view", "face:x"}, "view = face:x");
  expect_refused({"--view", "a.png"}, "only SVG pictures show images");
  expect_refused({"--section", "1"}, "drawing_aligner");
  expect_refused({"--section", "high"}, "section = high");
  expect_refused({"--section", "1", "--view", "front"}, "section");
  expect_refused({"--view", "top", "--depth_before", "1"}, "depth_before");
  expect_refused({"--view", "face:0", "--depth_behind", "-2"}, "depth_behind");
}

TEST(DrawingExporterDxf, EmptyDrawing) {
  const ExportedDrawing exported(DrawingGraph{});
  exported.Export("d.dxf");
  const json read = exported.Read("read_dxf.py", "d.dxf");
  ExpectSoundFile(read);
  EXPECT_EQ(read.at("entities"), json::array());
}

}  // namespace
}  // namespace limn::testing
