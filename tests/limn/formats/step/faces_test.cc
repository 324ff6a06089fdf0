// SPDX-License-Identifier: BSD-3-Clause
// Faces in STEP files: shells and solids, read back and checked by OpenCASCADE.
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS.hxx>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/formats/step/step_read_back.h"
#include "limn/geometry/polygon_with_holes.h"
#include "limn/model/drawing_transform.h"
#include "support/face_drawing.h"
#include "support/random_numbers.h"

namespace limn {
namespace {

double VolumeOfShape(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

std::map<GeomAbs_SurfaceType, int> SurfaceTypes(const TopoDS_Shape& shape) {
  std::map<GeomAbs_SurfaceType, int> types;
  for (const TopoDS_Shape& face : SubShapes(shape, TopAbs_FACE)) {
    ++types[BRepAdaptor_Surface(TopoDS::Face(face)).GetType()];
  }
  return types;
}

TEST_F(StepFaces, ACubeIsASolid) {
  const TopoDS_Shape read = ReadBack(testing::UnitCube());
  const std::vector<TopoDS_Shape> solids = SubShapes(read, TopAbs_SOLID);
  ASSERT_EQ(solids.size(), 1u);
  EXPECT_NEAR(VolumeOfShape(solids[0]), 1, 1e-9);
  EXPECT_NEAR(AreaOfShape(solids[0]), 6, 1e-9);
  EXPECT_EQ(SubShapes(read, TopAbs_FACE).size(), 6u);
  EXPECT_EQ(SubShapes(read, TopAbs_EDGE).size(), 12u);
  EXPECT_EQ(SubShapes(read, TopAbs_VERTEX).size(), 8u);
  EXPECT_EQ(SurfaceTypes(read), (std::map<GeomAbs_SurfaceType, int>{{GeomAbs_Plane, 6}}));
  EXPECT_THAT(left_out_, ::testing::IsEmpty());
  for (const char* name : {"'face_0'", "'face_5'", "'link_0'", "'link_11'", "'solids'"}) {
    EXPECT_THAT(text_, ::testing::HasSubstr(name));
  }
  EXPECT_THAT(text_, ::testing::Not(::testing::HasSubstr("'shells'")));
}

TEST_F(StepFaces, OfFiveSquaresAShell) {
  DrawingGraph graph = testing::UnitCube();
  graph.faces.pop_back();
  const TopoDS_Shape read = ReadBack(graph);
  EXPECT_THAT(SubShapes(read, TopAbs_SOLID), ::testing::IsEmpty());
  ASSERT_EQ(SubShapes(read, TopAbs_SHELL).size(), 1u);
  EXPECT_NEAR(AreaOfShape(read), 5, 1e-9);
  EXPECT_EQ(SubShapes(read, TopAbs_EDGE).size(), 12u);
}

TEST_F(StepFaces, AFaceTurnedTheWrongWayIsTurned) {
  DrawingGraph graph = testing::UnitCube();
  DrawingFace& face = graph.faces[2];
  face.normal = -face.normal;
  face.offset = -face.offset;
  std::reverse(face.loops[0].begin(), face.loops[0].end());
  for (FaceEdge& edge : face.loops[0]) std::swap(edge.from, edge.to);
  const TopoDS_Shape read = ReadBack(graph);
  ASSERT_EQ(SubShapes(read, TopAbs_SOLID).size(), 1u);
  EXPECT_NEAR(VolumeOfShape(read), 1, 1e-9);
}

TEST_F(StepFaces, APlateHasItsHoleAndItsBridge) {
  const TopoDS_Shape read = ReadBack(testing::PlateWithHole());
  const std::vector<TopoDS_Shape> faces = SubShapes(read, TopAbs_FACE);
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_NEAR(AreaOfShape(read), 6 - M_PI / 4, 1e-7);
  EXPECT_EQ(SubShapes(faces[0], TopAbs_WIRE).size(), 2u);
  EXPECT_EQ(SubShapes(read, TopAbs_EDGE).size(), 7u);  // five lines, a bridge and a circle
}

TEST_F(StepFaces, CylindersAndConesAreSolids) {
  TopoDS_Shape read = ReadBack(testing::Cylinder());
  ASSERT_EQ(SubShapes(read, TopAbs_SOLID).size(), 1u);
  EXPECT_NEAR(VolumeOfShape(read), 2 * M_PI, 1e-6);
  EXPECT_EQ(SurfaceTypes(read),
            (std::map<GeomAbs_SurfaceType, int>{{GeomAbs_Plane, 2}, {GeomAbs_Cylinder, 2}}));
  read = ReadBack(testing::Cylinder(0.5));
  ASSERT_EQ(SubShapes(read, TopAbs_SOLID).size(), 1u);
  EXPECT_NEAR(VolumeOfShape(read), 2 * M_PI / 3 * (1 + 0.5 + 0.25), 1e-5);
  EXPECT_EQ(SurfaceTypes(read),
            (std::map<GeomAbs_SurfaceType, int>{{GeomAbs_Plane, 2}, {GeomAbs_Cone, 2}}));
}

TEST_F(StepFaces, HalfACylinderOfFourSides) {
  const TopoDS_Shape read = ReadBack(testing::HalfCylinderSide());
  EXPECT_EQ(SubShapes(read, TopAbs_FACE).size(), 1u);
  EXPECT_NEAR(AreaOfShape(read), 2 * M_PI, 1e-6);
  EXPECT_EQ(SurfaceTypes(read), (std::map<GeomAbs_SurfaceType, int>{{GeomAbs_Cylinder, 1}}));
  // Seen from outside.
  const BRepAdaptor_Surface surface(TopoDS::Face(SubShapes(read, TopAbs_FACE)[0]));
  EXPECT_EQ(surface.Cylinder().Radius(), 1);
}

TEST_F(StepFaces, APatchOfFiveSides) {
  const DrawingGraph graph = testing::PentagonPatch();
  const TopoDS_Shape read = ReadBack(graph);
  EXPECT_EQ(SubShapes(read, TopAbs_FACE).size(), 1u);
  EXPECT_EQ(SubShapes(read, TopAbs_EDGE).size(), 5u);
  // It bulges more than the pentagon between the corners, and less than a lid over the arcs.
  const double pentagon = 5.0 / 2 * 4 * std::sin(2 * M_PI / 5);
  EXPECT_GT(AreaOfShape(read), pentagon);
  EXPECT_LT(AreaOfShape(read), 1.5 * AreaOf(graph.faces[0]));
  EXPECT_LT(LargestToleranceOf(read), 0.01);
}

// Four arcs over the sides of a square.
TEST_F(StepFaces, APatchOfFourSides) {
  testing::FaceDrawing drawing;
  const std::vector<Eigen::Vector3d> corners = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};
  std::vector<FaceLoop> sides;
  for (int k = 0; k < 4; ++k) {
    const Eigen::Vector3d& from = corners[k];
    const Eigen::Vector3d& to = corners[(k + 1) % 4];
    CircularArc arc;
    arc.center = (from + to) / 2 - Eigen::Vector3d(0, 0, 1);
    arc.radius = std::sqrt(2);
    arc.x_axis = (from - arc.center).normalized();
    arc.y_axis = (to - arc.center).normalized();
    arc.sweep_rad = M_PI / 2;
    sides.push_back({drawing.Whole(drawing.AddShape(arc))});
  }
  drawing.AddPatch(sides);
  const TopoDS_Shape read = ReadBack(drawing.graph());
  EXPECT_EQ(SubShapes(read, TopAbs_FACE).size(), 1u);
  EXPECT_EQ(SubShapes(read, TopAbs_EDGE).size(), 4u);
  EXPECT_LT(LargestToleranceOf(read), 1e-4);
  EXPECT_GT(AreaOfShape(read), 4);
}

// Between a circle and a square above it, and between two skew lines.
TEST_F(StepFaces, RuledSurfacesBetweenAnyRails) {
  testing::FaceDrawing drawing;
  CircularArc circle;
  circle.sweep_rad = 2 * M_PI;
  const LinkId bottom = drawing.AddShape(circle);
  const std::vector<Eigen::Vector3d> corners = {{1, 1, 2}, {-1, 1, 2}, {-1, -1, 2}, {1, -1, 2}};
  std::vector<LinkId> square;
  for (int k = 0; k < 4; ++k) square.push_back(drawing.AddLine(corners[k], corners[(k + 1) % 4]));
  drawing.AddRuled({drawing.Whole(bottom)}, drawing.Loop(square));
  drawing.AddRuled(std::vector<FaceLoop>{{drawing.Whole(drawing.AddLine({9, 0, 0}, {11, 0, 0}))},
                                         {drawing.Whole(drawing.AddLine({11, 0, 0}, {10, 1, 2}))},
                                         {drawing.Whole(drawing.AddLine({10, 1, 2}, {10, -1, 2}))},
                                         {drawing.Whole(drawing.AddLine({10, -1, 2}, {9, 0, 0}))}});
  const TopoDS_Shape read = ReadBack(drawing.graph());
  EXPECT_THAT(left_out_, ::testing::IsEmpty());
  EXPECT_EQ(SubShapes(read, TopAbs_FACE).size(), 3u);
  EXPECT_EQ(SubShapes(read, TopAbs_SHELL).size(), 2u);
  EXPECT_LT(LargestToleranceOf(read), 0.01);
}

// The line that both squares have a part of is cut, and the squares share the line between them.
TEST_F(StepFaces, FacesShareEdgesAndPartsOfLinks) {
  const TopoDS_Shape read = ReadBack(testing::TwoSquaresOnOneLine());
  ASSERT_EQ(SubShapes(read, TopAbs_SHELL).size(), 1u);
  EXPECT_EQ(SubShapes(read, TopAbs_FACE).size(), 2u);
  EXPECT_EQ(SubShapes(read, TopAbs_EDGE).size(), 7u);
  EXPECT_EQ(SubShapes(read, TopAbs_VERTEX).size(), 6u);
  EXPECT_NEAR(AreaOfShape(read), 2, 1e-9);
}

TEST_F(StepFaces, LinksWithoutFacesStayWires) {
  testing::FaceDrawing drawing;
  const LinkId a = drawing.AddLine({0, 0, 0}, {1, 0, 0});
  const LinkId b = drawing.AddLine({1, 0, 0}, {0, 1, 0});
  const LinkId c = drawing.AddLine({0, 1, 0}, {0, 0, 0});
  drawing.AddLine({1, 0, 0}, {3, 0, 0});
  drawing.AddPlane({drawing.Loop({a, b, c})});
  const TopoDS_Shape read = ReadBack(drawing.graph());
  EXPECT_EQ(SubShapes(read, TopAbs_EDGE).size(), 4u);
  EXPECT_EQ(SubShapes(read, TopAbs_WIRE).size(), 2u);
  EXPECT_THAT(text_, ::testing::HasSubstr("'link_3'"));
  EXPECT_THAT(text_, ::testing::HasSubstr("'path_0'"));
  EXPECT_THAT(text_, ::testing::Not(::testing::HasSubstr("'path_1'")));
}

// Planes and nodes of a drawing from photographs do not agree exactly: vertices go to where planes
// meet.
TEST_F(StepFaces, VerticesGoToWherePlanesMeet) {
  constexpr double kNoise = 0.002;
  DrawingGraph graph = testing::UnitCube();
  std::mt19937 random(7);
  testing::NormalDistribution<double> noise(0, kNoise);
  for (DrawingFace& face : graph.faces) {
    for (int axis = 0; axis < 3; ++axis) face.normal[axis] += noise(random);
    face.normal.normalize();
    face.offset += noise(random);
  }
  const TopoDS_Shape read = ReadBack(graph);
  ASSERT_EQ(SubShapes(read, TopAbs_SOLID).size(), 1u);
  EXPECT_NEAR(VolumeOfShape(read), 1, 10 * kNoise);
  EXPECT_LT(LargestToleranceOf(read), 1e-5);
}

// Circles of a drawing from photographs have neither one axis nor one radius.
TEST_F(StepFaces, ACylinderOfNoisyCirclesIsASolid) {
  std::mt19937 random(3);
  for (const double noise : {1e-5, 1e-4, 1e-3}) {
    SCOPED_TRACE(noise);
    testing::NormalDistribution<double> normal(0, noise);
    const auto random_vector = [&] { return testing::RandomVector(normal, random); };
    DrawingGraph graph = testing::Cylinder();
    for (DrawingLink& link : graph.links) {
      auto& arc = std::get<CircularArc>(link.primitive->shape);
      const Eigen::Vector3d turn = random_vector();
      const Eigen::Matrix3d rotation =
          Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
      arc.center += random_vector();
      arc.radius += normal(random);
      arc.x_axis = rotation * arc.x_axis;
      arc.y_axis = rotation * arc.y_axis;
    }
    const TopoDS_Shape read = ReadBack(graph);
    ASSERT_EQ(SubShapes(read, TopAbs_SOLID).size(), 1u);
    EXPECT_NEAR(VolumeOfShape(read), 2 * M_PI, 100 * noise);
    EXPECT_THAT(left_out_, ::testing::IsEmpty());
  }
}

// A spline and an arc leave the plane of their face a little: they are projected onto it.
TEST_F(StepFaces, CurvesAreProjectedOntoThePlane) {
  testing::FaceDrawing drawing;
  const CubicBSpline spline{
      {0, 0, 0, 0, 0.5, 1, 1, 1, 1},
      {{0, 0, 0}, {0.3, -0.4, 0.004}, {1, 0.3, -0.003}, {1.6, -0.3, 0.004}, {2, 0, 0}}};
  const Eigen::Matrix3d tilt =
      Eigen::AngleAxisd(0.002, Eigen::Vector3d::UnitY()).toRotationMatrix();
  CircularArc arc;
  arc.center = {1, 1, 0};
  arc.x_axis = tilt * Eigen::Vector3d::UnitX();
  arc.sweep_rad = M_PI;
  const LinkId bottom = drawing.AddShape(spline);
  const LinkId right = drawing.AddLine({2, 0, 0}, PointAt(arc, 0));
  const LinkId top = drawing.AddShape(arc);
  const LinkId left = drawing.AddLine(PointAt(arc, 1), {0, 0, 0});
  drawing.AddPlane({drawing.Loop({bottom, right, top, left})});
  DrawingGraph graph = drawing.graph();
  graph.faces[0].normal = Eigen::Vector3d::UnitZ();
  graph.faces[0].offset = 0;
  const TopoDS_Shape read = ReadBack(graph);
  EXPECT_THAT(left_out_, ::testing::IsEmpty());
  ASSERT_EQ(SubShapes(read, TopAbs_FACE).size(), 1u);
  EXPECT_LT(LargestToleranceOf(read), 1e-5);
  for (const TopoDS_Shape& edge : SubShapes(read, TopAbs_EDGE)) {
    double first = 0, last = 0;
    const auto curve = BRep_Tool::Curve(TopoDS::Edge(edge), first, last);
    for (int k = 0; k <= 10; ++k) {
      EXPECT_NEAR(curve->Value(first + k * (last - first) / 10).Z(), 0, 1e-9);
    }
  }
}

TEST_F(StepFaces, ThreeFacesAtAnEdgeAreSeveralShells) {
  testing::FaceDrawing drawing;
  const LinkId hinge = drawing.AddLine({0, 0, 0}, {0, 0, 1});
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d out(std::cos(2.0 * k), std::sin(2.0 * k), 0);
    const LinkId bottom = drawing.AddLine(out, {0, 0, 0});
    const LinkId top = drawing.AddLine({0, 0, 1}, out + Eigen::Vector3d::UnitZ());
    const LinkId side = drawing.AddLine(out + Eigen::Vector3d::UnitZ(), out);
    drawing.AddPlane({drawing.Loop({hinge, top, side, bottom})});
  }
  const TopoDS_Shape read = ReadBack(drawing.graph());
  EXPECT_THAT(left_out_, ::testing::IsEmpty());
  EXPECT_EQ(SubShapes(read, TopAbs_FACE).size(), 3u);
  EXPECT_NEAR(AreaOfShape(read), 3, 1e-9);
}

// A link that crosses others near a plane meets them in it, and so do the corners.
TEST_F(StepFaces, AcrossAPlaneBordersHaveNoGaps) {
  testing::FaceDrawing drawing;
  const LinkId a = drawing.AddLine({-0.2, 0, 0.04}, {1.2, 0, 0.04});
  const LinkId b = drawing.AddLine({1, -0.2, 0}, {1, 1, 0});
  const LinkId c = drawing.AddLine({1, 1, 0}, {0, 1, 0});
  const LinkId d = drawing.AddLine({0, 1, 0}, {0, -0.2, 0});
  drawing.AddPlane({{drawing.Part(a, 0.2 / 1.4, 1.2 / 1.4), drawing.Part(b, 0.2 / 1.2, 1),
                     drawing.Whole(c), drawing.Part(d, 0, 1 / 1.2)}});
  DrawingGraph graph = drawing.graph();
  graph.faces[0].normal = Eigen::Vector3d::UnitZ();
  graph.faces[0].offset = 0;
  const TopoDS_Shape read = ReadBack(graph);
  EXPECT_THAT(left_out_, ::testing::IsEmpty());
  EXPECT_NEAR(AreaOfShape(read), 1, 1e-6);
  EXPECT_LT(LargestToleranceOf(read), 1e-5);
}

TEST_F(StepFaces, PlanesMeetInAStraightLine) {
  testing::FaceDrawing drawing;
  const CubicBSpline bent{{0, 0, 0, 0, 1, 1, 1, 1},
                          {{0, 0, 0}, {0.02, 0.02, 0.3}, {-0.02, 0.01, 0.7}, {0, 0, 1}}};
  const LinkId hinge = drawing.AddShape(bent);
  for (const int axis : {0, 1}) {
    const Eigen::Vector3d out = Eigen::Vector3d::Unit(axis);
    const LinkId bottom = drawing.AddLine(out, {0, 0, 0});
    const LinkId top = drawing.AddLine({0, 0, 1}, out + Eigen::Vector3d::UnitZ());
    const LinkId side = drawing.AddLine(out + Eigen::Vector3d::UnitZ(), out);
    drawing.AddPlane({drawing.Loop({hinge, top, side, bottom})});
  }
  DrawingGraph graph = drawing.graph();
  for (DrawingFace& face : graph.faces) face.offset = 0;
  graph.faces[0].normal = Eigen::Vector3d::UnitY();
  graph.faces[1].normal = -Eigen::Vector3d::UnitX();
  const TopoDS_Shape read = ReadBack(graph);
  EXPECT_EQ(SubShapes(read, TopAbs_SHELL).size(), 1u);
  EXPECT_EQ(SubShapes(read, TopAbs_EDGE).size(), 7u);
  EXPECT_LT(LargestToleranceOf(read), 1e-5);
}

// A face whose border has a gap, and one whose plane is not that of its border.
TEST_F(StepFaces, FacesThatDoNotFitAreApartOrLeftOutAndTold) {
  DrawingGraph graph = testing::UnitCube();
  graph.faces[0].loops[0].pop_back();
  graph.faces[3].offset += 0.3;
  const TopoDS_Shape read = ReadBack(graph);
  EXPECT_EQ(SubShapes(read, TopAbs_FACE).size(), 5u);
  EXPECT_EQ(SubShapes(read, TopAbs_SHELL).size(), 2u);
  EXPECT_NEAR(AreaOfShape(read), 5, 1e-9);
  EXPECT_THAT(left_out_,
              ::testing::ElementsAre("1 of 6 faces share no edges in the file, since their borders "
                                     "do not fit those of their neighbors: 0",
                                     "1 of 6 faces are not in the file, since they have no valid "
                                     "shape there: 3"));
  // All faces failed: wires only.
  graph.faces = {graph.faces[3]};
  const TopoDS_Shape wires = ReadBack(graph);
  EXPECT_THAT(SubShapes(wires, TopAbs_FACE), ::testing::IsEmpty());
  EXPECT_EQ(SubShapes(wires, TopAbs_EDGE).size(), 12u);
}

TEST_F(StepFaces, AFaceApartKeepsItsHole) {
  DrawingGraph graph = testing::PlateWithHole();
  DrawingFace& face = graph.faces[0];
  face.loops[0].pop_back();
  const Polygon2d polygon = {
      {{{0, 0}, {3, 0}, {3, 2}, {0, 2}}, {{1, 0.5}, {1, 1.5}, {2, 1.5}, {2, 0.5}}}};
  face.vertices.clear();
  for (const Polyline2d& outline : polygon.outlines) {
    for (const Eigen::Vector2d& corner : outline) {
      face.vertices.emplace_back(corner.x(), corner.y(), 1);
    }
  }
  face.triangles = Triangulate(polygon);
  const TopoDS_Shape read = ReadBack(graph);
  const std::vector<TopoDS_Shape> faces = SubShapes(read, TopAbs_FACE);
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_EQ(SubShapes(faces[0], TopAbs_WIRE).size(), 2u);
  EXPECT_NEAR(AreaOfShape(read), 6 - 1, 1e-9);
  EXPECT_THAT(text_, ::testing::HasSubstr("'path_0'"));  // its links stay wires
}

TEST_F(StepFaces, FarFromTheOriginAndTurned) {
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for (const DrawingGraph& graph : {testing::UnitCube(), testing::Cylinder()}) {
    const TopoDS_Shape read = ReadBack(Transformed(graph, 3000, rotation, {4.5e5, 5.1e6, 300}));
    ASSERT_EQ(SubShapes(read, TopAbs_SOLID).size(), 1u);
    EXPECT_NEAR(VolumeOfShape(read) / std::pow(3000, 3), graph.faces.size() == 6 ? 1 : 2 * M_PI,
                1e-5);
  }
}

TEST_F(StepFaces, TheSameBytesWithFacesAgain) {
  ReadBack(testing::Cylinder());
  const std::string first = text_;
  ReadBack(testing::Cylinder());
  EXPECT_EQ(text_, first);
}

}  // namespace
}  // namespace limn
