// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/wireframe_files.h"

#include <filesystem>
#include <ostream>
#include <sstream>
#include <string_view>
#include <system_error>

#include <nlohmann/json.hpp>

#include "limn/files/json_text.h"
#include "limn/files/json_value.h"
#include "limn/files/text_file.h"
#include "limn/files/whole_file.h"
#include "limn/formats/json_place.h"
#include "limn/formats/obj_reader.h"
#include "limn/util/number_text.h"

namespace limn {
namespace {

constexpr const char* kWireframeVertices = "wf_vertices";
constexpr const char* kWireframeEdges = "wf_edges";

int ToVertexIndex(const JsonValue& value, size_t num_vertices) {
  const int index = value.Integer();
  if (index < 0 || index >= static_cast<int>(num_vertices)) {
    value.Fail("no vertex of this index: there are " + std::to_string(num_vertices) +
               ", counted from 0");
  }
  return index;
}

Wireframe ToWireframe(const JsonValue& value) {
  Wireframe wireframe;
  wireframe.vertices = PlacesOf(value.At(kWireframeVertices));
  for (const JsonValue& edge : value.At(kWireframeEdges).Items()) {
    const std::vector<JsonValue> ends = edge.Items(2, 2);
    wireframe.edges.emplace_back(ToVertexIndex(ends[0], wireframe.vertices.size()),
                                 ToVertexIndex(ends[1], wireframe.vertices.size()));
  }
  return wireframe;
}

constexpr std::string_view kObjHead = "# wireframe by limn";

// What the comments say before the first statement.
struct ObjComments {
  bool is_ours = false;
  LengthUnit unit = LengthUnit::kNone;
};

ObjComments ReadObjComments(const std::string& path) {
  constexpr std::string_view kUnit = "# unit: ";
  ObjComments comments;
  std::istringstream text(ReadTextFile(path));
  std::string line;
  while (std::getline(text, line) && line.starts_with('#')) {
    comments.is_ours |= line == kObjHead;
    if (line.starts_with(kUnit)) comments.unit = UnitOfName(line.substr(kUnit.size()));
  }
  return comments;
}

}  // namespace

void WriteWireframeObj(const Wireframe& wireframe, const ObjOptions& options,
                       const WireframeStamp& stamp, std::ostream& out) {
  out << kObjHead << '\n';
  if (stamp.unit != LengthUnit::kNone) out << "# unit: " << UnitName(stamp.unit) << '\n';
  if (stamp.tolerance > 0) out << "# tolerance: " << NumberText(stamp.tolerance) << '\n';
  for (const Eigen::Vector3d& vertex : wireframe.vertices) {
    PutObjVector("v", vertex, options, out);
  }
  for (const auto& [a, b] : wireframe.edges) out << "l " << a + 1 << ' ' << b + 1 << '\n';
}

void WriteWireframeJson(const Wireframe& wireframe, const WireframeStamp& stamp,
                        std::ostream& out) {
  out << "{\"format\": \"limn-wireframe\"";
  if (stamp.unit != LengthUnit::kNone) out << ",\n\"unit\": \"" << UnitName(stamp.unit) << '"';
  if (stamp.tolerance > 0) out << ",\n\"tolerance\": " << NumberText(stamp.tolerance);
  out << ",\n\"" << kWireframeVertices << "\": [";
  const char* separator = "\n";
  for (const Eigen::Vector3d& vertex : wireframe.vertices) {
    out << separator << '[' << NumberText(vertex.x()) << ", " << NumberText(vertex.y()) << ", "
        << NumberText(vertex.z()) << ']';
    separator = ",\n";
  }
  out << "],\n\"" << kWireframeEdges << "\": [";
  separator = "\n";
  for (const auto& [a, b] : wireframe.edges) {
    out << separator << '[' << a << ", " << b << ']';
    separator = ",\n";
  }
  out << "]}\n";
}

std::optional<Wireframe> ReadJsonWireframe(const std::string& path) {
  const std::string text = ReadWholeFile(path, kMaxDrawingBytes);
  if (text.find(std::string("\"") + kWireframeVertices + '"') == std::string::npos) {
    return std::nullopt;
  }
  try {
    const auto json = ParseJson(path, text);
    const JsonValue root(json);
    if (!json.is_array()) {
      Wireframe wireframe = ToWireframe(root);
      const auto unit = json.find("unit");
      if (unit != json.end() && unit->is_string()) {
        wireframe.unit = UnitOfName(unit->get<std::string>());
      }
      return wireframe;
    }
    const std::vector<JsonValue> entries = root.Items();
    if (entries.size() != 1) {
      root.Fail("a list of " + std::to_string(entries.size()) +
                " wireframes: take out the one of this scene");
    }
    return ToWireframe(entries.front());
  } catch (const std::exception&) {
    RethrowJsonError(path);
  }
}

std::optional<Wireframe> ReadWireframe(const std::string& path) {
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored)) return std::nullopt;
  const std::string extension = FileExtension(path);
  if (extension == ".obj") {
    const ObjComments comments = ReadObjComments(path);
    auto wireframe = ReadObjWireframe(path, /*may_lack_edges=*/comments.is_ours);
    if (wireframe) wireframe->unit = comments.unit;
    return wireframe;
  }
  if (extension == ".json") return ReadJsonWireframe(path);
  return std::nullopt;
}

}  // namespace limn
