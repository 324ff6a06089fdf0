// SPDX-License-Identifier: BSD-3-Clause
// STEP files, read back by OpenCASCADE's reader.
#include "limn/formats/step/step_drawing_writer.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Geom_BSplineCurve.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/formats/primitive_drawing.h"
#include "limn/formats/small_drawing.h"
#include "limn/formats/temporary_folder.h"
#include "limn/formats/write_drawing.h"
#include "limn/geometry/polyline.h"
#include "limn/model/drawing_paths.h"
#include "limn/model/drawing_transform.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

class DrawingStep : public ::testing::Test {
 protected:
  void Write(const std::string& name, const DrawingGraph& graph,
             LengthUnit unit = LengthUnit::kNone) {
    DrawingFormatOptions options;
    options.unit = unit;
    options.write_step = &WriteDrawingStep;
    WriteDrawing(folder_.Path(name), graph, {{"a", "b"}, "{}"}, options);
  }
  TopoDS_Shape WriteAndRead(const DrawingGraph& graph, LengthUnit unit = LengthUnit::kNone) {
    const std::string path = folder_.Path("d.step");
    Write("d.step", graph, unit);
    STEPControl_Reader reader;
    EXPECT_EQ(reader.ReadFile(path.c_str()), IFSelect_RetDone);
    EXPECT_EQ(reader.TransferRoots(), 1);
    return reader.OneShape();
  }

  TemporaryFolder folder_;
};

TEST_F(DrawingStep, EdgesAreNamedByTheirKind) {
  DrawingGraph graph = SmallDrawing();
  graph.links[1].kind = LinkKind::kPaint;
  WriteAndRead(graph);
  const std::string text = TemporaryFolder::Read(folder_.Path("d.step"));
  EXPECT_THAT(text, ::testing::HasSubstr("'link_0'"));
  EXPECT_THAT(text, ::testing::HasSubstr("'link_1_paint'"));
}

std::vector<TopoDS_Shape> Children(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
  std::vector<TopoDS_Shape> children;
  for (TopoDS_Iterator child(shape); child.More(); child.Next()) {
    EXPECT_EQ(child.Value().ShapeType(), type);
    children.push_back(child.Value());
  }
  return children;
}

int CountDistinct(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
  TopTools_IndexedMapOfShape shapes;
  TopExp::MapShapes(shape, type, shapes);
  return shapes.Extent();
}

Eigen::Vector3d At(const gp_Pnt& point) { return {point.X(), point.Y(), point.Z()}; }

double LengthOf(const DrawingLink& link) {
  return Length(link.primitive ? SampleShape(link.primitive->shape, 1e-9)
                               : Polyline3d(link.points_in_world));
}

void ExpectSameType(const BRepAdaptor_Curve& curve, const DrawingLink& link) {
  const std::string name = link.primitive ? ShapeName(link.primitive->shape) : "polyline";
  if (name == "line") {
    EXPECT_EQ(curve.GetType(), GeomAbs_Line);
  } else if (name == "arc" || name == "circle") {
    ASSERT_EQ(curve.GetType(), GeomAbs_Circle);
    EXPECT_EQ(curve.Circle().Radius(), std::get<CircularArc>(link.primitive->shape).radius);
  } else {
    ASSERT_EQ(curve.GetType(), GeomAbs_BSplineCurve);
    const bool spline = name == "spline";
    EXPECT_EQ(curve.Degree(), spline ? 3 : 1);
    const size_t num_poles =
        spline ? std::get<CubicBSpline>(link.primitive->shape).control_points.size()
               : link.points_in_world.size();
    // The reader makes closed splines periodic.
    if (!link.closed) {
      EXPECT_EQ(curve.NbPoles(), static_cast<int>(num_poles));
    }
  }
}

void ExpectSameCurve(const TopoDS_Edge& edge, const DrawingLink& link) {
  const BRepAdaptor_Curve curve(edge);
  ExpectSameType(curve, link);
  EXPECT_NEAR(GCPnts_AbscissaPoint::Length(curve, 1e-9) / LengthOf(link), 1, 1e-6);
  const Polyline3d samples =
      link.primitive ? SampleShape(link.primitive->shape, 1e-7) : Polyline3d(link.points_in_world);
  for (int k = 0; k <= 20; ++k) {
    const double t =
        curve.FirstParameter() + k / 20.0 * (curve.LastParameter() - curve.FirstParameter());
    EXPECT_LT(ClosestPoint(samples, At(curve.Value(t))).squared_distance, 1e-12);
  }
  EXPECT_LT((At(curve.Value(curve.FirstParameter())) - samples.front()).norm(), 1e-9);
  EXPECT_LT((At(curve.Value(curve.LastParameter())) - samples.back()).norm(), 1e-9);
}

