#include "limn/io/junctions_reader.h"

#include <nlohmann/json.hpp>

#include "limn/io/whole_file.h"
#include "limn/util/errors.h"

namespace limn {

std::vector<CurveNode> ReadJunctions(const std::string& path) {
  const std::string text = ReadWholeFile(path);
  std::vector<CurveNode> nodes;
  try {
    const nlohmann::json file = nlohmann::json::parse(text);
    for (const nlohmann::json& junction : file.at("junctions")) {
      const nlohmann::json& position = junction.at("position");
      CurveNode node;
      for (int axis = 0; axis < 3; ++axis) {
        node.position_in_world[axis] = position.at(axis).get<double>();
      }
      node.degree = junction.at("degree").get<int>();
      if (node.degree < 1) throw IoError(path, "a junction of degree below 1");
      nodes.push_back(node);
    }
  } catch (const nlohmann::json::exception& error) {
    throw IoError(path, error.what());
  }
  return nodes;
}

}  // namespace limn
