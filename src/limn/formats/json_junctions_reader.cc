#include "limn/formats/json_junctions_reader.h"

#include <nlohmann/json.hpp>

#include "limn/files/json_text.h"
#include "limn/files/whole_file.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

JunctionKind JunctionKindNamed(const std::string& name) {
  if (name == "corner") return JunctionKind::kCorner;
  if (name == "t") return JunctionKind::kTee;
  if (name == "crossing") return JunctionKind::kCrossing;
  return JunctionKind::kUnknown;
}

}  // namespace

std::vector<CurveNode> ReadJunctions(const std::string& path) {
  using Json = nlohmann::ordered_json;
  const std::string text = ReadWholeFile(path, kMaxJsonBytes);
  std::vector<CurveNode> nodes;
  try {
    const Json file = ParseJson(path, text);
    for (const Json& junction : file.at("junctions")) {
      const Json& position = junction.at("position");
      CurveNode node;
      for (int axis = 0; axis < 3; ++axis) {
        node.position_in_world[axis] = position.at(axis).get<double>();
      }
      node.degree = IntFromJson(junction.at("degree"));
      if (node.degree < 1) throw IoError(path, "a junction of degree below 1");
      if (junction.contains("kind")) {
        node.kind = JunctionKindNamed(junction.at("kind").get<std::string>());
      }
      nodes.push_back(node);
    }
  } catch (const std::exception&) {
    RethrowJsonError(path);
  }
  return nodes;
}

}  // namespace limn