TEST_F(DrawingStep, AWirePerPathWithTheLinksCurves) {
  const DrawingGraph graph = PrimitiveDrawing();
  const TopoDS_Shape read = WriteAndRead(graph);
  const std::vector<DrawingPath> paths = PathsOf(graph);
  const std::vector<TopoDS_Shape> wires = Children(read, TopAbs_WIRE);
  ASSERT_EQ(wires.size(), paths.size());
  EXPECT_LT(paths.size(), graph.links.size());
  for (size_t p = 0; p < paths.size(); ++p) {
    const std::vector<TopoDS_Shape> edges = Children(wires[p], TopAbs_EDGE);
    ASSERT_EQ(edges.size(), paths[p].size());
    for (size_t i = 0; i < edges.size(); ++i) {
      SCOPED_TRACE("link " + std::to_string(paths[p][i].link));
      ExpectSameCurve(TopoDS::Edge(edges[i]), graph.links[paths[p][i].link]);
    }
  }
}

TEST_F(DrawingStep, LinksShareTheVerticesOfTheirNodes) {
  const DrawingGraph graph = PrimitiveDrawing();
  const TopoDS_Shape read = WriteAndRead(graph);
  EXPECT_EQ(CountDistinct(read, TopAbs_EDGE), static_cast<int>(graph.links.size()));
  EXPECT_EQ(CountDistinct(read, TopAbs_VERTEX), static_cast<int>(graph.nodes.size()));
  // Also across wires: as many edges at every vertex as the node has link ends.
  std::multiset<int> degrees, expected;
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(read, TopAbs_VERTEX, vertices);
  for (int v = 1; v <= vertices.Extent(); ++v) {
    int degree = 0;
    for (TopExp_Explorer edge(read, TopAbs_EDGE); edge.More(); edge.Next()) {
      for (TopoDS_Iterator end(edge.Current()); end.More(); end.Next()) {
        degree += end.Value().IsSame(vertices(v));
      }
    }
    degrees.insert(degree);
  }
  for (const DrawingNode& node : graph.nodes) expected.insert(node.Degree());
  EXPECT_EQ(degrees, expected);
}

// 0-1-2-3 with links of any direction.
TEST_F(DrawingStep, EdgesOfAWireFollowEachOther) {
  PrimitiveDrawingBuilder builder;
  std::vector<NodeId> nodes;
  for (int n = 0; n < 4; ++n) nodes.push_back(builder.AddNode({1.0 * n, 0.1 * n * n, 0}));
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  builder.AddPolyline({zero, {1.5, 0.5, 0}, zero}, nodes[2], nodes[1]);
  builder.AddPolyline({zero, zero}, nodes[0], nodes[1]);
  builder.AddPolyline({zero, zero}, nodes[3], nodes[2]);
  builder.AddShape(TiltedArc({9, 0, 0}, 1, 0.4, 0, 2));
  RebuildIncidence(&builder.graph());
  const std::vector<TopoDS_Shape> wires = Children(WriteAndRead(builder.graph()), TopAbs_WIRE);
  ASSERT_EQ(wires.size(), 2u);
  const std::vector<TopoDS_Shape> edges = Children(wires[0], TopAbs_EDGE);
  ASSERT_EQ(edges.size(), 3u);
  for (size_t i = 1; i < edges.size(); ++i) {
    EXPECT_TRUE(TopExp::LastVertex(TopoDS::Edge(edges[i - 1]), true)
                    .IsSame(TopExp::FirstVertex(TopoDS::Edge(edges[i]), true)))
        << i;
  }
  const auto start = BRep_Tool::Pnt(TopExp::FirstVertex(TopoDS::Edge(edges[0]), true));
  EXPECT_LT((At(start) - builder.graph().nodes[3].position_in_world).norm(), 1e-12);
}

TEST_F(DrawingStep, UnitsBecomeMillimeters) {
  PrimitiveDrawingBuilder builder;
  builder.AddShape(LineSegment{{1, 2, 3}, {1, 2, 5}});
  RebuildIncidence(&builder.graph());
  const std::map<LengthUnit, double> lengths = {
      {LengthUnit::kNone, 2},     {LengthUnit::kMillimeter, 2}, {LengthUnit::kCentimeter, 20},
      {LengthUnit::kMeter, 2000}, {LengthUnit::kInch, 50.8},    {LengthUnit::kFoot, 609.6}};
  for (const auto& [unit, length] : lengths) {
    const TopoDS_Shape read = WriteAndRead(builder.graph(), unit);
    const BRepAdaptor_Curve curve(TopoDS::Edge(TopExp_Explorer(read, TopAbs_EDGE).Current()));
    EXPECT_NEAR(GCPnts_AbscissaPoint::Length(curve), length, 1e-9);
  }
}

