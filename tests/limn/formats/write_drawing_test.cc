// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/write_drawing.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limn/formats/colors.h"
#include "limn/formats/json_kinds_reader.h"
#include "limn/formats/read_curves.h"
#include "limn/formats/small_drawing.h"
#include "limn/formats/temporary_folder.h"
#include "limn/model/drawing_transform.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

DrawingMetadata SmallMetadata() { return {{"a.png", "sub/b c.png"}, R"({"z":1,"a":{"b":[2.5]}})"}; }

void ExpectSamePolylines(const CurveSet& set, const DrawingGraph& graph) {
  ASSERT_EQ(set.polylines.size(), graph.links.size());
  for (size_t i = 0; i < graph.links.size(); ++i) {
    EXPECT_EQ(set.polylines[i], graph.links[i].points_in_world) << "link " << i;
  }
}

TEST(WriteDrawing, SmallDrawingIsValid) {
  EXPECT_THAT(Validate(SmallDrawing()), ::testing::IsEmpty());
}

TEST(WriteDrawing, LinksComeBackExactlyFromEveryFormat) {
  const TemporaryFolder folder;
  const DrawingGraph graph = SmallDrawing();
  for (const char* name : {"d.ply", "d.obj", "d.json"}) {
    SCOPED_TRACE(name);
    WriteDrawing(folder.Path(name), graph, SmallMetadata());
    ExpectSamePolylines(ReadCurves(folder.Path(name)), graph);
  }
}

// MeshLab shows no element of more than two vertices.
TEST(WriteDrawing, ObjOfSegmentsHasTwoVerticesPerElement) {
  const TemporaryFolder folder;
  const DrawingGraph graph = SmallDrawing();
  DrawingFormatOptions options;
  options.obj.segments = true;
  WriteDrawing(folder.Path("d.obj"), graph, SmallMetadata(), options);
  std::istringstream lines(TemporaryFolder::Read(folder.Path("d.obj")));
  size_t num_segments = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("l ")) continue;
    ++num_segments;
    EXPECT_EQ(std::count(line.begin(), line.end(), ' '), 2) << line;
  }
  EXPECT_EQ(num_segments, 2u + 3u + 1u + 4u);
  ExpectSamePolylines(ReadCurves(folder.Path("d.obj")), graph);
}

TEST(WriteDrawing, ObjWithYUpIsTurnedBackByAQuarter) {
  const TemporaryFolder folder;
  const DrawingGraph graph = SmallDrawing();
  DrawingFormatOptions options;
  options.obj.y_up = true;
  WriteDrawing(folder.Path("d.obj"), graph, SmallMetadata(), options);
  const Eigen::Matrix3d y_up_from_z_up =
      Eigen::AngleAxisd(-M_PI / 2, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const Eigen::Matrix3d exact = y_up_from_z_up.array().round();
  ExpectSamePolylines(ReadCurves(folder.Path("d.obj")),
                      Transformed(graph, 1, exact, Eigen::Vector3d::Zero()));
}

TEST(WriteDrawing, TheMainViewDirectionIsKept) {
  const TemporaryFolder folder;
  DrawingMetadata metadata = SmallMetadata();
  metadata.main_view_direction = Eigen::Vector3d(0.6, 0, -0.8);
  WriteDrawing(folder.Path("d.json"), SmallDrawing(), metadata);
  EXPECT_EQ(ReadDrawingJson(folder.Path("d.json")).metadata.main_view_direction,
            metadata.main_view_direction);
}

TEST(WriteDrawing, JsonKeepsTheWholeGraph) {
  const TemporaryFolder folder;
  const DrawingGraph graph = SmallDrawing();
  const std::string path = folder.Path("d.json");
  WriteDrawing(path, graph, SmallMetadata());
  const DrawingFile file = ReadDrawingJson(path);
  EXPECT_EQ(file.metadata.view_names, SmallMetadata().view_names);
  EXPECT_EQ(file.metadata.options_json, SmallMetadata().options_json);
  ASSERT_EQ(file.graph.nodes.size(), graph.nodes.size());
  for (size_t i = 0; i < graph.nodes.size(); ++i) {
    EXPECT_EQ(file.graph.nodes[i].position_in_world, graph.nodes[i].position_in_world);
    EXPECT_EQ(file.graph.nodes[i].kind, graph.nodes[i].kind);
    EXPECT_EQ(file.graph.nodes[i].incident, graph.nodes[i].incident);
    EXPECT_EQ(file.graph.nodes[i].continuations, graph.nodes[i].continuations);
  }
  for (size_t i = 0; i < graph.links.size(); ++i) {
    EXPECT_EQ(file.graph.links[i].sigma, graph.links[i].sigma);
    EXPECT_EQ(file.graph.links[i].supporting_views, graph.links[i].supporting_views);
    EXPECT_EQ(file.graph.links[i].residual_px, graph.links[i].residual_px);
    EXPECT_EQ(file.graph.links[i].closed, graph.links[i].closed);
    ASSERT_EQ(file.graph.links[i].members.size(), 2u);
    EXPECT_EQ(file.graph.links[i].members[1].curve, 5);
    EXPECT_EQ(file.graph.links[i].members[1].end, 4);
  }
  // Writing what was read gives the same bytes.
  WriteDrawing(folder.Path("again.json"), file.graph, file.metadata);
  EXPECT_EQ(TemporaryFolder::Read(path), TemporaryFolder::Read(folder.Path("again.json")));
}

TEST(WriteDrawing, JsonNamesTheCurves) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("d.json");
  const auto curves = [&](const DrawingGraph& graph) {
    WriteDrawing(path, graph, SmallMetadata());
    const auto json = nlohmann::json::parse(TemporaryFolder::Read(path));
    std::vector<int> names;
    for (const auto& link : json.at("links")) names.push_back(link.at("curve"));
    return names;
  };
  DrawingGraph graph = SmallDrawing();
  EXPECT_THAT(curves(graph), ::testing::ElementsAre(0, 0, 2, 3));
  graph.nodes[0].continuations.clear();
  EXPECT_THAT(curves(graph), ::testing::ElementsAre(0, 1, 2, 3));
}

