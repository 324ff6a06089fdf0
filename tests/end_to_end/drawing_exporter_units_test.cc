// SPDX-License-Identifier: BSD-3-Clause
// A length of 3.05 m is one in every format and unit.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <regex>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "end_to_end/exported_drawing.h"
#include "limn/formats/write_drawing.h"

namespace limn::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct Unit {
  const char* name;
  double per_meter;
  int dxf_code;
};
const Unit kUnits[] = {
    {"m", 1, 6}, {"cm", 100, 5}, {"mm", 1000, 4}, {"in", 1 / 0.0254, 1}, {"ft", 1 / 0.3048, 2}};

constexpr double kMeters = 3.05;
constexpr double kMetersPerModelUnit = 1.525;

// A straight link along x with a dimension.
DrawingGraph Rule() {
  DrawingGraph graph;
  DrawingLink link;
  link.points_in_world = {{0, 0, 0}, {1, 0, 0}, {kMeters / kMetersPerModelUnit, 0, 0}};
  link.sigma.assign(3, 0.001);
  graph.nodes.resize(2);
  graph.nodes[1].position_in_world = link.points_in_world.back();
  link.node0 = 0;
  link.node1 = 1;
  graph.dimensions.resize(1);
  graph.dimensions[0].to = link.points_in_world.back();
  graph.dimensions[0].shift = {0, 0.3, 0};
  graph.links.push_back(std::move(link));
  RebuildIncidence(&graph);
  return graph;
}

// Turned about z by a right angle: the link is along y in the world.
Alignment Metric() {
  Alignment alignment;
  alignment.world_from_model.scale = kMetersPerModelUnit;
  alignment.world_from_model.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  alignment.scale = ScaleSource::kLengths;
  return alignment;
}

nlohmann::json GlbHeader(const std::string& bytes) {
  uint32_t size = 0;
  std::memcpy(&size, bytes.data() + 12, sizeof(size));
  return nlohmann::json::parse(bytes.substr(20, size));
}

// The largest extent of the file's positions along an axis.
double ExtentOfGlb(const std::string& bytes) {
  double extent = 0;
  const nlohmann::json header = GlbHeader(bytes);
  for (const auto& accessor : header.at("accessors")) {
    if (!accessor.contains("min") || accessor.at("min").size() != 3) continue;
    for (int axis = 0; axis < 3; ++axis) {
      extent = std::max(
          extent, accessor.at("max")[axis].get<double>() - accessor.at("min")[axis].get<double>());
    }
  }
  return extent;
}

// The largest number that a matching line begins with after `start`.
double Largest(const std::string& text, const std::string& pattern) {
  double largest = 0;
  const std::regex regex(pattern);
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) {
    for (size_t i = 1; i < it->size(); ++i) largest = std::max(largest, std::stod((*it)[i]));
  }
  return largest;
}

bool CanWriteStep() {
#ifdef LIMN_WITH_STEP
  return true;
#else
  return false;
#endif
}

class UnitsOfFiles : public ::testing::Test {
 protected:
  std::string Exported(const std::string& name, const std::vector<std::string>& more) const {
    std::vector<std::string> options = more;
    options.insert(options.end(), {"--overwrite", "1"});
    exported_.Export(name, options);
    return ReadTree(exported_.dir().path()).at(name);
  }
  void ExpectRefused(const std::vector<std::string>& options, const std::string& text) const {
    const LimnRun run = exported_.TryExport("refused.svg", options);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, HasSubstr(text));
  }

  ExportedDrawing exported_{Rule(), Metric()};
};

TEST_F(UnitsOfFiles, AKnownLengthMeasuresAsItIs) {
  for (const bool aligned : {true, false}) {
    for (const Unit& unit : kUnits) {
      SCOPED_TRACE(std::string(unit.name) + (aligned ? " aligned" : ""));
      const std::vector<std::string> options = {"--unit", unit.name, "--aligned",
                                                aligned ? "1" : "0"};
      const double length = unit.per_meter * kMeters;
      const std::string in_unit = std::string("unit: ") + unit.name;

      Exported("d.dxf", options);
      const nlohmann::json dxf = exported_.Read("read_dxf.py", "d.dxf");
      EXPECT_EQ(dxf.at("unit"), unit.dxf_code);
      EXPECT_THAT(dxf.at("errors"), ::testing::IsEmpty());
      EXPECT_NEAR(dxf.at("entities")[0].at("length"), length, 1e-9 * length);
      EXPECT_NEAR(dxf.at("entities")[1].at("measured"), length, 1e-9 * length);
      EXPECT_THAT(dxf.at("entities")[1].at("text"), HasSubstr(std::string(" ") + unit.name));

      const std::string obj = Exported("d.obj", options);
      EXPECT_THAT(obj, HasSubstr("# " + in_unit + "\n"));
      EXPECT_NEAR(Largest(obj, "v ([-0-9.e+]+) ([-0-9.e+]+) ([-0-9.e+]+)"), length, 1e-9 * length);
      EXPECT_THAT(Exported("d.ply", options), HasSubstr("comment " + in_unit + "\n"));
      EXPECT_THAT(Exported("d.graphml", options),
                  HasSubstr(std::string("<data key=\"unit\">") + unit.name + "</data>"));
      EXPECT_NEAR(ExtentOfGlb(Exported("d.glb", options)), kMeters, 1e-6);
      EXPECT_THAT(Exported("d.svg", {"--unit", unit.name, "--aligned", aligned ? "1" : "0",
                                     "--view", "top", "--sheet_scale", "10"}),
                  aligned ? HasSubstr("height=\"341mm\"") : HasSubstr("width=\"325mm\""));
      if (!CanWriteStep()) continue;
      EXPECT_NEAR(
          Largest(
              Exported("d.step", options),
              "CARTESIAN_POINT\\('[^']*',\\(\\s*([-0-9.E+]+),\\s*([-0-9.E+]+),\\s*([-0-9.E+]+)\\)"),
          1000 * kMeters, 1e-6);
    }
  }
}

TEST_F(UnitsOfFiles, AlignedFilesAreInMeters) {
  EXPECT_THAT(Exported("d.obj", {"--aligned", "1"}), HasSubstr("# unit: m\n"));
  EXPECT_THAT(Exported("d.obj", {}), Not(HasSubstr("unit")));
}

TEST_F(UnitsOfFiles, AFactorBesideAUnitIsRefused) {
  ExpectRefused({"--unit", "mm", "--scale", "100", "--aligned", "1"}, "the unit converts to it");
  // What says the same twice does not contradict itself.
  EXPECT_EQ(Exported("d.obj", {"--unit", "mm", "--scale", "1000", "--aligned", "1"}),
            Exported("d.obj", {"--unit", "mm", "--aligned", "1"}));
}

TEST_F(UnitsOfFiles, SheetsOfModelUnitsHaveNoScale) {
  const std::string sheet = Exported("d.svg", {"--view", "top"});
  EXPECT_THAT(sheet, HasSubstr("model units<"));
  EXPECT_THAT(sheet, Not(HasSubstr("1:")));
  ExpectRefused({"--view", "top", "--sheet_scale", "10"}, "--known_length");
}

}  // namespace
}  // namespace limn::testing
