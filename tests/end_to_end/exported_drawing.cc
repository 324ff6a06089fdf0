// SPDX-License-Identifier: BSD-3-Clause
#include "end_to_end/exported_drawing.h"

#include <variant>

#include <gtest/gtest.h>

#include "limn/formats/write_drawing.h"
#include "limn/geometry/polyline.h"

namespace limn::testing {
namespace {

std::string ReaderPath(const std::string& script) {
  return std::string(LIMN_SOURCE_DIR) + "/tests/scripts/readers/" + script;
}

nlohmann::json LastLine(const LimnRun& run, const std::string& start) {
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  const size_t begin = run.out.rfind("\n" + start);
  const std::string text = begin == std::string::npos ? run.out : run.out.substr(begin + 1);
  const auto end = text.find('\n');
  const auto json = nlohmann::json::parse(text.substr(0, end), nullptr, false);
  EXPECT_FALSE(json.is_discarded()) << run.out << run.err;
  return json;
}

}  // namespace

ExportedDrawing::ExportedDrawing(const DrawingGraph& graph,
                                 const std::optional<Alignment>& alignment) {
  WriteDrawing(Path("drawing.json"), graph, {{"a.png", "b.png"}, "{}", alignment});
}

LimnRun ExportedDrawing::TryExport(const std::string& name,
                                   const std::vector<std::string>& more) const {
  std::vector<std::string> arguments = {"drawing_exporter", "--input_path", Path("drawing.json"),
                                        "--output_path", Path(name)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return RunLimn(arguments);
}

void ExportedDrawing::Export(const std::string& name, const std::vector<std::string>& more) const {
  const LimnRun run = TryExport(name, more);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_TRUE(std::filesystem::exists(Path(name)));
}

nlohmann::json ExportedDrawing::Read(const std::string& script, const std::string& name) const {
  return LastLine(RunProgram("/usr/bin/python3", {ReaderPath(script), Path(name)}), "{");
}

nlohmann::json ExportedDrawing::ReadIn(const std::string& program, const std::string& name) const {
  return LastLine(
      RunProgram("/usr/bin/python3", {ReaderPath("read_in_programs.py"), program, Path(name)}),
      "{");
}

nlohmann::json ExportedDrawing::ReadInBlender(const std::string& script,
                                              const std::string& name) const {
  return LastLine(RunProgram("blender", {"--background", "--factory-startup", "--python-exit-code",
                                         "1", "--python", ReaderPath(script), "--", Path(name)}),
                  "{");
}

double ShapeLength(const DrawingLink& link) {
  if (!link.primitive) return Length(link.points_in_world);
  constexpr int kSteps = 20000;
  double length = 0;
  Eigen::Vector3d previous = PointAt(link.primitive->shape, 0);
  for (int k = 1; k <= kSteps; ++k) {
    const Eigen::Vector3d next = PointAt(link.primitive->shape, static_cast<double>(k) / kSteps);
    length += (next - previous).norm();
    previous = next;
  }
  return length;
}

Eigen::Vector3d ToPoint(const nlohmann::json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

}  // namespace limn::testing