TEST(WriteDrawing, JsonKeepsThePrimitives) {
  const TemporaryFolder folder;
  DrawingGraph graph = SmallDrawing();
  const std::vector<CurveShape> shapes = {
      LineSegment{{0, 0, 0}, {1, 0, 0}}, CircularArc{{0, 1, 0}, {0, 1, 0}, {1, 0, 0}, 1.0 / 3, 2},
      CubicBSpline{{0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0.1}}},
      CircularArc{{5, 6, 5}, {0, -1, 0}, {1, 0, 0}, 1, 2 * M_PI}};
  for (size_t l = 0; l < shapes.size(); ++l) {
    graph.links[l].primitive = LinkPrimitive{shapes[l], 0.25, 0.5};
  }
  const std::string path = folder.Path("d.json");
  WriteDrawing(path, graph, SmallMetadata());
  const DrawingFile file = ReadDrawingJson(path);
  for (size_t l = 0; l < shapes.size(); ++l) {
    const auto& primitive = file.graph.links[l].primitive;
    ASSERT_TRUE(primitive);
    EXPECT_STREQ(ShapeName(primitive->shape), ShapeName(shapes[l]));
    EXPECT_EQ(PointAt(primitive->shape, 0.3), PointAt(shapes[l], 0.3));
    EXPECT_EQ(primitive->max_px, 0.5);
  }
  WriteDrawing(folder.Path("again.json"), file.graph, file.metadata);
  const std::string text = TemporaryFolder::Read(path);
  EXPECT_EQ(text, TemporaryFolder::Read(folder.Path("again.json")));
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"\"spline\"", "\"bezier\""},
                                 {"\"radius\":1.0", "\"radius\":-1.0"},
                                 {"\"knots\":[0.0,", "\"knots\":["}}) {
    const size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    const std::string bad = std::string(text).replace(at, from.size(), to);
    EXPECT_THROW(ReadDrawingJson(folder.Write("bad.json", bad)), IoError) << from;
  }
}

TEST(WriteDrawing, JsonKeepsWhatIsKnownOfPlacesAndScale) {
  const TemporaryFolder folder;
  DrawingGraph graph = SmallDrawing();
  graph.nodes[0].covariance << 2, 1, 0, 1, 3, 0.5, 0, 0.5, 1.0 / 3;
  DrawingMetadata metadata = SmallMetadata();
  metadata.alignment = Alignment();
  metadata.alignment->scale = ScaleSource::kLengths;
  metadata.alignment->scale_sigma = 0.01;
  const std::string path = folder.Path("d.json");
  WriteDrawing(path, graph, metadata);
  const DrawingFile back = ReadDrawingJson(path);
  EXPECT_EQ(back.graph.nodes[0].covariance, graph.nodes[0].covariance);
  EXPECT_TRUE(back.graph.nodes[1].covariance.isZero(0));
  EXPECT_EQ(back.metadata.alignment->scale_sigma, 0.01);
  const std::string text = TemporaryFolder::Read(path);
  for (const auto& [from, to] :
       {std::pair<std::string, std::string>{"\"covariance\":[2.0,1.0,", "\"covariance\":[2.0,9.0,"},
        {"\"covariance\":[2.0,", "\"covariance\":["},
        {"\"scale_sigma\":0.01", "\"scale_sigma\":-0.01"}}) {
    const size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    const std::string bad = std::string(text).replace(at, from.size(), to);
    EXPECT_THROW(ReadDrawingJson(folder.Write("bad.json", bad)), IoError) << from;
  }
}

