// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/formats/temporary_folder.h"
#include "limn/formats/write_drawing.h"
#include "limn/model/drawing_graph.h"

namespace limn {

class StepFaces : public ::testing::Test {
 protected:
  // Fails if anything in the file is invalid.
  TopoDS_Shape ReadBack(const DrawingGraph& graph) {
    EXPECT_THAT(Validate(graph), ::testing::IsEmpty());
    const std::string path = folder_.Path("d.step");
    options_.write_step = &WriteDrawingStep;
    left_out_ = WriteDrawing(path, graph, {{"a", "b"}, "{}"}, options_);
    text_ = TemporaryFolder::Read(path);
    STEPControl_Reader reader;
    EXPECT_EQ(reader.ReadFile(path.c_str()), IFSelect_RetDone);
    reader.TransferRoots();
    const TopoDS_Shape shape = reader.OneShape();
    EXPECT_FALSE(shape.IsNull());
    EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
    return shape;
  }

  DrawingFormatOptions options_;
  TemporaryFolder folder_;
  std::string text_;
  std::vector<std::string> left_out_;
};

inline std::vector<TopoDS_Shape> SubShapes(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, type, map);
  std::vector<TopoDS_Shape> shapes;
  for (int i = 1; i <= map.Extent(); ++i) shapes.push_back(map(i));
  return shapes;
}

inline double AreaOfShape(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  return properties.Mass();
}

// Distances between edges and surfaces, and between vertices and edges.
inline double LargestToleranceOf(const TopoDS_Shape& shape) {
  double largest = 0;
  for (const TopoDS_Shape& edge : SubShapes(shape, TopAbs_EDGE)) {
    largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Edge(edge)));
  }
  for (const TopoDS_Shape& vertex : SubShapes(shape, TopAbs_VERTEX)) {
    largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Vertex(vertex)));
  }
  return largest;
}

}  // namespace limn
