// SPDX-License-Identifier: BSD-3-Clause
// Rods as solids in STEP files, read back and checked by OpenCASCADE.
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS.hxx>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/formats/primitive_drawing.h"
#include "limn/formats/step/step_read_back.h"
#include "support/face_drawing.h"

namespace limn {
namespace {

using StepRodSolids = StepFaces;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kRodRadius = 0.0625;

DrawingGraph AsRods(DrawingGraph graph, const std::vector<LinkId>& rods) {
  for (const LinkId id : rods) {
    graph.links[id].kind = LinkKind::kRod;
    graph.links[id].rod_radius = kRodRadius;
  }
  return graph;
}

double VolumeOfRod(const TopoDS_Shape& solid) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(solid, properties);
  return properties.Mass();
}

// By Pappus, if the rod is not bent too much.
double ExpectedVolume(const DrawingLink& rod) {
  return M_PI * kRodRadius * kRodRadius * Length(SampleShape(rod.primitive->shape, 1e-9));
}

// Neither its caps nor a second side.
GeomAbs_SurfaceType SideOf(const TopoDS_Shape& solid) {
  for (const TopoDS_Shape& face : SubShapes(solid, TopAbs_FACE)) {
    const GeomAbs_SurfaceType type = BRepAdaptor_Surface(TopoDS::Face(face)).GetType();
    if (type != GeomAbs_Plane) return type;
  }
  return GeomAbs_OtherSurface;
}

TEST_F(StepRodSolids, AreCurvesUnlessTubesAreAskedFor) {
  const TopoDS_Shape read = ReadBack(AsRods(PrimitiveDrawing(), {0}));
  EXPECT_THAT(SubShapes(read, TopAbs_SOLID), ::testing::IsEmpty());
  EXPECT_THAT(text_, HasSubstr("'link_0_rod_0.0625'"));
}

TEST_F(StepRodSolids, CylindersToriAndSplinesByTheirPrimitives) {
  options_.step.rods_as_tubes = true;
  const std::map<LinkId, GeomAbs_SurfaceType> sides = {
      {0, GeomAbs_Cylinder}, {1, GeomAbs_Torus}, {2, GeomAbs_BSplineSurface}, {7, GeomAbs_Torus}};
  for (const auto& [id, side] : sides) {
    SCOPED_TRACE(id);
    const DrawingGraph graph = AsRods(PrimitiveDrawing(), {id});
    const TopoDS_Shape read = ReadBack(graph);
    const std::vector<TopoDS_Shape> solids = SubShapes(read, TopAbs_SOLID);
    ASSERT_EQ(solids.size(), 1u);
    EXPECT_EQ(SideOf(solids[0]), side);
    const double exact = side == GeomAbs_BSplineSurface ? 1e-3 : 1e-6;
    EXPECT_NEAR(VolumeOfRod(solids[0]) / ExpectedVolume(graph.links[id]), 1, exact);
    EXPECT_THAT(left_out_, ::testing::IsEmpty());
    EXPECT_THAT(text_, HasSubstr("MANIFOLD_SOLID_BREP('link_" + std::to_string(id) + "_rod_"));
    EXPECT_THAT(text_, Not(HasSubstr("EDGE_CURVE('link_" + std::to_string(id) + "_rod_")));
    EXPECT_THAT(text_, HasSubstr("EDGE_CURVE('link_4'"));
  }
}

// Its ends meet smoothly.
TEST_F(StepRodSolids, AClosedSplineIsClosed) {
  PrimitiveDrawingBuilder builder;
  builder.AddShape(CubicBSpline{
      {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4},
      {{0, 0, 0}, {1, 0, 0}, {2, 2, 1}, {0, 3, 0}, {-2, 1, 0.5}, {-1, 0, 0}, {0, 0, 0}}});
  RebuildIncidence(&builder.graph());
  options_.step.rods_as_tubes = true;
  const DrawingGraph graph = AsRods(builder.graph(), {0});
  const std::vector<TopoDS_Shape> solids = SubShapes(ReadBack(graph), TopAbs_SOLID);
  ASSERT_EQ(solids.size(), 1u);
  EXPECT_EQ(SideOf(solids[0]), GeomAbs_BSplineSurface);
  EXPECT_NEAR(VolumeOfRod(solids[0]) / ExpectedVolume(graph.links[0]), 1, 1e-3);
}

// 4 has no primitive, 5 is bent more than it is thick.
TEST_F(StepRodSolids, ThoseWithoutAValidOneStayCurvesAndAreTold) {
  options_.step.rods_as_tubes = true;
  DrawingGraph graph = AsRods(PrimitiveDrawing(), {0, 4, 5});
  graph.links[5].rod_radius = 1.1;
  EXPECT_EQ(SubShapes(ReadBack(graph), TopAbs_SOLID).size(), 1u);
  EXPECT_THAT(left_out_,
              ::testing::ElementsAre("2 of 3 rods are curves in the file, since no tube along them "
                                     "is a valid solid: 4 5"));
  EXPECT_THAT(text_, HasSubstr("EDGE_CURVE('link_4_rod_"));
}

TEST_F(StepRodSolids, BesideFacesAndWithoutWires) {
  options_.step.rods_as_tubes = true;
  testing::FaceDrawing drawing;
  const LinkId a = drawing.AddLine({0, 0, 0}, {1, 0, 0});
  const LinkId b = drawing.AddLine({1, 0, 0}, {0, 1, 0});
  const LinkId c = drawing.AddLine({0, 1, 0}, {0, 0, 0});
  const LinkId rod = drawing.AddLine({1, 0, 0}, {3, 0, 0});
  drawing.AddPlane({drawing.Loop({a, b, c})});
  const TopoDS_Shape read = ReadBack(AsRods(drawing.graph(), {rod}));
  EXPECT_EQ(SubShapes(read, TopAbs_SOLID).size(), 1u);
  EXPECT_THAT(text_, HasSubstr("'shells'"));
  EXPECT_THAT(text_, HasSubstr("'rods'"));
  EXPECT_THAT(text_, Not(HasSubstr("'path_0'")));
}

}  // namespace
}  // namespace limn