TEST(WriteDrawing, JsonKeepsTheDimensions) {
  const TemporaryFolder folder;
  DrawingGraph graph = SmallDrawing();
  graph.dimensions = {{{0, 0, 1.0 / 3}, {1, 0, 0}, {0, 0, 2}}, {{1, 0, 0}, {5, 5, 5}, {0, 0, 0}}};
  const std::string path = folder.Path("d.json");
  WriteDrawing(path, graph, SmallMetadata());
  const std::vector<DrawingDimension> back = ReadDrawingJson(path).graph.dimensions;
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[0].from, Eigen::Vector3d(0, 0, 1.0 / 3));
  EXPECT_EQ(back[0].to, Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(back[0].shift, Eigen::Vector3d(0, 0, 2));
  EXPECT_EQ(back[1].to, Eigen::Vector3d(5, 5, 5));
  std::string text = TemporaryFolder::Read(path);
  const std::string shift = "\"shift\":[0.0,0.0,2.0]";
  ASSERT_NE(text.find(shift), std::string::npos);
  text.replace(text.find(shift), shift.size(), "\"shift\":[0.0,0.0]");
  EXPECT_THROW(ReadDrawingJson(folder.Write("bad.json", text)), IoError);
}

TEST(WriteDrawing, JsonKeepsTheRegularities) {
  const TemporaryFolder folder;
  DrawingGraph graph = SmallDrawing();
  graph.regularities = {{{{1, 0, 0}, {1}}, {{0, 0.6, 0.8}, {0}}},
                        {{{0, 0, 1}, 1.0 / 3, -1}, {{0, 0.6, 0.8}, -2, 1}},
                        {0.125, 3},
                        {{{1, 2, 3}, {0, 1, 0}}}};
  graph.links[0].regularity = LinkRegularity{.direction = 1, .planes = {0, 1}};
  graph.links[2].regularity = LinkRegularity{.radius = 1, .axis = 0, .planes = {}};
  const std::string path = folder.Path("d.json");
  WriteDrawing(path, graph, SmallMetadata());
  const DrawingFile file = ReadDrawingJson(path);
  const Regularities& back = file.graph.regularities;
  ASSERT_EQ(back.directions.size(), 2u);
  EXPECT_EQ(back.directions[1].direction, graph.regularities.directions[1].direction);
  EXPECT_EQ(back.directions[1].orthogonal_to, std::vector<int>{0});
  ASSERT_EQ(back.planes.size(), 2u);
  EXPECT_EQ(back.planes[0].offset, 1.0 / 3);
  EXPECT_EQ(back.planes[0].normal_direction, -1);
  EXPECT_EQ(back.planes[1].normal_direction, 1);
  EXPECT_EQ(back.radii, graph.regularities.radii);
  ASSERT_EQ(back.axes.size(), 1u);
  EXPECT_EQ(back.axes[0].point, graph.regularities.axes[0].point);
  ASSERT_TRUE(file.graph.links[0].regularity && file.graph.links[2].regularity);
  EXPECT_EQ(file.graph.links[0].regularity->planes, (std::vector<int>{0, 1}));
  EXPECT_EQ(file.graph.links[0].regularity->direction, 1);
  EXPECT_EQ(file.graph.links[2].regularity->axis, 0);
  EXPECT_FALSE(file.graph.links[1].regularity);
  WriteDrawing(folder.Path("again.json"), file.graph, file.metadata);
  const std::string text = TemporaryFolder::Read(path);
  EXPECT_EQ(text, TemporaryFolder::Read(folder.Path("again.json")));
  for (const auto& [from, to] :
       {std::pair<std::string, std::string>{"\"radii\":[0.125", "\"radii\":[-0.125"},
        {"\"orthogonal_to\":[1]", "\"orthogonal_to\":[2]"},
        {"\"normal_direction\":1", "\"normal_direction\":7"},
        {"\"normal\":[0.0,0.0,1.0]", "\"normal\":[0.0,0.0,1.1]"},
        {"\"planes\":[0,1]", "\"planes\":[0,2]"},
        {"\"axis\":0", "\"axis\":1"}}) {
    const size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    const std::string bad = std::string(text).replace(at, from.size(), to);
    EXPECT_THROW(ReadDrawingJson(folder.Write("bad.json", bad)), IoError) << from;
  }
}