// A primitive need not go through the node of a free end, or through the start of a closed link.
TEST_F(DrawingStep, FreeEndsAreThoseOfTheCurves) {
  PrimitiveDrawingBuilder builder;
  const NodeId a = builder.AddNode({0, 0, 0.01}), b = builder.AddNode({1, 0, -0.01});
  builder.AddShape(LineSegment{{0, 0, 0}, {1, 0, 0}}, a, b);
  const NodeId anchor = builder.AddNode({5.01, 0, 0});
  builder.AddShape(TiltedArc({5, 0, 0}, 1, 0.4, 1, 2 * M_PI), anchor);
  RebuildIncidence(&builder.graph());
  EXPECT_THAT(Validate(builder.graph()), ::testing::IsEmpty());
  const TopoDS_Shape read = WriteAndRead(builder.graph());
  std::vector<double> lengths;
  for (TopExp_Explorer edge(read, TopAbs_EDGE); edge.More(); edge.Next()) {
    lengths.push_back(
        GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(TopoDS::Edge(edge.Current()))));
  }
  EXPECT_THAT(lengths, ::testing::ElementsAre(::testing::DoubleNear(1, 1e-9),
                                              ::testing::DoubleNear(2 * M_PI, 1e-9)));
}

// Fitted primitives may end a little beside their nodes, and models may be far from their origin.
TEST_F(DrawingStep, WiresHoldWherePrimitivesEndBesideTheirNodes) {
  DrawingGraph graph = PrimitiveDrawing();
  std::get<LineSegment>(graph.links[0].primitive->shape).end += Eigen::Vector3d(1e-6, -1e-6, 2e-6);
  std::get<CircularArc>(graph.links[1].primitive->shape).center += Eigen::Vector3d(0, 1e-6, 0);
  graph = Transformed(graph, 1, Eigen::Matrix3d::Identity(), {4.5e5, 5.1e6, 300});
  const TopoDS_Shape read = WriteAndRead(graph, LengthUnit::kMeter);
  EXPECT_EQ(Children(read, TopAbs_WIRE).size(), PathsOf(graph).size());
  EXPECT_EQ(CountDistinct(read, TopAbs_EDGE), static_cast<int>(graph.links.size()));
  EXPECT_EQ(CountDistinct(read, TopAbs_VERTEX), static_cast<int>(graph.nodes.size()));
  double length = 0, expected = 0;
  for (TopExp_Explorer edge(read, TopAbs_EDGE); edge.More(); edge.Next()) {
    length += GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(TopoDS::Edge(edge.Current())), 1e-6);
  }
  for (const DrawingLink& link : graph.links) expected += 1000 * LengthOf(link);
  EXPECT_NEAR(length / expected, 1, 1e-6);
}

TEST_F(DrawingStep, TheSameBytesAgain) {
  Write("a.stp", PrimitiveDrawing());
  Write("b.STEP", PrimitiveDrawing());
  EXPECT_EQ(TemporaryFolder::Read(folder_.Path("a.stp")),
            TemporaryFolder::Read(folder_.Path("b.STEP")));
}

TEST_F(DrawingStep, NothingIsNoStepFile) {
  EXPECT_THROW(Write("a.step", {}), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder_.Path("a.step")));
}

TEST_F(DrawingStep, NeedsItsWriter) {
  EXPECT_THROW(WriteDrawing(folder_.Path("a.step"), PrimitiveDrawing(), {{"a", "b"}, "{}"}),
               IoError);
  EXPECT_FALSE(std::filesystem::exists(folder_.Path("a.step")));
}

// Knots that are too near to each other for OpenCASCADE.
TEST_F(DrawingStep, CurvesThatOpenCascadeRefusesAreNamed) {
  PrimitiveDrawingBuilder builder;
  const double knot = 0.5;
  const CubicBSpline spline{{0, 0, 0, 0, knot, std::nextafter(knot, 1), 1, 1, 1, 1},
                            {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 1, 0}, {4, 0, 0}, {5, 0, 1}}};
  builder.AddShape(spline);
  RebuildIncidence(&builder.graph());
  try {
    Write("a.step", builder.graph());
    FAIL() << "it was written";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("link_0"));
  }
}

}  // namespace
}  // namespace limn
