// SPDX-License-Identifier: BSD-3-Clause
// Exported files as FreeCAD, Open3D, MeshLab, CloudCompare and LibreCAD read them. These are not in
// scripts/setup.sh: a test of one that is not installed is skipped.
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "end_to_end/exported_drawing.h"
#include "limn/formats/primitive_drawing.h"
#include "limn/geometry/polyline.h"

namespace limn::testing {
namespace {

using nlohmann::json;

// Single precision, with which some of the programs read and write.
constexpr double kRelative = 1e-5;

class DrawingExporterPrograms : public ::testing::Test {
 protected:
  json ReadBy(const std::string& program, const std::string& name,
              const std::vector<std::string>& options = {}) {
    exported_.Export(name, options);
    return exported_.ReadIn(program, name);
  }

  // Polylines of all links, whatever their primitives are.
  void ExpectAllPolylines(const json& read, bool closing_segments = true) {
    size_t num_segments = 0;
    double length = 0;
    Eigen::AlignedBox3d box;
    for (const DrawingLink& link : graph_.links) {
      std::vector<Eigen::Vector3d> points = link.points_in_world;
      if (link.closed && !closing_segments) points.pop_back();
      num_segments += points.size() - 1;
      length += Length(points);
      for (const Eigen::Vector3d& point : points) box.extend(point);
    }
    EXPECT_EQ(read.at("segments"), num_segments);
    EXPECT_NEAR(read.at("length").get<double>() / length, 1, kRelative);
    ExpectBounds(read, box);
  }

  void ExpectBounds(const json& read, const Eigen::AlignedBox3d& box) {
    const double size = box.diagonal().norm();
    EXPECT_LT((ToPoint(read.at("low")) - box.min()).norm(), kRelative * size);
    EXPECT_LT((ToPoint(read.at("high")) - box.max()).norm(), kRelative * size);
  }

  // Edges of the shapes of all links.
  void ExpectAllShapes(const json& read, double mm_per_unit) {
    double length = 0;
    for (const DrawingLink& link : graph_.links) length += ShapeLength(link);
    EXPECT_TRUE(read.at("valid"));
    EXPECT_EQ(read.at("edges"), graph_.links.size());
    EXPECT_EQ(read.at("faces"), 0);
    EXPECT_NEAR(read.at("length").get<double>() / length, mm_per_unit, 1e-6 * mm_per_unit);
  }

  const DrawingGraph graph_ = PrimitiveDrawing();
  const ExportedDrawing exported_{graph_};
};

#define LIMN_SKIP_IF_MISSING(read) \
  if ((read).contains("missing")) GTEST_SKIP() << (read).at("missing") << " is not installed"

#ifdef LIMN_WITH_STEP
TEST_F(DrawingExporterPrograms, FreeCadReadsStep) {
  const json read = ReadBy("freecad", "d.step", {"--unit", "mm"});
  LIMN_SKIP_IF_MISSING(read);
  ExpectAllShapes(read, 1);
}

TEST_F(DrawingExporterPrograms, FreeCadReadsMillimetersOfOtherUnits) {
  const json read = ReadBy("freecad", "d.step", {"--unit", "in"});
  LIMN_SKIP_IF_MISSING(read);
  ExpectAllShapes(read, 25.4);
}
#endif

TEST_F(DrawingExporterPrograms, Open3dReadsPly) {
  const json read = ReadBy("open3d", "d.ply");
  LIMN_SKIP_IF_MISSING(read);
  ExpectAllPolylines(read);
}

TEST_F(DrawingExporterPrograms, MeshLabReadsPly) {
  const json read = ReadBy("meshlab", "d.ply");
  LIMN_SKIP_IF_MISSING(read);
  ExpectAllPolylines(read);
}

TEST_F(DrawingExporterPrograms, MeshLabReadsSegmentsOfObj) {
  const json read = ReadBy("meshlab", "d.obj", {"--segments", "1"});
  LIMN_SKIP_IF_MISSING(read);
  ExpectAllPolylines(read);
}

// It reads neither circles nor splines, and arcs as if their planes were level. What is read here
// are the vertices that it writes, in which nothing is closed.
TEST_F(DrawingExporterPrograms, CloudCompareReadsSegmentsOfDxf) {
  const json read = ReadBy("cloudcompare", "d.dxf", {"--segments", "1", "--junctions", "0"});
  LIMN_SKIP_IF_MISSING(read);
  ExpectAllPolylines(read, /*closing_segments=*/false);
}

// The sheet would be many times as large as the plan. Lines are as wide as they would be on the
// thing itself, hence thin only if that is large.
TEST_F(DrawingExporterPrograms, LibreCadShowsPlansWithoutSheet) {
  const json read =
      ReadBy("librecad", "front.dxf",
             {"--view", "front", "--paper_space", "0", "--scale", "1000", "--unit", "mm"});
  LIMN_SKIP_IF_MISSING(read);
  Eigen::AlignedBox3d box;
  for (const DrawingLink& link : graph_.links) {
    for (const Eigen::Vector3d& point : link.points_in_world) box.extend(point);
  }
  const double width_by_height = box.sizes().x() / box.sizes().z();
  EXPECT_NEAR(read.at("width_by_height").get<double>() / width_by_height, 1, 0.02);
}

}  // namespace
}  // namespace limn::testing