TEST(WriteDrawing, JsonKeepsTheKinds) {
  const TemporaryFolder folder;
  DrawingGraph graph = SmallDrawing();
  const std::vector<LinkKind> kinds = {LinkKind::kEdge, LinkKind::kPaint, LinkKind::kShadow,
                                       LinkKind::kTexture};
  for (size_t l = 0; l < kinds.size(); ++l) {
    graph.links[l].kind = kinds[l];
    graph.links[l].kind_confidence = 1.0 / static_cast<double>(l + 1);
    graph.links[l].tentative = l >= 1;
    if (l >= 1) graph.links[l].evidence = -2.5 * static_cast<double>(l);
    if (l >= 1) graph.links[l].confidence = 0.3 * static_cast<double>(l);
    if (l >= 1) graph.links[l].tri_angle_deg = 12.5 * static_cast<double>(l);
    graph.links[l].curve_px = 0.1 * static_cast<double>(l);
    graph.links[l].doubt = l == 2 ? LinkDoubt::kExplained : LinkDoubt::kNone;
  }
  const std::string path = folder.Path("d.json");
  WriteDrawing(path, graph, SmallMetadata());
  const DrawingGraph read = ReadDrawingJson(path).graph;
  for (size_t l = 0; l < kinds.size(); ++l) {
    EXPECT_EQ(read.links[l].kind, kinds[l]);
    EXPECT_EQ(read.links[l].kind_confidence, graph.links[l].kind_confidence);
    EXPECT_EQ(read.links[l].tentative, l >= 1);
    EXPECT_EQ(read.links[l].evidence, graph.links[l].evidence);
    EXPECT_EQ(read.links[l].confidence, graph.links[l].confidence);
    EXPECT_EQ(read.links[l].tri_angle_deg, graph.links[l].tri_angle_deg);
    EXPECT_EQ(read.links[l].curve_px, graph.links[l].curve_px);
    EXPECT_EQ(read.links[l].doubt, graph.links[l].doubt);
  }
  const std::string text = TemporaryFolder::Read(path);
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"\"paint\"", "\"ink\""},
                                 {"\"kind_confidence\":1.0", "\"kind_confidence\":1.5"},
                                 {"\"explained by others\"", "\"envy\""},
                                 {"\"tentative\":true", "\"tentative\":1"}}) {
    const size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    const std::string bad = std::string(text).replace(at, from.size(), to);
    EXPECT_THROW(ReadDrawingJson(folder.Write("bad.json", bad)), IoError) << from;
  }
}

// PLY has them per edge, OBJ as groups, GraphML as attributes.
TEST(WriteDrawing, OtherFormatsTellTheKinds) {
  const TemporaryFolder folder;
  DrawingGraph graph = SmallDrawing();
  const auto written = [&](const char* name) {
    WriteDrawing(folder.Path(name), graph, SmallMetadata());
    ExpectSamePolylines(ReadCurves(folder.Path(name)), graph);
    return TemporaryFolder::Read(folder.Path(name));
  };
  EXPECT_THAT(written("d.ply"), ::testing::Not(HasSubstr("property uchar kind")));
  EXPECT_THAT(written("d.obj"), ::testing::Not(HasSubstr("\ng ")));
  graph.links[1].kind = LinkKind::kPaint;
  graph.links[1].kind_confidence = 0.75;
  graph.links[2].kind = LinkKind::kShadow;
  graph.links[2].tentative = true;
  EXPECT_THAT(written("d.ply"), HasSubstr("property uchar kind"));
  const std::string obj = written("d.obj");
  EXPECT_THAT(obj, HasSubstr("o link_1\ng paint\n"));
  EXPECT_THAT(obj, HasSubstr("o link_2\ng shadow\n"));
  WriteDrawing(folder.Path("d.graphml"), graph, SmallMetadata());
  const std::string graphml = TemporaryFolder::Read(folder.Path("d.graphml"));
  EXPECT_THAT(graphml, HasSubstr("<data key=\"edge_kind\">paint</data>"
                                 "<data key=\"kind_confidence\">0.75</data>"
                                 "<data key=\"tentative\">false</data>"));
  EXPECT_THAT(graphml, HasSubstr("<data key=\"tentative\">true</data>"));
}

DrawingGraph DrawingWithARod() {
  DrawingGraph graph = SmallDrawing();
  graph.links[1].kind = LinkKind::kRod;
  graph.links[1].rod_radius = 0.375;
  graph.links[2].tentative = true;
  graph.links[2].doubt = LinkDoubt::kRodOutline;
  return graph;
}

TEST(WriteDrawing, JsonKeepsRods) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("d.json");
  WriteDrawing(path, DrawingWithARod(), SmallMetadata());
  const DrawingGraph read = ReadDrawingJson(path).graph;
  EXPECT_EQ(read.links[1].kind, LinkKind::kRod);
  EXPECT_EQ(read.links[1].rod_radius, 0.375);
  EXPECT_EQ(read.links[0].rod_radius, 0);
  EXPECT_EQ(read.links[2].doubt, LinkDoubt::kRodOutline);
  std::string text = TemporaryFolder::Read(path);
  const std::string radius = "\"rod_radius\":0.375,";
  ASSERT_NE(text.find(radius), std::string::npos);
  text.erase(text.find(radius), radius.size());
  EXPECT_THROW(ReadDrawingJson(folder.Write("bad.json", text)), IoError);
}

TEST(WriteDrawing, JsonKeepsBodiesAndDepth) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("d.json");
  DrawingGraph graph = SmallDrawing();
  const RoundBody cone = {RoundShape::kCone, {1, 2, 3}, {1, 2, 5}, 0.5, 0.25, 0.0625, 0.375};
  const RoundBody ball = {RoundShape::kSphere, {1, 2, 3}, {1, 2, 3}, 0.5, 0.5, 0.0625, 0.375};
  graph.links[0].body = cone;
  graph.links[1].body = ball;
  for (const int id : {0, 1}) {
    graph.links[id].kind = LinkKind::kContour;
    graph.links[id].kind_confidence = 0.5;
  }
  graph.links[0].depth_sigma = 0.125;
  WriteDrawing(path, graph, SmallMetadata());
  const DrawingGraph read = ReadDrawingJson(path).graph;
  EXPECT_EQ(read.links[0].body, cone);
  EXPECT_EQ(read.links[1].body, ball);
  EXPECT_EQ(read.links[2].body, std::nullopt);
  EXPECT_EQ(read.links[0].depth_sigma, 0.125);
  EXPECT_EQ(read.links[1].depth_sigma, -1);
  const std::string text = TemporaryFolder::Read(path);
  const auto refuses = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    EXPECT_THROW(ReadDrawingJson(folder.Write("bad.json", changed)), IoError) << to;
  };
  refuses("\"cone\"", "\"cube\"");
  refuses("\"radii\":[0.5", "\"radii\":[-0.5");
  refuses("\"radii\":", "\"radius\":");
  refuses("\"body\":{", "\"body\":null,\"other\":{");
  refuses("\"kind\":\"contour\"", "\"kind\":\"edge\"");
}

// PLY has the radius per edge, OBJ as a comment, GraphML as an attribute, DXF as extended data.
TEST(WriteDrawing, OtherFormatsTellTheRadiiOfRods) {
  const TemporaryFolder folder;
  const auto written = [&](const DrawingGraph& graph, const char* name) {
    WriteDrawing(folder.Path(name), graph, SmallMetadata());
    return TemporaryFolder::Read(folder.Path(name));
  };
  EXPECT_THAT(written(SmallDrawing(), "d.ply"), ::testing::Not(HasSubstr("rod_radius")));
  EXPECT_THAT(written(SmallDrawing(), "d.dxf"), ::testing::Not(HasSubstr("\n1041\n")));
  const DrawingGraph graph = DrawingWithARod();
  EXPECT_THAT(written(graph, "d.dxf"), HasSubstr("\n1071\n1\n1041\n0.375\n0\n"));
  EXPECT_THAT(written(graph, "d.obj"), HasSubstr("o link_1\ng rod\n# rod_radius 0.375\n"));
  EXPECT_THAT(written(graph, "d.graphml"), HasSubstr("<data key=\"rod_radius\">0.375</data>"));
  const std::string ply = written(graph, "d.ply");
  EXPECT_THAT(ply, HasSubstr("property uchar kind\n"));
  EXPECT_THAT(ply, HasSubstr("property double rod_radius\nend_header\n"));
  // The last edge is of a link that is no rod, the first five are two of link 0 and three of 1.
  const size_t row = 2 * 4 + 3 + 4 + 1 + 8, num_edges = 2 + 3 + 1 + 4;
  const auto radius_at = [&](size_t edge) {
    double radius = -1;
    std::memcpy(&radius, ply.data() + ply.size() - (num_edges - edge) * row + row - 8, 8);
    return radius;
  };
  for (size_t edge = 0; edge < num_edges; ++edge) {
    EXPECT_EQ(radius_at(edge), edge >= 2 && edge < 5 ? 0.375 : 0);
  }
  for (const char* name : {"d.ply", "d.obj"}) {
    ExpectSamePolylines(ReadCurves(folder.Path(name)), graph);
  }
}

// Extended data of links only: not of the junction, which is put after them.
TEST(WriteDrawing, RadiiInDxfAreThoseOfTheirEntities) {
  const TemporaryFolder folder;
  DrawingGraph graph = SmallDrawing();
  graph.links.back().kind = LinkKind::kRod;
  graph.links.back().rod_radius = 0.375;
  WriteDrawing(folder.Path("d.dxf"), graph, SmallMetadata());
  const std::string dxf = TemporaryFolder::Read(folder.Path("d.dxf"));
  const size_t at = dxf.find("\n1041\n");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(dxf.find("\n1041\n", at + 1), std::string::npos);
}

TEST(WriteDrawing, LayersOfDxfCanBeTheKinds) {
  const TemporaryFolder folder;
  DrawingGraph graph = SmallDrawing();
  graph.links[1].kind = LinkKind::kPaint;
  DrawingFormatOptions options;
  options.dxf.layers = DxfLayers::kKind;
  WriteDrawing(folder.Path("d.dxf"), graph, SmallMetadata(), options);
  const std::string dxf = TemporaryFolder::Read(folder.Path("d.dxf"));
  EXPECT_THAT(dxf, HasSubstr("\npaint\n"));
  EXPECT_THAT(dxf, HasSubstr("\nunknown\n"));
  EXPECT_THAT(dxf, ::testing::Not(HasSubstr("\nshadow\n")));
}

TEST(ReadJsonKinds, CurvesComeByKindAndBadFilesAreRefused) {
  const TemporaryFolder folder;
  const auto curves = ReadJsonKinds(
      folder.Write("k.json", R"({"curves": [{"kind": "edge", "points": [[0, 0, 0], [1, 0, 0.5]]},
                               {"kind": "contour", "points": [[0, 1, 0], [1, 0, 0], [2, 0, 0]]},
                               {"kind": "edge", "points": [[5, 0, 0], [6, 0, 0]]}]})"));
  EXPECT_EQ(curves[static_cast<int>(LinkKind::kEdge)].polylines.size(), 2u);
  EXPECT_EQ(curves[static_cast<int>(LinkKind::kEdge)].polylines[0][1], Eigen::Vector3d(1, 0, 0.5));
  EXPECT_EQ(curves[static_cast<int>(LinkKind::kContour)].polylines[0].size(), 3u);
  EXPECT_TRUE(curves[static_cast<int>(LinkKind::kPaint)].polylines.empty());
  for (const char* bad :
       {R"({"curves": [{"kind": "ink", "points": [[0, 0, 0], [1, 0, 0]]}]})",
        R"({"curves": [{"kind": "unknown", "points": [[0, 0, 0], [1, 0, 0]]}]})",
        R"({"curves": [{"kind": "edge", "points": [[0, 0, 0]]}]})",
        R"({"curves": [{"kind": "edge", "points": [[0, 0], [1, 0]]}]})", R"({"links": []})"}) {
    EXPECT_THROW(ReadJsonKinds(folder.Write("bad.json", bad)), IoError) << bad;
  }
}

// As written before there were kinds.
TEST(WriteDrawing, JsonWithoutKindsIsOfUnknownKind) {
  const TemporaryFolder folder;
  WriteDrawing(folder.Path("d.json"), SmallDrawing(), SmallMetadata());
  std::string text = TemporaryFolder::Read(folder.Path("d.json"));
  const std::string kind = "\"kind\":\"unknown\",";
  for (size_t at = text.find(kind); at != std::string::npos; at = text.find(kind)) {
    text.erase(at, kind.size());
  }
  for (const DrawingLink& link : ReadDrawingJson(folder.Write("old.json", text)).graph.links) {
    EXPECT_EQ(link.kind, LinkKind::kUnknown);
    EXPECT_EQ(link.kind_confidence, 0);
    EXPECT_FALSE(link.tentative);
  }
}

TEST(WriteDrawing, BrokenAlignmentsAreNotWritten) {
  const TemporaryFolder folder;
  DrawingMetadata metadata;
  metadata.alignment.emplace();
  metadata.alignment->world_from_model.rotation.setZero();
  const std::string path = folder.Path("a.json");
  EXPECT_THROW(WriteDrawing(path, SmallDrawing(), metadata), InputError);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(WriteDrawing, BrokenJsonIsRefused) {
  const TemporaryFolder folder;
  WriteDrawing(folder.Path("d.json"), SmallDrawing(), SmallMetadata());
  const std::string text = TemporaryFolder::Read(folder.Path("d.json"));
  const auto with = [&](const std::string& from, const std::string& to) {
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return folder.Write("bad.json", std::string(text).replace(at, from.size(), to));
  };
  EXPECT_THROW(ReadDrawingJson(folder.Write("cut.json", text.substr(0, text.size() / 2))), IoError);
  EXPECT_THROW(ReadDrawingJson(with("limn-drawing", "other")), IoError);
  EXPECT_THROW(ReadDrawingJson(with("\"format_version\": 1", "\"format_version\": 2")), IoError);
  EXPECT_THROW(ReadDrawingJson(with("\"kind\":\"junction\"", "\"kind\":\"knot\"")), IoError);
  EXPECT_THROW(ReadDrawingJson(with("\"node0\":0", "\"node0\":77")), IoError);
  EXPECT_THROW(ReadDrawingJson(with("\"closed\"", "\"shut\"")), IoError);
  EXPECT_THAT([&] { ReadDrawingJson(with("\"sub/b c.png\"", "\"a.png\"")); },
              ThrowsMessage<IoError>(HasSubstr("view \"a.png\" is listed twice")));
  EXPECT_THAT([&] { ReadDrawingJson(with(R"({"z":1,"a":{"b":[2.5]}})", "[]")); },
              ThrowsMessage<IoError>(HasSubstr("options: an object expected")));
}

// Other programs sort the members.
TEST(WriteDrawing, JsonIsReadInAnyOrderOfMembers) {
  const TemporaryFolder folder;
  WriteDrawing(folder.Path("d.json"), SmallDrawing(), SmallMetadata());
  const std::string sorted =
      nlohmann::json::parse(TemporaryFolder::Read(folder.Path("d.json"))).dump();
  ASSERT_LT(sorted.find("\"links\""), sorted.find("\"views\""));
  const DrawingFile file = ReadDrawingJson(folder.Write("sorted.json", sorted));
  WriteDrawing(folder.Path("again.json"), file.graph, file.metadata);
  EXPECT_EQ(nlohmann::json::parse(TemporaryFolder::Read(folder.Path("again.json"))).dump(), sorted);
}

TEST(WriteDrawing, JsonHasLimitsOfNumbersAndErrorsNameThePlace) {
  const TemporaryFolder folder;
  DrawingGraph graph = SmallDrawing();
  graph.links[1].primitive = LinkPrimitive{LineSegment{{-1, 1e-17, 0}, {0, 0, 0}}};
  graph.dimensions = {{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}};
  WriteDrawing(folder.Path("d.json"), graph, SmallMetadata());
  const std::string text = TemporaryFolder::Read(folder.Path("d.json"));
  const auto said_of = [&](const std::string& from, const std::string& to) -> std::string {
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    try {
      ParseDrawingJson("d.json", std::string(text).replace(at, from.size(), to));
    } catch (const IoError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(said_of(R"("from":[0.0,)", R"("from":[1e300,)"),
            "d.json: dimensions[0].from[0]: a number from -1e15 to 1e15 expected");
  EXPECT_EQ(said_of(R"("residual_px":0.1)", R"("residual_px":"0.1")"),
            "d.json: links[0].residual_px: a number expected");
  EXPECT_EQ(said_of(R"("members":[[3,0,7])", R"("members":[[3,0])"),
            "d.json: links[0].members[0]: a list of 3 expected, not of 2");
  EXPECT_EQ(said_of(R"("start":[-1.0,)", R"("start":[1e6,)"),
            "d.json: no valid drawing: link 1: primitive: it is not where the points of the link "
            "are");
}

TEST(WriteDrawing, JsonOfAHubIsReadInLinearTime) {
  constexpr int kNumLinks = 100'000;
  DrawingGraph graph;
  graph.nodes.resize(kNumLinks + 1);
  for (int i = 0; i < kNumLinks; ++i) {
    graph.nodes[i + 1].position_in_world = {1, 1e-3 * i, 0};
    DrawingLink link;
    link.points_in_world = {{0, 0, 0}, graph.nodes[i + 1].position_in_world};
    link.sigma = {1, 1};
    link.node0 = 0;
    link.node1 = i + 1;
    graph.links.push_back(link);
  }
  RebuildIncidence(&graph);
  const TemporaryFolder folder;
  WriteDrawing(folder.Path("d.json"), graph, SmallMetadata());
  EXPECT_EQ(ReadDrawingJson(folder.Path("d.json")).graph.nodes[0].Degree(), kNumLinks);
}

TEST(WriteDrawing, JsonNamesRefinedCameras) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("d.json");
  EXPECT_EQ(RefinedCamerasOfDrawing(path), "");
  DrawingMetadata metadata = SmallMetadata();
  for (const char* cameras : {"", "0123456789abcdef"}) {
    metadata.refined_cameras = cameras;
    WriteDrawing(path, SmallDrawing(), metadata);
    EXPECT_EQ(ReadDrawingJson(path).metadata.refined_cameras, cameras);
    EXPECT_EQ(RefinedCamerasOfDrawing(path), cameras);
  }
}

TEST(WriteDrawing, JsonKeepsTheAlignment) {
  const TemporaryFolder folder;
  DrawingMetadata metadata = SmallMetadata();
  WriteDrawing(folder.Path("d.json"), SmallDrawing(), metadata);
  EXPECT_FALSE(ReadDrawingJson(folder.Path("d.json")).metadata.alignment);
  EXPECT_THAT(TemporaryFolder::Read(folder.Path("d.json")),
              ::testing::Not(HasSubstr("world_from_model")));

  Alignment& alignment = metadata.alignment.emplace();
  alignment.world_from_model.scale = 1.0 / 3;
  alignment.world_from_model.rotation << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  alignment.world_from_model.translation = {0.1, 1e-17, -4e6};
  alignment.up = UpSource::kPositions;
  alignment.axes = AxesSource::kLines;
  alignment.scale = ScaleSource::kLengths;
  WriteDrawing(folder.Path("a.json"), SmallDrawing(), metadata);
  const DrawingFile file = ReadDrawingJson(folder.Path("a.json"));
  ASSERT_TRUE(file.metadata.alignment);
  EXPECT_EQ(file.metadata.alignment->world_from_model.rotation,
            alignment.world_from_model.rotation);
  EXPECT_EQ(file.metadata.alignment->up, UpSource::kPositions);
  EXPECT_EQ(file.metadata.alignment->axes, AxesSource::kLines);
  EXPECT_EQ(file.metadata.alignment->scale, ScaleSource::kLengths);
  WriteDrawing(folder.Path("again.json"), file.graph, file.metadata);
  const std::string text = TemporaryFolder::Read(folder.Path("a.json"));
  EXPECT_EQ(TemporaryFolder::Read(folder.Path("again.json")), text);

  const auto fails = [&](const std::string& from, const std::string& to,
                         const std::string& reason) {
    const size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    const std::string bad =
        folder.Write("bad.json", std::string(text).replace(at, from.size(), to));
    EXPECT_THAT([&] { ReadDrawingJson(bad); }, ThrowsMessage<IoError>(HasSubstr(reason))) << from;
  };
  fails("\"scale\":0.3", "\"scale\":-0.3", "world_from_model: the scale is not positive");
  fails("[1.0,0.0,0.0]", "[1.0,0.1,0.0]", "world_from_model: the matrix is not a rotation");
  fails("\"unit\":\"m\"", "\"unit\":\"none\"", "world_from_model.unit: not \"m\"");
  fails("\"up_from\":\"positions\"", "\"up_from\":\"stars\"", "unknown source \"stars\"");
  fails("\"axes_from\"", "\"axes\"", "axes_from");
  fails("[1.0,0.0,0.0]", "[1.0,0.0]", "bad.json");
}

// COLMAP's ReadPly takes vertex properties of type float, double and uchar only.
TEST(WriteDrawing, PlyHeaderIsWhatColmapReads) {
  const TemporaryFolder folder;
  WriteDrawing(folder.Path("d.ply"), SmallDrawing(), SmallMetadata());
  std::istringstream file(TemporaryFolder::Read(folder.Path("d.ply")));
  std::string line;
  std::vector<std::string> vertex_properties;
  bool in_vertex = false;
  while (std::getline(file, line) && line != "end_header") {
    if (line.starts_with("element")) in_vertex = line.starts_with("element vertex");
    if (in_vertex && line.starts_with("property")) vertex_properties.push_back(line);
    if (line.starts_with("format")) {
      EXPECT_EQ(line, "format binary_little_endian 1.0");
    }
  }
  EXPECT_THAT(vertex_properties, ::testing::SizeIs(7));
  EXPECT_THAT(vertex_properties,
              ::testing::Each(::testing::AnyOf(::testing::StartsWith("property double "),
                                               ::testing::StartsWith("property uchar "))));
}

TEST(WriteDrawing, EmptyDrawingIsAFileToo) {
  const TemporaryFolder folder;
  for (const char* name : {"e.ply", "e.obj", "e.json"}) {
    WriteDrawing(folder.Path(name), {}, {});
    EXPECT_TRUE(ReadCurves(folder.Path(name)).polylines.empty());
  }
  for (const char* name : {"e.dxf", "e.graphml"}) {
    WriteDrawing(folder.Path(name), {}, {});
    EXPECT_FALSE(TemporaryFolder::Read(folder.Path(name)).empty());
  }
}

TEST(WriteDrawing, RefusesBrokenGraphsNamesAndExtensions) {
  const TemporaryFolder folder;
  DrawingGraph broken = SmallDrawing();
  broken.links[0].points_in_world[0].x() += 1;
  EXPECT_THROW(WriteDrawing(folder.Path("d.ply"), broken, SmallMetadata()), InputError);
  EXPECT_THROW(WriteDrawing(folder.Path("d.stl"), SmallDrawing(), SmallMetadata()), IoError);
  DrawingFormatOptions unknown;
  unknown.format = "stl";
  EXPECT_THROW(WriteDrawing(folder.Path("d.ply"), SmallDrawing(), SmallMetadata(), unknown),
               IoError);
  DrawingGraph no_circle = SmallDrawing();
  no_circle.links[3].primitive.emplace().shape = CircularArc{};
  EXPECT_THROW(WriteDrawing(folder.Path("d.ply"), no_circle, SmallMetadata()), InputError);
  EXPECT_THROW(WriteDrawing(folder.Path("d.json"), SmallDrawing(), {{"only one"}, "{}"}),
               InputError);
  EXPECT_THROW(WriteDrawing(folder.Path("d.json"), SmallDrawing(), {{"a", "b"}, "[1]"}),
               InputError);
  EXPECT_FALSE(std::filesystem::exists(folder.Path("d.json")));
}

TEST(WriteSketch, CurvesComeBack) {
  const TemporaryFolder folder;
  CurveSketch sketch;
  for (const bool closed : {false, true}) {
    Curve3D curve;
    for (int i = 0; i < 4; ++i) {
      curve.points_in_world.emplace_back(i, i * i, closed ? 1 : 0);
      curve.depth_sigma.push_back(0.5);
      curve.support.Append({});
    }
    curve.closed = closed;
    sketch.curves.push_back(curve);
  }
  WriteSketch(folder.Path("s.ply"), sketch);
  const CurveSet read = ReadCurves(folder.Path("s.ply"));
  const CurveSet expected = ToCurveSet(sketch);
  EXPECT_EQ(read.polylines, expected.polylines);
}

TEST(ColorOfCurve, NeighboringIdsAreFarApartAndNeverDark) {
  for (int id = 0; id < 1000; ++id) {
    const Color a = ColorOfCurve(id);
    const Color b = ColorOfCurve(id + 1);
    const int difference =
        std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue);
    EXPECT_GT(difference, 100) << id;
    EXPECT_GT(std::max({a.red, a.green, a.blue}), 180) << id;
  }
}

}  // namespace
}  // namespace limn
